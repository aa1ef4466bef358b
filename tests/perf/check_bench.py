#!/usr/bin/env python3
"""./raytree bench and its programs: what they write and refuse, and that they measure the lesson's own rays. No test asserts
how fast anything is.

    check_bench.py FOLDER_OF_PROGRAMS
"""
import collections
import csv
import json
import pathlib
import shutil
import signal
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import skips
from programs import BIN, ROOT, ProgramTest, wait_until_it_watches

sys.path[:0] = [str(ROOT / "tests/perf"), str(ROOT / "common/program")]
import bench_page
import bench_report
import bench_run
from children import Children

BENCH = (sys.executable, ROOT / "tests/perf/bench.py")
PICTURE = ("--no-peers", "--no-parts", "--no-growth", "--no-instructions")


class Bench(ProgramTest):
    def bench(self, *arguments):
        return self.run_program(*BENCH, "--programs", BIN, *arguments)

    def refused_by_bench(self, *arguments):
        return self.refused(*BENCH, "--programs", BIN, *arguments)

    def rows(self, file):
        with open(self.here / file, newline="") as text:
            return list(csv.DictReader(text))

    def measured(self, *arguments):
        return json.loads(self.run_program("bench_picture", *arguments)[0])

    def test_a_quick_run_writes_all_its_files_with_sane_values(self):
        self.bench("--quick", "--scenes", "s4,s6:1", "--size", "24x18", "--rounds", "1", "--no-instructions", "--no-parts", "--out", "new/out")
        names = {path.name for path in (self.here / "new/out").iterdir()}
        self.assertEqual(names, {"pictures.csv", "growth.csv", "benchmark.md", "spheres.svg", "memory.svg", "depth.svg",
                                 "resolution.svg", "lights.svg"} | ({"threads.svg"} & names))
        pictures = self.rows("new/out/pictures.csv")
        self.assertEqual({row["scene"] for row in pictures}, {"s4", "s6:1"})
        self.assertLessEqual({"double", "float", "long double", "double, baseline"}, {row["who"] for row in pictures})
        for row in pictures:
            self.assertGreaterEqual(float(row["cpu_seconds"]), 0)
            if row["who"] in ("double", "long double", "double, baseline"):
                self.assertEqual((row["camera"], row["rays_equal"]), (str(24 * 18), "True"), row)
            if row["who"] == "double":
                self.assertEqual(float(row["cpu_by_double"]), 1)
                self.assertGreater(float(row["bytes"]), 0)
            if row["who"] == "double, baseline":
                self.assertEqual(row["psnr_db"], "999.0", "pictures must not depend on the instruction set")
        growth = self.rows("new/out/growth.csv")
        self.assertEqual([row["spheres"] for row in growth if row["what"] == "spheres"], ["1", "10", "100", "1000"])
        lights = [int(row["rays"]) for row in growth if row["what"] == "lights of s4"]
        self.assertGreater(lights[1], lights[0])
        self.assertIn("| double | ", (self.here / "new/out/benchmark.md").read_text())

    def test_rays_are_those_of_the_ray_trees(self):
        scene = ROOT / "tests/perf/scenes/s4.toml"
        said = self.measured(scene, "--size", "8x6", "--count")
        kinds = collections.Counter()
        for y in range(6):
            for x in range(8):
                tree = json.loads(self.run_program("lesson08", scene, "--size", "8x6", "--pixel", f"{x},{y}", "--tree", "json")[0])
                kinds.update(node["kind"] for node in tree["nodes"])
                kinds["shadow"] += len(tree["shadows"])
        self.assertEqual(said["rays"], {kind: kinds[kind] for kind in ("camera", "shadow", "reflected", "transmitted")})
        self.assertGreater(said["rays"]["transmitted"], 0)

    def test_scenes_have_the_spheres_they_promise(self):
        for name, spheres in (("s1", 3), ("s5", 100), ("s5:17", 17), ("s6", 7381), ("s6:2", 91)):
            self.assertEqual(self.measured(name, "--size", "2x2")["spheres"], spheres, name)
        text = self.run_program("scene_to_pov", "s6", "--size", "4x3")[0]
        self.assertEqual(text.count("sphere {"), 7381)

    def test_povray_makes_the_same_picture_of_the_same_rays(self):
        if not shutil.which("povray"):
            self.skipTest("nothing bears witness to the export, as povray is not installed")
        runner = bench_run.Runner(BIN, self.here, Children())
        for scene in ("02_mirrors/scenes/pure_specular.toml", "06_fresnel/scenes/half_and_glass.toml"):
            file = ROOT / "lessons" / scene
            ours = self.measured(file, "--size", "160x120", "--count", "--out", "ours.exr")
            self.run_program("scene_to_pov", file, "--size", "160x120", "--out", "scene.pov")
            theirs = bench_run.povray(runner, "scene.pov", "160x120", "theirs.png")
            psnr = json.loads(self.run_program("picture_psnr", "theirs.png", "ours.exr")[0])["psnr"]
            # 16 bits a channel give 107 dB where all pixels see the same; one pixel that does not costs it 60.
            self.assertGreater(psnr, 60, scene)
            for kind in ("reflected", "transmitted"):
                self.assertEqual(theirs[kind], ours["rays"][kind] + ours["capped"][kind], (scene, kind))

    def test_embree_makes_the_same_picture(self):
        if not (BIN / "bench_embree").exists():
            self.skipTest("bench_embree is not built, as libembree-dev is not installed")
        for scene in ("s3", "s4"):
            self.measured(scene, "--size", "160x120", "--out", "ours.exr")
            self.run_program("bench_embree", scene, "--size", "160x120", "--out", "theirs.exr")
            psnr = json.loads(self.run_program("picture_psnr", "theirs.exr", "ours.exr")[0])["psnr"]
            self.assertGreater(psnr, 60, scene)  # in float, an edge of a checker or a shadow may move to the next pixel

    def test_what_povray_cannot_do_is_refused(self):
        self.assertIn("sky", self.refused("scene_to_pov", ROOT / "lessons/04_hdr_sky/scenes/probe.toml"))
        self.assertIn("glossy", self.refused("scene_to_pov", ROOT / "lessons/08_phong/scenes/exponents.toml"))

    def test_bad_arguments_give_one_sentence(self):
        self.assertIn("WxH", self.refused_by_bench("--size", "640"))
        self.assertIn("--rounds", self.refused_by_bench("--rounds", "0"))
        self.assertIn("--scenes", self.refused_by_bench("--scenes", ","))
        self.assertIn("--speed", self.refused_by_bench("--speed"))
        (self.here / "file").write_text("")
        self.assertIn("is a file", self.refused_by_bench("--out", "file/folder"))
        self.assertIn("s7", self.refused("bench_picture", "s7"))
        self.assertIn("s5:0", self.refused("bench_picture", "s5:0"))
        self.assertIn("--size", self.refused("bench_picture", "s1", "--size", "0x1"))
        self.assertIn("no.exr", self.refused("picture_psnr", "no.exr", "no.exr"))
        err = self.run_program(*BENCH, "--programs", BIN, "--scenes", "s9", *PICTURE, code=2)[1]
        self.assertIn("there is no scene \"s9\"", err)
        self.assertFalse((self.here / "out").exists())

    def test_interruption_writes_nothing(self):
        process = subprocess.Popen([*map(str, BENCH), "--programs", str(BIN), "--scenes", "s5:2000", "--rounds", "100", *PICTURE],
                                   cwd=self.here, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        wait_until_it_watches(process, signal.SIGTERM)  # Python itself catches SIGINT, so only this says that bench listens
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=600)
        self.assertEqual((process.returncode, out), (130, b""), err)
        self.assertIn(b"nothing was written", err)
        self.assertEqual(list(self.here.iterdir()), [])


