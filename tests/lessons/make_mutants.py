#!/usr/bin/env python3
"""Makes known-wrong tracers from mutants.toml and the solved exercises.

    make_mutants.py DIR                      writes DIR/mutantsNN.cpp, one for each lesson, and DIR/mutants.cpp
    make_mutants.py DIR variants FILE.toml   the same from [[variant]] entries of another file, with that name
"""
import collections
import json
import pathlib
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "lessons"))
import make_exercises

target = pathlib.Path(sys.argv[1])
target.mkdir(parents=True, exist_ok=True)
plural = sys.argv[2] if len(sys.argv) > 2 else "mutants"
listed = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else HERE / "mutants.toml"
entries = make_exercises.manifest()
solved = {trace.parent.name[:2]: make_exercises.exercise(trace, entries, solved=True)
          for trace in make_exercises.LESSONS.glob("[0-9][0-9]_*/trace.h") if "// SOLUTION" in trace.read_text()}
mutants = collections.defaultdict(list)
with open(listed, "rb") as file:
    for mutant in tomllib.load(file)[plural.removesuffix("s")]:
        mutants[mutant["id"][:2]].append(mutant)

for number in sorted(solved):
    text = f'#include "tests/lessons/mutants.h"\n#include "solved{number}.h"\n'
    rows = []
    for mutant in mutants[number]:
        if solved[number].count(mutant["find"]) != 1:
            sys.exit(f"{listed.name}: {mutant['id']}: \"{mutant['find']}\" stands {solved[number].count(mutant['find'])} times in "
                     f"solved exercise {number}, expected once")
        space = plural.removesuffix("s") + "_" + mutant["id"].replace("-", "_")
        text += solved[number].replace(mutant["find"], mutant.get("replace", "")).replace(f"solved{number}", space).replace("#pragma once", "")
        groups = ", ".join(json.dumps(group) for group in mutant.get("stub", []))
        rows.append(f"        {{{json.dumps(mutant['id'])}, {json.dumps(mutant['mistake'])}, {{{groups}}}, "
                    f"{json.dumps(mutant.get('endless', False))}, exerciseSubject<{space}::Tracer>()}},\n")
    text += (f"\nnamespace rt::cases\n{{\nstd::vector<Mutant> {plural}{number}()\n{{\n    return {{\n{''.join(rows)}    }};\n}}\n}}\n")
    (target / f"{plural}{number}.cpp").write_text(text)

numbers = sorted(solved)
text = '#include "tests/lessons/mutants.h"\n\nnamespace rt::cases\n{\n'
text += "".join(f"std::vector<Mutant> {plural}{n}();\n" for n in numbers)
text += f"std::vector<Mutant> {plural}(int lesson)\n{{\n"
text += "".join(f"    if (lesson == {int(n)}) return {plural}{n}();\n" for n in numbers)
text += "    return {};\n}\n}\n"
(target / f"{plural}.cpp").write_text(text)
