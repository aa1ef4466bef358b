#!/usr/bin/env python3
"""The programs trade and lesson10 as their users call them: files, messages, exit codes, interruption.

    check_trade.py FOLDER_OF_PROGRAMS
"""
import csv
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from programs import ROOT, ProgramTest

CLASSIC = ROOT / "lessons/10_speed_and_accuracy/scenes/classic.toml"


class Trade(ProgramTest):
    SECONDS = 600

    def test_a_small_study_writes_all_its_files(self):
        out, _ = self.run_program("trade", CLASSIC, "--quick", "--size", "32x24", "--out", "new/folder")
        files = sorted(path.name for path in (self.here / "new/folder").iterdir())
        self.assertEqual(files, ["modelling.csv", "pareto_classic.svg", "pareto_classic_samples.svg", "trade.csv", "trade.html"])
        self.assertEqual(len(out.splitlines()), len(files))
        with open(self.here / "new/folder/trade.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["scene"] for row in rows}, {"classic"})
        self.assertTrue(all(float(row["ns_per_pixel"]) > 0 for row in rows))
        front = [(float(row["ns_per_pixel"]), float(row["psnr_db"])) for row in rows if row["pareto"] == "1"]
        self.assertGreater(len(front), 1)
        self.assertEqual([dB for _, dB in sorted(front)], sorted(dB for _, dB in front))

    def test_modelling_alone(self):
        self.run_program("trade", CLASSIC, "--quick", "--modelling", "--size", "32x24", "--out", "m")
        self.assertEqual(sorted(path.name for path in (self.here / "m").iterdir()), ["modelling.csv", "trade.html"])

    def test_a_recommendation_is_rendered(self):
        out, err = self.run_program("trade", CLASSIC, "--accuracy", "50dB", "--size", "64x48", "--out", "p.png")
        self.assertIn("recommended", out)
        self.assertIn("the promise is kept", err)
        self.assertTrue((self.here / "p.png").read_bytes().startswith(b"\x89PNG"))

    def test_a_promise_that_cannot_be_kept_has_its_own_exit_code(self):
        out, err = self.run_program("trade", CLASSIC, "--budget", "0.001ms", "--size", "64x48", code=4)
        self.assertIn("not kept", out)
        self.assertIn("not kept", err)

    def test_bad_input_gives_one_sentence(self):
        self.assertIn("100ms", self.refused("trade", CLASSIC, "--budget", "100"))
        self.assertIn("60dB", self.refused("trade", CLASSIC, "--accuracy", "60"))
        self.assertIn("no.toml", self.refused("trade", "no.toml"))
        self.assertIn("--size", self.refused("trade", "--size", "0x1"))
        self.assertIn("--against", self.refused("trade", "--against", "none"))
        self.assertIn("--modelling", self.refused("trade", "--modelling", "--budget", "1s"))
        (self.here / "file").write_text("")
        self.assertIn("is a file", self.refused("trade", "--out", "file/folder"))
        self.assertIn(".png", self.refused("trade", CLASSIC, "--budget", "1s", "--out", "p.jpeg"))
        self.assertIn("--exhibit", self.refused("lesson10", "--exhibit", "nothing"))
        self.assertIn("--exhibit", self.refused("lesson10", "--out", "p.png"))

    def test_interruption_writes_nothing(self):
        self.interrupted("trade", "--out", "d")
        self.interrupted("trade", "--budget", "100s", "--size", "1600x1200", "--against", "many")

    def test_lesson_10_makes_a_pair(self):
        _, err = self.run_program("lesson10", "--exhibit", "lost_shells", "--size", "64x48", "--out", "p.ppm")
        self.assertEqual(int((self.here / "p.ppm").read_bytes().split()[1]), 132)
        self.assertIn("pixels with leaks", err)


unittest.main(verbosity=1)
