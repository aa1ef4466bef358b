#!/usr/bin/env python3
"""Makes the kits: what the compile box sees. One a group of lessons, as a lesson's own functions must not be in it.

    make_kit.py OUT COMPILER KIT

writes OUT/KIT, which is 01, 04 or rest, with the headers that tests/grade/wire/student.h needs, precompiled, the runner's
object and exercise.student.cpp; and OUT/flags, one a line, that all of it is and must be compiled with, OUT/compiler, and OUT/compiler_files,
what a root folder must hold for it to run in. In OUT/01 rays meet neither spheres nor planes; in OUT/01 and OUT/04
the lat-long map throws NotAttempted.
"""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
WIRE = "tests/grade/wire"
SOURCES = [f"{WIRE}/student.h", f"{WIRE}/exercise.student.cpp", f"{WIRE}/runner.student.cpp"]
# A mark as often as it stands in common/: spheres are met in shapes.h, sphere_search.h and look_ahead.h.
STUBS = {"01": ["01-sphere"] * 3 + ["01-plane"] * 2 + ["04-latlong"], "04": ["04-latlong"], "rest": []}
FILL = "-ftrivial-auto-var-init=pattern"  # of ours; a precompiled header serves the others too
# Lesson 01's recorder asks what blocks a shadow ray; a mark thrown there would look like the student's.
BODIES = {"01-sphere": "return {};", "01-plane": "return {};"}
# One machine for all: no -march. Whoever nests templates deeper than this, or lets the compiler compute longer, exhausts it.
FLAGS = ["-std=c++20", "-O1", "-DRAYTREE_HEADERS_ONLY", "-ffp-contract=off", "-fno-lto", "-fno-diagnostics-show-caret",
         "-fdiagnostics-color=never", "-fmax-errors=20", "-ftemplate-depth=200", "-fconstexpr-depth=256", "-fconstexpr-ops-limit=10000000",
         "-fconstexpr-loop-limit=1000000", "-ftemplate-backtrace-limit=4", "-w", "-pipe"]


def headers(compiler):
    """The headers of ours that the student's side includes."""
    files = set()
    for source in SOURCES:
        if source.endswith("exercise.student.cpp"):
            continue
        # -I. and no whole path: make would have its blanks escaped.
        made = subprocess.run([compiler, "-std=c++20", "-x", "c++", "-I.", "-MM", source], cwd=ROOT, check=True,
                              capture_output=True, text=True).stdout
        files |= {pathlib.Path(word) for word in re.sub(r"\\\n", " ", made).split()[1:]}
    files.add(pathlib.Path(SOURCES[1]))
    for file in files:
        if "trace.h" == file.name or file.name == "geometry.h" or "questions" in file.parts or "box" in file.parts:
            sys.exit(f"make_kit.py: {file} holds solutions and must not be in a kit")
    return sorted(files)


def said(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True, stdin=subprocess.DEVNULL, env={"PATH": "/usr/bin:/bin", "LC_ALL": "C"})


def place(file):
    """The file without links in the folders that lead to it: /lib/x is /usr/lib/x."""
    path = pathlib.Path(file)
    return path.parent.resolve() / path.name


def compiler_files(compiler):
    """All that compiling needs: programs with their libraries, what is linked statically, headers of the standard library."""
    found = {place(compiler)}
    for name in ("cc1plus", "collect2", "as", "ld"):
        if program := shutil.which(said(compiler, f"-print-prog-name={name}").stdout.strip()):  # another compiler has others
            found.add(place(program))
    for program in list(found):
        found |= {place(file) for file in re.findall(r"(/\S+) \(0x", said("ldd", str(program)).stdout)}
    names = ["crt1.o", "crti.o", "crtn.o", "crtbegin.o", "crtbeginT.o", "crtend.o", "libstdc++.a", "libm.a", "libgcc.a", "libgcc_eh.a", "libc.a",
             "liblto_plugin.so"]
    linked = [pathlib.Path(said(compiler, f"-print-file-name={name}").stdout.strip()) for name in names]
    linked = {place(path) for path in linked if path.is_absolute()}
    for path in linked:
        if path.stat().st_size < 1000 and b"GNU ld script" in path.read_bytes():  # libm.a names two others
            found |= {place(file) for file in re.findall(r"/\S+", path.read_text()) if pathlib.Path(file).is_file()}
    listing = said(compiler, "-x", "c++", "-v", "-E", "/dev/null").stderr
    for folder in re.search(r"<\.\.\.> search starts here:\n(.*?)End of search", listing, re.S)[1].split():
        path = pathlib.Path(folder).resolve()
        parts = [path] if "c++" in path.parts or "gcc" in path.parts else [path / name for name in ("asm", "asm-generic", "bits", "c++", "glm", "gnu", "linux", "sys")]
        found |= {file for part in parts for file in part.rglob("*") if file.is_file()}
        found |= {file for file in path.glob("*.h") if file.is_file()}
    return sorted(map(str, found | linked))


def stubbed(text, ids):
    """The text with the solutions of these ids replaced, and how many that were. Marks of others are removed."""
    count = 0

    def body(match):
        nonlocal count
        if match["id"] not in ids:
            return match["body"]
        count += 1
        return match["indent"] + BODIES.get(match["id"], f'todo("{match["id"]}");') + "\n"

    text = re.sub(r"^(?P<indent> *)// SOLUTION (?P<id>\S+)\n(?P<body>.*?)^ *// END\n", body, text, flags=re.M | re.S)
    if count:
        text = text.replace("#pragma once\n", '#pragma once\n\n#include "common/base/todo.h"\n', 1)
    return text, count


def main():
    out, compiler, kit = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3]
    ids = STUBS[kit]
    if (out / kit).exists():
        shutil.rmtree(out / kit)
    replaced = 0
    for file in headers(compiler):
        text, count = stubbed((ROOT / file).read_text(), ids)
        replaced += count
        (out / kit / file).parent.mkdir(parents=True, exist_ok=True)
        (out / kit / file).write_text(text)
    if replaced != len(ids):
        sys.exit(f"make_kit.py: kit {kit}: {len(ids)} solutions should be replaced, {replaced} were found")
    run = [compiler, *FLAGS, "-I."]
    runner = f"{WIRE}/runner.student.cpp"
    subprocess.run([*run, FILL, "-c", runner, "-o", "runner.o"], cwd=out / kit, check=True)
    (out / kit / runner).unlink()
    subprocess.run([*run, FILL, "-x", "c++-header", f"{WIRE}/student.h"], cwd=out / kit, check=True)
    (out / "flags").write_text("\n".join(FLAGS) + "\n")
    whole = str(pathlib.Path(shutil.which(compiler)).resolve())
    (out / "compiler_files").write_text("".join(f"{file}\n" for file in compiler_files(whole)))
    (out / "compiler").write_text(whole + "\n")


main()
