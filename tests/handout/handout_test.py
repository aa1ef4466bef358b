#!/usr/bin/env python3
"""The hand-out: what must not be in it, that it comes whole or not at all, and that a student can work with it.

    handout_test.py BUILD [TEST...]     BUILD/handout_test is where it unpacks and builds: always the same place, so that
                                        ccache knows it
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(ROOT / "lessons"))
sys.dont_write_bytecode = True
import make_exercises  # noqa: E402

LESSONS = make_exercises.lessons()
CORE = ("common/base/shapes.h", "common/scene/sky.h", "common/search/sphere_search.h", "common/search/look_ahead.h")


def pack(out, *options, root=ROOT):
    script = root / "tests/handout/handout.py"
    return subprocess.run([sys.executable, "-B", str(script), "--out", str(out), *options], capture_output=True, text=True)


def normal(text):
    """Without comments and white space: a solution that was only formatted anew is still one."""
    return re.sub(r"\s+", "", re.sub(r"//[^\n]*", "", text))


def solutions():
    """Of each exercise: its lesson, id and the lines between its marks."""
    for trace in sorted([*ROOT.glob("lessons/00_*/geometry.h"), *ROOT.glob("lessons/*/trace.h")]):
        for match in make_exercises.SOLUTION.finditer(trace.read_text()):
            yield int(trace.parent.name[:2]), match["id"], match["body"]
    for core in CORE:
        for match in make_exercises.SOLUTION.finditer((ROOT / core).read_text()):
            yield int(match["id"][:2]), match["id"], match["body"]


def tellTales(body):
    """The whole solution, and its longest line: half a solution is one too."""
    lines = sorted((normal(line) for line in body.splitlines()), key=len)
    return [normal(body), lines[-1]] if len(lines[-1]) > 30 else [normal(body)]


def texts(folder):
    """Each text file of the hand-out, as it is and normalised."""
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.suffix not in (".png", ".exr", ".hdr", ".svg"):
            text = path.read_text()
            yield path.relative_to(folder), text, normal(text)


def digests(folder):
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(folder.rglob("*")) if path.is_file()}


class Temporary(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)


class Contents(Temporary):
    def test_holds_no_marks_mistakes_or_places_of_ours(self):
        result = pack(self.folder / "all")
        self.assertEqual(result.returncode, 0, result.stderr)
        names = set()
        for name, text, _ in texts(self.folder / "all"):
            names.add(str(name))
            self.assertNotRegex(text, r"(?m)^ *// SOLUTION \S", name)
            self.assertNotRegex(text, r"(?m)^ *// END$", name)
            self.assertNotIn("make_exercises.py --solved", text, name)
            for place in (str(ROOT), str(BUILD), str(self.folder), "/home/"):
                self.assertNotIn(place, text, name)
        for needed in ("README.md", "LICENSE", "raytree", "lessons/06_fresnel/exercise.h", "lessons/exercises.toml",
                       "tests/cases/cases_fresnel.cpp", "slides-notes/06-fresnel.md", "CMakePresets.json"):
            self.assertIn(needed, names)
        for path in (self.folder / "all").rglob("*"):
            self.assertNotRegex(path.name, r"^(trace\.h|geometry\.h|entry\.cpp|mutants.*|errata_test\.cpp|registry.*|"
                                           r"tutorial_steps.*|\.git|\.ci|viz|ask.*|question\b.*|reference.*)$")

    def test_holds_no_solution_of_the_last_lesson(self):
        for last in LESSONS:
            folder = self.folder / str(last)
            self.assertEqual(pack(folder, "--lessons", f"0-{last}").returncode, 0)
            files = list(texts(folder))
            for lesson, name, body in solutions():
                if lesson < last:
                    continue
                for tale in tellTales(body):
                    for path, _, text in files:
                        self.assertNotIn(tale, text, f"{name} stands in {path} of lessons 0-{last}")

    def test_holds_no_solution_where_its_exercise_is(self):
        folder = self.folder / "all"
        pack(folder)
        files = list(texts(folder))
        for lesson, name, body in solutions():
            for tale in tellTales(body):
                for path, _, text in files:
                    later = re.match(r"lessons/(\d\d)_.*/exercise\.h", str(path))
                    kept = str(path) in CORE and lesson < LESSONS[-1]
                    if not kept and not (later and int(later[1]) > lesson):
                        self.assertNotIn(tale, text, f"{name} stands in {path}")

    def test_takes_exercises_as_shipped_not_as_solved(self):
        copy = self.folder / "copy"
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns("build", "out", ".git", "__pycache__", "*.part"))
        pack(self.folder / "one", root=copy)
        subprocess.run([sys.executable, "-B", str(copy / "lessons/make_exercises.py"), "--solved",
                        str(self.folder / "solved")], check=True)
        exercise = copy / "lessons/02_mirrors/exercise.h"
        exercise.write_text((self.folder / "solved/solved02.h").read_text().replace("solved02", "exercise02"))
        pack(self.folder / "two", root=copy)
        self.assertEqual(digests(self.folder / "one"), digests(self.folder / "two"))

    def test_says_what_it_shows(self):
        result = pack(self.folder / "all")
        self.assertIn("--lessons 0-N", result.stdout)
        self.assertIn("01-sphere in common/base/shapes.h", result.stdout)
        result = pack(self.folder / "first", "--lessons", "0-1")
        self.assertNotRegex(result.stdout, "shapes.h|search.h")

    def test_links_lead_somewhere(self):
        folder = self.folder / "some"
        pack(folder, "--lessons", "0-3")
        for name, text, _ in texts(folder):
            for target in re.findall(r"\]\(([^)\s]+)\)", text) if name.suffix == ".md" else []:
                if not target.startswith("http"):
                    self.assertTrue((folder / name.parent / target.split("#")[0]).exists(), f"{name}: {target}")


class Writing(Temporary):
    def test_gives_the_same_bytes_each_time(self):
        for name in ("one", "two"):
            self.assertEqual(pack(self.folder / name).returncode, 0)
        self.assertEqual(digests(self.folder / "one"), digests(self.folder / "two"))
        packed = [(self.folder / f"{name}.tar.gz").read_bytes() for name in ("one", "two")]
        self.assertEqual(packed[0], packed[1])
        with tarfile.open(self.folder / "one.tar.gz") as tar:
            tar.extractall(self.folder / "unpacked")
        self.assertEqual(digests(self.folder / "unpacked/raytree"), digests(self.folder / "one"))
        self.assertTrue(os.access(self.folder / "unpacked/raytree/raytree", os.X_OK))

    def test_overwrites_nothing_but_an_untouched_handout(self):
        mine = self.folder / "mine"
        mine.mkdir()
        (mine / "thesis.txt").write_text("years of work")
        result = pack(mine)
        self.assertEqual(result.returncode, 2)
        self.assertIn("no earlier hand-out", result.stderr)
        self.assertEqual([path.name for path in mine.iterdir()], ["thesis.txt"])
        ours = self.folder / "ours"
        self.assertEqual(pack(ours, "--lessons", "0-2").returncode, 0)
        self.assertEqual(pack(ours, "--lessons", "0-1").returncode, 0)
        self.assertFalse((ours / "lessons/02_mirrors/exercise.h").exists())
        exercise = ours / "lessons/01_direct_illumination/exercise.h"
        exercise.write_text(exercise.read_text() + "// my idea\n")
        result = pack(ours)
        self.assertEqual(result.returncode, 2)
        self.assertIn("01_direct_illumination/exercise.h", result.stderr)
        self.assertTrue(exercise.read_text().endswith("// my idea\n"))

    def test_is_written_whole_or_not_at_all(self):
        out = self.folder / "out"
        pack(out, "--lessons", "0-1")
        before = digests(out), (self.folder / "out.tar.gz").read_bytes()
        (self.folder / "out.tar.gz.part").mkdir()  # so the archive cannot be written
        result = pack(out, "--lessons", "0-2")
        self.assertEqual(result.returncode, 2)
        self.assertNotIn("Traceback", result.stderr)
        self.assertEqual((digests(out), (self.folder / "out.tar.gz").read_bytes()), before)

    def test_refuses_lessons_that_do_not_exist(self):
        for lessons in ("9", "3-2", "0-9", "a", "-1", "1,2"):
            result = pack(self.folder / "out", f"--lessons={lessons}")
            self.assertEqual(result.returncode, 2, lessons)
            self.assertIn("--lessons", result.stderr)
            self.assertFalse((self.folder / "out").exists())


class Working(unittest.TestCase):
    """As a student: configure, build, try."""

    def run_in(self, *command, expect=0):
        result = subprocess.run(command, cwd=self.handout, capture_output=True, text=True, timeout=1500,
                                env=dict(os.environ, CCACHE_BASEDIR=str(BUILD), NO_COLOR="1"))
        self.assertEqual(result.returncode, expect, f"{command}:\n{result.stdout[-3000:]}{result.stderr[-3000:]}")
        return result.stdout + result.stderr

    def solve(self, lesson=2, change=lambda text: text):
        text = (BUILD / f"handout_test/solved/solved{lesson:02}.h").read_text().replace("solved", "exercise")
        changed = change(text)
        next(self.handout.glob(f"lessons/{lesson:02}_*/exercise.h")).write_text(changed)
        return changed != text

    def cases(self, expect):
        self.run_in("cmake", "--build", "build/student", "--target", "exercise02_tests")
        return self.run_in("build/student/bin/exercise02_tests", expect=expect)

    def test_student_preset_builds_and_tells_the_three_states(self):
        place = BUILD / "handout_test"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        subprocess.run([sys.executable, "-B", str(ROOT / "lessons/make_exercises.py"), "--solved", str(place / "solved")],
                       check=True)
        result = pack(place / "handout")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.handout = place / "handout"
        self.run_in("cmake", "--preset", "student", "-DRAYTREE_TESTS=ON")
        self.run_in("cmake", "--build", "build/student", "--target", "exercise02", "exercise02_tests", "learn")

        text = self.cases(expect=0)
        self.assertIn("02-mirror has not been attempted", text)
        self.assertNotRegex(text, r"\[ +FAILED")
        self.assertNotRegex(text, r"\[  PASSED  \] [1-9]")
        learn = ["build/student/bin/learn", "--state", str(place / "state.json"), "--once", "2"]
        self.assertIn("not attempted yet", self.run_in(*learn, expect=1))

        self.solve()
        text = self.cases(expect=0)
        self.assertNotRegex(text, r"SKIPPED|FAILED")
        self.assertRegex(text, r"\[  PASSED  \] [1-9]")
        self.assertIn("right: all", self.run_in(*learn))

        known = "A - B"
        self.assertTrue(self.solve(change=lambda text: re.sub(r"return B - A;", f"return {known};", text)))
        text = self.cases(expect=1)
        self.assertIn("Slide: Reflected Vector", text)
        self.assertIn("expected", text)
        text = self.run_in(*learn, expect=1)
        self.assertIn("Reflected Vector", text)
        self.assertIn("this looks like", text)

        for lesson in LESSONS:  # all functions of all lessons are known
            self.solve(lesson)
            self.assertIn("right: all", self.run_in(*learn[:-1], str(lesson)))
        self.assertIn("all exercises are right", self.run_in(*learn[:-1], str(LESSONS[-1])))

        # The picture, and the command that `learn` names. A build that has nothing to do has nothing to say.
        door = ["./raytree", "exercise", "2", "--size", "32x24", "--out", str(place / "mine.png")]
        self.run_in(*door)
        self.assertTrue((place / "mine.png").exists())
        self.assertEqual(self.run_in(*door).count("\n"), 1)
        command = re.search(r"\./raytree exercise (2 \S+ --pixel \S+ --explain)", text)
        self.assertTrue(command, text)
        words = command[1].split()
        self.assertIn("Reflected vector", self.run_in("build/student/bin/exercise02", *words[1:]))
        self.assertIn("there is no exercise 09", self.run_in("./raytree", "exercise", "9", expect=2))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
