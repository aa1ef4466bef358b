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


def machine_code(compiler, header, folder, number):
    unit = folder / "unit.cpp"
    # Lesson 10's Tracer is also given its world: here the scene, which starts rays at the points themselves.
    world = "struct World : rt::Scene<Real> { static constexpr bool wrongAngle = false; static const auto& leave(const auto& I, const auto&) { return I; } static Real schlickWithIncidentAngle(Real, Real, Real) { return 0; } };"
    head = f"template <class Real> {world}\n" if number == "10" else ""
    unit.write_text(f'#include "{header}"\n{head}extern template class rt::Scene<double>;\n'
                    f"template struct rt::lesson{number}::Tracer<double{', World<double>' if head else ''}>;\n")
    subprocess.run([compiler, "-std=c++20", "-O2", "-DRAYTREE_HEADERS_ONLY", "-ffp-contract=off", f"-I{ROOT}", "-c", str(unit), "-o", str(folder / "unit.o")], check=True)
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", str(folder / "unit.o")], check=True, capture_output=True, text=True).stdout
    functions = {}
    for name, body in re.findall(r"^[0-9a-f]+ <(.*)>:\n((?: .*\n)*)", listing, re.M):
        functions[name] = collections.Counter(line.split("\t")[1].split()[0] for line in body.splitlines())
    return functions


problems = 0
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for trace in sorted(ROOT.glob("lessons/[0-9][0-9]_*/trace.h")):
        number = trace.parent.name[:2]
        text = trace.read_text()
        if f"lesson{number}" not in text:
            continue
        for line in text.splitlines():
            if "rec." in line and not re.fullmatch(r" *rec\.\w+\(.*\);(?: //.*)?", line):
                print(f"{trace}: not a whole statement: {line.strip()}", file=sys.stderr)
                problems += 1
        erased = folder / "erased.h"
        erased.write_text(re.sub(r"^ *rec\..*\n", "", text, flags=re.M))
        same = machine_code(sys.argv[1], trace, folder, number) == machine_code(sys.argv[1], erased, folder, number)
        print(f"lesson {number}: {'same instructions' if same else 'DIFFERENT instructions'} without recorder calls")
        problems += not same
sys.exit(bool(problems))
