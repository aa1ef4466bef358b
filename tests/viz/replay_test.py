#!/usr/bin/env python3
"""Recorded mouse and key events lead to the states that they led to when they were recorded.

    replay_test.py VIEWER

Each recording in replays/ has a .json file of the same name: the viewer's arguments and what its state must then say. New ones:
`viewer ... --size-window 1600x900 --record NAME.log --state STATE.json`.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import xdesktop
import xscreen

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import skips  # noqa: E402

VIEWER = pathlib.Path(sys.argv.pop(1)).resolve()
REPLAYS = pathlib.Path(__file__).parent / "replays"
NO_DISPLAY = {key: value for key, value in os.environ.items() if key != "DISPLAY"}


class Replays(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def play(self, log, arguments=("6",), env=NO_DISPLAY):
        """Without a display the viewer starts one for itself, which takes a while."""
        return subprocess.run([VIEWER, *arguments, "--size-window", "1600x900", "--play", log, "--script", "state state.json"],
                              cwd=self.folder, env=env, capture_output=True, text=True, timeout=6000)

    def state(self, log, arguments=("6",), env=NO_DISPLAY):
        done = self.play(log, arguments, env)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / "state.json").read_text())

    def test_recordings_lead_to_their_states(self):
        recordings = sorted(REPLAYS.glob("*.log"))
        self.assertGreaterEqual(len(recordings), 6)
        env = NO_DISPLAY
        if not xscreen.missing():
            screen = xscreen.Screen()
            self.addCleanup(screen.close)
            env = screen.env
        for log in recordings:
            with self.subTest(log.name):
                expected = json.loads(log.with_suffix(".json").read_text())
                state = self.state(log.resolve(), expected["arguments"], env)
                state["comparison"] = state["comparison"] is not None
                self.assertEqual({key: state[key] for key in expected["state"]}, expected["state"])

    @unittest.skipIf(xscreen.missing(), xscreen.missing())
    def test_what_is_recorded_can_be_played(self):
        screen = xscreen.Screen()
        self.addCleanup(screen.close)
        viewer = xscreen.Viewer(screen, VIEWER, self.folder, 6, "--record", "mine.log")
        self.addCleanup(viewer.stop)
        viewer.click(100, 110)
        viewer.do("mousemove", 700, 20)
        viewer.keys("bracketleft", "Home", "i", "e", "Right", "Right", "shift+Down", "n", "space")
        before = screen.part((432, 480, 704, 342))
        xscreen.wait_for(lambda: screen.part((432, 480, 704, 342)) != before, "the next step")
        viewer.keys("space", "End", "Left", "2")
        recorded = viewer.quit()
        self.assertEqual(list(self.folder.glob("*.part")), [])
        events = [line.split() for line in (self.folder / "mine.log").read_text().splitlines()]
        self.assertEqual([event for event in events if event[0] == "TimerEvent" or event[-1] == "q"], [])
        played = self.state("mine.log")
        # Key e has written its files again, and its message goes away with time.
        self.assertEqual({**played, "message": ""}, {**recorded, "message": ""})
        self.assertNotEqual(played["pixel"], [420, 196])

    @unittest.skipIf(xscreen.missing(), xscreen.missing())
    def test_the_close_button_ends_a_recording_and_writes_it(self):
        screen = xscreen.Screen()
        self.addCleanup(screen.close)
        desktop = xdesktop.Desktop(screen)
        self.addCleanup(desktop.close)
        for words in ((), ("--record", "mine.log")):
            viewer = xscreen.Viewer(screen, VIEWER, self.folder, 6, *words)
            self.addCleanup(viewer.stop)
            viewer.keys("Home", "Right")
            found = subprocess.run(["xdotool", "search", "--name", "^raytree"], env=screen.env, capture_output=True, text=True).stdout
            desktop.ask_to_close(int(found.split()[0]))
            viewer.process.wait(xscreen.PATIENCE)
            self.assertEqual(json.loads((self.folder / "state.json").read_text())["step"], 1)
        self.assertNotIn("ExitEvent", (self.folder / "mine.log").read_text())
        self.assertEqual(self.state("mine.log")["step"], 1)
        self.assertEqual(list(self.folder.glob("*.part")), [])

    def test_what_is_no_recording_is_refused_with_one_sentence(self):
        good = (REPLAYS / "steps.log").read_bytes()
        broken = {
            "empty.log": b"",
            "other.log": b"{}\n",
            "noise.log": bytes(range(256)) * 10,
            "headless.log": good[good.index(b"\n") + 1:],
            "cut.log": good[:-len(good.splitlines()[-1].split()[-1]) - 2],
            "unknown.log": good + b"NoSuchEvent 1 2 0 0 0 0\n",
            "words.log": good + b"KeyPressEvent here there 0 0 1 Home\n",
        }
        for name, content in broken.items():
            (self.folder / name).write_bytes(content)
        for name in [*broken, "absent.log", "."]:
            with self.subTest(name):
                done = self.play(name)
                self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
                self.assertIn(name, done.stderr)
                self.assertFalse((self.folder / "state.json").exists())

    @unittest.skipIf(xscreen.missing(), xscreen.missing())
    def test_a_recording_that_cannot_be_written_is_refused_at_the_start(self):
        screen = xscreen.Screen()
        self.addCleanup(screen.close)
        done = subprocess.run([VIEWER, "6", "--record", "missing/mine.log"], cwd=self.folder, env=screen.env, capture_output=True,
                              text=True, timeout=600)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
        self.assertIn("missing", done.stderr)


if __name__ == "__main__":
    skips.main()
