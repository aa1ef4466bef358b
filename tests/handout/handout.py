#!/usr/bin/env python3
"""Packs the course for students: exercises as shipped, scenes, notes, public cases; no solutions.

    handout.py [--out DIR] [--lessons 0-8] [--mistakes DIR]

writes the folder DIR and, next to it, DIR.tar.gz: whole or not at all, and the same bytes each time. --mistakes names a
folder with NN.json of the program grade_mistakes: what known mistakes answer to the public cases.
Exit codes: 0 done, 2 bad usage, or DIR is not ours to overwrite.
"""
import argparse
import gzip
import hashlib
import io
import json
import os
import pathlib
import re
import shutil
import sys
import tarfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TEMPLATES = pathlib.Path(__file__).resolve().parent
MARKER = ".raytree-handout"  # says that a folder is a hand-out, and how its files were
sys.path.insert(0, str(ROOT / "lessons"))
sys.dont_write_bytecode = True
import make_exercises  # noqa: E402

# What is taken as it is, apart from marks. Nothing else is: a new file stays inside until it is named here.
COMMON = ["common/*.h", "common/*/*.h", "common/*/*.cpp", "common/*/*.json", "common/CMakeLists.txt", "common/SCENES.md"]
PROGRAMS = ["lessons/lessons.cmake", "lessons/*/lesson.toml", "lessons/programs/exercise.cpp.in", "lessons/programs/exercise_main.*", "lessons/programs/facts.*", "lessons/programs/program.*", "lessons/programs/program_main.h"]
GEOMETRY = ["functions.h", "figures/*", "program.cpp", "tutorial.cpp", "tutorial.h"]
CASES = ["check.h", "run_cases.h", "subject.h", "scenes.h", "cases.h", "lesson00_subject.h", "lesson00_cases.*"]
ENGINE = ["tests/grade/result.*", "tests/grade/candidate.h", "tests/grade/box/*", "tests/grade/wire/*",
          "tests/learn/*.h", "tests/learn/*.cpp", "tests/grade/questions/manifest.*",
          "tests/grade/questions/mistakes.*", "tests/grade/questions/in_float.h"]
# What needs lessons, mistakes or a sandbox.
NOT_ENGINE = re.compile(r"_test\.cpp$|/mistakes_main\.cpp$|\.md$|/probe\.|/launch_main|/selftest|/seccomp\.cpp|/reference|"
                        r"/misbehaving|\.cmake$")
LESSONS = make_exercises.lessons()


class Refused(Exception):
    """One sentence for the user."""


def lesson_range(text):
    found = re.fullmatch(r"(\d+)(?:-(\d+))?", text)
    first, last = (int(found[1]), int(found[2] or found[1])) if found else (1, 0)
    chosen = [lesson for lesson in LESSONS if first <= lesson <= last]
    if not chosen or chosen[0] != first or chosen[-1] != last:
        raise Refused(f"--lessons {text}: expected numbers from {LESSONS[0]} to {LESSONS[-1]} of lessons that have exercises, as in 0-3")
    return chosen


def case_files():
    """(lesson, path, function) of the cases of each lesson: a file's first line says whose it has."""
    found = []
    for path in sorted(ROOT.glob("tests/cases/cases_*.cpp")):
        text = path.read_text()
        found.append((int(re.match(r"// Lesson (\d\d)", text)[1]), path.relative_to(ROOT),
                      re.search(r"^std::vector<Case> (\w+)\(\)$", text, re.M)[1]))
    return sorted(found)


def folder_of(lesson):
    return next(ROOT.glob(f"lessons/{lesson:02}_*"))


def source(path):
    return (ROOT / path).read_text()


