#!/usr/bin/env python3
"""Every decimal number in the text, tables and formulas of README, the notes and the lessons' READMEs has a source. It stands
in a `text` block of the same file (check_commands.py runs those), or in a sum whose sides are equal, or figures.toml says
which command prints it (run here and compared), or that it is given or measured, and why.

    check_figures.py FOLDER_OF_PROGRAMS

A printed number agrees if it is the same when rounded to the digits of the text; signs are not compared, as a minus in the
text may belong to a sum.
"""
import concurrent.futures
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

from texts import LESSONS, NOTES, ROOT, blocks, finish, name, problem

BIN = pathlib.Path(sys.argv[1]).resolve()
READ = [ROOT / "README.md", *sorted(NOTES.glob("*.md")), *(lesson / "README.md" for lesson in LESSONS)]
DECIMAL = re.compile(r"(?<![\w.])\d+\.\d+(?:e-?\d+)?(?![\w.]*\d)|(?<![\w.])\d+e-\d+")
PRINTED = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?:e[-+]?\d+)?")
NOT_TEXT = r"\\\\\[[\d.]+em\]|`[^`]*`|\]\([^)]*\)|<!--.*?-->"  # gaps of formulas, code, where links lead, directives
SECONDS = 600  # only what hangs takes that


def scene_with(edit, place, call):
    """The call, with its scene replaced by a copy in which `old` is `new`."""
    old, new = edit
    changed = []
    for word in call:
        if word.endswith(".toml"):
            text = (ROOT / word).read_text()
            if text.count(old) != 1:
                raise OSError(f"{word} has {old} {text.count(old)} times, not once")
            (place / pathlib.Path(word).name).write_text(text.replace(old, new))
            word = str(place / pathlib.Path(word).name)
        changed.append(word)
    return changed


def run(command, edit):
    """(Numbers that it prints or the tree that it prints as JSON, None), or (None, why there are none)."""
    program, *call = command.split()
    stdin, call = (" ".join(call), []) if program == "widget_values" else ("", call)
    with tempfile.TemporaryDirectory() as place:
        try:
            call = scene_with(edit, pathlib.Path(place), call) if edit else call
            done = subprocess.run([str(BIN / program), *call], cwd=ROOT, input=stdin, capture_output=True, text=True, timeout=SECONDS)
        except (OSError, subprocess.TimeoutExpired) as error:
            return None, str(error)
    if done.returncode:
        return None, done.stderr.strip()
    if program == "widget_values":
        return [abs(float.fromhex(word)) for word in done.stdout.split()], None
    if done.stdout.startswith("{"):
        return json.loads(done.stdout), None
    return [float(number) for number in PRINTED.findall(done.stdout)], None


def numbers(printed, field=""):
    """The numbers in it, without their signs; only those of a field such as nodes.0.radiance.0, if one is named."""
    for key in field.split(".") if field else ():
        printed = printed[int(key) if isinstance(printed, list) else key]
    if isinstance(printed, (dict, list)):
        return [one for each in (printed.values() if isinstance(printed, dict) else printed) for one in numbers(each)]
    return [abs(printed)] if isinstance(printed, (int, float)) else []


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
    side = re.sub(r"\*\*\{(\d+)\}", r"**\1", side)
    side = re.sub(r"([\d)])\s*\(", r"\1*(", side)
    if not re.fullmatch(r"(sqrt|[\d.+\-*/() ])+", side):
        return None
    try:
        return eval(side, {"__builtins__": {}}, {"sqrt": math.sqrt})  # digits, operators and sqrt, nothing else
    except (SyntaxError, TypeError, ZeroDivisionError):
        return None


def sums(path, number, line, fenced, blocked):
    """The decimals of sums such as 0.95 * 2 = 1.9; each must be right to one unit of the result, as its terms are rounded too,
    or what a `text` block of the file says, where a power makes more of that."""
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
                if abs(a - b) > 2 * half_unit(max(result, key=half_unit)) and not agrees(result[-1], blocked):
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


def spot(figure):
    return figure.get("line") or figure["begin"]


def key(command, figure):
    return command, tuple(figure.get("edit", ()))


def covers(figure, line, number, lines):
    """Whether a figure speaks of this line: by a part of it, or by parts of the first line and of the one behind the last."""
    if "line" in figure:
        return figure["line"] in line
    begin = next((i for i, one in enumerate(lines, 1) if figure["begin"] in one), len(lines) + 1)
    return begin <= number < next((i for i, one in enumerate(lines, 1) if i > begin and figure["end"] in one), len(lines) + 1)


def check_figure(path, number, found, figure, output):
    """Compares a line's numbers with what its commands print. Returns those that are right or were complained about."""
    commands = figure["commands"]
    keys = {command: key(command, figure) for command in commands}
    failed = [command for command in commands if output[keys[command]][0] is None]
    for command in failed:
        problem(path, number, f"`{command}` fails: {output[keys[command]][1]}")
    if failed:
        return set(found)
    asked = [one for one in found if one not in figure.get("given", [])]
    if figure.get("in_order") and len(asked) != len(commands):
        problem(path, number, f"{len(asked)} numbers for {len(commands)} commands of figures.toml")
        return set(found)
    for i, one in enumerate(asked):
        sources = [commands[i]] if figure.get("in_order") else commands
        printed = [each for command in sources for each in numbers(output[keys[command]][0], figure.get("field", ""))]
        if not agrees(one, printed):
            near = min(printed, key=lambda each: abs(each - float(one)), default=None)
            problem(path, number, f"{one} is not printed by `{'`, `'.join(sources)}`; the nearest number there is {near:.6g}")
    return set(found)


def check(path, figures, given, measured, output, used):
    blocked = [float(one) for _, language, text in blocks(path) if language == "text" for one in PRINTED.findall(text)]
    lines = path.read_text().splitlines()
    skipped, count = measured_lines(path, measured), 0
    for number, line, fenced in prose(path):
        found = DECIMAL.findall(line)
        if number in skipped or not found:
            continue
        covered = sums(path, number, line, fenced, blocked)
        covered |= {one for one in found if one in given}
        used |= {(name(path), one) for one in found if one in given}
        rest = [one for one in found if one not in covered]
        matching = [i for i, figure in enumerate(figures) if covers(figure, line, number, lines)]
        for i in matching:
            used.add((name(path), spot(figures[i])))
            ordered = figures[i].get("in_order")
            covered |= check_figure(path, number, found if ordered else rest, figures[i], output)
        for one in found:
            if one not in covered and not agrees(one, blocked):
                problem(path, number, f"where does {one} come from? Name its command in tests/course/figures.toml, or why it is given")
        count += len(found)
    return count


book = tomllib.loads((ROOT / "tests/course/figures.toml").read_text())
commands = sorted({key(command, figure) for figure in book["figure"] for command in figure["commands"]})
with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count())) as pool:
    output = dict(zip(commands, pool.map(lambda one: run(*one), commands)))
used, count = set(), 0
for path in READ:
    of = {kind: [entry for entry in book[kind] if entry["note"] == name(path)] for kind in ("figure", "given", "measured")}
    given = {one for entry in of["given"] for one in entry["numbers"]}
    count += check(path, of["figure"], given, of["measured"], output, used)
    for what in sorted(given | {spot(figure) for figure in of["figure"]}):
        if (name(path), what) not in used:
            problem(path, 1, f"tests/course/figures.toml names \"{what}\", which no line with a number has any more")
finish(f"{count} numbers, {len(commands)} commands")
