#!/usr/bin/env python3
"""The viewer on displays that cannot draw, on small and on dense screens, and the X server that it starts for itself.

    display_test.py VIEWER BROKEN_GL

Ends with 77 if Xvfb or xdotool is missing.
"""
import json
import os
import pathlib
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import unittest

import xscreen
from xdesktop import Desktop
from xscreen import Screen, Viewer, wait_for

VIEWER = pathlib.Path(sys.argv.pop(1)).resolve()
BROKEN_GL = pathlib.Path(sys.argv.pop(1)).resolve()
REPLAYS = pathlib.Path(__file__).parent / "replays"
SOCKETS = pathlib.Path("/tmp/.X11-unix")
PLAIN = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY", "GDK_SCALE", "QT_SCALE_FACTOR")}
SMALL = ("2", "--size-window", "640x400")
LONG = 120  # seconds: for what must not hang


def png_size(file):
    return struct.unpack(">II", pathlib.Path(file).read_bytes()[16:24])


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)

    def screen(self, *size, **options):
        screen = Screen(*size, **options)
        self.addCleanup(screen.close)
        return screen

    def desktop(self, screen):
        desktop = Desktop(screen)
        self.addCleanup(desktop.close)
        return desktop

    def start(self, *words, env=PLAIN):
        process = subprocess.Popen([VIEWER, *map(str, words)], cwd=self.here, env=env, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        return process

    def end(self, process, code=0):
        out, error = process.communicate(timeout=LONG)
        self.assertEqual((process.returncode, out), (code, ""), error)
        return error

    def view(self, *words, code=0, env=PLAIN):
        return self.end(self.start(*words, env=env), code)

    def picture(self, *words, env=PLAIN):
        self.view(*words, "--screenshot", "shot.png", env=env)
        return (self.here / "shot.png").read_bytes()


class Displays(Case):
    @classmethod
    def setUpClass(cls):
        cls.good = Screen(700, 500)
        cls.addClassCleanup(cls.good.close)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([VIEWER, *SMALL, "--screenshot", "shot.png"], cwd=folder, env=PLAIN, check=True, capture_output=True)
            cls.expected = (pathlib.Path(folder) / "shot.png").read_bytes()

    def cannot(self, env, *said):
        """A window is refused with one sentence, which says why; pictures are drawn all the same."""
        env = {**PLAIN, **env}
        window, shot = self.start(2, env=env), self.start(*SMALL, "--screenshot", "shot.png", env=env)
        error = self.end(window, 3)
        self.assertEqual(error.count("\n"), 1, error)
        for part in (*said, "--screenshot"):
            self.assertIn(part, error)
        self.end(shot)
        self.assertEqual((self.here / "shot.png").read_bytes(), self.expected)

    def on(self, screen, **more):
        return {"DISPLAY": screen.env["DISPLAY"], **more}

    def broken(self, how):
        """The good display with an OpenGL that fails there. LD_PRELOAD knows no blanks in a path, LD_LIBRARY_PATH does."""
        return self.on(self.good, LD_PRELOAD=BROKEN_GL.name, LD_LIBRARY_PATH=str(BROKEN_GL.parent), RAYTREE_BROKEN_HOW=how,
                       RAYTREE_BROKEN_DISPLAY=self.good.env["DISPLAY"])

    def test_there_is_none(self):
        self.cannot({}, "there is no display")
        self.cannot({"DISPLAY": ""}, "there is no display")

    def test_a_session_with_wayland_alone_is_none(self):
        self.cannot({"WAYLAND_DISPLAY": "wayland-0", "XDG_SESSION_TYPE": "wayland"}, "there is no display")

    def test_it_cannot_be_opened(self):
        self.cannot({"DISPLAY": ":64999"}, "the display :64999 cannot be opened")
        self.cannot({"DISPLAY": "nonsense"}, "nonsense", "cannot be opened")

    def test_its_opengl_is_too_old(self):
        self.cannot(self.on(self.good, MESA_GL_VERSION_OVERRIDE="3.1"), "has OpenGL 3.1, and 3.2 is needed")
        self.cannot(self.on(self.good, MESA_GL_VERSION_OVERRIDE="2.1"), "has OpenGL 2.1, and 3.2 is needed")

    def test_its_opengl_is_indirect(self):
        self.cannot(self.on(self.good, LIBGL_ALWAYS_INDIRECT="1"), "has no OpenGL that works")

    def test_it_has_no_opengl(self):
        self.cannot(self.on(self.screen(700, 500, options=("-extension", "GLX"))), "has no OpenGL")

    def test_it_has_too_few_colours(self):
        self.cannot(self.on(self.screen(700, 500, 8)), "has no OpenGL")

    def test_colours_of_16_bits_are_enough_and_the_picture_has_all_of_them(self):
        screen = self.screen(700, 500, 16)
        self.assertEqual(self.picture(*SMALL, env={**PLAIN, **self.on(screen)}), self.expected)
        window = self.start(2, env={**PLAIN, **self.on(screen)})
        wait_for(lambda: subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "raytree"], env=screen.env,
                                        capture_output=True).returncode == 0, "the window")
        self.assertIsNone(window.poll())

    def test_its_driver_crashes(self):
        for how in ("crash", "abort", "exit"):
            with self.subTest(how):
                self.cannot(self.broken(how), "crashes")

    def test_its_driver_or_server_hangs(self):
        SOCKETS.mkdir(mode=0o1777, exist_ok=True)
        listening = socket.socket(socket.AF_UNIX)
        self.addCleanup(listening.close)
        number = 61000 + os.getpid() % 4000
        file = SOCKETS / f"X{number}"
        listening.bind(str(file))
        self.addCleanup(file.unlink)
        listening.listen(8)  # and never answers
        self.cannot({"DISPLAY": f":{number}"}, "does not answer")
        self.cannot(self.broken("hang"), "does not answer")

    def test_what_is_played_without_a_window_is_drawn_all_the_same(self):
        log = REPLAYS / "steps.log"
        env = {**PLAIN, **self.on(self.good, MESA_GL_VERSION_OVERRIDE="3.1")}
        self.view(6, "--size-window", "1600x900", "--play", log, "--script", "state bad.json", env=env)
        self.view(6, "--size-window", "1600x900", "--play", log, "--script", "state none.json")
        self.assertEqual((self.here / "bad.json").read_text(), (self.here / "none.json").read_text())

    def test_the_extension_render_is_not_needed(self):
        env = {**PLAIN, **self.on(self.screen(700, 500, options=("-extension", "RENDER")))}
        self.assertEqual(self.picture(*SMALL, env=env), self.expected)

    def test_one_sentence_if_no_server_can_be_started_or_it_cannot_draw(self):
        for name, env, said in (("absent", {"PATH": str(self.here)}, "xvfb"),
                                ("no driver", {"LIBGL_DRIVERS_PATH": str(self.here)}, "libgl1-mesa-dri")):
            with self.subTest(name):
                error = self.view(*SMALL, "--screenshot", "none.png", code=3, env={**PLAIN, **env})
                self.assertEqual(error.count("\n"), 1, error)
                self.assertIn("there is no display", error)
                self.assertIn(said, error)
                self.assertFalse((self.here / "none.png").exists())