class Report(unittest.TestCase):
    def test_turns_alternate(self):
        asked = []
        bench_run.in_turns(3, "ab", asked.append)
        self.assertEqual("".join(asked), "abbaab")

    def test_numbers_have_three_digits(self):
        self.assertEqual([bench_report.number(x) for x in (0.012345, 1.5, 123.4, 123456.7)], ["0.0123", "1.50", "123", "123,457"])

    def test_a_goal_is_met_only_if_all_its_scenes_meet_it(self):
        def goal(*ratios):
            pictures = [{"scene": f"s{5 + i}", "who": "Embree", "cpu_by_double": r, "wall_by_double": r} for i, r in enumerate(ratios)]
            return [row[2] for row in bench_page.goals({"pictures": pictures}) if "Embree" in row[0]]
        self.assertEqual((goal(1.6, 1.5), goal(1.6, 1.4)), (["yes"], ["no"]))

    def test_a_plot_goes_up_where_values_do(self):
        text = bench_report.svg("a < b", "x", "y", {"c": [(1, 1), (10, 100)]})
        (x0, y0), (x1, y1) = [(float(p.split('cx="')[1].split('"')[0]), float(p.split('cy="')[1].split('"')[0]))
                              for p in text.split("<circle")[1:]]
        self.assertTrue(x1 > x0 and y1 < y0)
        self.assertIn("a &lt; b", text)

    def test_columns_of_numbers_stand_to_the_right(self):
        rule = bench_report.table(["who", "rays", "ratio", "goal"], [["double", "1,234", "2.5 (1.00)", "1.5"], ["Embree", "-", "-", "at most"]]).splitlines()[1]
        self.assertEqual(rule, "| --- | ---: | ---: | --- |")
        self.assertEqual(bench_report.table(["who"], []), "| who |\n| --- |\n")

    def test_a_plot_has_its_caption_on_the_page(self):
        growth = [{"what": "spheres", "x": x, "ns_a_ray": x, "bytes_a_sphere": 0, "build_cpu_seconds": 0} for x in (1, 10)]
        self.assertEqual(bench_page.plots({"growth": growth}).keys(), {"spheres.svg"})
        self.assertIn(f"![{bench_page.CAPTIONS['spheres']}](plots/spheres.svg)", bench_page.growth_text(growth, "plots/", {"spheres.svg"}))


skips.main()
