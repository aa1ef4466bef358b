#!/usr/bin/env python3
"""The program `grade` as an instructor uses it: exit codes, interruption, parts, files, and what students get to see.

    grade_test.py FOLDER_OF_PROGRAMS

Exit code 77: there is no sandbox on this machine."""
import csv
import json
import os
import pathlib
import re
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[1:1] = [str(HERE.parent), str(HERE)]
from classroom import HOSTILE, SECRET, data_of, exercise_text, make_class, outputs, results_of
import skips
from programs import BIN

PLACE = pathlib.Path(tempfile.mkdtemp())  # of the class, and of the run that is the reference for all others
CLASS, SECRET_FILE, WHOLE = PLACE / "class", PLACE / "secret", PLACE / "whole"
STUDENTS = []
LINES = []


def command(*arguments, out, submissions=CLASS, secret=SECRET_FILE, lesson=2):
    line = [str(BIN / "grade"), str(lesson), "--out", str(out)]
    line += ["--submissions", str(submissions)] if submissions else []
    line += ["--secret", str(secret)] if secret else []
    return line + [str(one) for one in arguments]


def run(line, **how):
    return subprocess.run(line, capture_output=True, text=True, timeout=1200, **how)


def setUpModule():
    PLACE.chmod(0o755)  # the box's user goes through it
    SECRET_FILE.write_text(SECRET)
    STUDENTS.extend(make_class(CLASS))
    done = run(command("--jobs", 2, out=WHOLE))
    if done.returncode == 4:
        tearDownModule()
        print(f"skipped: {done.stderr.strip()}")
        sys.exit(77)
    assert done.returncode == 0, done.stderr
    LINES.extend(done.stdout.splitlines())


def tearDownModule():
    shutil.rmtree(PLACE)


def descendants(process):
    """Process ids below it, as /proc has them now."""
    parents = {}
    for entry in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            parents[int(entry.parent.name)] = int(entry.read_text().rsplit(")", 1)[1].split()[1])
        except OSError:
            pass  # it has ended
    found = {process}
    for _ in range(len(parents)):
        more = {child for child, parent in parents.items() if parent in found} - found
        if not more:
            break
        found |= more
    return found - {process}


def alive(process):
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def processor_seconds(process):
    """Of a program in bubblewrap's box; 0 for any other, as the compiler."""
    try:
        if pathlib.Path(f"/proc/{process}/comm").read_text() != "program\n":
            return 0
        return int(pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[11]) / os.sysconf("SC_CLK_TCK")
    except OSError:
        return 0


