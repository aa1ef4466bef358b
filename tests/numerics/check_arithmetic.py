#!/usr/bin/env python3
"""Arithmetic is what the sources say: the same bits at every optimisation level, and no build with -ffast-math.

check_arithmetic.py COMPILER PROGRAM PROGRAM: the programs are bits.cpp, built in two ways."""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
compiler, *programs = sys.argv[1:]
problems = []

sums = {program: subprocess.run([program], capture_output=True, text=True, check=True).stdout for program in programs}
if len(set(sums.values())) != 1:
    problems.append("the bits depend on how the compiler optimises:\n" + "\n".join(f"{p}: {s}" for p, s in sums.items()))


def compiles(*flags):
    return subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-I", ROOT, *flags, ROOT / "common/base/vec.h"],
                          capture_output=True, text=True)


if (plain := compiles()).returncode != 0:
    problems.append(f"common/base/vec.h does not compile:\n{plain.stderr}")
flags = ["-ffast-math", "-Ofast", "-ffinite-math-only"]
if "Free Software" in subprocess.run(
        [compiler, "--version"], capture_output=True, text=True).stdout:
    flags += ["-funsafe-math-optimizations", "-freciprocal-math", "-fno-signed-zeros"]  # clang has no macro for these
for flag in flags:
    refused = compiles(flag)
    if refused.returncode == 0 or "fast-math" not in refused.stderr:
        problems.append(f"common/base/vec.h compiles with {flag}: it must refuse to")

for line in (ROOT / "common/CMakeLists.txt").read_text().splitlines():
    if "target_compile_options(raytree_core" in line and "-ffp-contract=off" in line:
        break
else:
    problems.append("common/CMakeLists.txt: raytree_core must be compiled with -ffp-contract=off")

for problem in problems:
    print(problem, file=sys.stderr)
print(f"{next(iter(sums.values())).strip()}; {len(problems)} problems")
sys.exit(bool(problems))
