#!/usr/bin/env python3
"""The viewer used by real mouse and key events, on a display of its own.

    clicks_test.py VIEWER

What the events did is read from the state that the viewer writes when key q ends it, and from the pixels on the screen.
Ends with 77 if Xvfb or xdotool is missing.
"""
import json
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import xdesktop
from xscreen import HEIGHT, PATIENCE, WIDTH, Screen, Viewer, missing, steady, wait_for

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]

# viz/base/layout.cpp at 1600x900: x, y, width, height.
TITLE, STRIP = 46, 78
IMAGE = (0, TITLE, 432, 324)
SCENE = (432, TITLE, 704, 434)
CODE = (432, 480, 704, 342)
TREE = (1136, TITLE, 464, 496)
BOTTOM = (0, HEIGHT - STRIP, WIDTH, STRIP)
SLIDERS = (130, BOTTOM[1] + 14, WIDTH - 130, 14)  # a band in the middle of the upper row, right of the buttons
WHOLE = (0, 0, WIDTH, HEIGHT)
NOWHERE = (700, 20)  # in the title, where nothing follows the pointer

# viz/base/palette.cpp, the dark look.
RAISED = (31, 40, 53)
CAMERA, REFLECTED, TRANSMITTED, ACCENT = (86, 180, 233), (245, 159, 20), (32, 166, 76), (125, 211, 252)

# Lesson 6 on its first scene: 640x480, a glass ball that splits the chosen pixel's ray again and again.
PICTURE = (640, 480)
KINDS = {"camera", "reflected", "transmitted", "lit", "blocked"}


def densest(points, half):
    """The point with the most others around it."""
    known = set(points)
    reach = range(-half, half + 1)
    return max(points, key=lambda p: sum((p[0] + dx, p[1] + dy) in known for dx in reach for dy in reach))


def runs(points):
    """Of pixels in one row: first and last x of each run, gaps of up to 3 closed."""
    found = []
    for x in sorted(x for x, _ in points):
        if found and x - found[-1][1] <= 4:
            found[-1][1] = x
        else:
            found.append([x, x])
    return found


