#!/usr/bin/env python3
"""The programs trade and lesson10 as their users call them: files, messages, exit codes, interruption.

    check_trade.py FOLDER_OF_PROGRAMS
"""
import csv
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(sys.argv.pop(1)).resolve()
CLASSIC = ROOT / "lessons/10_speed_and_accuracy/scenes/classic.toml"


class Trade(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.here = pathlib.Path(self.folder.name)

    def run_program(self, *command, code=0):
        done = subprocess.run([str(BIN / command[0]), *map(str, command[1:])], capture_output=True, cwd=self.here, timeout=300)
        self.assertEqual(done.returncode, code, done.stderr.decode())
        return done.stdout.decode(), done.stderr.decode()

    def refused(self, *command):
        """Standard error of a call that must fail with one sentence and leave no file."""
        before = sorted(self.here.iterdir())
        out, err = self.run_program(*command, code=2)
        self.assertEqual((out, err.count("\n"), sorted(self.here.iterdir())), ("", 1, before), err)
        return err

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
        for command in (["--out", "d"], ["--budget", "100s", "--size", "1600x1200", "--against", "many"]):
            process = subprocess.Popen([str(BIN / "trade"), *command], cwd=self.here, stderr=subprocess.PIPE, stdout=subprocess.PIPE)
            # On a busy machine loading takes seconds: not before the program watches for the signal.
            status = pathlib.Path(f"/proc/{process.pid}/status")
            for _ in range(600):
                caught = next(line.split()[1] for line in status.read_text().splitlines() if line.startswith("SigCgt"))
                if int(caught, 16) >> (signal.SIGINT - 1) & 1:
                    break
                time.sleep(0.1)
            time.sleep(0.5)
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=60)
            self.assertEqual((process.returncode, out), (130, b""), err)
            self.assertIn(b"nothing was written", err)
            self.assertEqual(list(self.here.iterdir()), [])

    def test_lesson_10_makes_a_pair(self):
        _, err = self.run_program("lesson10", "--exhibit", "lost_shells", "--size", "64x48", "--out", "p.ppm")
        self.assertEqual(int((self.here / "p.ppm").read_bytes().split()[1]), 132)
        self.assertIn("pixels with leaks", err)


unittest.main(verbosity=1)
