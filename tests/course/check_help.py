#!/usr/bin/env python3
"""What `./raytree WORD --help` shows at once, without building, is what the programs say of themselves.

    check_help.py FOLDER_OF_PROGRAMS            compares; exit code 1 and a line for each difference
    check_help.py FOLDER_OF_PROGRAMS --write    writes common/help/ anew

common/help/lesson.txt and exercise.txt hold for all lessons that have no file of their own: NN stands for the number.
"""
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HELP = ROOT / "common/help"
BIN = pathlib.Path(sys.argv[1]).resolve()
PROGRAMS = {"learn": "learn", "grade": "grade", "merge": "grade_merge", "render": "render", "view": "viewer", "trade": "trade"}
SCRIPTS = {"handout": "tests/handout/handout.py", "notes": "slides-notes/site/build_site.py", "bench": "tests/perf/bench.py"}


def said(*command):
    """What it prints for --help, as wide as it is stored."""
    environment = os.environ | {"COLUMNS": "120", "LC_ALL": "C.UTF-8"}
    done = subprocess.run([*map(str, command), "--help"], env=environment, capture_output=True, text=True, check=False)
    if done.returncode or not done.stdout:
        sys.exit(f"{' '.join(map(str, command))} --help: exit code {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def words(text):
    """Libraries of other versions break lines elsewhere, and have capitals of their own."""
    return re.sub(r"\s+", " ", text).strip().lower()


def texts():
    """File name -> what belongs there; and the lessons whose text the common file must be."""
    found = {f"{word}.txt": said(BIN / program) for word, program in PROGRAMS.items() if (BIN / program).exists()}
    found |= {f"{word}.txt": said(sys.executable, "-B", ROOT / script) for word, script in SCRIPTS.items()}
    for kind in ("lesson", "exercise"):
        of = {}
        for program in sorted(BIN.glob(f"{kind}[0-9][0-9]")):
            number = program.name[-2:]
            # Its first line names the lesson: what is left is the same for most.
            text = said(program).split("\n", 1)[1]
            of[number] = text.replace(program.name, f"{kind}NN")
        shared = max(set(of.values()), key=list(of.values()).count)
        found[f"{kind}.txt"] = shared
        found |= {f"{kind}{number}.txt": text.replace(f"{kind}NN", f"{kind}{number}") for number, text in of.items() if text != shared}
    return found


def main():
    found = texts()
    if "--write" in sys.argv:
        HELP.mkdir(exist_ok=True)
        for name, text in found.items():
            (HELP / name).write_text(text)
    stored = {path.name: path.read_text() for path in HELP.glob("*.txt")}
    problems = [f"common/help/{name} is of no program" for name in sorted(set(stored) - set(found)) if (BIN / "viewer").exists() or name != "view.txt"]
    problems += [f"common/help/{name} differs from what the program says" for name in sorted(found) if words(found[name]) != words(stored.get(name, ""))]
    for problem in problems:
        print(f"{problem}; expected: tests/course/check_help.py {os.path.relpath(BIN)} --write")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