class Clicks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.screen = Screen()
        cls.addClassCleanup(cls.screen.close)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def view(self, *words):
        viewer = Viewer(self.screen, PROGRAM, self.folder, *(words or (6,)))
        self.addCleanup(viewer.stop)
        return viewer

    def tree(self, *words):
        """The nodes that are shown, as the viewer exports them."""
        subprocess.run([PROGRAM, *map(str, words or (6,)), "--export", "tree.json"], cwd=self.folder, check=True, capture_output=True)
        return json.loads((self.folder / "tree.json").read_text())["nodes"]

    def scripted(self, *words):
        """The state without any events."""
        subprocess.run([PROGRAM, *map(str, words or (6,)), "--script", "state scripted.json"], cwd=self.folder, check=True, capture_output=True)
        return json.loads((self.folder / "scripted.json").read_text())

    def changes(self, box, act, what):
        """Does something and waits until a part of the screen looks different, and has come to rest."""
        before = self.screen.part(box)
        act()
        wait_for(lambda: self.screen.part(box) != before, what)
        return steady(self.screen, box)

    def drag(self, viewer, start, end, box, button=1):
        """The button goes down, the pointer moves there by way of the middle, the button goes up. The viewer asks where the
        pointer is when it gets round to a movement, so each must have had its effect before the next."""
        middle = ((start[0] + end[0]) // 2, (start[1] + end[1]) // 2)
        viewer.do("mousemove", *start)
        steady(self.screen, box)
        viewer.do("mousedown", button)
        for place in (middle, end):
            self.changes(box, lambda: viewer.do("mousemove", *place), f"the drag from {start} to {place}")
        viewer.do("mouseup", button)
        steady(self.screen, box)

    def rest(self, viewer, box=WHOLE):
        """The picture with the pointer where it does no harm."""
        viewer.do("mousemove", *NOWHERE)
        return steady(self.screen, box)

    def comes_back(self, box, first, what):
        """Waits until a part of the screen looks as it did, to the last pixel."""
        wait_for(lambda: self.screen.part(box) == first, what)

    def blob(self, box, colour, distance=0):
        """A place well within something of this colour."""
        points = self.screen.pixels_like(box, colour, distance)
        self.assertGreater(len(points), 50, f"almost nothing of colour {colour} in {box}")
        return densest(points, 6)

    def pixel_at(self, x, y):
        """Of the picture, fitted into its pane with a margin of 10."""
        zoom = min((IMAGE[2] - 20) / PICTURE[0], (IMAGE[3] - 20) / PICTURE[1])
        return [(x + 0.5 - IMAGE[0] - IMAGE[2] / 2) / zoom + PICTURE[0] / 2, (y + 0.5 - IMAGE[1] - IMAGE[3] / 2) / zoom + PICTURE[1] / 2]

    # Mouse

    def test_a_click_on_the_picture_chooses_the_pixel_under_the_pointer(self):
        viewer = self.view()
        viewer.click(330, 300)
        viewer.click(100, 110)
        state = viewer.quit()
        for got, expected in zip(state["pixel"], self.pixel_at(100, 110)):
            self.assertAlmostEqual(got, expected, delta=2)  # a pixel of the screen is 1.6 of the picture
        self.assertEqual(state["selected"], 0)

    def test_zoomed_and_moved_the_same_pixel_stays_under_the_pointer(self):
        x, y = 150, 180
        viewer = self.view()
        fitted = self.rest(viewer, IMAGE)
        viewer.do("mousemove", x, y)
        self.changes(IMAGE, lambda: viewer.do("click", 5), "the wheel over the picture")
        viewer.do("mousemove", *NOWHERE, "key", "r")
        self.comes_back(IMAGE, fitted, "key r to fit the picture")
        viewer.do("mousemove", x, y)
        self.changes(IMAGE, lambda: viewer.do("click", "--repeat", 4, 4), "the wheel over the picture")
        self.drag(viewer, (x, y), (x + 40, y - 30), IMAGE)
        viewer.click(x + 40, y - 30)
        viewer.click(SCENE[0] + 40, 8)  # in the title: nothing
        state = viewer.quit()
        for got, expected in zip(state["pixel"], self.pixel_at(x, y)):
            self.assertAlmostEqual(got, expected, delta=2)

    def test_a_changed_scene_is_one_for_the_view_and_for_programs(self):
        lesson, file, answers = self.folder / "lesson", self.folder / "mine.toml", self.folder / "answers"
        # The lesson, which leaves a word when it has answered about a tree.
        lesson.write_text(f'''#!/bin/sh
            '{PROGRAM.parent}/lesson06' "$@" || exit
            case "$*" in *--out*) ;; *) echo answered >> '{answers}' ;; esac
            ''')
        lesson.chmod(0o755)
        answers.write_text("")
        glass = (ROOT / "lessons/06_fresnel/scenes/half_and_glass.toml").read_text()
        file.write_text(glass)
        viewer = self.view(6, "mine.toml", "--compare", lesson)
        wait_for(answers.read_text, "the program's first answer")
        first = self.rest(viewer, SCENE)
        self.changes(BOTTOM, lambda: file.write_text("[[sphere\n"), "the word that it is no scene")
        self.assertEqual(self.screen.part(SCENE), first)
        before = len(answers.read_text())
        self.changes(SCENE, lambda: file.write_text(glass.replace("radius = 1.0", "radius = 0.7")), "the scene in space")
        wait_for(lambda: len(answers.read_text()) > before, "the program's answer")
        self.rest(viewer)
        state = viewer.quit()
        self.assertEqual(state["comparison"]["nodes"], state["nodes"])
        self.assertEqual((state["comparison"]["first_difference"], state["message"]), (None, ""))
        self.assertEqual(state["nodes"], len(self.tree(6, "mine.toml")))

    def test_the_view_is_fitted_when_a_slow_tree_comes(self):
        self.tree(3)
        program = self.folder / "tracer"
        program.write_text("#!/bin/sh\nsleep 2\ncat tree.json\n")
        program.chmod(0o755)
        viewer = self.view(3, "--tracer", program)
        wait_for(lambda: self.screen.pixels_like(TREE, REFLECTED), "the tree")
        first = self.rest(viewer, SCENE)
        viewer.keys("r", "l", "l")
        self.assertTrue(self.rest(viewer, SCENE) == first)
        viewer.quit()

    def test_a_click_on_a_node_of_the_tree_selects_it(self):
        nodes = self.tree()
        viewer = self.view()
        reflected, transmitted = self.blob(TREE, REFLECTED), self.blob(TREE, TRANSMITTED)
        for place in (reflected, transmitted):
            self.changes(CODE, lambda: viewer.click(*place), f"the click on the tree at {place}")
        chosen = viewer.quit()["selected"]
        self.assertEqual(nodes[chosen]["kind"], "transmitted")

    def test_a_click_on_a_ray_in_space_selects_it(self):
        viewer = self.view()
        viewer.keys("g", "5", "Return")
        self.rest(viewer)
        # Lit tubes are of many shades; the camera's ray is by far the thickest.
        place = self.blob((SCENE[0] + 60, SCENE[1] + 100, SCENE[2] - 200, SCENE[3] - 180), CAMERA, 45)
        self.changes(CODE, lambda: viewer.click(*place), f"a click on the camera's ray at {place}")
        self.assertEqual(viewer.quit()["selected"], 0)

    def test_dragging_in_space_turns_the_view_and_selects_nothing(self):
        viewer = self.view()
        first = self.rest(viewer, SCENE)
        for button, start, end in ((1, (700, 250), (800, 290)), (2, (700, 250), (730, 230)), (3, (700, 250), (700, 300))):
            self.drag(viewer, start, end, SCENE, button)
        for wheel in (4, 5):
            viewer.do("mousemove", 760, 260)
            self.changes(SCENE, lambda: viewer.do("click", wheel), "the wheel in space")
        viewer.do("mousemove", *NOWHERE, "key", "r")
        self.comes_back(SCENE, first, "key r to show what was shown at the start")
        state = viewer.quit()
        self.assertEqual((state["selected"], state["step"], state["event"]), (0, state["last_step"], None))

    def knobs(self):
        """Places of the three sliders: first and last x of what is filled, the knob at its end; and their height."""
        middle = SLIDERS[1] + SLIDERS[3] // 2
        found = []
        for y in range(SLIDERS[1], SLIDERS[1] + SLIDERS[3]):
            row = [run for run in runs(self.screen.pixels_like((SLIDERS[0], y, SLIDERS[2], 1), ACCENT, 30)) if run[1] - run[0] >= 2]
            if len(row) >= 3 and sum(b - a for a, b in row) > sum(b - a for a, b in found):
                found, middle = row, y
        self.assertGreaterEqual(len(found), 3, "three sliders")
        # The hole of a knob may part it from what is filled.
        joined = [found[0]]
        for run in found[1:]:
            if run[0] - joined[-1][1] < 16:
                joined[-1] = [joined[-1][0], run[1]]
            else:
                joined.append(run)
        self.assertEqual(len(joined), 3, joined)
        return joined, middle

    def test_sliders_are_pressed_and_dragged(self):
        viewer = self.view()
        self.rest(viewer)
        (_, depth, _), y = self.knobs()
        # 8 is shown: half of what is filled is 4. The knob reaches 7 to both sides of its place.
        self.changes(TREE, lambda: viewer.click((depth[0] + depth[1] - 5) // 2, y), "the press on the slider of the depth")
        self.rest(viewer)
        (step, _, weak), y = self.knobs()
        self.drag(viewer, (step[1] - 7, y), ((step[0] + step[1] - 5) // 2, y), BOTTOM)
        self.drag(viewer, ((weak[0] + weak[1]) // 2, y), (WIDTH - 3, y), BOTTOM)
        state = viewer.quit()
        self.assertEqual((state["max_depth"], state["nodes"]), (4, len(self.tree(6, "--depth", 4))))
        self.assertAlmostEqual(state["step"], state["last_step"] / 2, delta=2)
        self.assertEqual(state["weakest"], 1)
        self.assertEqual(state["shown_nodes"], [0])

    def test_what_is_shown_can_be_clicked_away(self):
        viewer = self.view()
        lower = (0, HEIGHT - STRIP // 2, 500, STRIP // 2)
        for colour in (REFLECTED, TRANSMITTED):
            x, y = self.blob(lower, colour)
            self.changes(lower, lambda: viewer.click(x, y), "the click on a kind of rays")
        state = viewer.quit()
        self.assertEqual({kind for kind, shown in state["kinds"].items() if not shown}, {"reflected", "transmitted"})
        self.assertEqual(state["shown_nodes"], [0])

    # Playing

    def play_button(self):
        button = (60, BOTTOM[1] + 4, 70, 34)
        xs, ys = zip(*self.screen.pixels_like(button, ACCENT))
        return (min(xs) + max(xs)) // 2, (min(ys) + max(ys)) // 2

    def test_the_button_plays_and_space_pauses(self):
        viewer = self.view()
        self.rest(viewer)
        viewer.click(*self.play_button())
        viewer.do("mousemove", *NOWHERE)

        def steps(count):
            for _ in range(count):
                before = self.screen.part(CODE)
                wait_for(lambda: self.screen.part(CODE) != before, "the next step")
        steps(3)
        viewer.keys("space")
        paused = steady(self.screen, CODE)
        time.sleep(1.2)  # two steps, if it played
        self.assertEqual(self.screen.part(CODE), paused)
        viewer.keys("space")
        steps(1)
        state = viewer.quit()
        self.assertTrue(state["playing"])
        self.assertTrue(2 <= state["step"] < state["last_step"], state["step"])

    # Keys

    def test_keys_step(self):
        for keys, step in ((["Home", "Left", "Right", "Right", "Right", "Left"], 2), (["Home", "End", "Left", "Left", "Right"], -1)):
            viewer = self.view()
            viewer.keys(*keys)
            state = viewer.quit()
            self.assertEqual(state["step"], step % state["last_step"], keys)
            self.assertIsNotNone(state["event"])

    def test_keys_that_repeat_are_not_drawn_one_by_one(self):
        viewer = self.view()

        def cost(act):
            before = viewer.processor_time()
            act()
            self.rest(viewer)
            return viewer.processor_time() - before
        viewer.keys("Home")
        self.rest(viewer)
        idle = cost(lambda: None)
        one = max(cost(lambda: viewer.keys("Right")) - idle, 1)
        many = cost(lambda: viewer.do("key", "--delay", 0, *["Right"] * 40)) - idle
        self.assertLess(many, 15 * one)
        state = viewer.quit()
        self.assertEqual(state["step"], 41)

    def test_keys_choose_rays_depth_and_what_is_shown(self):
        nodes = self.tree(6, "--depth", 7)
        viewer = self.view()
        viewer.keys("bracketleft", "bracketleft", "bracketright", "2", "4", "5", "5", "n", "l", "h", "Escape")
        viewer.keys("g", "9", "1", "BackSpace", "BackSpace", "1", "2", "Return", "Down", "Down", "Up", "Prior")
        state = viewer.quit()
        self.assertEqual((state["max_depth"], state["nodes"]), (7, len(nodes)))
        self.assertEqual(state["selected"], nodes[13]["parent"])
        self.assertEqual({kind for kind, shown in state["kinds"].items() if not shown}, {"reflected", "lit"})
        self.assertEqual((state["normals"], state["look"], state["help"], state["message"]), (False, "light", False, ""))

    def test_the_viewer_can_be_left_while_its_picture_is_refined(self):
        viewer = self.view(6, "--size", "1200x900", "--spp", 4)
        coarse = self.screen.part(IMAGE)
        viewer.keys("bracketleft", "bracketleft")
        wait_for(lambda: self.screen.part(IMAGE) != coarse, "a coarse picture")
        self.assertEqual(viewer.quit()["max_depth"], 6)

    def test_the_window_is_there_before_its_picture_and_can_be_left(self):
        desktop = xdesktop.Desktop(self.screen)
        self.addCleanup(desktop.close)
        for way in ("key", "button", "signal"):
            viewer = Viewer(self.screen, PROGRAM, self.folder, 6, "--spp", 20000, rests=False)  # would take hours
            self.addCleanup(viewer.stop)
            wait_for(lambda: self.screen.pixels_like(TREE, REFLECTED), "the tree")
            if way == "key":
                viewer.keys("Home", "Right")
                state = viewer.quit()
                self.assertEqual(state["step"], 1)
                self.assertLess(state["painted"], 1)
            elif way == "button":
                found = subprocess.run(["xdotool", "search", "--name", "raytree"], env=self.screen.env, capture_output=True, text=True).stdout
                desktop.ask_to_close(int(found.split()[0]))
                self.assertEqual(viewer.process.wait(PATIENCE), 0)
            else:
                viewer.process.send_signal(signal.SIGINT)
                self.assertEqual(viewer.process.wait(PATIENCE), 130)
            viewer.stop()

    def test_a_heavy_picture_gets_finer_and_is_whole_at_last(self):
        viewer = Viewer(self.screen, PROGRAM, self.folder, 6, "--spp", 64, rests=False)
        self.addCleanup(viewer.stop)
        wait_for(lambda: self.screen.pixels_like(TREE, REFLECTED), "the tree")
        looks = {self.screen.part(IMAGE)}
        wait_for(lambda: looks.add(self.screen.part(IMAGE)) or len(looks) > 2, "finer pictures")
        steady(self.screen, WHOLE)
        self.assertEqual(viewer.quit()["painted"], 1)

    def test_what_a_key_does_does_not_depend_on_where_the_pointer_is(self):
        keys = ["Home", "Right", "Right", "shift+Right", "shift+Right", "shift+Left", "shift+Down", "Home", "Right", "Right", "Down"]
        states = []
        for place in (216, 208), (700, 300), (1300, 300), (200, 600), NOWHERE, (700, HEIGHT - 20):
            viewer = self.view(6, "--pixel", "300,200")
            viewer.do("mousemove", *place)
            viewer.keys(*keys, "m", "n")
            states.append({**viewer.quit(), "hovered": None})
        self.assertEqual((states[0]["pixel"], states[0]["step"]), ([301, 201], 2))
        for state in states:
            self.assertEqual(state, states[0])

    def test_capital_letters_do_what_small_ones_do(self):
        for way in (lambda key: f"shift+{key}"), (lambda key: key.upper()):
            viewer = self.view()
            viewer.keys(*map(way, "nlhc"))
            state = viewer.quit()
            self.assertEqual((state["normals"], state["look"], state["help"]), (False, "light", True))
            self.assertIn("--compare", state["message"])

    def caps(self):
        """The key caps of the bottom row, as boxes from the left: runs of their colour in one row of pixels, above the letters."""
        y = HEIGHT - STRIP // 4 - 7
        return [run for run in runs(self.screen.pixels_like((600, y, WIDTH - 600, 1), RAISED)) if run[1] - run[0] > 8]

    def test_key_caps_are_buttons(self):
        y, did = HEIGHT - STRIP // 4, []
        for i in range(3):  # h; the arrows, which lie side by side; Space
            viewer = self.view()
            self.rest(viewer)
            viewer.click(self.caps()[i][0] + 6, y)
            state = viewer.quit()
            did.append((state["help"], state["step"] - state["last_step"]))
        self.assertEqual(did[:2], [(True, 0), (False, -1)])
        self.assertTrue(state["playing"])

    def test_caps_of_the_cheat_sheet_are_buttons(self):
        viewer = self.view()
        viewer.keys("h")
        self.rest(viewer)
        # The lowest cap, key q, ends the viewer.
        x, y = max(self.screen.pixels_like((0, TITLE, WIDTH, HEIGHT - TITLE - STRIP - 2), RAISED), key=lambda place: (place[0] > WIDTH // 2, place[1]))
        viewer.click(x, y - 3)
        viewer.process.wait(PATIENCE)
        self.assertEqual(viewer.quit()["help"], False)

    def test_play_has_a_speed(self):
        viewer = self.view()
        viewer.keys("comma", *["period"] * 9, "comma")
        state = viewer.quit()
        self.assertEqual((state["speed"], state["message"], state["tone"]), (32, "plays 32 steps a second", "done"))

    def test_letters_grow_and_shrink(self):
        viewer = self.view()
        first = self.rest(viewer)
        self.changes(TREE, lambda: viewer.keys("plus"), "larger letters")
        self.changes(TREE, lambda: viewer.keys("minus", "minus"), "smaller letters")
        viewer.keys("plus")
        self.comes_back(WHOLE, first, "the letters of the start")
        viewer.quit()

    def labels(self, colour):
        """The middles of the plates of this colour in space, from the left."""
        plates = []
        for x, y in self.screen.pixels_like((SCENE[0], SCENE[1], SCENE[2], SCENE[3] - 60), colour):  # above the legend
            for plate in plates:
                if abs(plate[0] - x) < 30 and abs(plate[1] - y) < 24:
                    plate[2].append((x, y))
                    break
            else:
                plates.append((x, y, [(x, y)]))
        found = [points for _, _, points in plates if len(points) > 120]
        return sorted((sum(x for x, _ in points) // len(points), sum(y for _, y in points) // len(points)) for points in found)

    def test_labels_in_space_can_be_clicked_and_stay_where_they_are(self):
        viewer = self.view(3)
        self.rest(viewer)
        places, chosen = self.labels(REFLECTED), set()
        self.assertEqual(len(places), 2)
        viewer.quit()
        for place in places:
            viewer = self.view(3)
            viewer.click(*place)
            self.rest(viewer)
            for (x, y), (x0, y0) in zip(self.labels(REFLECTED), places):
                self.assertLess(abs(x - x0) + abs(y - y0), 4)
            chosen.add(viewer.quit()["selected"])
        self.assertEqual(chosen, {1, 2})

    def test_a_ray_that_is_not_there_is_told(self):
        viewer = self.view()
        viewer.keys("g", "9", "9", "9", "Return", "g", "7", "q", "Escape")  # within a number q is no order, and Escape leaves it
        state = viewer.quit()
        self.assertEqual(state["selected"], 0)
        self.assertIn("999", state["message"])

    def test_compared_trees_are_switched_and_their_difference_found(self):
        words = (6, "--compare", "depth=2")
        first = self.scripted(*words)["comparison"]["first_difference"]
        viewer = self.view(*words)
        viewer.keys("d", "c")
        state = viewer.quit()
        self.assertEqual((state["selected"], state["comparison"]), (first["expected_node"], None))
        self.assertNotEqual(state["selected"], 0)

    def test_panes_are_enlarged_one_after_the_other(self):
        viewer = self.view()
        first = self.rest(viewer)
        middle = (1150, 100, 440, 600)  # shows another thing with each pane
        for _ in range(6):
            self.changes(middle, lambda: viewer.keys("m"), "the next pane")
        viewer.keys("m")
        self.comes_back(WHOLE, first, "all panes after the last one")
        viewer.click(TREE[0] + 20, TREE[1] + TREE[3] - 20)  # an empty corner
        tree = self.changes(SCENE, lambda: viewer.keys("m"), "the pane that was clicked")
        viewer.keys("Escape")
        viewer.do("mousemove", *NOWHERE)
        self.comes_back(WHOLE, first, "key Escape to give all panes back")
        self.assertNotEqual(tree, self.changes(SCENE, lambda: viewer.keys("m", "m"), "the pane after it"))
        viewer.quit()

    def test_keys_of_vtk_do_nothing(self):
        viewer = self.view()
        first = self.rest(viewer)
        viewer.do("mousemove", 760, 260)  # they mean the scene below the pointer
        viewer.keys("w", "s", "p", "f", "i", "u", "j", "a", "o", "z", "x", "b", "F1", "F5", "Tab", "Delete", "3", "3")
        # Something that is seen, so that all of them have been dealt with.
        self.changes(BOTTOM, lambda: viewer.keys("n"), "key n")
        viewer.keys("n")
        viewer.do("mousemove", *NOWHERE)
        self.comes_back(WHOLE, first, "key n to undo itself")
        self.assertEqual(viewer.quit(), self.scripted())

    def test_keys_with_ctrl_or_alt_do_nothing(self):
        viewer = self.view(6, "--compare", "depth=2")
        first = self.rest(viewer)
        for modifier in ("ctrl", "alt", "ctrl+shift"):
            viewer.keys(*(f"{modifier}+{key}" for key in ("c", "d", "n", "l", "h", "2", "g", "Left", "bracketleft", "space", "e", "q")))
        self.changes(BOTTOM, lambda: viewer.keys("n"), "key n")
        viewer.keys("n")
        self.comes_back(WHOLE, first, "key n to undo itself")
        self.assertEqual(viewer.quit(), self.scripted(6, "--compare", "depth=2"))
        self.assertFalse((self.folder / "raytree-export").exists())

    def test_pictures_and_exports_are_written_and_nothing_overwritten(self):
        (self.folder / "raytree.png").write_text("mine")
        viewer = self.view()
        viewer.keys("F12", "n", "F12", "e")
        state = viewer.quit()
        self.assertEqual((self.folder / "raytree.png").read_text(), "mine")
        shots = [(self.folder / f"raytree-{i}.png").read_bytes() for i in (2, 3)]
        self.assertTrue(all(shot.startswith(b"\x89PNG") for shot in shots))
        self.assertNotEqual(*shots)
        files = {path.suffix for path in (self.folder / "raytree-export").iterdir()}
        self.assertLessEqual({".json", ".vtp", ".glb", ".gltf", ".html"}, files)
        self.assertEqual((state["message"], state["tone"]), ("raytree-export: 6 files written", "done"))
        self.assertEqual([path for path in self.folder.rglob("*part*")], [])

    # The window

    def test_the_window_can_be_resized(self):
        viewer = self.view()
        first = self.rest(viewer)
        window = subprocess.run(["xdotool", "search", "--name", "^raytree: 06 Fresnel, Spheres: one 50%"], env=self.screen.env, capture_output=True, text=True).stdout.split()[0]
        right = (1300, 60, 280, 700)
        self.changes(right, lambda: viewer.do("windowsize", window, 1280, 720), "the smaller window")
        viewer.do("mousemove", 172, 168)  # the middle of the picture now
        viewer.click(172, 168)
        steady(self.screen, IMAGE)
        for size in ((300, 200), (801, 455), (1, 1), (WIDTH, HEIGHT)):
            viewer.do("windowsize", window, *size)
            steady(self.screen, WHOLE)
        viewer.do("mousemove", *NOWHERE)
        self.assertNotEqual(first, steady(self.screen, WHOLE))  # another pixel
        state = viewer.quit()
        self.assertAlmostEqual(state["pixel"][0], 320, delta=4)
        self.assertAlmostEqual(state["pixel"][1], 240, delta=4)

    def test_clicking_wildly_does_no_harm(self):
        dice = random.Random(20)
        keys = ["Up", "Down", "Left", "Right", "Home", "End", "space", "Prior", "bracketleft", "bracketright", "1", "2", "3", "4", "5",
                "n", "c", "d", "l", "h", "m", "g", "7", "Return", "Escape", "r", "t", "w", "slash", "question", "BackSpace"]
        viewer = self.view(6, "--compare", "schlick")
        words = []
        for _ in range(90):
            words += ["mousemove", dice.randrange(WIDTH), dice.randrange(HEIGHT)]
            what = dice.randrange(8)
            if what < 4:
                words += ["click", dice.choice((1, 1, 1, 2, 3, 4, 5))]
            elif what < 5:
                words += ["mousedown", 1, "mousemove", dice.randrange(WIDTH), dice.randrange(HEIGHT), "mouseup", 1]
            else:
                words += ["key", dice.choice(keys)]
        words += ["mouseup", 1, "mouseup", 2, "mouseup", 3, "key", "Escape", "key", "Escape", "key", "Escape"]
        viewer.do(*words)
        state = viewer.quit()
        self.assertTrue(0 <= state["pixel"][0] < PICTURE[0] and 0 <= state["pixel"][1] < PICTURE[1])
        self.assertTrue(0 <= state["selected"] < state["nodes"])
        self.assertTrue(0 <= state["step"] <= state["last_step"])
        self.assertEqual(set(state["kinds"]), KINDS)


if __name__ == "__main__":
    if missing():
        print(f"skipped: {missing()}")
        sys.exit(77)
    unittest.main()
