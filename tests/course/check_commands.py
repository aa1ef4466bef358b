#!/usr/bin/env python3
"""Every command that README, the notes, the lessons' READMEs and the grader's show is run, in a scratch copy of the project,
as a reader's shell would run it: fenced `sh` blocks line by line, and `./raytree ...` in the text. All must succeed. A `text`
block after an `sh` block is what the commands print: each of its lines must be among the output ("..." stands for any lines,
and for anything at a line's end). A C++ block below <!-- instead of LINE in FILE --> is put into that file, as the reader does.

    check_commands.py FOLDER_OF_PROGRAMS

What would take long is bounded, what cannot run here is named with the reason.
"""
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys

from scratch import BIN, Scratch
from texts import READ, ROOT, blocks, edits, finish, inline_commands, name, problem

# Not run at all: pattern -> reason.
CANNOT = {
    r"\./raytree test\b": "it runs this check",
    r"git clone |cd raytree$|git pull": "the scratch copy is the clone",
    r"sudo |apt-get ": "changes the machine",
    r"\./raytree notes": "tests/course/site_test.py builds the site",
    r"\./raytree bench": "tests/perf/check_bench.py measures",
    r"trade --notes": "writes into the project's own notes, wherever it is called",
    r"sbatch ": "needs a cluster with Slurm",
    r"^tests/grade/recipes/": "tests/grade/recipes/recipes_test.py runs the recipes",
    r"\.ci/run|^cmake |ctest ": "builds and runs everything",
    r"xdg-open |^\$?EDITOR|^nano ": "opens a window or an editor",
}
# Words in capitals and brackets that the reader fills in.
PLACEHOLDERS = {r"OUT/part-\*": "marks", r"\s*\[[^\]]*\]": "", r"\bLESSON\b": "6", r"\bDIR\b": "class", r"\bOUT\b": "marks", r"\bFILE\b": "course.secret",
                r"\bPATH\b": "class/ada.h", r"\bNAME\b": "ada", r"(?<=lesson )N SCENE\b": "2", r"\bNN_": "02_", r"(?<= )N\b": "2"}
# Long or interactive ones get a bound: pattern -> added to the command, unless it names that option itself.
BOUNDS = [
    (r"lesson 9\b", {"--size": "32x24", "--spp": "4"}),   # minutes of path tracing
    (r"lesson 10\b", {"--size": "32x24"}),
    (r"\./raytree trade\b", {"--size": "32x24", "--quick": ""}),
    (r"\./raytree learn\b(?!.*--(hint|list|reset|once))", {"--once": "1"}),  # watches for saves else
    (r"\./raytree learn\b", {"--state": "learn.json"}),   # else beside the reader's own
    (r"\./raytree view\b(?!.*--(export|script|screenshot|help))", {"--screenshot": "shot.png"}),  # waits for clicks else
]
# Exit codes that are no failure.
CODES = {r"\./raytree learn\b": (0, 1)}  # 1: something is not written yet
REPLACED = {"--spp", "--size"}  # by the bound, even if the command names them
GRADER = r"\./raytree (learn|grade|merge|handout)\b"
NEEDS = {r"\./raytree( view\b|\s*$)": "viewer", GRADER: "grade"}
NO_SANDBOX = 4  # the grader's exit code; on a machine that is very busy its self-test may end so in between
SECONDS = 600  # only what hangs, or should have a bound, takes that


def bounded(command):
    for pattern, options in BOUNDS:
        if not re.search(pattern, command):
            continue
        for option, value in options.items():
            if option in REPLACED:
                command = re.sub(rf" {option} \S+", "", command)
            if not re.search(rf"{option}\b", command):
                code, comment = re.match(r"((?:'[^']*'|[^#'])*)(.*)", command).groups()
                command = f"{code.rstrip()} {option} {value} {comment}".rstrip()
    return command


def runnable(command):
    for pattern, value in PLACEHOLDERS.items():
        command = re.sub(pattern, value, command)
    return bounded(command)


def furnish(here, solved):
    """What readers have by then: a class, a ray tree, a tracer of their own, a secret."""
    (here / "class").mkdir()
    exercise = solved.read_text().replace("solved06", "exercise06")
    (here / "class/ada.h").write_text(exercise)
    (here / "class/ben.h").write_text((ROOT / "lessons/06_fresnel/exercise.h").read_text())
    (here / "my_tracer").write_text(f'#!/bin/sh\nexec "{BIN}/lesson06" "$@"\n')
    (here / "my_tracer").chmod(0o755)
    subprocess.run([str(BIN / "lesson06"), "--tree", "json"], stdout=open(here / "tree.json", "w"), check=True)
    (here / "course.secret").write_bytes(bytes(range(32)))