def servers_of(process):
    """Running children of a process that are X servers."""
    found = []
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            name, _, rest = (folder / "stat").read_text().partition("(")[2].rpartition(")")
            if name == "Xvfb" and int(rest.split()[1]) == process and rest.split()[0] not in "ZX":
                found.append(int(folder.name))
        except OSError:
            pass  # it has just ended
    return found


def runs(process):
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


def socket_of(server):
    """The file of the socket at which an X server listens, if it does."""
    links = [os.readlink(file) for file in pathlib.Path(f"/proc/{server}/fd").iterdir()]
    for line in pathlib.Path("/proc/net/unix").read_text().splitlines():
        words = line.split()
        if len(words) == 8 and words[7].startswith(str(SOCKETS)) and f"socket:[{words[6]}]" in links:
            return pathlib.Path(words[7])
    return None


class OwnServer(Case):
    def drawing(self):
        """A viewer that is long at work, its X server and the server's socket."""
        viewer = self.start(6, "--threads", "1", "--size", "8000x8000", "--screenshot", "shot.png")
        server, = wait_for(lambda: viewer.poll() is None and servers_of(viewer.pid), "the viewer's X server")
        return viewer, server, wait_for(lambda: socket_of(server), "its socket")

    def test_it_ends_with_the_viewer_however_that_ends(self):
        for how in (signal.SIGTERM, signal.SIGINT, signal.SIGKILL):
            with self.subTest(how.name):
                viewer, server, file = self.drawing()
                viewer.send_signal(how)
                viewer.wait(xscreen.PATIENCE)
                wait_for(lambda: not runs(server), "the end of the viewer's X server")
                self.assertFalse(file.exists())

    def test_ctrl_c_at_a_terminal_ends_the_viewer_first(self):
        # Ctrl-C reaches all of the terminal's foreground group: a server in it would go first and take the viewer's words.
        viewer, server, _ = self.drawing()
        self.assertNotEqual(os.getpgid(server), os.getpgid(viewer.pid))
        self.assertNotEqual(os.getsid(server), os.getsid(viewer.pid))

    def test_other_programs_cannot_connect(self):
        _, _, file = self.drawing()

        def accepts(name, data):
            with socket.socket(socket.AF_UNIX) as client:
                client.connect(str(file))
                padded = name + bytes(-len(name) % 4) + data + bytes(-len(data) % 4)
                client.sendall(struct.pack("<BxHHHHxx", ord("l"), 11, 0, len(name), len(data)) + padded)
                return client.recv(1) == b"\1"

        self.assertFalse(accepts(b"", b""))
        self.assertFalse(accepts(b"MIT-MAGIC-COOKIE-1", bytes(16)))

    def test_many_at_once(self):
        viewers = [self.start(*SMALL, "--screenshot", f"{i}.png") for i in range(6)]
        for viewer in viewers:
            self.end(viewer)
        pictures = {(self.here / f"{i}.png").read_bytes() for i in range(6)}
        self.assertEqual(len(pictures), 1)

    def test_it_needs_no_home_and_no_folder_for_temporary_files(self):
        self.assertEqual(self.picture(*SMALL, env={"PATH": os.environ["PATH"], "TMPDIR": "/nowhere"}), self.picture(*SMALL))

    def test_it_ends_before_the_viewer_does(self):
        viewer = self.start(*SMALL, "--screenshot", "shot.png")
        server, = wait_for(lambda: viewer.poll() is None and servers_of(viewer.pid), "the viewer's X server")
        file = wait_for(lambda: socket_of(server), "its socket")
        self.end(viewer)
        self.assertFalse(runs(server))
        self.assertFalse(file.exists())


