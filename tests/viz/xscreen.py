"""An X display of its own for tests: what is shown there can be read, and real mouse and key events can be sent to it.

Coordinates are pixels from the upper left corner.
"""
import json
import mmap
import os
import pathlib
import select
import shutil
import struct
import subprocess
import tempfile
import time

WIDTH, HEIGHT = 1600, 900
PATIENCE = 600  # seconds for what takes a tenth of one on an idle machine: only what hangs takes them


def missing():
    """Why there can be no screen, as a sentence; empty if there can."""
    return next((f"{name} is not installed (Debian's package {package})"
                 for name, package in (("Xvfb", "xvfb"), ("xdotool", "xdotool")) if not shutil.which(name)), "")


def wait_for(condition, what):
    """Waits until condition() is true and returns its value; after a long time an AssertionError says what did not come."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.02)
    raise AssertionError(f"waited {PATIENCE} s for {what}")


class Screen:
    """Xvfb keeps its picture in a file in the format of xwd, four bytes a pixel: blue, green, red, nothing."""

    def __init__(self, width=WIDTH, height=HEIGHT, depth=24, options=()):
        self.folder = tempfile.TemporaryDirectory()
        reads, writes = os.pipe()
        # -noreset: otherwise the server starts anew, for a moment deaf, whenever its last window goes.
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writes), "-screen", "0", f"{width}x{height}x{depth}", "-fbdir", self.folder.name,
             "-nolisten", "tcp", "-noreset", *options], pass_fds=[writes], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writes)
        self.processes = [self.server]  # whose work is seen here
        number = b""
        while not number.endswith(b"\n"):
            if not select.select([reads], [], [], PATIENCE)[0]:
                raise AssertionError("Xvfb names no display")
            part = os.read(reads, 16)
            if not part:
                raise AssertionError("Xvfb does not start")
            number += part
        os.close(reads)
        self.env = {**os.environ, "DISPLAY": ":" + number.decode().strip()}
        with open(pathlib.Path(self.folder.name) / "Xvfb_screen0", "rb") as file:
            self.memory = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        header = struct.unpack(">25I", self.memory[:100])
        self.width, self.height, self.stride = header[4], header[5], header[12]
        self.start = header[0] + 12 * header[19]

    def close(self):
        self.memory.close()
        self.server.terminate()
        self.server.wait()
        self.folder.cleanup()

    def rows(self, x, y, width, height):
        """The bytes of a rectangle, row by row."""
        begin = self.start + 4 * x
        return [self.memory[begin + row * self.stride:begin + row * self.stride + 4 * width] for row in range(y, y + height)]

    def part(self, box):
        return b"".join(self.rows(*box))

    def pixels_like(self, box, colour, distance=0):
        """Those of a rectangle whose red, green and blue are that near to a colour's."""
        found = []
        r, g, b = colour
        for row, data in enumerate(self.rows(*box)):
            for i in range(0, len(data), 4):
                if abs(data[i] - b) <= distance and abs(data[i + 1] - g) <= distance and abs(data[i + 2] - r) <= distance:
                    found.append((box[0] + i // 4, box[1] + row))
        return found

    def do(self, *words):
        """xdotool, several of whose commands may follow one another: they arrive in this order."""
        subprocess.run(["xdotool", *map(str, words)], env=self.env, check=True, timeout=PATIENCE, stdout=subprocess.DEVNULL)


def at_work(process):
    """Of a process, whether its first thread, and whether any other one, has something to do: it has a processor or waits for one."""
    first, others = False, False
    for thread in pathlib.Path(f"/proc/{process.pid}/task").glob("*"):
        try:
            # The name before the state may contain anything, but ends with the last parenthesis.
            works = (thread / "stat").read_text().rpartition(")")[2].split()[0] in "RD"
        except (FileNotFoundError, ProcessLookupError):
            works = True  # it has just ended
        if thread.name == str(process.pid):
            first = works
        else:
            others = others or works
    return first, others


def steady(screen, box):
    """The picture in a rectangle, once it does not change and neither the server nor the viewer has anything left to do: on a busy
    machine that takes longer. What other threads have finished the viewer draws within its 80 ms, for which it wakes up."""
    last, since, calm = screen.part(box), time.monotonic(), 0
    end = since + PATIENCE
    while calm < 3 or time.monotonic() - since < 0.12:
        if time.monotonic() > end:
            raise AssertionError(f"waited {PATIENCE} s for a picture at rest")
        time.sleep(0.01)
        work = [at_work(process) for process in screen.processes]  # before the picture: whoever is done has drawn it
        now = screen.part(box)
        if now != last or any(others for _, others in work):
            last, since, calm = now, time.monotonic(), 0
        elif not any(first for first, _ in work):
            calm += 1
    return last


class Viewer:
    """The viewer on a screen, started in a folder; what it says goes into stderr.txt there."""

    def __init__(self, screen, program, folder, *words, rests=True):
        """rests: until nothing is at work any more; otherwise until there is a window that shows something."""
        self.screen, self.folder = screen, pathlib.Path(folder)
        self.file = self.folder / "state.json"
        self.file.unlink(missing_ok=True)
        # Nothing of the viewer before: the screen must be black, or its last picture would be taken for this one's first.
        middle = (0, screen.height // 2, screen.width, 1)
        wait_for(lambda: not any(screen.part(middle).replace(b"\0", b"")), "an empty screen")
        screen.do("mousemove", 3, 3)
        with open(self.folder / "stderr.txt", "wb") as errors:
            self.process = subprocess.Popen([program, *map(str, words), "--state", self.file], env=screen.env, cwd=folder,
                                            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors)
        screen.processes.append(self.process)
        try:
            # Before its first frame the window does not listen.
            wait_for(lambda: self.ended() or any(screen.part(middle).replace(b"\0", b"")), "the window's picture")
            if rests:
                steady(screen, (0, 0, screen.width, screen.height))
        except BaseException:
            self.stop()
            raise

    def ended(self):
        return self.process.poll() is not None

    def processor_time(self):
        """In the kernel's ticks, of all threads so far."""
        return sum(map(int, pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()[11:13]))

    def said(self):
        return (self.folder / "stderr.txt").read_text()

    def do(self, *words):
        self.screen.do(*words)

    def keys(self, *names):
        self.do(*[word for name in names for word in ("key", name)])

    def click(self, x, y, button=1):
        self.do("mousemove", x, y, "click", button)

    def drag(self, start, end, button=1):
        (x0, y0), (x1, y1) = start, end
        moves = [word for i in range(1, 5) for word in ("mousemove", round(x0 + (x1 - x0) * i / 4), round(y0 + (y1 - y0) * i / 4))]
        self.do("mousemove", x0, y0, "mousedown", button, *moves, "mouseup", button)

    def quit(self):
        """Presses q and returns the state that the viewer leaves: all events before it have been dealt with by then."""
        if not self.ended():
            self.keys("q")
        try:
            code = self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.stop()
            raise AssertionError("key q does not end the viewer")
        if code:
            raise AssertionError(f"the viewer ended with {code}: {self.said()}")
        return json.loads(self.file.read_text())

    def stop(self):
        if not self.ended():
            self.process.kill()
        self.process.wait()
        if self.process in self.screen.processes:
            self.screen.processes.remove(self.process)
