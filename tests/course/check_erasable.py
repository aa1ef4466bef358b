#!/usr/bin/env python3
"""Recorder calls are erasable and free: a lesson without its `rec.` lines compiles to the same machine code.

    check_erasable.py COMPILER
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def machine_code(compiler, header, folder, number):
    unit = folder / "unit.cpp"
    unit.write_text(f'#include "{header}"\n' + "".join(f"template struct rt::lesson{number}::Tracer<{real}>;\n" for real in ("float", "double")))
    subprocess.run([compiler, "-std=c++20", "-O2", "-ffp-contract=off", f"-I{ROOT}", "-c", str(unit), "-o", str(folder / "unit.o")], check=True)
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", str(folder / "unit.o")], check=True, capture_output=True, text=True).stdout
    return listing.split("Disassembly", 1)[1]


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
        print(f"lesson {number}: {'same machine code' if same else 'DIFFERENT machine code'} without recorder calls")
        problems += not same
sys.exit(bool(problems))
