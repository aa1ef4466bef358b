#!/usr/bin/env python3
"""Every scene of the repository renders, small, with the first lesson that models it; it shows more than one colour, and its
pixel has a ray tree.

    check_scenes.py FOLDER_OF_PROGRAMS
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from texts import FOLDERS, ROOT, finish, name, problem

BIN = pathlib.Path(sys.argv[1]).resolve()
SIZE = "32x24"


def scenes():
    """Files with a camera or objects: all .toml files of the project below a folder scenes/, wherever it is. A class's marks, which
    have such folders too, are not the project's."""
    return sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("scenes/*.toml"))


def check(scene):
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder) / "p.ppm"
        done = subprocess.run([str(BIN / "render"), str(scene), "--size", SIZE, "--out", str(picture), "--tree", "json"], capture_output=True, timeout=600)
        if done.returncode:
            problem(scene, 1, f"does not render: {done.stderr.decode().strip()}")
            return
        pixels = re.sub(rb"^P6\s+\d+\s+\d+\s+\d+\s", b"", picture.read_bytes())
    if len(set(zip(pixels[::3], pixels[1::3], pixels[2::3]))) < 2:
        problem(scene, 1, "all pixels of the picture have the same colour")
    if not any(node.get("hit") for node in json.loads(done.stdout)["nodes"]):
        problem(scene, 1, "the ray through its pixel meets nothing")


if not (BIN / "render").exists():
    sys.exit(f"check_scenes: {BIN} has no program `render`; build everything first")
found = scenes()
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    list(pool.map(check, found))
named = {path.parent.parent.name for path in found}
for lesson in sorted(ROOT.glob("lessons/0[1-9]_*")):
    if lesson.name not in named:
        problem(lesson, 1, "has no scenes")
finish(f"{len(found)} scenes rendered")
