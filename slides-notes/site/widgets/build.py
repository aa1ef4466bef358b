#!/usr/bin/env python3
"""Writes the widgets of the notes: widgets.js, with the lessons' C++ in it as WebAssembly, and widgets.css.

usage: build.py OUTDIR

Exit codes: 0 done, 2 bad usage or a mistake in the sources, 3 a package is missing."""
import base64
import functools
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PARTS = ["core", "drawing", "slider", "line", "cosine", "reflect", "partial", "bowling", "refract", "fresnel", "cap", "phong"]
EXPORTS = ["results", "line", "cosine", "reflect", "partial", "bowling", "refract", "fresnel", "cap", "phong"]
PACKAGES = "clang lld wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32 libglm-dev"
OLDEST = 14


NOT_HERE = 3  # exit code: a package is missing, so that a site is made without widgets


def fail(message, code=2):
    print(f"build.py: {message}", file=sys.stderr)
    sys.exit(code)


def find_clang():
    """The packaged clang that has all it needs: Debian's default, whose name has no version, else the newest of the others."""
    names = ["clang++", *(f"clang++-{version}" for version in range(99, OLDEST - 1, -1))]
    found = [path for path in map(shutil.which, names) if path and version_of(path) >= OLDEST]
    return next(filter(is_whole, found), found[0] if found else None)


@functools.cache
def version_of(clang):
    done = subprocess.run([clang, "-dumpversion"], capture_output=True, text=True)
    return int((re.match(r"\d+", done.stdout) or ["0"])[0])


@functools.cache
def is_whole(clang):
    """Whether it has the C++ library and the linker of its own version: packages of several versions may lie side by side."""
    text = "#include <cmath>\n#include <new>\nint main(int count, char**) { return int(std::sqrt(double(count))) + !new (std::nothrow) int(count); }\n"
    with tempfile.TemporaryDirectory(prefix="raytree-clang-") as folder:
        done = subprocess.run([clang, "--target=wasm32-wasi", "-x", "c++", "-", "-o", f"{folder}/whole.wasm"], input=text, capture_output=True, text=True)
    return done.returncode == 0


def find_glm():
    return next((folder / "glm" for folder in map(pathlib.Path, ("/usr/include", "/usr/local/include")) if (folder / "glm/vec3.hpp").exists()), None)


def missing():
    """Why nothing can be built here, as a sentence; empty if it can."""
    if not find_clang():
        return f"the widgets of the notes need clang++ {OLDEST} or newer, which compiles the lessons to WebAssembly; Debian's packages: {PACKAGES}"
    if not find_glm():
        return "the widgets of the notes need GLM in /usr/include or /usr/local/include; Debian's package: libglm-dev"
    if not pathlib.Path("/usr/include/wasm32-wasi").exists():
        return f"the widgets of the notes need a C library for WebAssembly in /usr/include/wasm32-wasi; Debian's packages: {PACKAGES}"
    if not is_whole(find_clang()):
        return f"the widgets of the notes need a C++ library and a linker for WebAssembly of the same version as {find_clang()}; Debian's packages: {PACKAGES}"
    return ""


def compile_formulas(folder):
    """The lessons as a WebAssembly module of a few kB. They throw only what cannot happen here; then the module stops."""
    include = pathlib.Path(folder, "include")
    include.mkdir()
    (include / "glm").symlink_to(find_glm()) # not /usr/include itself: it holds headers of another machine
    module = pathlib.Path(folder, "formulas.wasm")
    command = [find_clang(), "--target=wasm32-wasi", "-std=c++20", "-Oz", "-DNDEBUG", "-DRAYTREE_HEADERS_ONLY", "-flto", "-fignore-exceptions", "-ffunction-sections",
               "-ffp-contract=off", "-I", str(ROOT), "-isystem", str(include), "-isystem", str(HERE / "include"),
               "-mexec-model=reactor", "-Wl,--gc-sections,--strip-all,--lto-O2", *[f"-Wl,--export={name}" for name in EXPORTS],
               str(HERE / "formulas.cpp"), str(HERE / "no_throw.cpp"), "-o", str(module)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        fail(f"formulas.cpp does not compile to WebAssembly (packages: {PACKAGES}):\n{done.stderr}")
    return module.read_bytes()


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    if why := missing():
        fail(why, NOT_HERE)
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="raytree-widgets-") as folder:
        module = base64.b64encode(compile_formulas(folder)).decode()
    parts = [(HERE / f"{name}.js").read_text() for name in PARTS]
    script = '"use strict";\n(() => {\nconst MODULE = "' + module + '";\n' + "\n".join(parts) + "\nstart();\n})();\n"
    for name, text in (("widgets.js", script), ("widgets.css", (HERE / "widgets.css").read_text())):
        part = out / (name + ".part")
        part.write_text(text)
        part.replace(out / name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