class Handout:
    def __init__(self, lessons, mistakes):
        self.lessons = lessons
        self.files = {}  # path in the hand-out -> (bytes, executable)
        self.kept = []   # solutions that had to stay, since later exercises stand on them
        self.entries = make_exercises.manifest()
        self.programs()
        for lesson in lessons:
            self.lesson(lesson)
        self.cases()
        self.engine(mistakes)
        self.project()
        self.notes()
        self.links()

    def add(self, path, content, executable=False):
        data = content if isinstance(content, bytes) else content.encode()
        self.files[str(path)] = (data, executable)

    def copy(self, *patterns, without=None):
        for pattern in patterns:
            for path in sorted(ROOT.glob(pattern)):
                name = str(path.relative_to(ROOT))
                if path.is_file() and not (without and without.search(name)):
                    self.add(name, path.read_bytes())

    def template(self, name, **values):
        text = (TEMPLATES / name).read_text()
        for key, value in values.items():
            text = text.replace(f"@{key}@", value)
        return text

    def programs(self):
        self.copy(*COMMON, *PROGRAMS)
        for path in [name for name in self.files if name.startswith("common/") and name.endswith(".h")]:
            text = self.files[path][0].decode()
            if make_exercises.SOLUTION.search(text):
                self.add(path, self.core(path, text))

    def core(self, path, text):
        """Lessons that come later borrow the robust formulas of the core; the last one that is handed out must not."""
        redacted = False

        def body(match):
            nonlocal redacted
            if int(match["id"][:2]) < self.lessons[-1]:
                self.kept.append((match["id"], path))
                return match["body"]
            redacted = True
            return f"{match['indent']}todo(\"{match['id']}\");\n"

        text = make_exercises.SOLUTION.sub(body, text)
        if redacted and '"common/base/todo.h"' not in text:
            first = re.search(r'^#include "common/\S+"\n', text, re.M)
            text = text[:first.end()] + '#include "common/base/todo.h"\n' + text[first.end():]
        return text

    def lesson(self, lesson):
        folder = folder_of(lesson)
        name = folder.relative_to(ROOT)
        trace = folder / ("geometry.h" if lesson == 0 else "trace.h")
        # Made anew: the working copy may have been solved.
        self.add(name / "exercise.h", make_exercises.exercise(trace, self.entries, False))
        self.copy(f"{name}/scenes/*")
        if lesson == 0:
            self.copy(f"{name}/exercise.cpp", *[f"{name}/{pattern}" for pattern in GEOMETRY])
        self.add(name / "README.md", self.text(source(name / "README.md")))

    def cases(self):
        self.copy(*[f"tests/cases/{name}" for name in CASES], without=re.compile("_test"))
        later = []
        for lesson, path, function in case_files():
            if lesson in self.lessons:
                self.copy(str(path), f"tests/cases/golden/{lesson:02}_*.exr")
            else:
                later.append(f"std::vector<Case> {function}()\n{{\n    return {{}};\n}}\n")
        if later:
            self.add("tests/cases/cases_later.cpp",
                     "// Lessons that this hand-out does not have.\n#include \"tests/cases/cases.h\"\n\n"
                     "namespace rt::cases\n{\n\n" + "\n".join(later) + "\n} // namespace rt::cases\n")
        for lesson in self.lessons:
            name = "geometry_cases_test.cpp.in" if lesson == 0 else "exercise_cases_test.cpp.in"
            self.add(f"tests/exercises/exercise{lesson:02}_test.cpp",
                     self.template(name, NN=f"{lesson:02}", N=str(lesson), FOLDER=folder_of(lesson).name))
        self.copy("tests/learn/exercise_cases.h")
        self.add("tests/CMakeLists.txt", self.template("tests.cmake.in", LESSONS=self.numbers()))

    def engine(self, mistakes):
        self.copy(*ENGINE, without=NOT_ENGINE)
        # Nothing is graded here, so one kit serves all (Kit::whole): the robust formulas may be in it.
        kit = self.files["tests/grade/box/make_kit.py"][0].decode()
        kit, found = re.subn(r"^STUBS = \{.*\}$", 'STUBS = {"rest": []}', kit, flags=re.M)
        if found != 1:
            raise Refused("tests/grade/box/make_kit.py: there is no line STUBS = {...}")
        self.add("tests/grade/box/make_kit.py", kit)
        self.add("tests/grade/box/no_sandbox.cpp", self.template("no_sandbox.cpp.in"))
        self.add("tests/grade/CMakeLists.txt", self.template("grade.cmake.in"))
        for lesson in self.lessons:
            path = mistakes / f"{lesson:02}.json" if mistakes else None
            if path and path.is_file():
                self.add(f"tests/grade/mistakes/{lesson:02}.json", path.read_bytes())

    def project(self):
        self.copy("LICENSE", "CMakeLists.txt", ".clang-format")
        chosen = [entry for entry in self.entries.values() if entry["lesson"] in self.lessons]
        head, *blocks = re.split(r"^(?=\[\[exercise\]\])", source("lessons/exercises.toml"), flags=re.M)
        ids = {entry["id"] for entry in chosen}
        self.add("lessons/exercises.toml",
                 head.replace(" `id` is the mark in the sources: // SOLUTION id ... // END.", "")
                 + "".join(block for block in blocks if re.search(r'^id = "(.*)"', block, re.M)[1] in ids))
        self.add("lessons/CMakeLists.txt", self.template(
            "lessons.cmake.in", LESSONS=" ".join(folder_of(n).name for n in self.lessons if n)))
        presets = json.loads(source("CMakePresets.json"))
        for kind in ("configurePresets", "buildPresets", "testPresets"):
            presets[kind] = [preset for preset in presets[kind] if preset["name"] in ("base", "student")]
        for preset in presets["configurePresets"]:
            if preset["name"] == "student":  # a hand-out is for `learn`
                preset["cacheVariables"] |= {"RAYTREE_GRADER": "ON", "RAYTREE_PICTURES": "ON"}
        self.add("CMakePresets.json", json.dumps(presets, indent=2) + "\n")
        self.add("raytree", self.template("raytree.in", LESSONS=self.numbers()), True)
        self.copy("common/front_door.sh", "common/help/learn.txt", "common/help/exercise*.txt")
        table = "".join(f"| [{folder_of(n).name}](lessons/{folder_of(n).name}/README.md) | "
                        f"{sum(e['points'] for e in chosen if e['lesson'] == n)} | `./raytree learn {n}` |\n"
                        for n in self.lessons)
        self.add("README.md", self.template("README.md.in", TABLE=table, FIRST=str(self.lessons[0])))
        self.add(".gitignore", "/build/\n/out/\n*.part\n/.raytree-learn.json*\n/exercise[0-9][0-9].png\n")

    def numbers(self):
        return " ".join(f"{lesson:02}" for lesson in self.lessons)

    def text(self, markdown):
        """Notes and READMEs for somebody who has the exercises and not the lessons."""
        markdown = re.sub(r"<!-- from (?P<path>\S+)/\w+\.h -->\n```cpp\n(?P<code>.*?)^```\n", self.excerpt, markdown,
                          flags=re.M | re.S)
        markdown = markdown.replace("trace.h", "exercise.h").replace("geometry.h", "exercise.h")
        markdown = re.sub(r"\./raytree lesson (\d+)\b",
                          lambda found: f"./raytree exercise {found[1]}" if int(found[1]) in LESSONS else found[0], markdown)
        return re.sub(r"^(?:mkdir -p out && )?\./raytree (?:(?!exercise |learn|test).*|.*--make-sky.*)\n", "", markdown,
                      flags=re.M)

    def excerpt(self, match):
        """Code in the notes stays if it stands in the exercise."""
        exercise, _ = self.files.get(match["path"] + "/exercise.h", (b"", False))
        if match["code"] in exercise.decode():
            return match[0]
        return "*(These lines are yours to write.)*\n"

    def notes(self):
        pages = [next(ROOT.glob(f"slides-notes/{lesson:02}-*.md")) for lesson in self.lessons]
        for page in [*pages, ROOT / "slides-notes/glossary.md"]:
            text = self.text(page.read_text())
            if page.name.startswith("00"):  # the tutorial's answers, worked out
                text = re.sub(r"^## Exercise 1.*?(?=^## Erratum)", "", text, flags=re.M | re.S)
            self.add(f"slides-notes/{page.name}", text)
            for picture in re.findall(r"\]\((pictures/\S+?)\)", text):
                self.copy(f"slides-notes/{picture}")
        errata = re.sub(r" The tests are in \[.*", "", self.text(source("slides-notes/errata.md")))
        self.add("slides-notes/errata.md", re.sub(r" \| (?:test|---|`Errata\.\w+`) \|$", " |", errata, flags=re.M))
        rows = []
        for row in source("slides-notes/README.md").splitlines(keepends=True):
            page = re.search(r"\((\d\d)-\S+\.md\)", row)
            outside = row.startswith("Begin with [the first hour]")  # pages that are not in the hand-out
            if not outside and (not page or int(page[1]) in self.lessons):
                rows.append(row)
        index = self.text("".join(rows))
        self.add("slides-notes/README.md", re.sub(r"\n\| beyond the slides .*?\n(?=\n)", "", index, flags=re.S))

    def links(self):
        """What leads out of the hand-out is no link any more."""
        for name in [name for name in self.files if name.endswith(".md")]:
            here = pathlib.PurePosixPath(name).parent

            def link(match):
                target = os.path.normpath(here / match["target"].split("#")[0])
                if re.match(r"https?:", match["target"]) or target in self.files or any(
                        other.startswith(target + "/") for other in self.files):
                    return match[0]
                return match["text"]

            text = re.sub(r"(?<!!)\[(?P<text>[^\]\n]*)\]\((?P<target>[^)\s]+)\)", link, self.files[name][0].decode())
            self.add(name, text)

    def marker(self):
        digests = {name: hashlib.sha256(data).hexdigest() for name, (data, _) in sorted(self.files.items())}
        return (json.dumps({"raytree": "hand-out", "lessons": list(self.lessons), "files": digests}, indent=1)
                + "\n").encode()


