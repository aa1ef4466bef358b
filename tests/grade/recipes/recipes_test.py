#!/usr/bin/env python3
"""The recipes, and the front door that they call, as far as one machine can run them.

    recipes_test.py FOLDER_OF_PROGRAMS

Each test runs in the course as pack.sh packs it for Gradescope. Only the compiler is left out: `cmake` and `dpkg-query` on the PATH
are stubs that say yes and note what they were asked for, and the programs in FOLDER_OF_PROGRAMS stand where a build would put them.
Exit code 77: there is no sandbox on this machine."""
import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[1:1] = [str(HERE.parents[1]), str(HERE.parent), str(HERE.parents[1] / "course")]
from classroom import PACKAGES, SECRET, data_of, exercise_text, mistaken, outputs
import skips
from programs import BIN, ROOT
from texts import FILES, FOLDERS, committed

PLACE = pathlib.Path(tempfile.mkdtemp())
COURSE = PLACE / "source/raytree"
RECIPES = COURSE / "tests/grade/recipes"
STUDENTS = ["ada", "bob", "cem"]
ENV = {"PATH": f"{PLACE}/stubs:{os.environ['PATH']}", "HOME": str(PLACE), "LC_ALL": "C.UTF-8"}


def run(*line, cwd=COURSE, code=0, **more):
    done = subprocess.run([str(one) for one in line], cwd=cwd, env=ENV | more, capture_output=True, text=True, timeout=1200, stdin=subprocess.DEVNULL)
    assert done.returncode == code, f"{line}: exit code {done.returncode}, expected {code}\n{done.stdout}{done.stderr}"
    return done.stdout, done.stderr


def stub(name, text):
    (PLACE / "stubs" / name).write_text("#!/bin/sh\n" + text)
    (PLACE / "stubs" / name).chmod(0o755)


def pack(*arguments, code=0):
    return run(ROOT / "tests/grade/recipes/gradescope/pack.sh", *arguments, cwd=PLACE, code=code)


def setUpModule():
    if subprocess.run([str(BIN / "grade"), "--self-test"], capture_output=True).returncode == 4:
        print("skipped: there is no sandbox")
        sys.exit(77)
    PLACE.chmod(0o755)
    (PLACE / "secret").write_text(SECRET)
    (PLACE / "stubs").mkdir()
    stub("dpkg-query", 'for package; do echo "$package installed"; done\n')
    stub("cmake", f'echo "$@" >>"{PLACE}/cmake.log"\n')
    pack(2, "2026-fall", PLACE / "secret", PLACE / "autograder.zip")
    # As Gradescope unpacks it: with modes.
    with zipfile.ZipFile(PLACE / "autograder.zip") as archive:
        for info in archive.infolist():
            path = pathlib.Path(archive.extract(info, PLACE / "source"))
            path.chmod((info.external_attr >> 16) & 0o777)
    (COURSE / "build/release").mkdir(parents=True)
    (COURSE / "build/release/build.ninja").touch()
    parts = re.search(r'^parts="(.*)"', (COURSE / "raytree").read_text(), re.M)[1].split()
    (COURSE / "build/release/CMakeCache.txt").write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={COURSE}\n" + "".join(f"RAYTREE_{part}:BOOL=ON\n" for part in parts))
    (COURSE / "build/release/bin").symlink_to(BIN)
    texts = dict(zip(STUDENTS, (exercise_text(2, "solved"), mistaken(2, "02-mirror-colour-lost"), exercise_text(2, "exercise"))))
    for name, text in texts.items():
        (PLACE / "a class").mkdir(exist_ok=True)
        PACKAGES["folder"](PLACE / "a class" / name, text.encode())


def tearDownModule():
    shutil.rmtree(PLACE)


def built():
    """The targets that the front door asked for since the last call, beside whether the build itself is stale."""
    log = PLACE / "cmake.log"
    targets = re.findall(r"--target (?!build\.ninja)(\S+)", log.read_text()) if log.exists() else []
    log.write_text("")
    return targets


