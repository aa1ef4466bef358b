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


def wait_until_it_watches(process, sign=signal.SIGINT):
    """Until the program catches the signal: on a busy machine loading takes seconds. Python itself catches SIGINT, not SIGTERM."""
    status = pathlib.Path(f"/proc/{process.pid}/status")
    end = time.monotonic() + 600
    while process.poll() is None and time.monotonic() < end:
        caught = next(line.split()[1] for line in status.read_text().splitlines() if line.startswith("SigCgt"))
        if int(caught, 16) >> (sign - 1) & 1:
            return
        time.sleep(0.1)


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
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=600)
        self.assertEqual((process.returncode, out), (130, b""), err)
        self.assertIn(b"nothing was written", err)
        self.assertEqual(list(self.here.iterdir()), [])
