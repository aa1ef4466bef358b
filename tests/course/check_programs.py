#!/usr/bin/env python3
"""The programs as their users call them: options, messages, exit codes, files.

    check_programs.py FOLDER_OF_PROGRAMS
"""
import hashlib
import json
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from programs import ROOT, ProgramTest

MIRRORS = "lessons/02_mirrors/scenes/pure_specular.toml"
GLASS = """
[materials.glass]
ior = 1.5
[[sphere]]
center = [0, 0, -3]
radius = 1
material = "glass"
"""


class Programs(ProgramTest):
    def write(self, name, text):
        (self.here / name).write_text(text)
        return name

    def digest(self, name):
        return hashlib.sha256((self.here / name).read_bytes()).hexdigest()

    def test_every_format_is_written(self):
        for ending, magic in ((".png", b"\x89PNG"), (".exr", b"\x76\x2f\x31\x01"), (".hdr", b"#?RADIANCE"), (".ppm", b"P6")):
            self.run_program("lesson02", ROOT / MIRRORS, "--size", "40x30", "--out", "p" + ending)
            self.assertTrue((self.here / ("p" + ending)).read_bytes().startswith(magic))
        self.assertIn(b"40 30", (self.here / "p.ppm").read_bytes()[:20])

    def test_pictures_are_the_same_for_any_number_of_threads(self):
        for name in ("lesson02", "lesson08"):
            for threads in (1, 2, 7):
                self.run_program(name, "--size", "200x150", "--spp", "2", "--threads", threads, "--out", f"{threads}.exr")
            self.assertEqual(self.digest("1.exr"), self.digest("2.exr"))
            self.assertEqual(self.digest("1.exr"), self.digest("7.exr"))

    def test_options_change_the_picture(self):
        pictures = [(), ("--real", "float"), ("--real", "long-double"), ("--depth", "0"), ("--spp", "3")]
        digests = set()
        for options in pictures:
            self.run_program("lesson02", "--size", "64x48", "--out", "p.exr", *options)
            digests.add(self.digest("p.exr"))
        self.assertGreaterEqual(len(digests), 4)  # long double rounds to the same floats

    def test_tree_is_the_only_output(self):
        out, err = self.run_program("lesson02", ROOT / MIRRORS, "--pixel", "360,250", "--tree", "json")
        tree = json.loads(out)
        self.assertEqual(err, "")
        self.assertEqual(list(self.here.iterdir()), [])
        self.assertEqual((tree["version"], tree["lesson"], tree["real"], tree["pixel"], tree["max_depth"]), (1, 2, "double", [360, 250], 8))
        self.assertEqual([n["kind"] for n in tree["nodes"]], ["camera", "reflected", "reflected"])
        self.assertEqual([n["hit"]["primitive"] for n in tree["nodes"]], ["sphere1", "sphere0", "plane0"])

    def test_tree_of_the_scenes_own_pixel_follows_the_size(self):
        tree = json.loads(self.run_program("lesson02", ROOT / MIRRORS, "--size", "1280x960", "--tree", "json")[0])
        self.assertEqual(tree["pixel"], [720, 500])

    def test_ray_is_traced_as_given(self):
        scene = self.write("s.toml", "[materials.m]\nmirror = 1.0\n[[sphere]]\ncenter = [0, 0, -3]\nradius = 1\nmaterial = 'm'\n")
        tree = json.loads(self.run_program("lesson02", scene, "--ray", "-1.5,0,-3,2,0,0", "--tree", "json")[0])
        first, second = tree["nodes"]
        self.assertEqual((first["origin"], first["direction"], first["hit"]["t"]), ([-1.5, 0, -3], [1, 0, 0], 0.5))
        self.assertEqual((second["origin"], second["direction"], second["end"]), ([-1, 0, -3], [-1, 0, 0], "miss"))
        self.assertNotIn("pixel", tree)

    def test_json_follows_the_schema(self):
        import jsonschema
        schema = json.loads((ROOT / "common/tree/ray_tree.schema.json").read_text())
        for program, options in (("lesson01", []), ("lesson02", []), ("lesson02", ["--depth", "1"]), ("lesson02", ["--ray", "0,1,5,0,1,0"]),
                                 ("lesson04", []), ("lesson06", []), ("lesson07", []), ("lesson08", ["--depth", "2"])):
            jsonschema.validate(json.loads(self.run_program(program, "--tree", "json", *options)[0]), schema)

    def test_text_tree_and_explanation_name_the_numbers(self):
        out, _ = self.run_program("lesson02", "--tree", "text")
        for words in ("Trace( camera ray", "IntersectScene: sphere1", "Trace( reflected ray", "IsVisible( light 0", "return ("):
            self.assertIn(words, out)
        out, _ = self.run_program("lesson02", "--explain")
        for words in ("R = B - A", "max(0, N.L)", "throughput * own light"):
            self.assertIn(words, out)

    def test_help_has_examples(self):
        out, _ = self.run_program("lesson02", "--help")
        for words in ("Examples:", "--size WxH", "--ray ox,oy,oz,dx,dy,dz", "Exit codes"):
            self.assertIn(words, out)

    def test_bad_options_give_one_sentence(self):
        for options, words in ((["--size", "0x10"], "--size"), (["--size", "ten"], "WxH"), (["--pixel", "640,0"], "outside the picture"),
                               (["--pixel", "1"], "x,y"), (["--ray", "1,2,3"], "6 finite numbers"), (["--ray", "0,0,0,0,0,0"], "zero"),
                               (["--ray", "0,0,0,0,0,nan"], "6 finite numbers"), (["--real", "half"], "--real"), (["--depth", "-1"], "--depth"),
                               (["--spp", "0"], "--spp"), (["--threads", "x"], "--threads"), (["--tree", "xml"], "--tree"), (["--nonsense"], "--nonsense"),
                               (["--out", "p.jpeg"], ".png"), (["--out", "no/such/p.png"], "there is no folder"), (["--pixel", "1,1", "--ray", "0,0,0,0,0,1"], "--ray")):
            self.assertIn(words, self.refused("lesson02", *options))

    def test_bad_scenes_give_the_place(self):
        self.assertIn("no.toml", self.refused("lesson02", "no.toml"))
        self.write("s.toml", "[camera]\neye = [0, 1]\n")
        self.assertIn("s.toml:2:", self.refused("lesson02", "s.toml"))

    def test_a_bad_scene_leaves_the_old_picture(self):
        self.write("p.png", "old")
        self.write("s.toml", "[camera\n")
        self.refused("lesson02", "s.toml", "--out", "p.png")
        self.assertEqual((self.here / "p.png").read_text(), "old")

    def test_a_scene_beyond_the_lesson_is_refused_by_name(self):
        mirror = self.write("m.toml", "[materials.m]\nmirror = 1.0\n[[sphere]]\ncenter = [0, 0, -3]\nradius = 1\nmaterial = 'm'\n")
        message = self.refused("lesson01", mirror)
        for words in ("material 'm'", "mirrors", "lesson 02", "--force"):
            self.assertIn(words, message)
        _, err = self.run_program("lesson01", mirror, "--force", "--size", "8x6", "--out", "p.png")
        self.assertIn("traced without", err)

    def test_numbers_beyond_float_are_refused_in_float_only(self):
        scene = self.write("s.toml", "[materials.m]\n[[sphere]]\ncenter = [0, 0, -3e39]\nradius = 1e39\nmaterial = 'm'\n")
        self.assertIn("does not fit", self.refused("lesson01", scene, "--real", "float"))
        self.run_program("lesson01", scene, "--size", "8x6", "--out", "p.png")

    def test_render_takes_the_smallest_lesson(self):
        _, err = self.run_program("render", ROOT / "lessons/01_direct_illumination/scenes/behind.toml", "--size", "8x6", "--out", "p.png")
        self.assertIn("lesson 01", err)
        _, err = self.run_program("render", ROOT / MIRRORS, "--size", "8x6", "--out", "p.png")
        self.assertIn("lesson 02", err)

    def test_glass_in_lesson_05_is_worth_a_word(self):
        glass = self.write("g.toml", GLASS)
        out, err = self.run_program("lesson05", glass, "--ray", "0,0,0,0,0,-1", "--tree", "json")
        self.assertIn("lesson 06", err)
        self.assertEqual([n["kind"] for n in json.loads(out)["nodes"]], ["camera", "transmitted", "transmitted"])
        self.assertIn("lesson 05", self.refused("lesson02", glass))

    def test_fresnel_model_can_be_chosen(self):
        glass = self.write("g.toml", GLASS)
        weights = {}
        for model in ("exact", "schlick", "none"):
            out, _ = self.run_program("lesson06", glass, "--ray", "0,0.9,0,0,0,-1", "--depth", "1", "--fresnel", model, "--tree", "json")
            weights[model] = [n["weight"] for n in json.loads(out)["nodes"] if n["kind"] == "reflected"]
        self.assertAlmostEqual(weights["exact"][0], 0.11414110022135403, delta=1e-12)
        self.assertNotEqual(weights["exact"], weights["schlick"])
        self.assertEqual(weights["none"], [])

    def test_lesson_04_makes_a_sky(self):
        self.run_program("lesson04", "--make-sky", "sky.hdr")
        self.assertEqual((self.here / "sky.hdr").read_bytes(), (ROOT / "lessons/04_hdr_sky/scenes/probe.hdr").read_bytes())
        self.write("s.toml", '[sky]\nimage = "sky.hdr"\n')
        tree = json.loads(self.run_program("lesson04", "s.toml", "--ray", "0,0,0,-7,9,9", "--tree", "json")[0])
        self.assertGreater(tree["nodes"][0]["radiance"][0], 99)

    def test_every_lesson_renders_its_scenes(self):
        for folder in [path.parent for path in sorted(ROOT.glob("lessons/*/lesson.toml")) if "brings" in path.read_text()]:
            for scene in sorted(folder.glob("scenes/*.toml")):
                self.run_program(f"lesson{folder.name[:2]}", scene, "--size", "16x12", "--out", "p.png")

    def test_lesson_09_makes_a_pair(self):
        self.run_program("lesson09", "--limitation", "shadows", "--spp", "4", "--size", "64x48", "--out", "p.ppm")
        width = int((self.here / "p.ppm").read_bytes().split()[1])
        self.assertGreaterEqual(width, 128)
        self.assertIn("--limitation", self.refused("lesson09", "--limitation", "nothing"))

    def test_lesson_00_answers_the_tutorial(self):
        out, _ = self.run_program("lesson00")
        for words in ("0.4", "1.2", "53"):
            self.assertIn(words, out)
        self.assertIn("not attempted", self.run_program("exercise00")[0])

    def test_interruption_writes_nothing(self):
        self.interrupted("lesson02", "--size", "2000x2000", "--spp", "1000", "--out", "p.png")

    def test_an_untouched_exercise_is_magenta_and_says_nothing_else(self):
        self.run_program("exercise01", "--size", "8x6", "--out", "p.ppm")
        self.assertTrue((self.here / "p.ppm").read_bytes().endswith(b"\xff\x00\xff" * 48))


unittest.main(verbosity=1)
