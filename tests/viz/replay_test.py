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

VIEWER = pathlib.Path(sys.argv[1]).resolve()
NO_DISPLAY = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
problems = []
recordings = sorted((pathlib.Path(__file__).parent / "replays").glob("*.log"))
for log in recordings:
    expected = json.loads(log.with_suffix(".json").read_text())
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([VIEWER, *expected["arguments"], "--size-window", "1600x900", "--play", log.resolve(), "--script", "state state.json"],
                              cwd=folder, env=NO_DISPLAY, capture_output=True, timeout=120)
        if done.returncode != 0:
            problems.append(f"{log.name}: exit code {done.returncode}: {done.stderr.decode()}")
            continue
        state = json.loads((pathlib.Path(folder) / "state.json").read_text())
    state["comparison"] = state["comparison"] is not None
    problems += [f"{log.name}: {key} is {state[key]}, expected {value}" for key, value in expected["state"].items() if state[key] != value]
print("\n".join(problems) or f"{len(recordings)} recordings replayed")
sys.exit(bool(problems) or len(recordings) < 6)
