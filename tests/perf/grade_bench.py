#!/usr/bin/env python3
"""How long grading a class takes, and that an interrupted run grades nobody twice. Not a test: call it on an idle machine.

    grade_bench.py FOLDER_OF_PROGRAMS [--class 100] [--lesson 6] [--jobs 2]"""
import argparse
import json
import os
import pathlib
import resource
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/grade"))
from classroom import SECRET, data_of, exercise_text, without_times


def right_answers(lesson):
    """The solved exercise, and the same in other words."""
    solved = exercise_text(lesson, "solved")
    with open(ROOT / "tests/grade/questions/variants.toml", "rb") as file:
        variants = [one for one in tomllib.load(file)["variant"] if one["id"].startswith(f"{lesson:02}-")]
    return [solved] + [solved.replace(one["find"], one["replace"]) for one in variants if solved.count(one["find"]) == 1]


def make_class(folder, lesson, size):
    answers = right_answers(lesson)
    for i in range(size):
        place = folder / f"student{i:03}"
        place.mkdir(parents=True)
        # A comment makes each file another one, as it would be.
        (place / "exercise.h").write_text(answers[i % len(answers)] + f"// handed in by student {i}\n")
    return len(answers)


def lines_of(command, stop_after=None):
    """What a run prints, a dictionary for each submission; it is interrupted after some of them."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    lines = []
    for line in process.stdout:
        lines.append(json.loads(line))
        if len(lines) == stop_after:
            process.send_signal(signal.SIGINT)
    err = process.stderr.read()
    expected = 0 if stop_after is None else 130
    if process.wait() != expected:
        sys.exit(f"grade_bench: exit code {process.returncode}, expected {expected}: {err}")
    return lines


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)  # what the boxes used is in it: the grader waits for them
    return used.ru_utime + used.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("binaries", type=pathlib.Path)
    parser.add_argument("--class", dest="size", type=int, default=100)
    parser.add_argument("--lesson", type=int, default=6)
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    if args.size < 4:
        parser.error("--class: expected at least 4 submissions")
    with tempfile.TemporaryDirectory() as scratch:
        place = pathlib.Path(scratch)
        place.chmod(0o755)  # the box's user goes through it
        (place / "secret").write_text(SECRET)
        words = make_class(place / "class", args.lesson, args.size)
        command = [str(args.binaries.resolve() / "grade"), str(args.lesson), "--submissions", str(place / "class"),
                   "--secret", str(place / "secret"), "--jobs", str(args.jobs), "--out"]
        print(f"lesson {args.lesson:02}, {args.size} right submissions in {words} wordings, {args.jobs} jobs; "
              f"{os.cpu_count()} cores, load before {os.getloadavg()[0]:.1f}")
        wall, cpu = time.monotonic(), processor_seconds()
        lines_of(command + [str(place / "whole")])
        wall, cpu = time.monotonic() - wall, processor_seconds() - cpu
        whole = data_of(place / "whole")
        compiling = statistics.median(one["compile_seconds"] for one in whole.values())
        print(f"compiling one: {compiling:.2f} s of processor time (median)")
        print(f"the class: {wall:.1f} s, {cpu:.1f} s of processor time; each: {wall / args.size:.2f} s, {cpu / args.size:.2f} s of processor time")
        full = sum(sum(one["points"] for one in data["classes"]) >= sum(one["most"] for one in data["classes"]) - 1e-9 > 0 for data in whole.values())
        print(f"full marks: {full} of {args.size}")

        first = {line["student"] for line in lines_of(command + [str(place / "halves")], args.size // 2)}
        first |= set(data_of(place / "halves"))
        second = {line["student"] for line in lines_of(command + [str(place / "halves"), "--resume"]) if not line["kept"]}
        print(f"interrupted after {len(first)}, {len(second)} graded when resumed; graded twice: {len(first & second)}")
        alike = without_times(data_of(place / "halves")) == without_times(whole)
        print(f"results of both runs are {'the same' if alike else 'DIFFERENT'}")
        sys.exit(0 if full == args.size and not first & second and len(first | second) == args.size and alike else 1)


if __name__ == "__main__":
    main()
