#!/usr/bin/env python3
"""Grades a class of hostile, broken and merely odd submissions (attacks.toml) and holds each to the verdict it must get.

    attack_test.py BIN [--only NAME ...] [--keep DIR] [--jobs N] [-- OPTIONS OF grade]

BIN is the folder of the programs. What is kept in DIR is not graded again. Exit code 77: there is no sandbox on this machine."""
import argparse
import collections
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "lessons"))
import make_exercises
from packages import PACKAGES

NOTHING = 0.02  # of all points: what "none" may still earn
SECONDS = 3000  # for the whole class


def exercise_text(lesson, base):
    trace = next((ROOT / "lessons").glob(f"{lesson:02}_*/trace.h"))
    if base == "empty":
        return f"namespace rt::exercise{lesson:02} {{}}\n"
    text = make_exercises.exercise(trace, make_exercises.manifest(), base == "solved")
    return text.replace(f"solved{lesson:02}", f"exercise{lesson:02}")


def replaced(text, find, replacement, name):
    assert text.count(find) == 1, f"{name}: \"{find}\" stands {text.count(find)} times in the exercise, expected once"
    return text.replace(find, replacement)


def submission_text(attack):
    lesson = attack.get("lesson", 2)
    text = exercise_text(lesson, attack.get("base", "solved"))
    if "find" in attack:
        text = replaced(text, attack["find"], attack["replace"], attack["name"])
    if "before" in attack:
        text = replaced(text, "#pragma once\n", "#pragma once\n" + attack["before"] + "\n", attack["name"])
    return text + attack.get("after", "") + "\n"


def grade(binaries, lesson, submissions, out, jobs, extra, boxes):
    command = [str(binaries / "grade"), str(lesson), "--submissions", str(submissions), "--out", str(out), "--jobs", str(jobs),
               "--secret", str(out) + ".secret", "--cpu-seconds", "2", "--resume", *extra]
    pathlib.Path(str(out) + ".secret").write_text("a secret of the attacks, not of a course")
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, stdin=subprocess.DEVNULL,
                          env=os.environ | {"TMPDIR": str(boxes)})


def results_of(out):
    """The results by the student's name, each with the folder that it lies in."""
    found = {}
    for path in out.glob("results/*/results.json"):
        result = json.loads(path.read_text())
        found[result["extra_data"]["raytree"]["student"]] = (result, path.parent)
    return found


class Verdicts:
    def __init__(self):
        self.failures = collections.defaultdict(list)

    def that(self, name, holds, sentence):
        if not holds:
            self.failures[name].append(sentence)


def check(attack, result, folder, verdicts):
    name = attack["name"]
    data = result["extra_data"]["raytree"]
    states = attack.get("states", [attack.get("state", "graded")])
    verdicts.that(name, data["state"] in states, f"state is \"{data['state']}\" ({data['reason']}), expected {states}")
    if data["state"] != "graded":
        verdicts.that(name, result["score"] == 0, f"earned {result['score']} without being graded")
        verdicts.that(name, bool(data["reason"]), "there is no reason")
    else:
        most = sum(test["max_score"] for test in result["tests"])
        share = sum(test["score"] for test in result["tests"]) / most
        points = attack.get("points", "full")
        least, most_share = {"full": (1, 1), "none": (0, NOTHING)}[points] if isinstance(points, str) else points
        verdicts.that(name, least - 1e-9 <= share <= most_share + 1e-9, f"earned {share:.3f} of all points, expected {points}")
        if "outcomes" in attack:
            outcomes = {one["outcome"] for one in data["classes"]}
            verdicts.that(name, outcomes <= set(attack["outcomes"]), f"outcomes are {outcomes}, expected {attack['outcomes']}")
    told = (folder.parents[1] / "reports" / (folder.name + ".html")).read_text() + json.dumps({**result, "extra_data": None})
    if "remark" in attack:
        verdicts.that(name, any(attack["remark"] in remark for remark in data["remarks"]), f"no remark says \"{attack['remark']}\": {data['remarks']}")
    for words in ("before it is set", "differ"):  # what is said of everybody says nothing
        verdicts.that(name, attack.get("remark") == words or not any(words in remark for remark in data["remarks"]), f"a remark says \"{words}\": {data['remarks']}")
    if "message" in attack:
        verdicts.that(name, attack["message"] in told, f"nothing says \"{attack['message']}\": {data['reason']} {data['compiler_errors']}")
    verdicts.that(name, "/tmp/" not in told and str(ROOT) not in told, "a path of ours is told")


def running_below(folder):
    """Command lines that name something below the folder, as those of boxes do. Not from ps, which may be missing."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = path.read_bytes().replace(b"\0", b" ").decode(errors="replace")
        except OSError:
            continue  # it has ended
        if f"{folder}/" in words:
            found.append(words)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binaries", type=pathlib.Path)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("extra", nargs="*")
    args = parser.parse_args()
    binaries = args.binaries.resolve()
    with open(HERE / "attacks.toml", "rb") as file:
        attacks = [attack for attack in tomllib.load(file)["attack"] if not args.only or attack["name"] in args.only]
    lessons = collections.defaultdict(list)
    for attack in attacks:
        lessons[attack.get("lesson", 2)].append(attack)
    verdicts = Verdicts()
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as scratch:
        top = args.keep.resolve() if args.keep else pathlib.Path(scratch)
        pathlib.Path(scratch).chmod(0o755)  # the boxes' user goes through it
        boxes = pathlib.Path(scratch) / "boxes"
        boxes.mkdir()
        for lesson, all_of_lesson in sorted(lessons.items()):
            place = top / f"class{lesson:02}"
            shutil.rmtree(place, ignore_errors=True)
            place.mkdir(parents=True)
            for attack in all_of_lesson:
                PACKAGES[attack.get("package", "folder")](place / attack["name"], submission_text(attack).encode("utf-8", "surrogateescape"))
            out = top / f"out{lesson:02}"
            done = grade(binaries, lesson, place, out, args.jobs, args.extra, boxes)
            if done.returncode == 4:
                print(f"skipped: {done.stderr.strip()}")
                sys.exit(77)
            verdicts.that("the grader", done.returncode == 0, f"exit code {done.returncode}: {done.stderr[-2000:]}")
            found = results_of(out)
            for attack in all_of_lesson:
                if attack["name"] not in found:
                    verdicts.that(attack["name"], False, f"has no result; there are {sorted(found)[:5]} ...")
                    continue
                check(attack, *found[attack["name"]], verdicts)
                if "never" in attack:
                    text = (found[attack["name"]][1] / "results.json").read_text()
                    verdicts.that(attack["name"], attack["never"] not in text, f"\"{attack['never']}\" stands in what it printed: the box let it")
            for name in ("gradebook.csv", "junit.xml", "class.html"):
                verdicts.that("the class", (out / name).is_file(), f"{name} is missing")
    for trace in ("/tmp/raytree_was_here", "/dev/shm/raytree_was_here", "raytree_was_here"):
        verdicts.that("the box", not pathlib.Path(trace).exists(), f"{trace} was written")
    left = running_below(boxes)
    verdicts.that("the box", not left, f"a box is still running: {left[:1]}")
    for name, failures in verdicts.failures.items():
        for sentence in failures:
            print(f"FAILED {name}: {sentence}")
    print(f"{len(attacks)} submissions, {len(verdicts.failures)} with a wrong verdict, {time.monotonic() - start:.1f} s")
    sys.exit(1 if verdicts.failures else 0)


if __name__ == "__main__":
    main()
