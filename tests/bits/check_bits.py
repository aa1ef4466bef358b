#!/usr/bin/env python3
"""The tracer has the same bits elsewhere: its headers, compiled for another machine, and the programs of this one print the same
hashes of all shipped scenes. Skipped (77) without the compiler or what runs its programs.

usage: check_bits.py native|windows|arm64|wasm BITS_NATIVE FOLDER FLAGS [LIBRARY ...]
FOLDER keeps what is built, FLAGS are the product's, LIBRARYs have the tracer in them."""
import json
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
WIDGETS = ROOT / "slides-notes/site/widgets"
STACK = 8 << 20  # bytes, as on Linux
# Functions of the C library for double and float that are not exact; long double's bits are not promised.
OPEN = r"(a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|hypot|cbrt|erfc?|[lt]gamma|fma)f?"
TRACERS = {"entry.cpp.o", "scene.cpp.o"}  # objects of the lessons and of what they ask
FUNCTIONS = ["pow", "atan2", "acos", "hypot", "sin", "tan", "u of an angular sky", "v of an angular sky"] # as in compared.h


def find(*names):
    return next(filter(None, map(shutil.which, names)), None)


def find_clang():
    return find("clang++", *[f"clang++-{version}" for version in range(14, 30)])


def find_glm():
    return next((folder / "glm" for folder in map(pathlib.Path, ("/usr/include", "/usr/local/include")) if (folder / "glm/vec3.hpp").exists()), None)


# Of each machine: its compiler and flags, what runs its program, and Debian's packages that bring both.
def windows():
    wine = find("wine64", "wine", "/usr/lib/wine/wine64")
    return {"compiler": find("x86_64-w64-mingw32-g++"), "compile": [], "link": ["-static", f"-Wl,--stack,{STACK}"], "program": "elsewhere.exe",
            "runs": wine and [wine], "packages": "g++-mingw-w64-x86-64-win32 wine64 libglm-dev"}


def arm64():
    qemu = find("qemu-aarch64", "qemu-aarch64-static")
    return {"compiler": find("aarch64-linux-gnu-g++"), "compile": [], "link": ["-static"], "program": "elsewhere",
            "runs": qemu and [qemu], "packages": "g++-aarch64-linux-gnu qemu-user libglm-dev"}


def wasm():
    node, clang = find("node"), find_clang()
    if not pathlib.Path("/usr/include/wasm32-wasi").exists():
        clang = None
    return {"compiler": clang, "program": "elsewhere.wasm", "runs": node and [node, "--no-warnings", HERE / "run_wasm.mjs"],
            # Nothing throws: the library for it is not packaged.
            "compile": ["--target=wasm32-wasi", "-fignore-exceptions", "-isystem", WIDGETS / "include"],
            "link": ["--target=wasm32-wasi", WIDGETS / "no_throw.cpp", f"-Wl,-z,stack-size={STACK}"],
            "packages": "clang lld wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32 nodejs libglm-dev"}


MACHINES = {"windows": windows, "arm64": arm64, "wasm": wasm}


def fail(message):
    print(message, file=sys.stderr)
    sys.exit(1)


def run(command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, **options)
    if done.returncode:
        fail(f"{shlex.join(map(str, command))}: exit code {done.returncode}\n{(done.stderr or done.stdout).decode(errors='replace')}")
    return done.stdout


def lines(output):
    return output.decode().replace("\r", "").splitlines()


class Elsewhere:
    """The program for another machine, compiled, and its scenes beside it."""

    def __init__(self, name, native, folder, flags):
        made = pathlib.Path(native).resolve().parents[1] / "made" # by lessons/lessons.cmake
        machine = MACHINES[name]()
        glm = find_glm()
        if not (machine["compiler"] and machine["runs"] and glm):
            print(f"skipped: the bits on {name} are not compared, since a compiler for it or what runs its programs is missing; Debian's packages: {machine['packages']}")
            sys.exit(77)
        self.folder = folder / name
        self.runs = [*machine["runs"], machine["program"]]
        (self.folder / "include").mkdir(parents=True, exist_ok=True)
        link = self.folder / "include/glm" # not /usr/include itself: it holds headers of this machine
        if not link.is_symlink():
            link.symlink_to(glm)
        run([native, "--scenes", self.folder / "scenes"])
        cache = find("ccache")
        run([*[cache] * bool(cache), machine["compiler"], "-std=c++20", *flags, *machine["compile"], "-DRAYTREE_HEADERS_ONLY", "-I", ROOT, "-I", made,
             "-isystem", self.folder / "include", "-c", HERE / "elsewhere.cpp", "-o", self.folder / "elsewhere.o"])
        run([machine["compiler"], *machine["link"], self.folder / "elsewhere.o", "-o", self.folder / machine["program"]])
        if name == "wasm":
            self.runs.append(".") # the folder that it may read
        self.environment = dict(os.environ)
        if name == "windows":
            self.prepare_wine()

    def prepare_wine(self):
        """A folder for Wine that ends with the test. Made as Wine likes it, it has 695 MB and takes half a minute; programs of the
        console need none of that, and Wine finds its own libraries in the mode in which it makes such a folder."""
        self.wine = tempfile.TemporaryDirectory(prefix="raytree-wine-", ignore_cleanup_errors=True)
        pathlib.Path(self.wine.name, ".update-timestamp").write_text("disable")
        self.environment |= {"WINEPREFIX": self.wine.name, "WINEDEBUG": "-all", "WINEBOOTSTRAPMODE": "1", "WINEDLLOVERRIDES": "mscoree,mshtml,winemenubuilder.exe=d"}
        self.environment.pop("DISPLAY", None)
        tried = subprocess.run(self.runs, cwd=self.folder, env=self.environment, capture_output=True)
        if b"usage: elsewhere" not in tried.stderr: # another Wine: as it likes it
            del self.environment["WINEBOOTSTRAPMODE"]
            pathlib.Path(self.wine.name, ".update-timestamp").unlink()

    def __call__(self, *words):
        return lines(run([*self.runs, "scenes", *words], cwd=self.folder, env=self.environment))