class Sizes(Case):
    def place(self, screen):
        """Place and size of the window, as X tells them; nothing if there is none."""
        done = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "raytree", "getwindowgeometry", "--shell"],
                              env=screen.env, capture_output=True, text=True, timeout=xscreen.PATIENCE)
        said = dict(line.split("=") for line in done.stdout.split())
        return tuple(int(said[key]) for key in ("X", "Y", "WIDTH", "HEIGHT")) if said else None

    def window(self, screen, *words):
        """Place and size of the window, and what the viewer says."""
        viewer = Viewer(screen, VIEWER, self.here, *(words or (2,)))
        self.addCleanup(viewer.stop)
        place = self.place(screen)
        screen.do("mousemove", screen.width // 2, screen.height // 2)  # keys go to the window below the pointer
        viewer.quit()
        return place, viewer.said()

    def test_it_is_no_larger_than_the_screen(self):
        for width, height in ((1024, 768), (1280, 800), (1366, 768), (640, 480)):
            with self.subTest(f"{width}x{height}"):
                self.assertEqual(self.window(self.screen(width, height)), ((0, 0, width, height), ""))

    def test_on_a_large_screen_it_is_as_designed_and_in_the_middle(self):
        self.assertEqual(self.window(self.screen(1920, 1080)), ((160, 90, 1600, 900), ""))

    def test_it_lies_beside_panels_with_its_frame(self):
        screen = self.screen(1280, 800)
        desktop = self.desktop(screen)
        desktop.work_area((60, 30, 1220, 770))
        self.assertEqual(self.window(screen)[0], (60, 30, 1220, 770))
        desktop.manage((2, 3, 25, 5))
        self.assertEqual(self.window(screen)[0], (60, 30, 1215, 740))

    def test_the_current_desktop_counts(self):
        screen = self.screen(1280, 800)
        desktop = self.desktop(screen)
        desktop.work_area((0, 0, 1280, 800), (0, 0, 1280, 700))
        desktop.set("_NET_CURRENT_DESKTOP", "CARDINAL", [1])
        self.assertEqual(self.window(screen)[0], (0, 0, 1280, 700))

    def test_there_is_room_for_the_frame_of_a_manager_that_does_not_say_how_large_it_is(self):
        screen = self.screen(1280, 800)
        self.desktop(screen).manage()
        (_, _, width, height), _ = self.window(screen)
        self.assertLess(width, 1280)
        self.assertLess(height, 780)
        self.assertGreater(height, 700)

    def test_it_lies_on_the_monitor_with_the_pointer(self):
        screen = self.screen(2000, 800)
        self.desktop(screen).monitors(screen, (0, 0, 1100, 800), (1100, 100, 900, 600))
        for pointer, place in (((1500, 300), (1100, 100, 900, 600)), ((500, 300), (0, 0, 1100, 800))):
            screen.do("mousemove", *pointer)
            viewer = self.start(2, env={**PLAIN, **screen.env})
            wait_for(lambda: viewer.poll() is not None or self.place(screen), "the window")
            self.assertEqual(self.place(screen), place)
            viewer.terminate()
            viewer.wait(xscreen.PATIENCE)

    def test_a_size_that_was_asked_for_is_cut_with_a_sentence_and_kept_in_pictures(self):
        screen = self.screen(1280, 800)
        asked = ("2", "--size-window", "2000x700")
        place, said = self.window(screen, *asked)
        self.assertEqual(place, (0, 50, 1280, 700))
        self.assertEqual(said.count("\n"), 1, said)
        for part in ("2000x700", "1280x700"):
            self.assertIn(part, said)
        self.view(*asked, "--screenshot", "shot.png", env=screen.env)
        self.assertEqual(png_size(self.here / "shot.png"), (2000, 700))

    def test_what_is_recorded_on_a_small_screen_can_be_played(self):
        screen = self.screen(1024, 768)
        viewer = Viewer(screen, VIEWER, self.here, 6, "--record", "mine.log")
        self.addCleanup(viewer.stop)
        viewer.click(100, 110)
        recorded = viewer.quit()
        self.view(6, "--play", "mine.log", "--script", "state state.json")
        self.view(6, "--play", "mine.log", "--script", "state small.json", env=screen.env)
        for name in ("state", "small"):
            self.assertEqual(json.loads((self.here / f"{name}.json").read_text())["pixel"], recorded["pixel"])


class Gone(Case):
    def test_a_display_that_goes_ends_the_viewer_with_one_sentence(self):
        screen = self.screen(700, 500)
        viewer = Viewer(screen, VIEWER, self.here, 2)
        self.addCleanup(viewer.stop)
        screen.server.terminate()
        self.assertEqual(viewer.process.wait(xscreen.PATIENCE), 3)
        self.assertEqual(viewer.said(), "viewer: the display has closed the connection\n")


class Scale(Case):
    def pixel_below(self, screen, x, y, *words):
        """Size of the window on a screen, and the pixel that a click there chooses."""
        viewer = Viewer(screen, VIEWER, self.here, 6, *words)
        self.addCleanup(viewer.stop)
        viewer.click(x, y)
        return viewer.quit()["pixel"]

    def expect_near(self, pixel, usual):
        """Where panes begin is rounded to pixels of the screen."""
        for value, expected in zip(pixel, usual, strict=True):
            self.assertLessEqual(abs(value - expected), 3, f"{pixel} for {usual}")

    def usual(self):
        self.view(6, "--script", "click 100 110; state usual.json")
        return json.loads((self.here / "usual.json").read_text())["pixel"]

    def test_a_window_follows_the_resources_of_x(self):
        usual = self.usual()
        screen = self.screen(3840, 2160)
        self.desktop(screen).resources("Xft.dpi:\t192\n")
        # In the middle of the screen, 3200 x 1800.
        self.expect_near(self.pixel_below(screen, 320 + 200, 180 + 220), usual)
        # The option has the last word.
        self.assertEqual(self.pixel_below(screen, 1120 + 100, 630 + 110, "--scale", "1"), usual)

    def test_a_picture_does_not_follow_the_screen(self):
        screen = self.screen(1280, 800)
        self.desktop(screen).resources("Xft.dpi:\t192\n")
        env = {**screen.env, "GDK_SCALE": "2", "QT_SCALE_FACTOR": "2"}
        self.assertEqual(self.picture(2, env=env), self.picture(2))

    def test_a_picture_may_be_scaled(self):
        self.view(2, "--scale", "2", "--screenshot", "large.png")
        self.assertEqual(png_size(self.here / "large.png"), (3200, 1800))
        self.view(6, "--scale", "2", "--script", "click 200 220; state large.json")
        self.expect_near(json.loads((self.here / "large.json").read_text())["pixel"], self.usual())

    def test_scales_out_of_range_are_refused(self):
        for scale in ("0", "0.4", "4.1", "nan", "two"):
            with self.subTest(scale):
                error = self.view(2, "--scale", scale, "--screenshot", "none.png", code=2)
                self.assertEqual(error.count("\n"), 1, error)
                self.assertIn("--scale", error)


if __name__ == "__main__":
    if xscreen.missing():
        print(f"skipped: {xscreen.missing()} is not installed")
        sys.exit(77)
    unittest.main()
