#!/usr/bin/env python3
"""Every picture of the notes is what the command in slides-notes/pictures/README.md makes.

    check_pictures.py FOLDER_OF_PROGRAMS
"""
import concurrent.futures
import os
import re

import png
from scratch import BIN, Scratch
from texts import NOTES, finish, problem

TABLE = NOTES / "pictures/README.md"
FEWER = 32      # paths for a pixel, where the picture has up to 4096; a row may say more
SQUARE = 20     # pixels; the mean over 400 of them has a twentieth of a pixel's noise
MOST_NOISE = 24  # of 255, the largest difference of two such means. Seen: up to 12.5, with 256 paths in a caustic, which few paths find
MOST_EDGES = 0.02  # of a window's pixels may differ by more than 32 of 255: text and lines, smoothed by another driver. Seen: 0.001


def rows():
    """(line number, picture, command, way of comparing, paths or None)."""
    for number, line in enumerate(TABLE.read_text().splitlines(), 1):
        if match := re.fullmatch(r"\| (\S+\.(?:png|svg)) \| `([^`]+)` \| (\w+)(?: (\d+))? \|", line):
            yield number, *match.groups()


def means(picture):
    """Mean of each channel of each square."""
    width, height, lines = picture
    found = []
    for top in range(0, height - SQUARE + 1, SQUARE):
        for left in range(0, width - SQUARE + 1, SQUARE):
            parts = [line[3 * left:3 * (left + SQUARE)] for line in lines[top:top + SQUARE]]
            found += [sum(sum(part[channel::3]) for part in parts) / SQUARE**2 for channel in range(3)]
    return found


def difference(made, stored, way):
    """What is wrong with the picture that was made, or None."""
    if made.read_bytes() == stored.read_bytes():
        return None
    if stored.suffix == ".svg":
        return "is not what the command draws"
    a, b = png.read(made), png.read(stored)
    if a[:2] != b[:2]:
        return f"has {b[0]}x{b[1]} pixels, the command makes {a[0]}x{a[1]}"
    if way == "samples":
        worst = max(abs(x - y) for x, y in zip(means(a), means(b)))
        return f"differs from what the command makes by {worst:.1f} of 255 in the mean of a square" if worst > MOST_NOISE else None
    off = sum(abs(x - y) > (32 if way == "window" else 0) for one, other in zip(a[2], b[2]) for x, y in zip(one, other)) / (3 * a[0] * a[1])
    if off > (MOST_EDGES if way == "window" else 0):
        return f"differs from what the command makes in {100 * off:.2f} % of its values"
    return None


def check(scratch, number, picture, command, way, paths):
    """True if the picture was made again."""
    stored = NOTES / "pictures" / picture
    if not stored.exists():
        problem(TABLE, number, f"there is no picture {picture}")
        return False
    if way == "timings" or (way == "window" and not (BIN / "viewer").exists()):
        return False
    if way not in ("equal", "samples", "window"):
        problem(TABLE, number, f"{picture}: compared how? '{way}' is none of equal, samples, window, timings")
        return False
    here = scratch.clone(picture)
    code, output = scratch.run(re.sub(r"--spp \d+", f"--spp {paths or FEWER}", command) if way == "samples" else command, here)
    made = here / re.sub(r"^00_", "", picture) if (here / re.sub(r"^00_", "", picture)).exists() else here / picture
    if code or not made.exists():
        problem(TABLE, number, f"'{command}' does not make {picture}: {(output.strip().splitlines() or ['no output'])[-1]}")
    elif wrong := difference(made, stored, way):
        problem(TABLE, number, f"{picture} {wrong}; look at both, then store the new one: {command}")
    return True


listed = list(rows())
for path in sorted((NOTES / "pictures").iterdir()):
    if path.suffix in (".png", ".svg") and path.name not in {row[1] for row in listed}:
        problem(TABLE, 1, f"no row says how {path.name} is made")
scratch = Scratch()
try:
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        made = sum(pool.map(lambda row: check(scratch, *row), listed))
finally:
    scratch.close()
finish(f"{made} of {len(listed)} pictures made again")