def bits(number):
    return struct.pack(">d", number).hex()


def values(native, path, what):
    """Name and number of all that a picture or a tree holds, in order."""
    if what == "picture":
        data = path.read_bytes()
        width, _ = struct.unpack_from("<ii", data)
        for i, (number,) in enumerate(struct.iter_unpack("<d", data[8:])):
            yield f"pixel ({i // 3 % width}, {i // 3 // width}) {('red', 'green', 'blue')[i % 3]}", number
    elif what == "values":
        for i, (number,) in enumerate(struct.iter_unpack("<d", path.read_bytes())):
            yield f"{FUNCTIONS[i % len(FUNCTIONS)]} number {i // len(FUNCTIONS)}", number
    else:
        def walk(place, value):
            if isinstance(value, (dict, list)):
                for key, inner in (value.items() if isinstance(value, dict) else enumerate(value)):
                    yield from walk(f"{place}.{key}" if isinstance(value, dict) else f"{place}[{key}]", inner)
            else:
                yield place, value
        yield from walk("tree", json.loads(run([native, "--json", path])))


def first_difference(native, here, there, what):
    ours, theirs = list(values(native, here, what)), list(values(native, there, what))
    for (place, a), (other, b) in zip(ours, theirs):
        if place != other:
            return f"{place} here is {other} there"
        if isinstance(a, float) and isinstance(b, float) and bits(a) != bits(b):
            return f"{place} is {a!r} (bits {bits(a)}) here and {b!r} (bits {bits(b)}) there"
        if a != b and not (a != a and b != b):
            return f"{place} is {a!r} here and {b!r} there"
    return f"{len(ours)} numbers here, {len(theirs)} there" if len(ours) != len(theirs) else "something that JSON does not tell apart: NaN, infinities or kinds of zero"


def explain(name, line, other, native, elsewhere, folder):
    """Why the two lines differ, by running both programs once more for it."""
    file, lesson, kind = re.fullmatch(r"(\S+) lesson (\d+) (\w+): .*", line).groups()
    run([native, file, lesson, kind, folder / "here"])
    elsewhere(file, lesson, kind, "there")
    for what, here in re.findall(r"(\w+) ([0-9a-f]{16})", line):
        if f"{what} {here}" not in other:
            where = first_difference(native, folder / f"here.{what}", folder / f"there.{what}", what)
            print(f"{name}, {file}, lesson {int(lesson):02}, {kind}: the {what} has other bits: {where}", file=sys.stderr)


def compare_elsewhere(name, native, folder, flags):
    elsewhere = Elsewhere(name, native, folder, flags)
    ours, theirs = lines(run([native])), elsewhere()
    if len(ours) != len(theirs):
        fail(f"{name}: {len(theirs)} lines of hashes, expected {len(ours)}")
    different = [(a, b) for a, b in zip(ours, theirs) if a != b]
    for a, b in different[:5]:
        explain(name, a, b, native, elsewhere, elsewhere.folder)
    if different:
        fail(f"{name}: {len(different)} of {len(ours)} lines differ")
    print(f"{name}: {len(ours)} lines of hashes are those of this machine")


def check_calls(libraries):
    """The tracer asks the C library for no function that IEEE 754 leaves open. This names it on any machine."""
    reader = find("nm")
    if not reader:
        fail("nm is not installed: what the tracer calls is not known; Debian's package: binutils")
    read = set()
    for library in libraries:
        for line in lines(run([reader, "-A", "--undefined-only", library])):
            place, _, called = line.rsplit(None, 2)  # a path may have blanks
            place = place.rstrip(":")
            member = place.split(":")[-1]
            if member not in TRACERS:
                continue
            read.add(member)
            if re.fullmatch(OPEN, called):
                fail(f"{place} calls {called} of the C library, whose bits depend on the machine: expected portable::{called.removesuffix('f')} (common/base/portable.h)")
    if read != TRACERS:
        fail(f"{', '.join(libraries)} have {sorted(read)}, expected {sorted(TRACERS)}: what the tracer calls is not known")


def compare_stored(native):
    """With what is stored: so other compilers, libraries and processors are held to one another."""
    ours, stored = lines(run([native])), (HERE / "hashes.txt").read_text().splitlines()
    for line in sorted(set(ours) ^ set(stored)):
        print(f"{'+' if line in ours else '-'} {line}", file=sys.stderr)
    if ours != stored:
        fail("native: the lines with - are stored in tests/bits/hashes.txt, those with + are this machine's; if scenes or lessons were changed on purpose: bits_native > tests/bits/hashes.txt")
    print(f"native: {len(ours)} lines of hashes are the stored ones")


def main():
    if len(sys.argv) < 5 or sys.argv[1] not in ("native", *MACHINES):
        print(__doc__, file=sys.stderr)
        return 2
    name, native, folder, flags, *libraries = sys.argv[1:]
    if name == "native":
        check_calls(libraries)
        compare_stored(native)
    else:
        compare_elsewhere(name, native, pathlib.Path(folder), flags.split())
    return 0


if __name__ == "__main__":
    sys.exit(main())