class Grade(unittest.TestCase):
    maxDiff = 2000

    def setUp(self):
        self.here = pathlib.Path(tempfile.mkdtemp(dir=PLACE))
        self.here.chmod(0o755)
        self.addCleanup(shutil.rmtree, self.here)
        self.scratch = self.here / "scratch"  # of the grader: what is killed leaves its folders
        self.scratch.mkdir()
        os.environ["TMPDIR"] = str(self.scratch)

    def grade(self, *arguments, code=0, env=None, **how):
        done = run(command(*arguments, **how), env=env)
        self.assertEqual(done.returncode, code, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()], done.stderr

    def refused(self, *line, code=2, says=""):
        """One sentence, no result, nothing on standard output."""
        done = run([str(one) for one in line])
        self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (code, "", 1), done.stderr)
        self.assertTrue(done.stderr.startswith("grade: ") and "filesystem error" not in done.stderr, done.stderr)
        self.assertIn(says, done.stderr)

    def same(self, out, reference=WHOLE):
        got, expected = outputs(out), outputs(reference)
        self.assertEqual(sorted(got), sorted(expected))
        for name, text in expected.items():
            self.assertEqual(got[name], text, name)

    def test_a_class_is_graded(self):
        data = data_of(WHOLE)
        self.assertEqual(sorted(data), STUDENTS)
        self.assertEqual({name: one["state"] for name, one in data.items()}, {name: "not compiled" if name == "dora" else "graded" for name in STUDENTS})
        points = {name: sum(one["points"] for one in data[name]["classes"]) for name in STUDENTS}
        most = sum(one["most"] for one in data["ada"]["classes"])
        self.assertAlmostEqual(points["ada"], most)
        self.assertAlmostEqual(points[HOSTILE], most)
        self.assertEqual((points["cem"], points["dora"]), (0, 0))
        self.assertTrue(0 < points["bob"] < most)
        self.assertIn("the mirror's colour is not used", {one["mistake"] for one in data["bob"]["classes"]})
        with open(WHOLE / "gradebook.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file, strict=True))
        self.assertEqual(sorted(row["student"].removeprefix("'") for row in rows), STUDENTS)
        self.assertFalse([row["student"] for row in rows if row["student"].startswith("=")])
        self.assertEqual({float(row["points"]) for row in rows if row["student"] == "bob"}, {round(points["bob"], 2)})
        self.assertTrue((WHOLE / "class.html").is_file() and (WHOLE / "junit.xml").is_file())
        scene = re.search(r"view 2 (scenes/[\w-]+\.toml) --pixel", (WHOLE / "reports/bob.html").read_text())
        self.assertTrue(scene and "[camera]" in (WHOLE / "reports" / scene[1]).read_text())

    def test_standard_output_is_a_json_line_for_each_submission(self):
        lines = [json.loads(line) for line in LINES]
        self.assertEqual(sorted(line["student"] for line in lines), STUDENTS)
        self.assertEqual([(line["done"], line["of"], line["kept"]) for line in lines], [(i + 1, len(STUDENTS), False) for i in range(len(STUDENTS))])
        self.assertEqual({line["state"] for line in lines}, {"graded", "not compiled"})

    def test_bad_usage_is_refused_with_one_sentence(self):
        (self.here / "empty").mkdir()
        (self.here / "short").write_text("123456789012345")
        (self.here / "file").write_text("")
        new = self.here / "new"
        for says, line in (
                ("LESSON", [BIN / "grade", "--submissions", CLASS, "--out", new, "--secret", SECRET_FILE]),
                ("9", command(out=new, lesson=9)),
                ("--submissions", command(out=new, submissions=None)),
                ("excludes", command("--submission", CLASS / "ada", out=new)),
                ("--student", command("--student", "ada", out=new)),
                ("--out", [BIN / "grade", 2, "--submissions", CLASS, "--secret", SECRET_FILE]),
                ("missing", command(out=new, submissions=self.here / "missing")),
                ("missing", command("--submission", self.here / "missing", out=new, submissions=None)),
                ("no submissions", command(out=new, submissions=self.here / "empty")),
                ("15 bytes", command(out=new, secret=self.here / "short")),
                ("no such file", command(out=new, secret=self.here / "missing")),
                *[("i/n", command("--shard", shard, out=new)) for shard in ("3/2", "0/2", "1", "1/2x", "-1/2", "a/b")],
                ("same secret", command("--shard", "1/2", out=new, secret=None)),
                ("--jobs", command("--jobs", "0", out=new)),
                ("--i-trust-this-code", command("--sandbox", "none", out=new)),
                ("not a folder", command(out=self.here / "file")),
                ("not a folder", command(out=self.here / "file/below")),
                ("not a folder", command(out=self.here / "file", secret=None))):
            with self.subTest(says, line=line[1:]):
                self.refused(*line, says=says)
        self.assertEqual(sorted(path.name for path in self.here.iterdir()), ["empty", "file", "scratch", "short"])

    def test_results_that_cannot_be_written_are_refused_before_grading(self):
        # Root may write everywhere, unless it gives that up; another user could perhaps not reach the program, in root's home.
        as_others = ["setpriv", "--bounding-set", "-dac_override", "--inh-caps", "-dac_override"] if os.getuid() == 0 else []
        self.here.chmod(0o555)
        self.refused(*as_others, *command(out=self.here / "out"), says="read-only")
        self.here.chmod(0o755)

    def test_without_a_sandbox_nothing_runs(self):
        # A namespace that knows one user only, so that nobody else can be had for chroot, and a bubblewrap in it that does nothing.
        nothing_works = ["bwrap", "--unshare-user", "--uid", "0", "--gid", "0", "--dev-bind", "/", "/"]
        hidden = [*nothing_works, "--ro-bind", "/bin/false", shutil.which("bwrap") or "/usr/bin/bwrap", "--"]
        if not shutil.which("bwrap") or run([*nothing_works, "--", "true"]).returncode:
            self.skipTest("bubblewrap cannot run here, so that nothing can be hidden with it")
        for sandbox in ("auto", "bubblewrap", "chroot"):
            self.refused(*hidden, *command("--sandbox", sandbox, out=self.here / "out"), code=4, says="nothing was run")
        self.assertFalse((self.here / "out").exists())

    def stopped(self, signals, jobs):
        """A run that gets the signal after its first submission; then its results are there, whole, and no others."""
        out = self.here / "out"
        process = subprocess.Popen(command("--jobs", jobs, out=out), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
        process.stdout.readline()
        below = descendants(process.pid)
        os.killpg(process.pid, signals)  # as a terminal does: its children get it, too
        _, err = process.communicate(timeout=600)
        end = time.monotonic() + 300
        while any(map(alive, below)) and time.monotonic() < end:
            time.sleep(0.1)
        self.assertFalse([one for one in below if alive(one)], "processes of the box live on")
        done = sorted(data_of(out))
        self.assertTrue(1 <= len(done) < len(STUDENTS), done)
        self.assertFalse((out / "gradebook.csv").exists())
        return out, process.returncode, err, done

    def resumed(self, out, done):
        before = {name: (folder / "results.json").stat().st_mtime_ns for name, (_, folder) in results_of(out).items()}
        lines, _ = self.grade("--resume", "--jobs", 2, out=out)
        self.assertEqual(sorted(line["student"] for line in lines if line["kept"]), done)
        self.assertEqual(sorted(line["student"] for line in lines), STUDENTS)
        self.assertEqual(before, {name: (folder / "results.json").stat().st_mtime_ns for name, (_, folder) in results_of(out).items() if name in before})
        self.same(out)

    def test_an_interrupted_run_goes_on(self):
        out, code, err, done = self.stopped(signal.SIGINT, 1)
        self.assertEqual(code, 130, err)
        self.assertRegex(err, rf"^grade: interrupted after {len(done)} of {len(STUDENTS)}; .*--resume.*\n$")
        self.assertFalse(list(out.rglob(".part-*")), "half a file is left")
        self.assertFalse(list(self.scratch.iterdir()), "a folder of programs is left")
        self.resumed(out, done)

    def test_a_killed_run_goes_on(self):
        out, code, _, done = self.stopped(signal.SIGKILL, 2)
        self.assertEqual(code, -signal.SIGKILL)
        for path in out.rglob(".part-*"):
            path.unlink()  # a file that was being written; nobody reads it
        self.resumed(out, done)

    def test_a_program_dies_with_a_killed_grader(self):
        (self.here / "endless").mkdir()
        (self.here / "endless/exercise.h").write_text(exercise_text(2, "solved") + "static const int endless = [] { for (volatile int i = 0;; ++i) {} return 0; }();\n")
        process = subprocess.Popen(command("--submission", self.here / "endless", "--cpu-seconds", 600, out=self.here / "out", submissions=None))
        end = time.monotonic() + 600
        while not (spinning := [one for one in descendants(process.pid) if processor_seconds(one) > 1.5]):  # the self-test's has 1 s
            self.assertTrue(time.monotonic() < end and process.poll() is None, "it does not run")
            time.sleep(0.1)
        process.kill()
        process.wait()
        end = time.monotonic() + 300  # by itself it would end after ten minutes of processor time
        while (left := [one for one in spinning if alive(one)]) and time.monotonic() < end:
            time.sleep(0.1)
        for one in left:
            os.kill(one, signal.SIGKILL)
        self.assertFalse(left)

    def test_parts_make_the_same_gradebook_as_the_whole(self):
        parts = [self.here / "1", self.here / "2"]
        students = []
        for part in parts:
            lines, _ = self.grade("--shard", f"{part.name}/2", "--jobs", 2, out=part)
            students += [line["student"] for line in lines]
        self.assertEqual(sorted(students), STUDENTS)
        # More parts than students: the last has nothing to do, and is merged all the same.
        self.assertEqual(self.grade("--shard", "6/6", out=self.here / "3")[0], [])
        merged = self.here / "merged"
        self.assertEqual(run([str(BIN / "grade_merge"), str(merged), *map(str, parts), str(self.here / "3")]).returncode, 0)
        self.assertEqual((merged / "gradebook.csv").read_bytes(), (WHOLE / "gradebook.csv").read_bytes())
        got = outputs(parts[0]) | outputs(parts[1])
        for name, text in outputs(WHOLE).items():
            if "/" in name:
                self.assertEqual(got[name], text, name)

    def test_one_submission_alone_gets_the_same_result(self):
        arguments = ["--submission", CLASS / "bob", "--student", "bob"]
        self.grade(*arguments, out=self.here / "same", submissions=None)
        same, whole = outputs(self.here / "same"), outputs(WHOLE)
        for name in ("results/bob/results.json", "reports/bob.html", "instructor/bob.html"):
            self.assertEqual(same[name], whole[name])
        keys = [data_of(WHOLE)["bob"]["key"]]
        self.grade(*arguments, "--term", "next", out=self.here / "term", submissions=None)
        self.grade(*arguments, "--cpu-seconds", "9", out=self.here / "limit", submissions=None)
        keys += [data_of(self.here / name)["bob"]["key"] for name in ("term", "limit")]
        self.assertEqual(len(set(keys)), 3)

    def test_what_students_see_does_not_depend_on_the_secret(self):
        (self.here / "other").write_text("another secret of the tests")
        out = self.here / "out"
        self.grade("--jobs", 2, out=out, secret=self.here / "other")
        ours, others = data_of(WHOLE), data_of(out)
        for name in STUDENTS:
            self.assertNotEqual(ours[name]["key"], others[name]["key"])
        shown, other = outputs(WHOLE), outputs(out)
        pages = [name for name in shown if name.startswith("reports/") and name.endswith(".html")]
        self.assertEqual(len(pages), len(STUDENTS))
        # Their marks are the same, so these pages must be, to the byte.
        for name in pages:
            self.assertEqual(shown[name], other[name])
        for name, (result, _) in results_of(WHOLE).items():
            self.assertEqual(result["tests"], results_of(out)[name][0]["tests"])

    def test_hidden_cases_are_named_and_nothing_else(self):
        hidden = 0
        for name, (result, folder) in results_of(WHOLE).items():
            for test in result["tests"]:
                if "(hidden cases)" in test["name"]:
                    hidden += 1
                    self.assertEqual(test["visibility"], "after_published")
                    self.assertRegex(test["output"], r"^(Likely mistake: [^\n]*)?$")
            page = (WHOLE / "reports" / f"{folder.name}.html").read_text()
            for article in re.findall(r'<article class="class">.*?</article>', page, re.S):
                if "hidden cases" in article:
                    self.assertNotRegex(article, r"<dl|<figure|<img|\d cases|expected")
                    self.assertIn("These cases stay secret.", article)
        self.assertEqual(hidden, sum(one["hidden"] for data in data_of(WHOLE).values() for one in data["classes"]))
        self.assertGreater(hidden, 10)
        # A public case does say more, so that the words above are those of the pages.
        self.assertRegex((WHOLE / "reports/bob.html").read_text(), r"<dt>expected</dt>")

    def test_no_secret_leaves_its_file(self):
        for path in (path for path in WHOLE.rglob("*") if path.is_file()):
            data = path.read_bytes()
            for form in (SECRET.encode(), SECRET.encode().hex().encode()):
                self.assertNotIn(form, data, path)
        self.assertFalse((WHOLE / "secret").exists())

    def test_a_secret_is_made_where_none_is_given(self):
        out = self.here / "out"
        one = ["--submission", CLASS / "cem"]
        _, err = self.grade(*one, out=out, secret=None, submissions=None)
        self.assertIn(f"keep {out}/secret", err)
        self.assertEqual(stat.S_IMODE((out / "secret").stat().st_mode), 0o600)
        secret = (out / "secret").read_text().strip()
        self.assertGreaterEqual(len(secret), 32)
        for path in (path for path in out.rglob("*") if path.is_file() and path != out / "secret"):
            self.assertNotIn(secret, path.read_text(), path)
        lines, err = self.grade(*one, "--resume", out=out, secret=None, submissions=None)
        self.assertEqual([line["kept"] for line in lines], [True])
        self.assertNotIn("was made", err)
        self.assertEqual(secret, (out / "secret").read_text().strip())

    def test_only_what_changed_is_graded_again(self):
        out, submissions = self.here / "out", self.here / "class"
        shutil.copytree(WHOLE, out)
        shutil.copytree(CLASS, submissions)
        exercise = submissions / "cem/exercise.h"
        exercise.write_text(exercise.read_text() + "// one more line\n")
        broken = results_of(out)["dora"][1] / "results.json"
        broken.write_text(broken.read_text()[:100])
        lines, _ = self.grade("--resume", out=out, submissions=submissions)
        self.assertEqual({line["student"] for line in lines if not line["kept"]}, {"cem", "dora"})
        self.assertEqual((out / "gradebook.csv").read_bytes(), (WHOLE / "gradebook.csv").read_bytes())
        self.assertNotEqual(data_of(out)["cem"]["key"], data_of(WHOLE)["cem"]["key"])
        # Without --resume nothing is kept.
        lines, _ = self.grade("--submission", CLASS / "dora", out=out, submissions=None)
        self.assertEqual([line["kept"] for line in lines], [False])

    def test_a_run_without_a_sandbox_says_so_everywhere(self):
        self.grade("--submission", CLASS / "ada", "--sandbox", "none", "--i-trust-this-code", out=self.here / "out", submissions=None)
        self.assertEqual(data_of(self.here / "out")["ada"]["sandbox"], "none")
        self.assertNotEqual(data_of(self.here / "out")["ada"]["key"], data_of(WHOLE)["ada"]["key"])
        self.assertIn("without a sandbox", (self.here / "out/reports/ada.html").read_text())
        self.assertIn(",none,", (self.here / "out/gradebook.csv").read_text())

    def test_the_self_test_alone(self):
        done = run([str(BIN / "grade"), "--self-test"])
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^the sandbox \w+ holds\n$")


if __name__ == "__main__":
    skips.main()
