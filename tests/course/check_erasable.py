#!/usr/bin/env python3
"""Recorder calls are erasable and free: a lesson without its `rec.` lines compiles to the same machine instructions.

Compared is how often each function has each instruction, whatever its operands: in lessons 05 to 07 g++ 12 swaps two stack
slots, or the two factors of a product. The scene's functions are in sight, as in the grader's kits: where they are not, g++ 12
fills a gap in lesson 03 with other instructions of no effect, and moves one register more in lesson 07, without the lines.
In double: float is the same text.

    check_erasable.py COMPILER
"""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


# Lesson 10's Tracer is also given its world: here the scene, which starts rays at the points themselves.
WORLD = ("template <class Real> struct World : rt::Scene<Real> { static constexpr bool wrongAngle = false; static const auto& leave(const auto& I, const auto&) "
         "{ return I; } static Real schlickWithIncidentAngle(Real, Real, Real) { return 0; } };\n")


def machine_code(compiler, headers, folder):
    """Function -> its instructions, of all lessons: in one unit, so that the scene is compiled once and not for each of them."""
    tracers = "".join(f"template struct rt::lesson{number}::Tracer<double{', World<double>' * (number == '10')}>;\n" for number in headers)
    unit = folder / "unit.cpp"
    unit.write_text("".join(f'#include "{header}"\n' for header in headers.values()) + WORLD + "extern template class rt::Scene<double>;\n" + tracers)
    subprocess.run([compiler, "-std=c++20", "-O2", "-DRAYTREE_HEADERS_ONLY", "-ffp-contract=off", f"-I{ROOT}", "-c", str(unit), "-o", str(folder / "unit.o")], check=True)
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", str(folder / "unit.o")], check=True, capture_output=True, text=True).stdout
    functions = {}
    for name, body in re.findall(r"^[0-9a-f]+ <(.*)>:\n((?: .*\n)*)", listing, re.M):
        functions[name] = collections.Counter(line.split("\t")[1].split()[0] for line in body.splitlines())
    return functions


problems = 0
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    plain, erased = {}, {}
    for trace in sorted(ROOT.glob("lessons/[0-9][0-9]_*/trace.h")):
        number, text = trace.parent.name[:2], trace.read_text()
        for line in text.splitlines():
            if "rec." in line and not re.fullmatch(r" *rec\.\w+\(.*\);(?: //.*)?", line):
                print(f"{trace}: not a whole statement: {line.strip()}", file=sys.stderr)
                problems += 1
        plain[number], erased[number] = trace, folder / f"erased{number}.h"
        erased[number].write_text(re.sub(r"^ *rec\..*\n", "", text, flags=re.M))
    ours, without = machine_code(sys.argv[1], plain, folder), machine_code(sys.argv[1], erased, folder)
    for number in plain:
        functions = [function for function in ours.keys() | without.keys() if f"lesson{number}" in function]
        different = sorted(function for function in functions if ours.get(function) != without.get(function))
        same = functions and not different
        print(f"lesson {number}: {'same instructions' if same else 'DIFFERENT instructions'} without recorder calls in {len(functions)} functions {' '.join(different)}")
        problems += not same
    others = [function for function in ours.keys() | without.keys() if ours.get(function) != without.get(function) and "lesson" not in function]
    if others:
        print(f"different without recorder calls: {' '.join(sorted(others))}", file=sys.stderr)
        problems += 1
sys.exit(bool(problems))