def edit(here, path, number, change):
    """Writes what the reader writes, and lets `learn` read the scratch copy's files from now on."""
    file, old, new = change
    if (here / "lessons").is_symlink():
        (here / "lessons").unlink()
        shutil.copytree(ROOT / "lessons", here / "lessons")
    text = (here / file).read_text()
    if text.count(old) != 1:
        problem(path, number, f"{file} has '{old}' {text.count(old)} times, not once")
    (here / file).write_text(re.sub(rf"^ *{re.escape(old)}\n", lambda _: new, text, flags=re.M))
    return f" --file {file}"


def steps(path):
    """(line number, command or None, what is to be printed or to be written), in the file's order."""
    found = [(number, command, None) for number, command in inline_commands(path)]
    found += [(number, None, (file, old, new)) for number, file, old, new in edits(path)]
    for start, language, text in blocks(path):
        if language == "sh":
            lines = re.sub(r"\\\n", "  ", text).splitlines()
            found += [(start + i, line, None) for i, line in enumerate(lines) if line.strip() and not line.startswith("#")]
        elif language == "text":
            found.append((start, None, text))
    return sorted(found, key=lambda step: step[0])


def fits(expected, printed):
    """Whether the printed line is the expected one; "..." at its end stands for anything."""
    expected, printed = " ".join(expected.split()), " ".join(printed.split())
    return printed.startswith(expected[:-3].rstrip()) if expected.endswith("...") else printed == expected


def compare(path, start, text, output):
    printed = output.splitlines()
    for i, line in enumerate(text.splitlines()):
        if line.strip() in ("", "..."):
            continue
        if not any(fits(line, one) for one in printed):
            problem(path, start + i, f"the commands above do not print: {line.strip()}")


def check_file(scratch, path, solved, missing):
    """Returns (commands run, commands left out)."""
    here = scratch.clone(name(path).replace("/", "-"))
    furnish(here, solved)
    ran, left, output, edited = 0, 0, "", ""
    for number, command, expected in steps(path):
        if isinstance(expected, tuple):
            edited = edit(here, path, number, expected)
            continue
        if expected is not None:
            compare(path, number, expected, output)
            output = ""
            continue
        if any(re.search(pattern, command) for pattern in CANNOT) or \
           any(re.search(pattern, command.split("#")[0].rstrip()) for pattern, program in NEEDS.items() if program in missing):
            left += 1
            continue
        line = runnable(command) + (edited if re.match(r"\./raytree learn --once", command) else "")
        code, printed = scratch.run(line, here, SECONDS)
        output += printed
        ran += 1
        for file in printed.splitlines():
            if file.startswith(f"{here}/") and ":" not in file and not os.path.exists(file):
                problem(path, number, f"'{command}' says that it wrote {file}, which is not there")
        if code == NO_SANDBOX and re.search(GRADER, command):
            ran, left = ran - 1, left + 1
        elif code is None:
            problem(path, number, f"takes longer than {SECONDS} s; give it a bound in check_commands.py: {command}")
        elif code not in next((codes for pattern, codes in CODES.items() if re.search(pattern, command)), (0,)):
            last = (printed.strip().splitlines() or ["nothing was printed"])[-1]
            problem(path, number, f"'{command}' has exit code {code}: {last}")
    return ran, left


def missing_programs():
    missing = {program for program in ("viewer", "grade") if not (BIN / program).exists()}
    if "grade" not in missing and subprocess.run([str(BIN / "grade"), "--self-test"], capture_output=True).returncode == 4:
        missing.add("grade")  # no sandbox
    return missing


scratch = Scratch()
try:
    subprocess.run([sys.executable, "-B", str(ROOT / "lessons/make_exercises.py"), "--solved", str(scratch.place / "solved")], check=True)
    solved, missing = scratch.place / "solved/solved06.h", missing_programs()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        done = list(pool.map(lambda path: check_file(scratch, path, solved, missing), [path for path in READ if path.is_file()]))
finally:
    scratch.close()
left = f"; without {' and '.join(sorted(missing))} on this machine" if missing else ""
finish(f"{sum(ran for ran, _ in done)} commands run, {sum(out for _, out in done)} left out{left}")