class Recipes(unittest.TestCase):
    def setUp(self):
        self.here = pathlib.Path(tempfile.mkdtemp(dir=PLACE))
        self.here.chmod(0o755)
        self.out = self.here / "the results"
        built()

    def checkout(self):
        """The course in a folder of its own, with the class in it."""
        course = self.here / "course"
        shutil.copytree(COURSE, course, symlinks=True)
        shutil.copytree(PLACE / "a class", course / "submissions")
        return course

    def marks(self, gradebook):
        with open(gradebook / "gradebook.csv", newline="") as file:
            marks = {row["student"]: float(row["percent"]) for row in csv.DictReader(file)}
        self.assertEqual(list(marks), STUDENTS)
        self.assertEqual((marks["ada"], marks["cem"]), (100, 0))
        self.assertTrue(0 < marks["bob"] < 100)

    def test_front_door(self):
        """What the recipes ask of it; tests/course/front_door_test.py has the rest."""
        grade, _ = run("./raytree", "grade", "--help")
        self.assertIn("--submissions", grade)
        merge, _ = run("./raytree", "merge", "--help")
        self.assertIn("gradebook.csv", merge)
        # What the program says and its exit code come through.
        _, err = run("./raytree", "grade", "9", code=2)
        self.assertIn("9", err)
        self.assertEqual(built(), ["grade"])

    def test_gradescope_packs_the_whole_course_and_keeps_it_private(self):
        def below(top):
            return {str(path.relative_to(top)) for name in (*FOLDERS, *FILES) for path in (top / name, *(top / name).rglob("*"))
                    if path.is_file() and path.parent.name != "__pycache__"}
        packed = {str(path.relative_to(COURSE)) for path in COURSE.rglob("*") if path.is_file() and COURSE / "build" not in path.parents}
        self.assertEqual(sorted(packed), sorted(below(ROOT)))
        self.assertLessEqual({name for name in committed() if not name.startswith(".")}, packed)
        for name in packed:
            self.assertEqual(os.access(COURSE / name, os.X_OK), os.access(ROOT / name, os.X_OK), name)
        self.assertEqual(os.stat(PLACE / "autograder.zip").st_mode & 0o777, 0o600)
        self.assertEqual((PLACE / "source/secret").read_text(), SECRET)
        self.assertEqual((PLACE / "source/secret").stat().st_mode & 0o777, 0o600)
        for line, says in (((9, "t", PLACE / "secret"), "lesson"), ((2, "a b", PLACE / "secret"), "term"), ((2, "t", PLACE / "missing"), "secret"), ((2,), "usage")):
            _, err = pack(*line, code=2)
            self.assertIn(says, err)
            self.assertEqual(err.count("\n"), 1)

    def test_gradescope_packs_what_is_no_clone(self):
        # The packed course is none: there is nothing that git knows.
        archive = self.here / "again.zip"
        run(RECIPES / "gradescope/pack.sh", 2, "2026-fall", PLACE / "secret", archive, cwd=self.here)
        names = [sorted(name for name in zipfile.ZipFile(one).namelist() if "/build/" not in name) for one in (archive, PLACE / "autograder.zip")]
        self.assertEqual(*names)
        self.assertIn("raytree/tests/grade/grade_main.cpp", names[0])

    def test_gradescope_grades_what_was_handed_in(self):
        run("sh", "-c", "exec \"$AUTOGRADER/source/setup.sh\"", AUTOGRADER=str(PLACE))
        self.assertEqual(built(), ["grade"])
        shutil.copytree(PLACE / "a class/bob", PLACE / "submission")
        _, err = run(PLACE / "source/run_autograder", cwd="/", AUTOGRADER=str(PLACE))
        self.assertEqual([path.name for path in (PLACE / "results").iterdir()], ["results.json"])
        result = json.loads((PLACE / "results/results.json").read_text())
        most = sum(test["max_score"] for test in result["tests"])
        self.assertTrue(0 < sum(test["score"] for test in result["tests"]) < most, result["output"])
        self.assertNotIn("score", result, "Gradescope would show hidden points at once")
        for folder in ("source", "submission"):
            self.assertEqual((PLACE / folder).stat().st_mode & 0o777, 0o700)
        # The same as the instructor gets at home with the same secret and term.
        run("./raytree", "grade", 2, "--submission", PLACE / "submission", "--out", self.out, "--secret", PLACE / "secret", "--term", "2026-fall")
        data = result["extra_data"]["raytree"]
        self.assertEqual(data_of(self.out)["submission"]["key"], data["key"])
        # Who hands in nothing gets a sentence, not a failing autograder.
        shutil.rmtree(PLACE / "submission")
        (PLACE / "submission").mkdir()
        run(PLACE / "source/run_autograder", cwd="/", AUTOGRADER=str(PLACE))
        result = json.loads((PLACE / "results/results.json").read_text())
        self.assertEqual(result["score"], 0)
        self.assertIn("exercise.h", result["output"])

    def test_gradescope_gets_a_result_whatever_happens(self):
        place = self.here / "autograder"
        (place / "source/raytree").mkdir(parents=True)
        (place / "submission").mkdir()
        script = place / "source/run_autograder"
        shutil.copy(RECIPES / "gradescope/run_autograder", script)
        course = place / "source/course.sh"
        course.write_text("LESSON=2\nTERM_NAME=t\n")
        results = place / "results/results.json"
        written = 'out=; while [ $# -gt 0 ]; do [ "$1" = --out ] && out=$2; shift; done; mkdir -p "$out/results/submission"; echo \'{"score": 1}\' >"$out/results/submission/results.json"\n'

        def graded(raytree):
            (place / "source/raytree/raytree").write_text("#!/bin/sh\n" + raytree)
            (place / "source/raytree/raytree").chmod(0o755)
            results.unlink(missing_ok=True)
            run(script, cwd="/", AUTOGRADER=str(place))
            self.assertEqual([path.name for path in results.parent.iterdir()], ["results.json"])
            return json.loads(results.read_text())

        for code in (1, 2, 3, 4, 130):
            result = graded(f"echo 'building' >&2; echo 'grade: no \"box\" \\ holds\there \033[31m\303\274' >&2\nexit {code}\n")
            self.assertEqual(result["score"], 0)
            self.assertRegex(result["output"], rf"could not be graded.*exit code {code}.*grade: no .box. . holds.*here")
            self.assertEqual(result["tests"][0]["visibility"], "visible")
        self.assertEqual(graded(written + "exit 3\n"), {"score": 1})  # what was written counts, also after a failure
        self.assertIn("killed", graded("echo killed >&2; kill -9 $$\n")["output"])
        self.assertIn("exit code 0", graded("exit 0\n")["output"])  # and nothing written
        course.unlink()
        self.assertIn("could not be graded", graded(written)["output"])

    def test_slurm(self):
        parts = int(re.search(r"#SBATCH --array=1-(\d+)", (RECIPES / "slurm.sbatch").read_text())[1])
        # Slurm runs a copy of the script, in the folder where sbatch was called.
        script = self.here / "slurm_script"
        shutil.copy(RECIPES / "slurm.sbatch", script)
        course = self.checkout()
        for task in range(1, 5):  # the rest of the parts are as empty as the fourth
            run("sh", script, 2, "submissions", self.out, PLACE / "secret", cwd="/", SLURM_SUBMIT_DIR=str(course),
                SLURM_ARRAY_TASK_ID=str(task), SLURM_ARRAY_TASK_COUNT="1", SLURM_CPUS_PER_TASK="2")
        self.assertEqual(sorted(path.name for path in self.out.glob("part-*/results/*")), STUDENTS)
        self.assertGreaterEqual(parts, 4)
        self.assertIn(f"parts={parts} ", script.read_text())
        run("sh", "-c", 'exec ./raytree merge "$0/gradebook" "$0"/part-*', self.out)
        self.marks(self.out / "gradebook")
        self.assertEqual(built(), ["grade"] * 4 + ["grade_merge"])

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
    def test_parallel(self):
        # From another folder, with spaces in all names.
        run(RECIPES / "parallel.sh", 2, "a class", self.out.relative_to(PLACE), "secret", 2, cwd=PLACE)
        self.marks(self.out / "gradebook")
        self.assertEqual(sorted(path.name for path in self.out.iterdir()), ["gradebook", "part-1", "part-2"])
        before = outputs(self.out)
        stamp = (self.out / "part-1/results/ada/results.json").stat().st_mtime_ns
        run(RECIPES / "parallel.sh", 2, "a class", self.out.relative_to(PLACE), "secret", 2, cwd=PLACE)
        self.assertEqual(outputs(self.out), before)
        self.assertEqual((self.out / "part-1/results/ada/results.json").stat().st_mtime_ns, stamp)

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
    def test_parallel_does_not_merge_what_is_not_done(self):
        (self.here / "short").write_text("short")
        _, err = run(RECIPES / "parallel.sh", 2, PLACE / "a class", self.out, self.here / "short", 2, code=2)
        self.assertIn("not all parts are done", err)
        self.assertFalse((self.out / "gradebook").exists())

    def test_parallel_says_what_is_missing(self):
        (self.here / "bin").mkdir()
        for tool in ("sh", "grep"):
            (self.here / "bin" / tool).symlink_to(shutil.which(tool))
        _, err = run(RECIPES / "parallel.sh", 2, "a", "b", "c", 2, code=2, PATH=str(self.here / "bin"))
        self.assertIn("GNU parallel is missing", err)

    def test_github_actions(self):
        try:
            import yaml
        except ImportError:
            self.skipTest("python3-yaml is not installed")
        jobs = yaml.safe_load((RECIPES / "github-actions.yml").read_text())["jobs"]
        shards = jobs["grade"]["strategy"]["matrix"]["shard"]
        self.assertEqual(shards, list(range(1, len(shards) + 1)))
        self.assertEqual(jobs["merge"]["needs"], "grade")
        place = self.checkout()
        lesson = "./raytree grade 6 "
        for shard in shards[:4]:
            uploaded = None
            for step in jobs["grade"]["steps"]:
                if "run" in step:
                    self.assertNotRegex(step["run"], r"\$\{\{(?! matrix\.shard \}\})")
                    line = step["run"].replace("${{ matrix.shard }}", str(shard))
                    self.assertNotIn("secrets.", line, "a secret in a command line is in the log")
                    env = {name: SECRET for name in step.get("env", {})}
                    run("sh", "-ec", line.replace(lesson, "./raytree grade 2 "), cwd=place, **env)
                elif step["uses"].startswith("actions/upload-artifact"):
                    uploaded = step["with"]
            name = uploaded["name"].replace("${{ matrix.shard }}", str(shard))
            self.assertEqual(os.stat(place / "secret").st_mode & 0o777, 0o600)
            (self.here / "artefacts").mkdir(exist_ok=True)
            shutil.move(place / uploaded["path"], self.here / "artefacts" / name)
            (place / "secret").unlink()
        self.assertIn(lesson, str(jobs["grade"]["steps"]))
        self.assertIn(f"/{len(shards)}", str(jobs["grade"]["steps"]))
        for step in jobs["merge"]["steps"]:
            if step.get("uses", "").startswith("actions/download-artifact"):
                # Without a name, each artefact becomes a folder of its own.
                self.assertNotIn("name", step["with"])
                (place / step["with"]["path"]).mkdir()
                for part in (self.here / "artefacts").iterdir():
                    shutil.move(part, place / step["with"]["path"])
            elif "run" in step:
                run("sh", "-ec", step["run"], cwd=place)
            elif step["uses"].startswith("actions/upload-artifact"):
                self.marks(place / step["with"]["path"])
                marked = True
        self.assertTrue(marked)


if __name__ == "__main__":
    skips.main()