def check_target(out):
    """Only an earlier hand-out in which nobody has worked is overwritten."""
    if not out.exists():
        return
    if not out.is_dir():
        raise Refused(f"{out} is not a folder")
    if not any(out.iterdir()):
        return
    try:
        files = json.loads((out / MARKER).read_text())["files"]
    except (OSError, ValueError, KeyError, TypeError):
        raise Refused(f"{out} is not empty, and no earlier hand-out: nothing was written") from None
    for name, digest in files.items():
        path = out / name
        if path.is_file() and hashlib.sha256(path.read_bytes()).hexdigest() != digest:
            raise Refused(f"{out} is a hand-out in which somebody has worked ({name}): nothing was written")


def archive(files, folder):
    """The same files give the same bytes: no times, owners or order of the file system."""
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w", format=tarfile.GNU_FORMAT) as tar:
        for name, (data, executable) in sorted(files.items()):
            info = tarfile.TarInfo(f"{folder}/{name}")
            info.size, info.mode = len(data), 0o755 if executable else 0o644
            tar.addfile(info, io.BytesIO(data))
    packed = io.BytesIO()
    with gzip.GzipFile(fileobj=packed, mode="wb", mtime=0, filename="") as out:
        out.write(plain.getvalue())
    return packed.getvalue()


