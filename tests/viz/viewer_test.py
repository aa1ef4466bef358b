#!/usr/bin/env python3
"""The viewer as its users call it, without a window: scripts, exports, ray trees from files, other tracers, comparisons.

    viewer_test.py VIEWER
"""
import json
import os
import pathlib
import shlex
import stat
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
VIEWER = pathlib.Path(sys.argv.pop(1)).resolve()
PROGRAMS = VIEWER.parent
GLASS = ROOT / "lessons/06_fresnel/scenes"
SCENE = sorted(GLASS.glob("*.toml"))[0]
NO_DISPLAY = {key: value for key, value in os.environ.items() if key != "DISPLAY"}


class Viewer(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)

    def view(self, *words, code=0, seconds=600):
        done = subprocess.run([VIEWER, *map(str, words)], capture_output=True, cwd=self.here, timeout=seconds, env=NO_DISPLAY)
        self.assertEqual(done.returncode, code, done.stderr.decode())
        self.assertEqual(done.stdout, b"")
        return done.stderr.decode()

    def refused(self, *words, code=2, seconds=600):
        """Standard error of a call that must fail with one sentence and leave no file."""
        before = sorted(self.here.iterdir())
        error = self.view(*words, code=code, seconds=seconds)
        self.assertEqual(error.count("\n"), 1, error)
        self.assertEqual(sorted(self.here.iterdir()), before)
        return error

    def state(self, *words, script="", seconds=600):
        self.view(*words, "--script", f"{script}; state state.json", seconds=seconds)
        return json.loads((self.here / "state.json").read_text())

    def program(self, name, text):
        path = self.here / name
        path.write_text("#!/bin/sh\n" + text)
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return path

    def tree(self, lesson=6, *words):
        done = subprocess.run([PROGRAMS / f"lesson{lesson:02}", *words, "--tree", "json"], capture_output=True, cwd=self.here)
        return json.loads(done.stdout)

    def write(self, name, value):
        path = self.here / name
        path.write_text(value if isinstance(value, str) else json.dumps(value))
        return path

    # Scripts and exports

    def test_a_script_needs_no_display(self):
        state = self.state(6, script="pick 300 200; step first; step +4; depth 3")
        self.assertEqual((state["pixel"], state["max_depth"]), ([300, 200], 3))

    def test_a_script_may_be_a_file(self):
        self.write("commands.txt", "# look at one node\nselect 2\nstate there.json\n")
        self.view(6, "--script", "commands.txt")
        self.assertEqual(json.loads((self.here / "there.json").read_text())["selected"], 2)

    def test_a_wrong_script_does_nothing(self):
        error = self.refused(6, "--script", "state a.json; selct 3")
        self.assertIn('command 2 ("selct 3")', error)
        self.assertIn('did you mean "select"', error)

    def test_a_picture_of_the_window_within_a_script(self):
        self.view(2, "--script", "step 3; shot a.png; look light; shot b.png")
        pictures = [(self.here / name).read_bytes() for name in ("a.png", "b.png")]
        self.assertTrue(all(p.startswith(b"\x89PNG") for p in pictures))
        self.assertNotEqual(*pictures)

    def test_shots_and_exports_have_the_final_picture_of_the_depth_that_keys_have_chosen(self):
        keys = "; ".join(["key bracketleft"] * 3 + ["key bracketright"] + ["key bracketleft"] * 6)
        self.view(6, "--script", f"shot first.png; {keys}; shot keys.png")
        self.view(6, "--script", "shot first.png; depth 0; shot depth.png")
        self.assertEqual((self.here / "keys.png").read_bytes(), (self.here / "depth.png").read_bytes())
        self.view(6, "--script", "key bracketleft; key bracketleft; export out")
        subprocess.run([PROGRAMS / "lesson06", "--depth", "6", "--out", "plain.png"], check=True, capture_output=True, cwd=self.here)
        exported, = (self.here / "out").glob("*.png")
        self.assertEqual(exported.read_bytes(), (self.here / "plain.png").read_bytes())

    def test_without_its_fonts_the_view_still_has_text(self):
        fonts = {**NO_DISPLAY, "RAYTREE_FONTS": str(self.here)}
        done = subprocess.run([VIEWER, "2", "--script", "shot a.png; state s.json"], capture_output=True, cwd=self.here, env=fonts)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        self.assertIn("fonts-dejavu-core", json.loads((self.here / "s.json").read_text())["message"])

    def test_the_cheat_sheet_gives_the_view_back(self):
        self.view(2, "--script", "shot a.png")
        self.view(2, "--script", "help on; shot help.png; help off; shot b.png")
        self.assertEqual((self.here / "a.png").read_bytes(), (self.here / "b.png").read_bytes())

    def test_every_pane_is_reached_in_a_small_window(self):
        shots = "; ".join(f"key m; shot {i}.png" for i in range(7))
        self.view(3, "--size-window", "640x480", "--script", f"shot all.png; {shots}")
        all_panes = (self.here / "all.png").read_bytes()
        pictures = [(self.here / f"{i}.png").read_bytes() for i in range(7)]
        self.assertEqual(pictures[6], all_panes)
        self.assertEqual(len({*pictures}), 7)

    def test_with_more_samples_it_is_said_whose_tree_it_is(self):
        self.assertEqual((self.state(3, "--spp", 16)["samples"], self.state(3)["samples"]), (16, 1))
        for words, says in ((["--spp", "16"], True), ([], False), (["--spp", "16", "--ray", "0,1,5,0,0,-1"], False)):
            done = subprocess.run([PROGRAMS / "lesson06", *words, "--tree", "text"], capture_output=True, text=True, check=True)
            self.assertEqual("the picture has the mean of 16 samples" in done.stdout, says)

    def test_the_fitted_view_does_not_depend_on_what_was_seen_before(self):
        # Lines are wider from afar; nearly as wide as they should be they must not stay so. In lesson 2
        # seven steps back from eight are such a place.
        place = "760 260"
        words = ["shot 0.png", *[f"wheel {place} out"] * 8]
        for i in range(1, 9):
            words += [*[f"wheel {place} in"] * i, "key r", f"shot {i}.png", *[f"wheel {place} out"] * 8]
        self.view(2, "--script", "; ".join(words))
        shots = [(self.here / f"{i}.png").read_bytes() for i in range(9)]
        self.assertEqual([i for i in range(9) if shots[i] != shots[0]], [])

    def test_a_tree_of_one_pixel_stays_at_it(self):
        self.view(6, "--export", "tree.json")
        state = self.state("tree.json", script="pick 1 1; depth 0")
        again = self.state(6)
        self.assertEqual((state["pixel"], state["max_depth"]), (again["pixel"], again["max_depth"]))
        self.assertIn("tree.json", state["message"])

    def test_a_tree_names_no_other_file_than_a_scene(self):
        tree = self.tree()
        for name in ("/proc/kmsg", "/etc/passwd", "../../../../etc/passwd"):
            tree["scene"] = tree["source"] = name
            self.write("nosy.json", tree)
            self.assertIn("is not there", self.state("nosy.json")["message"])
            self.view("nosy.json", "--export", "nosy.html")
            self.assertNotIn("root:", (self.here / "nosy.html").read_text())

    def test_scripts_are_held_to_their_ranges(self):
        for slip in ("hide 5", "depth -5", "step 999", "pick 5000 1"):
            self.assertIn(f'"{slip}"', self.refused(6, "--script", slip))

    def test_all_formats_are_exported_without_a_display(self):
        self.view(6, "--export", "out")
        files = {path.name for path in (self.here / "out").iterdir()}
        self.assertEqual(files, {"ray_tree.json", "ray_tree.vtp", "ray_tree.glb", "ray_tree.gltf", "ray_tree.html", "picture.png"})
        tree = json.loads((self.here / "out/ray_tree.json").read_text())
        self.assertEqual(tree["source"], "lessons/06_fresnel/trace.h")
        self.assertTrue((self.here / "out/ray_tree.glb").read_bytes().startswith(b"glTF"))

    def test_one_format_is_exported(self):
        self.view(2, "--export", "only.gltf")
        self.assertEqual([path.name for path in self.here.iterdir()], ["only.gltf"])
        self.assertEqual(json.loads((self.here / "only.gltf").read_text())["asset"]["version"], "2.0")

    def test_an_export_that_cannot_be_written_is_refused_before_anything_is_traced(self):
        self.assertIn("missing", self.refused(6, "--export", "missing/tree.json"))
        self.write("file", "")
        self.write("broken.toml", "this is no scene")
        for path in ("file", "file/deep"):
            self.assertIn("file is no folder", self.refused("broken.toml", "--export", path))

    def test_a_folder_for_exports_is_made_when_there_is_something_to_export(self):
        self.write("broken.toml", "this is no scene")
        self.assertIn("broken.toml:1:", self.refused("broken.toml", "--export", "out/deep"))

    def test_whatever_cannot_be_written_is_refused_before_anything_is_traced(self):
        self.write("broken.toml", "this is no scene")  # what would be said, were the scene read first
        (self.here / "folder.png").mkdir()
        for path in ("missing/file.png", "folder.png", "broken.toml/file.png"):
            for option in ("--state", "--screenshot", "--record"):
                with self.subTest(f"{option} {path}"):
                    script = ["--script", "next"] if option == "--state" else []
                    self.assertTrue(self.refused("broken.toml", option, path, *script).startswith(f"viewer: {path}: "))

    def test_only_a_window_can_be_recorded(self):
        for words in (("--script", "next"), ("--screenshot", "a.png"), ("--export", "out")):
            self.assertIn("--record", self.refused(6, "--record", "mine.log", *words))

    # Ray trees from files

    def test_an_exported_tree_is_shown_again(self):
        self.view(6, "--export", "tree.json")
        state = self.state("tree.json", script="step 5; select 1")
        again = self.state(6, script="step 5; select 1")
        for key in ("nodes", "radiance", "selected", "step", "last_step", "pixel", "shown_nodes"):
            self.assertEqual(state[key], again[key], key)
        self.view("tree.json", "--screenshot", "shot.png")

    def test_a_tree_with_numbers_that_are_none_is_shown(self):
        tree = self.tree()
        tree["nodes"][0]["radiance"] = [None, 1, None]
        tree["nodes"][1]["direction"] = [None, None, None]
        tree["nodes"][1]["hit"] = None
        self.write("nan.json", tree)
        self.assertEqual(self.state("nan.json")["nodes"], len(tree["nodes"]))
        self.view("nan.json", "--screenshot", "shot.png", "--export", "out")

    def test_broken_trees_are_refused_with_one_sentence(self):
        good = self.tree()
        broken = {
            "empty": "",
            "cut": json.dumps(good)[:1000],
            "deep": "[" * 1000000,
            "list": "[]",
            "literal": json.dumps(good).replace(str(good["nodes"][0]["weight"]), "Nan", 1),
            "forward": json.dumps({**good, "nodes": [{**good["nodes"][0], "parent": 7}] + good["nodes"][1:]}),
            "words": json.dumps({**good, "nodes": [{**good["nodes"][0], "depth": "zero"}]}),
            "shadow": json.dumps({**good, "shadows": [{**good["shadows"][0], "node": 99999}]}),
            "version": json.dumps({**good, "version": 2}),
        }
        for name, text in broken.items():
            self.write(name + ".json", text)
            error = self.refused(name + ".json", "--script", "next")
            self.assertIn(name + ".json", error)
        self.assertIn("nodes[0].depth", self.refused("words.json", "--script", "next"))
        self.refused("absent.json", "--script", "next")

    def test_a_million_nodes_end_in_a_sentence_or_in_a_view(self):
        node = {"parent": -1, "kind": "camera", "depth": 0, "origin": [0, 0, 0], "direction": [0, 0, 1], "hit": None,
                "weight": 1, "throughput": [1, 1, 1], "radiance": [0, 0, 0], "contribution": [0, 0, 0], "end": "miss"}
        one = json.dumps(node)[1:]
        with open(self.here / "million.json", "w") as file:
            file.write('{"version": 1, "shadows": [], "nodes": [')
            for i in range(1000000):
                file.write(f'{"," if i else ""}{{"id": {i}, {one}')
            file.write("]}")
        done = subprocess.run([VIEWER, "million.json", "--script", "next"], capture_output=True, cwd=self.here, env=NO_DISPLAY, timeout=600)
        self.assertIn(done.returncode, (0, 2), done.stderr.decode())
        self.assertLessEqual(done.stderr.count(b"\n"), 1)

    def test_ten_thousand_nodes_are_usable(self):
        nodes = []
        for i in range(10000):
            parent = (i - 1) // 2 if i else -1
            depth = nodes[parent]["depth"] + 1 if i else 0
            nodes.append({"id": i, "parent": parent, "kind": "reflected" if i else "camera", "depth": depth, "origin": [0, 0, depth],
                          "direction": [0, 0, 1], "hit": {"t": 1, "point": [0, 0, depth + 1], "normal": [0, 0, -1],
                          "primitive": "sphere0", "material": "m", "inside": False}, "weight": .5, "throughput": [.5 ** depth] * 3,
                          "radiance": [1, 1, 1], "contribution": [0, 0, 0], "end": None})
        self.write("large.json", {"version": 1, "nodes": nodes, "shadows": []})
        state = self.state("large.json", script="select 7777; step first; step 5000; shot large.png")
        self.assertEqual((state["nodes"], state["step"]), (10000, 5000))

    def test_a_tree_names_its_scene_and_may_be_wrong(self):
        tree = self.tree()
        tree["scene"] = "/nowhere/scene.toml"
        self.write("lost.json", tree)
        state = self.state("lost.json")
        self.assertIn("/nowhere/scene.toml", state["message"])
        self.view("lost.json", "--screenshot", "shot.png")

    # Other tracers

    def test_an_exercise_is_shown_through_its_program(self):
        solved = PROGRAMS / "lesson06"
        state = self.state(6, SCENE, "--tracer", shlex.quote(str(solved)), script="pick 320 240")
        again = self.state(6, SCENE, script="pick 320 240")
        self.assertEqual(state["radiance"], again["radiance"])
        self.assertEqual(state["source"], "lesson06")

    def test_a_tracer_may_ignore_what_it_is_told(self):
        self.write("tree.json", self.tree())
        tracer = self.program("tracer", f"cat {self.here}/tree.json\n")
        state = self.state(6, SCENE, "--tracer", tracer)
        self.assertEqual(state["message"], "")
        self.assertGreater(state["nodes"], 1)

    def test_a_tracer_that_fails_is_told_in_one_sentence(self):
        failing = {
            "crashes": "kill -SEGV $$\n",
            "complains": "echo 'my error' >&2; exit 7\n",
            "babbles": "echo 'not a tree'\n",
            "says_nothing": "exit 0\n",
            "floods": "yes\n",
            "floods_errors": "yes >&2\n",
        }
        for name, text in failing.items():
            error = self.refused(6, SCENE, "--tracer", self.program(name, text), "--script", "next")
            self.assertIn(name, error)
            (self.here / name).unlink()
        self.assertIn("my error", self.refused(6, SCENE, "--tracer", "sh -c 'echo my error >&2; exit 7'", "--script", "next"))
        self.refused(6, SCENE, "--tracer", "/nowhere/tracer", "--script", "next")
        self.refused(6, SCENE, "--tracer", " ", "--script", "next")

    def test_a_tracer_that_hangs_is_stopped(self):
        tracer = self.program("hangs", 'case "$*" in *--out*) exit 0;; esac\nexec sleep 1200\n')
        begin = time.monotonic()
        error = self.refused(6, SCENE, "--tracer", tracer, "--script", "next")
        self.assertIn("hangs", error)
        self.assertLess(time.monotonic() - begin, 600, "it waited for the tracer")

    def test_a_tracer_that_fails_later_leaves_the_tree(self):
        self.write("tree.json", self.tree())
        tracer = self.program("sometimes", f'case "$*" in *7,7*) kill -9 $$;; *--out*) exit 0;; esac\ncat {self.here}/tree.json\n')
        state = self.state(6, SCENE, "--tracer", tracer, script="pick 7 7")
        self.assertIn("sometimes", state["message"])
        self.assertGreater(state["nodes"], 1)

    # Comparisons

    def test_schlick_differs_from_exact_in_fresnel_first(self):
        first = self.state(6, "--compare", "schlick")["comparison"]["first_difference"]
        self.assertEqual(first["field"], "fresnel")

    def test_a_lesson_agrees_with_itself_in_another_precision(self):
        for precision in ("double", "long-double"):
            self.assertIsNone(self.state(6, "--compare", precision)["comparison"]["first_difference"], precision)
        self.assertIsNone(self.state(2, "--compare", "float")["comparison"]["first_difference"])

    def test_another_cap_ends_earlier(self):
        first = self.state(6, "--compare", "depth=1")["comparison"]["first_difference"]
        self.assertIn(first["field"], ("missing ray", "end"))

    def test_an_exercise_that_is_not_attempted_differs_from_the_lesson(self):
        first = self.state(6, "--compare", "exercise")["comparison"]["first_difference"]
        self.assertIsNotNone(first)

    def test_swapped_indices_are_named(self):
        tree = self.tree()
        glass = next(node for node in tree["nodes"] if node["n1"] is not None)
        for node in tree["nodes"]:
            node["n1"], node["n2"] = node["n2"], node["n1"]
        self.write("swapped.json", tree)
        first = self.state(6, "--compare", "swapped.json", script="difference")["comparison"]["first_difference"]
        self.assertEqual((first["field"], first["expected_node"]), ("n1", glass["id"]))

    def test_what_cannot_be_compared_is_refused(self):
        for what in ("schlik", "depth=-1", "depth=two", "lesson=77", "absent.json", ""):
            words = self.refused(6, "--compare", what, "--script", "next") if what else ""
            if what:
                self.assertIn(what, words)


if __name__ == "__main__":
    unittest.main()
