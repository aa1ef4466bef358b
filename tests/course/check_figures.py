#!/usr/bin/env python3
"""Every decimal number in the text, tables and formulas of README, the notes and the lessons' READMEs has a source. It stands
in a `text` block of the same file (check_commands.py runs those), or in a sum whose sides are equal, or figures.toml says
which command prints it (run here and compared), or that it is given or measured, and why.

    check_figures.py FOLDER_OF_PROGRAMS

A printed number agrees if it is the same when rounded to the digits of the text; signs are not compared, as a minus in the
text may belong to a sum.
"""
import concurrent.futures
import math
import os
import pathlib
import re
import subprocess
import sys
import tomllib

from texts import LESSONS, NOTES, ROOT, blocks, finish, name, problem

BIN = pathlib.Path(sys.argv[1]).resolve()
READ = [ROOT / "README.md", *sorted(NOTES.glob("*.md")), *(lesson / "README.md" for lesson in LESSONS)]
DECIMAL = re.compile(r"(?<![\w.])\d+\.\d+(?:e-?\d+)?(?![\w.]*\d)|(?<![\w.])\d+e-\d+")
PRINTED = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?:e[-+]?\d+)?")
NOT_TEXT = r"`[^`]*`|\]\([^)]*\)|<!--.*?-->"  # code, where links lead, directives of the site
SECONDS = 20


def run(command):
    """(Numbers that it prints, None), or (None, why there are none)."""
    program, _, rest = command.partition(" ")
    call, stdin = ([program], rest) if program == "widget_values" else ([program, *rest.split()], "")
    try:
        done = subprocess.run([str(BIN / call[0]), *call[1:]], cwd=ROOT, input=stdin, capture_output=True, text=True, timeout=SECONDS)
    except (OSError, subprocess.TimeoutExpired) as error:
        return None, str(error)
    if done.returncode:
        return None, done.stderr.strip()
    if program == "widget_values":
        return [abs(float.fromhex(word)) for word in done.stdout.split()], None
    return [float(number) for number in PRINTED.findall(done.stdout)], None


def half_unit(number):
    """Half of the last printed digit, and a trace for binary fractions."""
    digits, _, exponent = number.partition("e")
    return 0.5000001 * 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2]))


def agrees(number, printed):
    return any(abs(float(number) - one) <= half_unit(number) for one in printed)


def value(side):
    """The value of a side of an equation that has only numbers; None for any other."""
    side = re.sub(r"\\(thinspace|left|right)|&|\\\\(\[[^]]*\])?|\^\\circ|\\,", "", side).strip().rstrip(",. ")
    side = re.sub(r"\\frac\{([^{}]*)\}\{([^{}]*)\}", r"((\1)/(\2))", side)
    side = re.sub(r"\\sqrt\{([^{}]*)\}", r"sqrt(\1)", side).replace(r"\cdot", "*").replace("^", "**")
    side = re.sub(r"([\d)])\s*\(", r"\1*(", side)
    if not re.fullmatch(r"(sqrt|[\d.+\-*/() ])+", side):
        return None
    try:
        return eval(side, {"__builtins__": {}}, {"sqrt": math.sqrt})  # digits, operators and sqrt, nothing else
    except (SyntaxError, TypeError, ZeroDivisionError):
        return None


def sums(path, number, line, fenced):
    """The decimals of sums such as 0.95 * 2 = 1.9; each must be right to one unit of the result, as its terms are rounded too."""
    covered = set()
    for formula in [line] if fenced else re.findall(r"\$([^$]+)\$", line):
        for part in re.split(r"\\quad|\\qquad|(?<!\d),|,(?!\d)", formula):
            sides = part.split("=")
            for left, right in zip(sides, sides[1:]):
                a, b = value(left), value(right)
                result = DECIMAL.findall(right)
                if a is None or b is None or not result:
                    continue
                covered |= {*DECIMAL.findall(left), *result}
                if abs(a - b) > 2 * half_unit(max(result, key=half_unit)):
                    problem(path, number, f"{left.strip()} is {a:.6g}, not {right.strip()}")
    return covered