def write(files, out):
    """All of it beside its place first, then by renaming."""
    part, old = out.with_name(out.name + ".part"), out.with_name(out.name + ".old.part")
    packed = out.with_name(out.name + ".tar.gz")
    packed_part = out.with_name(out.name + ".tar.gz.part")
    try:
        for left in (part, old):
            shutil.rmtree(left, ignore_errors=True)
        for name, (data, executable) in files.items():
            path = part / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
            path.chmod(0o755 if executable else 0o644)
        packed_part.write_bytes(archive(files, "raytree"))
        if out.exists():
            out.rename(old)
        part.rename(out)
        packed_part.rename(packed)
    except OSError as error:
        if old.exists() and not out.exists():
            old.rename(out)
        raise Refused(f"{out} could not be written: {error.strerror}") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)
        shutil.rmtree(old, ignore_errors=True)
        if packed_part.is_file():
            packed_part.unlink()
    return packed


def notice(handout):
    last = handout.lessons[-1]
    if last > handout.lessons[0]:
        print(f"Exercise N shows the solved functions of the lessons before it; to hand out week by week, use "
              f"--lessons 0-N (this one has {handout.lessons[0]}-{last}).")
    if handout.kept:
        kept = ", ".join(f"{name} in {path}" for name, path in handout.kept)
        print(f"Robust forms of exercises stay, since later exercises stand on them: {kept}.")


def main():
    parser = argparse.ArgumentParser(prog="raytree handout", description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/handout", help="default: out/handout")
    parser.add_argument("--lessons", default=f"{LESSONS[0]}-{LESSONS[-1]}", help="as in 0-3; default: %(default)s")
    parser.add_argument("--mistakes", type=pathlib.Path, default=ROOT / "tests/grade/mistakes",
                        help="folder of NN.json, made by grade_mistakes; default: the stored ones")
    args = parser.parse_args()
    try:
        out = pathlib.Path(os.path.abspath(args.out))
        lessons = lesson_range(args.lessons)
        check_target(out)
        handout = Handout(lessons, args.mistakes)
        handout.add(MARKER, handout.marker())
        packed = write(handout.files, out)
    except Refused as refused:
        print(f"raytree handout: {refused}", file=sys.stderr)
        sys.exit(2)
    except OSError as error:
        print(f"raytree handout: {error.filename or args.out}: {error.strerror}", file=sys.stderr)
        sys.exit(2)
    notice(handout)
    print(out)
    print(packed)


if __name__ == "__main__":
    main()
