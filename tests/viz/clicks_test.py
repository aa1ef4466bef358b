#!/usr/bin/env python3
"""The viewer's window under real mouse and key events, and recordings of them.

    clicks_test.py VIEWER

Exit code 77: there is no Xvfb or no xdotool, and nothing was tested.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

if not shutil.which("xdotool") or not shutil.which("Xvfb"):
    print("SKIPPED: real clicks need the programs Xvfb and xdotool", file=sys.stderr)
    sys.exit(77)

VIEWER = pathlib.Path(sys.argv.pop(1)).resolve()
WIDTH, HEIGHT = 1600, 900
# Where things are at that size, from the upper left corner; see layoutFor.
PICTURE = (13, 56, 405, 304)  # x, y, width, height of 640 x 480 pixels
SCENE, CODE = (780, 200), (780, 650)
ROOT_IN_TREE = (1162, 286)  # lesson 06: the camera ray's circle
STEPS, CAP = (246, 629, 842), (846, 1071, 842)  # sliders: left end, right end, y
PLAY = (97, 842)


class Window(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)
        self.server = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-noreset"],
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.addCleanup(self.stop_server)
        self.environment = {**os.environ, "DISPLAY": ":" + self.server.stdout.readline().decode().strip()}

    def stop_server(self):
        self.server.terminate()
        self.server.wait()
        self.server.stdout.close()

    def open(self, *words):
        self.viewer = subprocess.Popen([VIEWER, *map(str, words), "--size-window", f"{WIDTH}x{HEIGHT}", "--state", "state.json"],
                                       cwd=self.here, env=self.environment, stderr=subprocess.PIPE)
        self.send("search", "--sync", "--onlyvisible", "--name", "^raytree$")
        time.sleep(1)

    def send(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True, stdout=subprocess.DEVNULL, timeout=60)

    def point(self, x, y):
        self.send("mousemove", x, y)
        time.sleep(0.1)

    def click(self, x, y):
        self.point(x, y)
        self.send("click", 1)

    def drag(self, x, y, to_x, to_y):
        self.point(x, y)
        self.send("mousedown", 1)
        for t in (0.3, 0.6, 1):
            self.point(int(x + t * (to_x - x)), int(y + t * (to_y - y)))
        self.send("mouseup", 1)

    def keys(self, *names):
        """With the pointer over the code, where keys mean the same as everywhere but over the picture."""
        self.point(*CODE)
        for name in names:
            self.send("key", name)

    def close(self):
        self.keys("q")
        _, error = self.viewer.communicate(timeout=60)
        self.assertEqual(self.viewer.returncode, 0, error.decode())
        return json.loads((self.here / "state.json").read_text())

    def pixel(self, x, y):
        """Where a pixel of the picture is in the window."""
        return round(PICTURE[0] + (x + 0.5) * PICTURE[2] / 640), round(PICTURE[1] + (y + 0.5) * PICTURE[3] / 480)

    def picture(self, name):
        """Of the window as it is, by its own key."""
        count = len(list(self.here.glob("raytree*.png")))
        self.point(*CODE)
        self.send("key", "F12")
        for _ in range(200):
            files = sorted(self.here.glob("raytree*.png"), key=lambda path: path.stat().st_mtime_ns)
            if len(files) > count:
                break
            time.sleep(0.1)
        else:
            self.fail(f"{name}: F12 wrote no picture")
        self.send("key", "Escape")  # takes the message away that says so
        return files[-1].read_bytes()

    def test_a_click_on_the_picture_chooses_the_pixel_under_it(self):
        self.open(6)
        self.click(*self.pixel(200, 300))
        state = self.close()
        self.assertLessEqual(abs(state["pixel"][0] - 200) + abs(state["pixel"][1] - 300), 4, state["pixel"])

    def test_keys_step_select_and_show(self):
        self.open(6)
        self.keys("Home", "Right", "Right", "Right", "Left", "n", "2", "5", "l", "bracketleft", "shift+Left", "shift+Up")
        state = self.close()
        self.assertEqual((state["normals"], state["look"], state["max_depth"]), (False, "light", 7))
        self.assertEqual((state["kinds"]["reflected"], state["kinds"]["blocked"], state["kinds"]["camera"]), (False, False, True))
        self.assertEqual(state["pixel"], [419, 195])

    def test_steps_go_on_and_back_and_nodes_up_and_down(self):
        self.open(6)
        self.keys("Home", "Right", "Right", "Right", "Left")
        self.assertEqual(self.close()["step"], 2)
        self.open(6)
        self.keys("Down", "Down", "Down", "Up", "Prior")
        state = self.close()
        self.assertEqual(state["selected"], 0)
        self.assertEqual(state["step"], state["last_step"])

    def test_the_keys_of_the_library_do_no_harm(self):
        self.open(6)
        before = self.picture("before")
        self.keys("w", "s", "p", "f", "i", "u", "j", "F5")
        self.assertEqual(self.picture("after"), before)
        self.close()

    def test_the_tree_is_clicked_and_a_node_is_found_by_its_number(self):
        self.open(6)
        self.keys("g", "1", "2", "Return")
        self.assertEqual(self.close()["selected"], 12)
        self.open(6, "--pixel", "420,196")
        self.keys("Down", "Down")
        self.click(*ROOT_IN_TREE)
        self.assertEqual(self.close()["selected"], 0)

    def test_sliders_are_dragged(self):
        self.open(6)
        left, right, y = STEPS
        self.drag(right, y, (left + right) // 2, y)
        left, right, y = CAP
        self.drag(left + (right - left) * 8 // 10, y, left, y)
        self.assertEqual(self.close()["max_depth"], 0)

    def test_playing_goes_on_by_itself(self):
        self.open(2)
        self.click(*PLAY)
        time.sleep(2)
        self.keys("space")
        state = self.close()
        self.assertGreater(state["step"], 0)
        self.assertFalse(state["playing"])

    def test_a_drag_turns_the_scene_and_selects_nothing(self):
        self.open(6)
        before = self.picture("before")
        self.drag(*SCENE, SCENE[0] + 150, SCENE[1] + 40)
        self.assertNotEqual(self.picture("after"), before)
        self.assertEqual(self.close()["selected"], 0)

    def test_wild_clicking_leaves_it_alive(self):
        self.open(7)
        for i in range(60):
            self.send("mousemove", 20 + 353 * i % (WIDTH - 40), 20 + 211 * i % (HEIGHT - 40), "click", 1 + i % 5)
        self.keys("Escape")
        self.close()

    def test_what_was_recorded_is_done_again(self):
        self.open(6, "--record", "events.log")
        self.click(*self.pixel(300, 260))
        self.keys("Home", "Right", "Right", "Right", "n", "3", "l")
        self.click(*self.pixel(500, 200))
        self.keys("Down")
        recorded = self.close()
        self.assertNotIn("TimerEvent", (self.here / "events.log").read_text())
        done = subprocess.run([VIEWER, "6", "--play", "events.log", "--script", "state again.json", "--size-window", f"{WIDTH}x{HEIGHT}"],
                              cwd=self.here, env=self.environment, capture_output=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        again = json.loads((self.here / "again.json").read_text())
        for key in ("pixel", "selected", "step", "normals", "kinds", "look", "max_depth"):
            self.assertEqual(again[key], recorded[key], key)

    def test_a_recording_that_is_not_there_is_refused(self):
        done = subprocess.run([VIEWER, "2", "--play", "absent.log", "--script", "next"], cwd=self.here, env=self.environment, capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count(b"\n"), 1)


if __name__ == "__main__":
    unittest.main()
