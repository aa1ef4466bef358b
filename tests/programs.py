"""Programs as their users call them: a folder of its own for each test, exit codes, messages, interruption.

A check that imports this module is called with FOLDER_OF_PROGRAMS as its first argument.
"""
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[1]
BIN = pathlib.Path(sys.argv.pop(1)).resolve()


def is_alive(pid):
    """A zombie is dead, though nobody may have buried it."""
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


def wait_until(holds, complaint, seconds=600):
    """For what comes at once on an idle machine."""
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise AssertionError(complaint)
        time.sleep(0.02)


def wait_until_it_watches(process, sign=signal.SIGHUP):
    """Until the program catches the signal, by default the last that ours ask for: on a busy machine loading takes seconds.
    Python itself catches SIGINT, not SIGTERM."""
    status = pathlib.Path(f"/proc/{process.pid}/status")

    def catches():
        caught = next(line.split()[1] for line in status.read_text().splitlines() if line.startswith("SigCgt"))
        return process.poll() is not None or int(caught, 16) >> (sign - 1) & 1
    wait_until(catches, "it does not watch for signals")


class ProgramTest(unittest.TestCase):
    SECONDS = 600  # for one call: only what hangs takes that

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.here = pathlib.Path(self.folder.name)

    def run_program(self, *command, code=0):
        done = subprocess.run([str(BIN / command[0]), *map(str, command[1:])], capture_output=True, cwd=self.here, timeout=self.SECONDS)
        self.assertEqual(done.returncode, code, done.stderr.decode())
        return done.stdout.decode(), done.stderr.decode()

    def refused(self, *command):
        """Standard error of a call that must fail with one sentence and leave no file."""
        before = sorted(self.here.iterdir())
        out, err = self.run_program(*command, code=2)
        self.assertEqual((out, err.count("\n"), sorted(self.here.iterdir())), ("", 1, before), err)
        return err

    def interrupted(self, *command):
        """A call that SIGINT ends must say so and leave no file."""
        process = subprocess.Popen([str(BIN / command[0]), *command[1:]], cwd=self.here, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        wait_until_it_watches(process)
        time.sleep(1)  # it has begun, by now
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=600)
        self.assertEqual((process.returncode, out), (130, b""), err)
        self.assertIn(b"nothing was written", err)
        self.assertEqual(list(self.here.iterdir()), [])
