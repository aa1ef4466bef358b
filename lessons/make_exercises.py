#!/usr/bin/env python3
"""Makes each lesson's exercise.h from its trace.h (lesson 00: geometry.h).

In trace.h (and in the core where a lesson borrows from it):
    // SOLUTION id ... // END         becomes a TODO that throws NotAttempted
    // EXERCISE: text                 becomes the line `text`; it replaces the next line if both begin with the same
                                      `const auto name = `, and right above a SOLUTION it stands in for what the
                                      solution declares
    // EXERCISE-FROM file: f g        inserts the functions f and g of that file

    make_exercises.py                 writes lessons/NN_*/exercise.h
    make_exercises.py --check         exit 1 if one of them is stale
    make_exercises.py --solved DIR    writes DIR/solvedNN.h: the exercises with the solutions put back, for the tests
"""
import argparse
import pathlib
import re
import sys
import tomllib

LESSONS = pathlib.Path(__file__).resolve().parent
ROOT = LESSONS.parent
SOLUTION = re.compile(r"^(?P<indent> *)// SOLUTION (?P<id>\S+)\n(?P<body>.*?)^ *// END\n", re.M | re.S)


def manifest():
    with open(LESSONS / "exercises.toml", "rb") as file:
        return {entry["id"]: entry for entry in tomllib.load(file)["exercise"]}


def lessons():
    """The numbers of the lessons that have exercises, ascending."""
    return sorted({entry["lesson"] for entry in manifest().values()})


def function(path, name):
    """The member function `name` of a core header, with the comment above it."""
    text = (ROOT / path).read_text()
    found = re.search(rf"(?:^    ///.*\n)+^    (?!//).*\b{name}\(.*\n(?:^      +.*\n)*?^    {{\n(?:.*\n)*?^    }}\n", text, re.M)
    if not found:
        sys.exit(f"{path}: there is no function {name} with a comment above it")
    return found.group(0).replace("    ///", "    //")


def exercise(trace, entries, solved):
    text = trace.read_text()
    number = trace.parent.name[:2]

    def inserted(match):
        return "\n".join(function(match["file"], name) for name in match["names"].split())

    def todo(match):
        entry = entries.get(match["id"]) or sys.exit(f"{trace}: {match['id']} is not in exercises.toml")
        indent = match["indent"]
        if solved:
            return match["body"]
        return (f"{indent}// TODO {entry['id']} ({entry['points']} point{'s' * (entry['points'] != 1)}): {entry['title']}\n"
                f"{indent}// Slide: {entry['slide']}\n"
                f"{indent}todo(\"{entry['id']}\");\n")

    text = re.sub(r"^ *// EXERCISE-FROM (?P<file>\S+): (?P<names>.*)\n", inserted, text, flags=re.M)
    # A replaced statement starts like the line below it; an added line does not.
    text = re.sub(r"^(?P<indent> *)// EXERCISE: (?P<text>(?P<start>const auto \w+ = ).*)\n(?P=indent)(?P=start).*\n",
                  r"\g<indent>\g<text>\n", text, flags=re.M)
    if solved:
        text = re.sub(r"^ *// EXERCISE: .*\n(?= *// SOLUTION)", "", text, flags=re.M)
    text = re.sub(r"^( *)// EXERCISE: (.*)\n", r"\1\2\n", text, flags=re.M)
    text = SOLUTION.sub(todo, text)
    # Who brings the formulas also asks them.
    if " intersectSphere(" in text:
        text = text.replace("scene.occluded(I, L, dist)", "scene.occluded(I, L, dist, *this)")
    if " latLong(" in text:
        text = text.replace("scene.sky.color(ray.D)", "scene.sky.color(ray.D, *this)")
    text = re.sub(r"^template <std::floating_point Real>\n", "using Real = double;\n\n", text, flags=re.M)
    text = re.sub(r"^template <.*>\n", "using Real = double;\nusing Recorder = TreeRecorder<Real>;\n\n", text, flags=re.M)
    name = "solved" if solved else "exercise"
    text = text.replace(f"lesson{number}", f"{name}{number}").replace('"common/scene/lesson.h"', '"common/exercise.h"')
    title = re.match(r"// Lesson (?P<title>.*)\n", text)["title"]
    made = f"Made from {trace.name} by make_exercises.py: the TODOs are yours."
    return text.replace(f"// Lesson {title}\n", f"// Exercise {title}\n// {made}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--solved", type=pathlib.Path)
    args = parser.parse_args()
    entries = manifest()
    stale = []
    for trace in sorted([*LESSONS.glob("00_*/geometry.h"), *LESSONS.glob("[0-9][0-9]_*/trace.h")]):
        if "// SOLUTION" not in trace.read_text():
            continue
        text = exercise(trace, entries, bool(args.solved))
        if args.solved:
            target = args.solved / f"solved{trace.parent.name[:2]}.h"
        else:
            target = trace.parent / "exercise.h"
        if target.exists() and target.read_text() == text:
            continue
        if args.check:
            stale.append(str(target.relative_to(ROOT)))
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text)
    if stale:
        sys.exit(f"stale: {', '.join(stale)} (run lessons/make_exercises.py)")


if __name__ == "__main__":
    main()