def prose(path):
    """(line number, line without code, whether it is a displayed formula) of all that is not code."""
    fence = None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if line.startswith("```"):
            fence = None if fence is not None else line[3:].strip()
        elif fence in (None, "math"):
            yield number, re.sub(NOT_TEXT, " ", line), fence == "math"


def measured_lines(path, entries):
    """Lines of tables that are measured; the file must name the command that makes them."""
    lines, found = path.read_text().splitlines(), set()
    for entry in entries:
        if entry["command"] not in path.read_text():
            problem(path, 1, f"its measured figures are made by `{entry['command']}`, which it must name")
        begin = next((i for i, line in enumerate(lines) if entry.get("begin", "") in line), len(lines))
        end = next((i for i, line in enumerate(lines) if "end" in entry and entry["end"] in line), len(lines))
        found |= set(range(begin + 1, end + 1))
    return found


def check_figure(path, number, found, figure, output):
    """Compares a line's numbers with what its commands print. Returns those that are right or were complained about."""
    commands = figure["commands"]
    failed = [command for command in commands if output[command][0] is None]
    for command in failed:
        problem(path, number, f"`{command}` fails: {output[command][1]}")
    if failed:
        return set(found)
    asked = [one for one in found if one not in figure.get("given", [])]
    if figure.get("in_order") and len(asked) != len(commands):
        problem(path, number, f"{len(asked)} numbers for {len(commands)} commands of figures.toml")
        return set(found)
    for i, one in enumerate(asked):
        sources = [commands[i]] if figure.get("in_order") else commands
        printed = [each for command in sources for each in output[command][0]]
        if not agrees(one, printed):
            near = min(printed, key=lambda each: abs(each - float(one)), default=None)
            problem(path, number, f"{one} is not printed by `{'`, `'.join(sources)}`; the nearest number there is {near:.6g}")
    return set(found)


def check(path, figures, given, measured, output, used):
    blocked = [float(one) for _, language, text in blocks(path) if language == "text" for one in PRINTED.findall(text)]
    skipped, count = measured_lines(path, measured), 0
    for number, line, fenced in prose(path):
        found = DECIMAL.findall(line)
        if number in skipped or not found:
            continue
        covered = sums(path, number, line, fenced)
        covered |= {one for one in found if one in given}
        used |= {(name(path), one) for one in found if one in given}
        rest = [one for one in found if one not in covered]
        matching = [i for i, figure in enumerate(figures) if figure["line"] in line]
        for i in matching:
            used.add((name(path), figures[i]["line"]))
            ordered = figures[i].get("in_order")
            covered |= check_figure(path, number, found if ordered else rest, figures[i], output)
        for one in found:
            if one not in covered and not agrees(one, blocked):
                problem(path, number, f"where does {one} come from? Name its command in tests/course/figures.toml, or why it is given")
        count += len(found)
    return count


book = tomllib.loads((ROOT / "tests/course/figures.toml").read_text())
commands = sorted({command for figure in book["figure"] for command in figure["commands"]})
with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count())) as pool:
    output = dict(zip(commands, pool.map(run, commands)))
used, count = set(), 0
for path in READ:
    of = {kind: [entry for entry in book[kind] if entry["note"] == name(path)] for kind in ("figure", "given", "measured")}
    given = {one for entry in of["given"] for one in entry["numbers"]}
    count += check(path, of["figure"], given, of["measured"], output, used)
    for what in sorted(given | {figure["line"] for figure in of["figure"]}):
        if (name(path), what) not in used:
            problem(path, 1, f"tests/course/figures.toml names \"{what}\", which no line with a number has any more")
finish(f"{count} numbers, {len(commands)} commands")
