"""Calls the measuring programs in turns and keeps what they say."""
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys


class Failed(Exception):
    """One sentence for the user."""


class Runner:
    """Programs of one folder, run in a temporary one, one at a time."""

    def __init__(self, programs, folder, children):
        self.programs, self.folder, self.children = pathlib.Path(programs).resolve(), pathlib.Path(folder), children

    def has(self, program):
        return (self.programs / program).exists()

    def run(self, *command):
        """Standard output and standard error. A name without a slash that is one of ours is ours."""
        command = [str(word) for word in command]
        if self.has(command[0]):
            command[0] = str(self.programs / command[0])
        done = self.children.run(command, cwd=self.folder)
        out, err = done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")
        if done.returncode != 0:
            reason = (err.strip().splitlines() or [f"exit code {done.returncode}"])[-1]
            raise Failed(f"{pathlib.Path(command[0]).name} failed: {reason}")
        return out, err

    def json(self, *command):
        return json.loads(self.run(*command)[0])


class Progress:
    """One line that replaces itself on a terminal, one line a step elsewhere."""

    def __init__(self):
        self.terminal, self.last = sys.stderr.isatty(), None

    def __call__(self, phase, step, steps):
        if self.terminal:
            end = "\n" if step == steps else ""
            print(f"\r{phase:<50} {100 * step // steps:3}%{end}", end="", file=sys.stderr, flush=True)
        elif step == steps:
            print(phase, file=sys.stderr, flush=True)


def median(values):
    return statistics.median(values)


def in_turns(rounds, variants, measure, progress=lambda step, steps: None):
    """measure(variant) for each variant, `rounds` times over: [[results of round 0..] of variant 0, ...]. Every second
    round goes backwards, so that none always follows the same one."""
    results = [[] for _ in variants]
    step = 0
    for turn in range(rounds):
        order = range(len(variants))
        for i in order if turn % 2 == 0 else reversed(order):
            results[i].append(measure(variants[i]))
            step += 1
            progress(step, rounds * len(variants))
    return results


# Peers.

def povray(runner, scene, size, out, prefix=()):
    """Renders scene.pov on one thread: CPU seconds of tracing, and rays as POV-Ray counts them."""
    width, height = size.split("x")
    _, text = runner.run(*prefix, "povray", f"+I{scene}", f"+O{out}", "+FN16", "File_Gamma=1.0", f"+W{width}", f"+H{height}",
                         "-A", "-D", "+WT1")
    # Parsing has the same two lines; tracing is last.
    cpu = re.findall(r"using \d+ thread\(s\) with ([\d.]+) CPU-seconds", text)
    wall = re.findall(r"Trace Time:.*\(([\d.]+) seconds\)", text)
    if not cpu or not wall:
        raise Failed("povray did not say how long it took; expected its statistics")

    def count(what):
        found = re.search(rf"{what} Rays:\s+(\d+)", text)
        return int(found[1]) if found else 0

    return {"cpu": float(cpu[-1]), "wall": float(wall[-1]), "reflected": count("Reflected"), "transmitted": count("Refracted"),
            "text": text}


def instructions(runner, *command):
    """Instructions of a whole run of the program, by callgrind."""
    if runner.has(command[0]):
        command = (runner.programs / command[0], *command[1:])
    _, text = runner.run("valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *command)
    return int(re.search(r"Collected : (\d+)", text)[1])


def missing(runner):
    """What is not there, in one line each: what for, and how to install it."""
    lines = []
    for there, package, what in ((shutil.which("povray"), "povray", "no comparison with POV-Ray"),
                                 (runner.has("bench_embree"), "libembree-dev", "no comparison with Embree"),
                                 (shutil.which("valgrind"), "valgrind", "no instructions are counted"),
                                 (runner.has("bench_parts"), "libbenchmark-dev", "no parts are measured")):
        if not there:
            lines.append(f"{package} is not installed: {what} (apt-get install {package}, then again)")
    return lines


def machine(runner):
    """Processor and compiler, for the page."""
    cpu = "unknown processor"
    if os.path.exists("/proc/cpuinfo"):
        found = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
        cpu = found[1] if found else cpu
    cache = runner.programs.parent / "CMakeCache.txt"
    text = cache.read_text() if cache.exists() else ""
    flags = re.search(r"CMAKE_BUILD_TYPE:\w+=(\w*)", text)
    compiler = re.search(r"CMAKE_CXX_COMPILER:\w+=(.*)", text)
    version = ""
    if compiler:
        version = subprocess.run([compiler[1], "--version"], capture_output=True, text=True).stdout.splitlines()[0]
    return f"{cpu}, {os.cpu_count()} cores; {version or 'unknown compiler'}, {flags[1] if flags else 'unknown'} build"
