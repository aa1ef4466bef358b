#!/usr/bin/env python3
"""Stop means stop: what signals do to programs wherever these are, what becomes of their children, and trees without end.

    stop_test.py FOLDER_OF_PROGRAMS

No test asserts how fast: what is ended here would take hours, or never end.
"""
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from programs import BIN, ROOT, ProgramTest, is_alive, wait_until, wait_until_it_watches

PATIENCE = 600
HEAD = """
[camera]
eye = [0, 0, 0]
target = [0, 0, -1]
size = [{size}, {size}]
[trace]
max_depth = {depth}
[materials.glass]
ior = 1.5
"""
PANE = """
[[plane]]
point = [0, 0, -{z}]
normal = [{side}0.1, 0, {side}1]
material = "glass"
"""


def panes(size=64, depth=64):
    """Six parallel planes of glass: three panes."""
    return HEAD.format(size=size, depth=depth) + "".join(PANE.format(z=z, side="" if z % 2 else "-") for z in range(1, 7))


class Signalled(ProgramTest):
    def write(self, name, text):
        (self.here / name).write_text(text)
        return name

    def start(self, *command, **options):
        """The program, once it obeys signals in its own way."""
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options
        process = subprocess.Popen([str(BIN / command[0]), *map(str, command[1:])], cwd=self.here, **pipes)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        wait_until_it_watches(process)
        return process

    def ended(self, process, number=signal.SIGINT):
        """Standard error after the signal."""
        process.send_signal(number)
        out, err = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, 130, err)
        return err.decode()


class Stop(Signalled):
    def test_a_program_that_traces_is_stopped(self):
        self.write("panes.toml", panes(depth=20))
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for command in (("render", "panes.toml", "--spp", 65536, "--out", "p.png"),
                            ("lesson06", "panes.toml", "--spp", 65536, "--out", "p.png")):
                before = sorted(self.here.iterdir())
                process = self.start(*command)
                said = iter(process.stderr.readline, b"")
                self.assertTrue(any(b"can lead to" in line for line in said))  # before it begins
                time.sleep(0.5)
                self.assertEqual(self.ended(process, number), "interrupted: nothing was written\n")
                self.assertEqual(sorted(self.here.iterdir()), before)

    def test_a_program_that_reads_its_scene_is_stopped(self):
        os.mkfifo(self.here / "never.toml")  # whose end never comes
        for program in ("render", "lesson02", "exercise02"):
            self.assertEqual(self.ended(self.start(program, "never.toml")), "interrupted: nothing was written\n")

    def test_a_program_that_looks_no_more_is_ended_from_outside(self):
        """Here it waits for ever for somebody who reads what it writes: a loop in an exercise would be the same."""
        process = self.start("lesson06", self.write("panes.toml", panes(depth=12)), "--tree", "json")
        process.stdout.read(1)  # no pipe holds all that comes
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(PATIENCE), 130)  # before anybody reads on
        self.assertEqual(process.stderr.read(), b"interrupted: nothing was written\n")
        process.stdout.close()
        process.stderr.close()

    def test_too_many_rays_end_pictures_and_trees_with_a_sentence(self):
        self.write("panes.toml", panes())
        before = sorted(self.here.iterdir())
        for program, options in (("render", ()), ("lesson06", ()), ("lesson08", ()), ("lesson06", ("--tree", "json")),
                                 ("lesson06", ("--explain",)), ("lesson06", ("--tree", "text", "--out", "p.png")),
                                 ("lesson06", ("--ray", "0,0,0,0,0,-1"))):
            out, err = self.run_program(program, "panes.toml", *options, code=2)
            *_, foretold, said = err.splitlines()
            self.assertIn("panes.toml: at depth 64 a pixel can lead to 2^64 rays", foretold)
            what = "the ray" if "--ray" in options else r"pixel \d+,\d+"
            self.assertRegex(said, rf"^{program}: {what} leads to more than 1,000,000 rays at depth 64, .*--depth")
            self.assertEqual((out, sorted(self.here.iterdir())), ("", before))
        # As many as are traced are traced, without a word.
        out, err = self.run_program("lesson06", "panes.toml", "--depth", 16, "--tree", "text")
        self.assertEqual((out != "", err), (True, ""))

    def test_the_help_names_the_limit(self):
        out, _ = self.run_program("lesson06", "--help")
        self.assertIn("1,000,000 rays", " ".join(out.split()))

    def test_trade_says_so_too(self):
        self.write("panes.toml", panes(size=8).replace("[materials", "[[light]]\nposition = [0, 0, 1]\ncolor = [1, 1, 1]\n[materials"))
        _, err = self.run_program("trade", "panes.toml", "--modelling", "--out", "t", code=2)
        self.assertRegex(err, r"trade: pixel \d+,\d+ leads to more than 1,000,000 rays")
        self.assertFalse((self.here / "t").exists())


@unittest.skipUnless((BIN / "viewer").exists(), "without the viewer no program starts another")
class Children(Signalled):
    """The viewer with another program as its tracer, which starts a program itself and then never answers."""

    def start_viewer(self):
        tracer = self.here / "tracer"
        tracer.write_text(f"#!/bin/sh\nsleep 100000 &\necho $$ $! >{self.here}/started.part\n"
                          f"mv {self.here}/started.part {self.here}/started\nwait\n")
        tracer.chmod(0o755)
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        process = self.start("viewer", "2", "--tracer", tracer, "--export", "tree.json", env=environment)
        started = self.here / "started"
        wait_until(started.exists, "the tracer does not start")
        return process, [int(word) for word in started.read_text().split()]

    def gone(self, children):
        wait_until(lambda: not any(map(is_alive, children)), f"of {children} some live on")
        self.assertEqual(sorted(path.name for path in self.here.iterdir()), ["started", "tracer"])

    def test_they_end_with_a_parent_that_is_interrupted(self):
        process, children = self.start_viewer()
        self.assertIn("interrupted", self.ended(process))
        self.gone(children)

    def test_they_end_with_a_parent_that_is_killed(self):
        process, children = self.start_viewer()
        process.kill()
        process.communicate(timeout=PATIENCE)
        self.gone(children)


class Scripts(ProgramTest):
    """The same of common/program/children.py, which bench and notes use."""

    def start_script(self):
        started = self.here / "started"
        program = f"sleep 100000 & echo $$ $! >{self.here}/part; mv {self.here}/part {started}; wait"
        script = ("import sys; from children import *; children = Children(); raise_at_signals(children)\n"
                  "try:\n    children.run(['sh', '-c', sys.argv[1]])\n"
                  "except KeyboardInterrupt:\n    sys.exit(130)\n")
        process = subprocess.Popen([sys.executable, "-c", script, program], env={**os.environ, "PYTHONPATH": str(ROOT / "common/program")})
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        wait_until(started.exists, "the program does not start")
        return process, [int(word) for word in started.read_text().split()]

    def test_programs_end_with_a_script(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 130), (signal.SIGHUP, 130), (signal.SIGKILL, -signal.SIGKILL)):
            process, programs = self.start_script()
            process.send_signal(number)
            self.assertEqual(process.wait(PATIENCE), code)
            wait_until(lambda: not any(map(is_alive, programs)), f"of {programs} some live on")
            (self.here / "started").unlink()


if __name__ == "__main__":
    unittest.main()
