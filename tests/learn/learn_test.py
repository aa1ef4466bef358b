#!/usr/bin/env python3
"""`learn` as a student meets it: once for scripts, and watching in a pseudo terminal. handout_test.py runs every lesson solved.

    learn_test.py PROGRAM [TEST...]
"""
import fcntl
import json
import os
import pathlib
import pty
import re
import select
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEARN = str(pathlib.Path(sys.argv[1]).resolve())
PATIENCE = 600  # seconds; compilers are slow on busy machines

sys.path.insert(0, str(ROOT / "lessons"))
sys.dont_write_bytecode = True
import make_exercises  # noqa: E402

LESSONS = make_exercises.lessons()
SOLVED = tempfile.TemporaryDirectory()
subprocess.run([sys.executable, "-B", str(ROOT / "lessons/make_exercises.py"), "--solved", SOLVED.name], check=True)


def solved(lesson):
    text = (pathlib.Path(SOLVED.name) / f"solved{lesson:02}.h").read_text()
    return text.replace(f"solved{lesson:02}", f"exercise{lesson:02}")


def shipped(lesson):
    return next(ROOT.glob(f"lessons/{lesson:02}_*/exercise.h")).read_text()


class Learning(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        self.file = self.folder / "exercise.h"
        self.state = self.folder / "state.json"

    def learn(self, *options, expect, file=True):
        result = subprocess.run([LEARN, "--state", str(self.state), *(["--file", str(self.file)] if file else []), *options],
                                capture_output=True, text=True, timeout=PATIENCE, stdin=subprocess.DEVNULL)
        self.assertEqual(result.returncode, expect, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def change(self, old, new, lesson=2):
        text = solved(lesson)
        self.assertIn(old, text)
        self.file.write_text(text.replace(old, new))


class Once(Learning):
    def test_tells_the_three_states_by_exit_code_and_words(self):
        self.file.write_text(shipped(2))
        text = self.learn("--once", "2", expect=1)
        self.assertIn("02-mirror, What does a mirror show?", text)
        self.assertIn("not attempted yet", text)
        line = shipped(2)[:shipped(2).index('todo("02-mirror")')].count("\n") + 1
        self.assertIn(f"exercise.h:{line}: the TODO", text)
        self.file.write_text(solved(2))
        text = self.learn("--once", "2", expect=0)
        self.assertIn("right: all", text)
        self.assertIn("2 of ", text)
        self.change("return B - A;", "return A - B;")
        text = self.learn("--once", "2", "--exercise", "02-reflect", expect=1)
        self.assertIn("wrong: ", text)
        self.assertIn("Slide: Reflected Vector", text)
        self.assertRegex(text, r"expected \(.*\)\n +got      \(.*\)")
        self.assertNotIn("02-mirror, What", text)

    def test_writes_the_pictures_and_names_the_worst_pixel(self):
        self.change("mat.color *", "0.5 * mat.color *")
        text = self.learn("--once", "2", "--exercise", "02-mirror", expect=1)
        path = re.search(r"expected, got, difference: (\S+)", text)
        self.assertTrue(path, text)
        self.assertEqual((ROOT / path[1]).read_bytes()[:4], b"\x89PNG")
        self.assertRegex(text, r"the worst pixel: \./raytree view 2 lessons/02_mirrors/scenes/\w+\.toml --pixel \d+,\d+ "
                               r"--compare exercise")

    def test_shows_compiler_errors_with_their_lines(self):
        self.change("return B - A;", "return B - a;\n x1;\n x2;\n x3;")
        text = self.learn("--once", "2", expect=1)
        line = solved(2)[:solved(2).index("return B - A;")].count("\n") + 1
        self.assertIn("does not compile", text)
        self.assertRegex(text, rf"exercise\.h:{line}:\d+: error")
        self.assertNotIn("x3", text)
        self.assertIn("more", text)

    def test_says_in_words_that_code_crashed_or_never_ends(self):
        self.change("return B - A;", "int* nowhere = nullptr; asm volatile(\"\" : \"+r\"(nowhere)); *nowhere = 1; return B - A;")
        text = self.learn("--once", "2", "--exercise", "02-reflect", expect=1)
        self.assertIn("crashed", text)
        self.assertIn("segmentation fault", text)
        self.change("return B - A;", "for (volatile int i = 0; i < 1;) {} return B - A;")
        text = self.learn("--once", "2", "--exercise", "02-reflect", expect=1)
        self.assertIn("timed out", text)

    def test_shows_what_the_code_prints(self):
        self.change("return B - A;", 'std::puts("D is here"); return B - A;')
        self.assertIn("D is here", self.learn("--once", "2", expect=0))

    def test_names_the_likely_mistake(self):
        self.change("return B - A;", "return A - B;")
        self.assertIn("this looks like: ", self.learn("--once", "2", "--exercise", "02-reflect", expect=1))

    def test_says_of_each_exercise_of_a_file_what_it_says_of_the_first(self):
        self.change("return B - A;", "return A - B;")
        text = self.learn("--once", "2", expect=1)
        self.assertEqual(text.count("this looks like: "), 2, text)
        self.assertEqual(text.count("the worst pixel: "), 2, text)
        self.assertNotIn("next: ", text)
        self.file.write_text(solved(2))
        self.assertEqual(self.learn("--once", "2", expect=0).count("next: "), 1)

    def test_refuses_bad_usage(self):
        self.file.write_text(shipped(2))
        for options in (["--once", "9"], ["--once", "two"], ["--once", "2", "--exercise", "06-fresnel"], ["--hint", "06-snell"],
                        ["--exercise", "nothing"], ["--bad"], []):
            self.learn(*options, expect=2)
        self.assertIn("02-reflect", self.learn("--hint", "x", expect=2, file=False))

    def test_lists_hints_and_forgets(self):
        self.assertRegex(self.learn("--list", expect=0, file=False), r"> not attempted  00-slope .*slope-intercept")
        self.assertIn("A = (D.N)N", self.learn("--hint", "02-reflect", expect=0, file=False))
        self.file.write_text(solved(2))
        self.learn("--once", "2", expect=0)
        self.assertRegex(self.learn("--list", expect=0, file=False), r"right +02-reflect")
        self.learn("--reset", expect=0, file=False)
        self.assertNotRegex(self.learn("--list", expect=0, file=False), r"right +02-reflect")

    def test_a_broken_state_is_kept_and_progress_starts_afresh(self):
        self.file.write_text(solved(2))
        self.state.write_text("{ broken")
        text = self.learn("--once", "2", expect=0)
        self.assertIn("state.json.broken", text)
        self.assertEqual(pathlib.Path(str(self.state) + ".broken").read_text(), "{ broken")
        self.assertEqual(json.loads(self.state.read_text())["exercises"]["02-reflect"], "right")

    def test_without_a_terminal_it_prints_and_ends(self):
        self.file.write_text(shipped(2))
        self.assertIn("not attempted yet", self.learn("2", expect=1))


class Terminal:
    """A student at a terminal."""

    def __init__(self, test, *options, **environment):
        self.test, self.seen = test, ""
        self.pid, self.end = pty.fork()
        if self.pid == 0:
            os.environ.update({"TERM": "xterm", **environment})
            os.execv(LEARN, [LEARN, "--state", str(test.state), "--file", str(test.file), *options])
        self.code = None
        test.addCleanup(self.close)

    def until(self, wanted):
        """Reads until it says so; what was read before is forgotten."""
        start = time.monotonic()
        while wanted not in self.seen:
            left = PATIENCE - (time.monotonic() - start)
            ready = select.select([self.end], [], [], max(0, left))[0]
            try:
                data = os.read(self.end, 65536) if ready else b""
            except OSError:
                data = b""
            self.test.assertTrue(data, f"it never said \"{wanted}\", only:\n{self.seen}")
            self.seen += data.decode(errors="replace")
        before, self.seen = self.seen.split(wanted, 1)
        return before

    def type(self, keys):
        os.write(self.end, keys.encode())

    def wait(self):
        """Its exit code."""
        start = time.monotonic()
        while time.monotonic() - start < PATIENCE:
            if select.select([self.end], [], [], 0.05)[0]:
                try:
                    self.seen += os.read(self.end, 65536).decode(errors="replace")
                except OSError:
                    pass
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                self.code = os.waitstatus_to_exitcode(status)
                return self.code
        self.test.fail("it does not end")

    def close(self):
        if self.code is None:
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
        os.close(self.end)


READY = "to be saved"


class Watching(Learning):
    def test_goes_from_not_attempted_over_wrong_to_right_and_on(self):
        self.file.write_text(shipped(2))
        terminal = Terminal(self, "2", "--exercise", "02-reflect")
        self.assertIn("not attempted yet", terminal.until(READY))
        self.change("return B - A;", "return A - B;")
        text = terminal.until(READY)
        self.assertIn("wrong", text)
        self.assertIn("Reflected Vector", text)
        self.change("return B - A;", "return B - ;")
        self.assertIn("does not compile", terminal.until(READY))
        self.change("return B - A;", "int* nowhere = nullptr; asm volatile(\"\" : \"+r\"(nowhere)); *nowhere = 1; return B - A;")
        self.assertIn("crashed", terminal.until(READY))
        self.change("return B - A;", "for (volatile int i = 0; i < 1;) {} return B - A;")
        self.assertIn("timed out", terminal.until(READY))
        # Editors write beside the file and rename.
        beside = self.folder / "exercise.h~"
        beside.write_text(solved(2))
        beside.rename(self.file)
        text = terminal.until(READY)
        self.assertIn("right: all", text)
        self.assertIn("next: 03-blend", text)
        terminal.type("q")
        self.assertEqual(terminal.wait(), 0)

    def test_keys(self):
        self.file.write_text(shipped(2))
        terminal = Terminal(self, "2", "--exercise", "02-mirror")
        terminal.until(READY)
        terminal.type("h")
        terminal.until("hint: ")
        terminal.until("ray.spawn(reflected, I, direction)")
        terminal.type("n")
        self.assertIn("02-reflect, The reflected vector", terminal.until(READY))
        terminal.type("p")
        self.assertIn("02-mirror, What does", terminal.until(READY))
        terminal.type("r")
        self.assertIn("compiling", terminal.until(READY))
        terminal.type("?")
        terminal.type("q")
        self.assertEqual(terminal.wait(), 0)
        self.assertEqual(json.loads(self.state.read_text())["current"], "02-mirror")
        again = Terminal(self, "2")
        self.assertIn("02-mirror, What does", again.until(READY))

    def test_waits_while_the_file_is_gone(self):
        self.file.write_text(shipped(2))
        terminal = Terminal(self, "2", "--exercise", "02-reflect")
        terminal.until(READY)
        self.file.unlink()
        time.sleep(1)
        self.file.write_text(solved(2))
        self.assertIn("right: all", terminal.until(READY))

    def test_waits_while_an_editor_has_truncated_the_file_or_put_a_folder_there(self):
        self.file.write_text(shipped(2))
        terminal = Terminal(self, "2", "--exercise", "02-reflect")
        terminal.until(READY)
        self.file.write_text("")
        terminal.until(READY)
        self.file.unlink()
        self.file.mkdir()
        time.sleep(1)
        self.file.rmdir()
        self.file.write_text(solved(2))
        self.assertIn("right: all", terminal.until(READY))

    def test_ctrl_c_leaves_the_terminal_as_it_was(self):
        self.file.write_text(shipped(2))
        for end, code in ((lambda t: t.type("\x03"), 130), (lambda t: os.kill(t.pid, signal.SIGTERM), 130),
                          (lambda t: t.type("q"), 0)):
            terminal = Terminal(self, "2")
            before = termios.tcgetattr(terminal.end)
            self.assertTrue(before[3] & termios.ECHO)
            terminal.until(READY)
            self.assertFalse(termios.tcgetattr(terminal.end)[3] & termios.ECHO)
            number = struct.unpack("i", fcntl.ioctl(terminal.end, 0x80045430, bytes(4)))[0]  # TIOCGPTN
            slave = os.open(f"/dev/pts/{number}", os.O_RDWR | os.O_NOCTTY)  # it keeps its state while somebody has it
            self.addCleanup(os.close, slave)
            end(terminal)
            self.assertEqual(terminal.wait(), code)
            self.assertEqual(termios.tcgetattr(slave), before)

    def test_does_without_colour(self):
        self.file.write_text(shipped(2))
        for environment in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            terminal = Terminal(self, "2", **environment)
            text = terminal.until(READY)
            self.assertNotRegex(text, r"\033\[\d+m")
        self.assertNotIn("\033", text)
        text = Terminal(self, "2").until(READY)
        self.assertRegex(text, r"\033\[\d+m")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
