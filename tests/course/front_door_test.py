#!/usr/bin/env python3
"""./raytree on machines that are not ours: what it installs, builds, says and waits for.

Debian's tools and CMake are stubs that note how they were called: `tests/bare/` tries the same with real ones.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ["sh", "readlink", "dirname", "sed", "tr", "cat", "grep", "head", "tail", "mkdir", "rm", "ls", "flock", "env", "nproc", "sleep", "touch", "true", "chmod"]

STUBS = {
    # Says what $FACTS/present lists.
    "dpkg-query": '''for package; do grep -qx -e "$package" "$FACTS/present" && echo "$package installed"; done; true''',
    # Installs by adding to that list. $FACTS/unknown: in no list; broken: what goes wrong.
    "apt-get": '''while [ "$1" = -o ]; do shift 2; done
echo "apt-get $*" >>"$FACTS/log"
case "$1" in
    update)
        if [ -s "$FACTS/locked" ]; then sed -i 1d "$FACTS/locked"; echo "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 1 (apt)"; exit 100; fi
        if [ -f "$FACTS/broken-update" ]; then echo "E: The repository 'http://foreign.example bookworm Release' does not have a Release file."; exit 100; fi ;;
    install)
        for word; do
            case "$word" in -s | --assume-no) pretend=yes ;; esac
            if grep -qx -e "$word" "$FACTS/unknown"; then echo "E: Unable to locate package $word" >&2; bad=yes; fi
        done
        [ -z "${bad:-}" ] || exit 100
        [ -z "${pretend:-}" ] || exit 0
        if [ -f "$FACTS/broken-install" ]; then echo "E: Unable to fetch some archives"; exit 100; fi
        for word; do case "$word" in install | -* | APT::*) ;; *) echo "$word" >>"$FACTS/present" ;; esac; done ;;
esac''',
    # Configures by writing the options into the cache, builds programs that say how they were called.
    "cmake": '''echo "cmake $*" >>"$FACTS/log"
[ ! -f "$FACTS/path" ] || echo "$PATH" >"$FACTS/path"
build=build/release
mkdir -p "$build/bin" 2>/dev/null
case "$1" in
    --build)
        build=$2
        shift 2
        if [ "${2:-}" = build.ninja ] && [ -f "$FACTS/broken-configure" ]; then rm "$FACTS/broken-configure"; exit 1; fi
        if [ -f "$FACTS/slow" ]; then echo begins >>"$FACTS/turns"; sleep 1; echo ends >>"$FACTS/turns"; fi
        [ $# = 0 ] || shift
        [ ! -f "$FACTS/broken-build" ] || exit 1
        for target; do printf '#!/bin/sh\\necho "%s: $*"\\nexit %s' "$target" "$(cat "$FACTS/exits" 2>/dev/null || echo 0)" >"$build/bin/$target"; chmod +x "$build/bin/$target"; done ;;
    *)
        if [ "$1" != --fresh ] && [ -f "$FACTS/broken-configure" ]; then rm "$FACTS/broken-configure"; exit 1; fi
        if [ -f "$FACTS/broken-cmake" ]; then echo "CMake Error: no"; exit 1; fi
        : >"$build/build.ninja"
        echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >"$build/CMakeCache.txt"
        for word; do case "$word" in -D*) word=${word#-D}; echo "${word%%=*}:BOOL=${word#*=}" >>"$build/CMakeCache.txt" ;; esac; done ;;
esac''',
    "sudo": '''[ ! -f "$FACTS/no-sudo" ] || exit 1
while [ "${1#-}" != "$1" ]; do shift; done
echo "sudo $*" >>"$FACTS/log"
exec "$@"''',
    "id": '''if [ "$1" = -u ]; then cat "$FACTS/uid"; else echo somebody; fi''',
    "ctest": '''echo "ctest $*" >>"$FACTS/log"
while [ "$1" != --output-junit ]; do shift; done
echo '<testsuite><testcase name="a" status="run"/></testsuite>' >"$2"''',
}


class FrontDoor(unittest.TestCase):
    def setUp(self):
        self.place = pathlib.Path(tempfile.mkdtemp(prefix="front door "))
        self.addCleanup(shutil.rmtree, self.place)
        self.clone = self.place / "a clone"
        self.clone.mkdir()
        (self.clone / "common").mkdir()
        shutil.copy(ROOT / "raytree", self.clone)
        shutil.copy(ROOT / "common/front_door.sh", self.clone / "common")
        for name in ("lessons", "tests", "common/help"):
            (self.clone / name).symlink_to(ROOT / name)
        self.facts = self.place / "facts"
        self.facts.mkdir()
        for name in ("present", "unknown", "log", "turns"):
            (self.facts / name).touch()
        (self.facts / "uid").write_text("0\n")
        self.tools = self.place / "tools"
        self.tools.mkdir()
        for tool in TOOLS:
            (self.tools / tool).symlink_to(shutil.which(tool))
        for name, text in STUBS.items():
            (self.tools / name).unlink(missing_ok=True)
            (self.tools / name).write_text("#!/bin/sh\n" + text + "\n")
            (self.tools / name).chmod(0o755)
        # No HOME, no locale, no terminal, no display.
        self.environment = {"PATH": str(self.tools), "FACTS": str(self.facts)}

    def raytree(self, *words, code=0, door=None, **more):
        done = subprocess.run([door or self.clone / "raytree", *words], cwd=more.pop("cwd", self.place), env=self.environment | more,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout, done.stderr

    def log(self):
        text = (self.facts / "log").read_text()
        (self.facts / "log").write_text("")
        return text

    def installed(self):
        return set((self.facts / "present").read_text().split())

    def test_a_lesson_needs_no_viewer_no_tests_and_no_grader(self):
        out, err = self.raytree("lesson", "2", "--size", "4x3")
        self.assertEqual(out, "lesson02: --size 4x3\n")
        self.assertIn("g++", self.installed())
        for package in ("libvtk9-dev", "libgtest-dev", "bubblewrap", "chromium", "doxygen", "xvfb"):
            self.assertNotIn(package, self.installed())
        log = self.log()
        self.assertIn("-DRAYTREE_VIEWER=OFF", log)
        self.assertIn("-DRAYTREE_TESTS=OFF", log)
        self.assertIn("--target lesson02\n", log)
        self.assertLess(log.index("apt-get update"), log.index("--no-install-recommends"))
        self.assertIn("packages.log", err)

    def test_what_was_asked_for_once_stays(self):
        self.raytree("view", "2")
        self.assertIn("-DRAYTREE_VIEWER=ON", self.log())
        self.assertIn("libvtk9-dev", self.installed())
        self.raytree("lesson", "2")
        log = self.log()
        self.assertNotIn("--preset", log)  # nothing to configure anew
        self.assertNotIn("apt-get", log)   # nor to install
        self.raytree("learn")
        log = self.log()
        self.assertIn("-DRAYTREE_VIEWER=ON", log)
        self.assertIn("-DRAYTREE_GRADER=ON", log)
        self.assertIn("bubblewrap", self.installed())

    def test_the_viewer_compares_with_an_exercise_that_is_built(self):
        self.raytree("view", "6", "--compare", "exercise")
        self.assertIn("--target viewer exercise06\n", self.log())

    def test_a_hand_out_needs_python_only(self):
        (self.tools / "python3").symlink_to(shutil.which("python3"))
        self.raytree("handout", "--lessons", "77", code=2)
        self.assertEqual(self.installed(), {"python3"})
        self.assertNotIn("cmake", self.log())

    def test_openimageio_comes_when_a_picture_asks_for_it(self):
        self.raytree("lesson", "4")
        self.assertNotIn("libopenimageio-dev", self.installed())
        program = self.place / "program"
        program.write_text('#!/bin/sh\necho "again: $*, door: ${RAYTREE_DOOR:-none}"\n')
        program.chmod(0o755)
        out, _ = self.raytree("pictures", str(program), "4", "two words")
        self.assertEqual(out, "again: 4 two words, door: none\n")
        self.assertIn("libopenimageio-dev", self.installed())
        self.assertIn("-DRAYTREE_PICTURES=ON", self.log())

    def test_all_is_installed_at_once_for_the_tests(self):
        self.raytree("test", "-R", "course")
        log = self.log()
        installs = [line for line in log.splitlines() if line.startswith("apt-get install -y")]
        self.assertEqual(len(installs), 1, log)
        for package in ("g++", "libvtk9-dev", "libgtest-dev", "chromium", "doxygen", "clang"):
            self.assertIn(f" {package}", installs[0])
        self.assertIn("ctest", log)
        self.assertIn("-R course", log)

    def test_help_comes_at_once(self):
        for words in (["lesson"], ["lesson", "2"], ["exercise"], ["exercise", "3"], ["learn"], ["grade"], ["merge"], ["render"], ["view"], ["trade"],
                      ["handout"], ["notes"], ["bench"], ["test"]):
            for flag in ("--help", "-h"):
                out, err = self.raytree(*words, flag)
                self.assertIn("usage", out.lower(), words)
                self.assertEqual(err, "")
        self.assertIn("lesson02", self.raytree("lesson", "2", "--help")[0])
        self.assertEqual(self.log(), "")
        self.assertEqual(self.installed(), set())

    def test_a_foreign_source_that_fails_is_said_and_passed_over(self):
        (self.facts / "broken-update").touch()
        out, err = self.raytree("lesson", "2")
        self.assertIn("lesson02", out)
        self.assertIn("foreign.example", err)
        self.assertIn("going on", err)

    def test_waits_for_another_apt(self):
        (self.facts / "locked").write_text("once\n")
        out, err = self.raytree("lesson", "2")
        self.assertIn("lesson02", out)
        self.assertIn("waiting: another program is installing packages", err)
        self.assertIn("-y", self.log())

    def test_a_package_that_no_list_has_is_named(self):
        (self.facts / "unknown").write_text("libglm-dev\n")
        _, err = self.raytree("lesson", "2", code=2)
        self.assertIn("libglm-dev", err)
        self.assertNotIn("libfmt-dev", err)
        # What only some tests need is left out, and the rest is installed.
        (self.facts / "unknown").write_text("chromium\n")
        _, err = self.raytree("test")
        self.assertIn("chromium", err)
        self.assertIn("doxygen", self.installed())

    def test_what_could_not_be_installed_is_said_in_a_sentence(self):
        (self.facts / "broken-install").touch()
        _, err = self.raytree("lesson", "2", code=2)
        self.assertIn("Unable to fetch some archives", err)
        self.assertIn("packages.log", err)

    def test_without_root_one_line_says_it_all(self):
        (self.facts / "uid").write_text("1000\n")
        (self.facts / "no-sudo").touch()
        for sudo in ("refuses", "is missing"):
            if sudo == "is missing":
                (self.tools / "sudo").unlink()
            _, err = self.raytree("test", code=2)
            line, = [line for line in err.splitlines() if "apt-get" in line]
            self.assertTrue(line.startswith("apt-get update && apt-get install -y --no-install-recommends "), line)
            self.assertIn("chromium", line)
            self.assertIn("libvtk9-dev", line)
            # Root runs just that line.
            subprocess.run(["sh", "-c", line], env=self.environment, check=True, stdout=subprocess.DEVNULL)
            self.assertIn("chromium", self.installed())
            self.raytree("test")
            (self.facts / "present").write_text("")
        (self.facts / "present").write_text("")

    def test_sudo_installs_and_nothing_else(self):
        (self.facts / "uid").write_text("1000\n")
        self.raytree("lesson", "2")
        for line in self.log().splitlines():
            if line.startswith("sudo "):
                self.assertRegex(line, r"^sudo (env .*apt-get|true)")
            if line.startswith("cmake"):
                self.assertNotIn("sudo", line)

    def test_elsewhere_the_names_are_printed_when_cmake_fails(self):
        (self.tools / "dpkg-query").unlink()
        (self.tools / "apt-get").unlink()
        self.assertIn("lesson02", self.raytree("lesson", "2")[0])
        shutil.rmtree(self.clone / "build")
        (self.facts / "broken-cmake").touch()
        _, err = self.raytree("lesson", "2", code=2)
        self.assertIn("libtomlplusplus-dev", err)
        self.assertIn("neither Debian nor Ubuntu", err)

    def test_through_a_symbolic_link(self):
        (self.place / "bin").mkdir()
        (self.place / "bin/raytree").symlink_to(self.clone / "raytree")
        (self.place / "second").symlink_to("bin/raytree")
        for door in ("bin/raytree", "second"):
            self.assertIn("lesson02", self.raytree("lesson", "2", door=self.place / door)[0])

    def test_beside_conda(self):
        conda = self.place / "miniconda 3"
        (conda / "conda-meta").mkdir(parents=True)
        (conda / "bin").mkdir()
        (self.facts / "path").touch()
        self.raytree("lesson", "2", PATH=f"{conda}/bin:{self.tools}")
        self.assertEqual((self.facts / "path").read_text().strip(), str(self.tools))

    def test_a_clone_with_line_ends_of_windows(self):
        """As git for Windows clones, with core.autocrlf: the scripts keep their line ends."""
        def git(*words):
            subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "core.autocrlf=true", "-c", "safe.directory=*", *words],
                           env={"PATH": os.environ["PATH"], "HOME": str(self.place)}, cwd=self.place, check=True, capture_output=True)
        source = self.place / "source"
        (source / "common").mkdir(parents=True)
        for name in ("raytree", ".gitattributes", "common/front_door.sh"):
            shutil.copy(ROOT / name, source / name)
        git("init", str(source))
        git("-C", str(source), "add", ".")
        git("-C", str(source), "commit", "-m", "all")
        git("clone", str(source), "windows")
        for name in ("raytree", "common/front_door.sh"):
            self.assertNotIn(b"\r", (self.place / "windows" / name).read_bytes())

    def test_one_builds_while_the_others_wait(self):
        (self.facts / "slow").touch()
        commands = (["lesson", "2"], ["grade", "6"], ["view"])
        both = [subprocess.Popen([self.clone / "raytree", *words], env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True) for words in commands]
        said = [one.communicate(timeout=300) for one in both]
        self.assertEqual([one.returncode for one in both], [0, 0, 0], said)
        turns = (self.facts / "turns").read_text().split()
        self.assertEqual(turns, ["begins", "ends"] * (len(turns) // 2))
        waited = [err for _, err in said if "waiting: \"./raytree " in err]
        self.assertGreaterEqual(len(waited), 1)
        self.assertIn("is building", waited[0])

    def test_a_killed_build_is_waited_for(self):
        """What a killed front door started goes on; until it ends nobody else may build."""
        (self.facts / "slow").touch()
        first = subprocess.Popen([self.clone / "raytree", "lesson", "2"], env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                 stderr=subprocess.DEVNULL)
        while "begins" not in (self.facts / "turns").read_text():
            self.assertIsNone(first.poll())
        first.send_signal(signal.SIGKILL)
        first.wait()
        out, _ = self.raytree("lesson", "3")
        self.assertEqual(out, "lesson03: \n")
        turns = (self.facts / "turns").read_text().split()
        self.assertEqual(turns, ["begins", "ends"] * (len(turns) // 2))

    def test_a_broken_or_moved_build_is_configured_afresh(self):
        (self.facts / "broken-configure").touch()
        self.assertIn("lesson02", self.raytree("lesson", "2")[0])
        self.assertIn("cmake --fresh", self.log())
        moved = self.place / "moved"
        self.clone.rename(moved)
        self.assertIn("lesson02", self.raytree("lesson", "2", door=moved / "raytree")[0])
        self.assertIn("--preset", self.log())

    def test_a_build_that_fails_ends_it(self):
        (self.facts / "broken-cmake").touch()
        _, err = self.raytree("lesson", "2", code=2)
        self.assertIn("cmake failed", err)
        (self.facts / "broken-cmake").unlink()
        (self.facts / "broken-build").touch()
        _, err = self.raytree("lesson", "2", code=2)
        self.assertIn("the build failed", err)

    def test_what_the_program_says_comes_through(self):
        (self.facts / "exits").write_text("7")
        out, _ = self.raytree("grade", "9", code=7)
        self.assertEqual(out, "grade: 9\n")

    def test_programs_of_tests_by_name(self):
        self.raytree("test", "common_tests", "lesson_tests", "-V")
        log = self.log()
        self.assertIn("--target common_tests lesson_tests\n", log)
        self.assertIn("-R ^(common_tests|lesson_tests)$ --no-tests=error -V\n", log)
        self.assertNotIn("chromium", self.installed())

    def test_usage_mistakes(self):
        for words, says in ((["lessen"], "unknown command \"lessen\""), (["lesson"], "expected the number"), (["lesson", "77"], "there is no lesson 77"),
                            (["exercise", "9"], "no exercise"), (["lesson", "two"], "got \"two\"")):
            _, err = self.raytree(*words, code=2)
            self.assertIn(says, err)
        self.assertEqual(self.log(), "")

    def test_a_clone_of_somebody_else(self):
        (self.clone / "lessons").unlink()  # ours may be closed to others
        (self.clone / "lessons/02_mirrors").mkdir(parents=True)
        self.place.chmod(0o755)
        self.clone.chmod(0o555)
        self.addCleanup(self.clone.chmod, 0o755)
        nobody = {"user": 65534} if os.getuid() == 0 else {}  # root may write anywhere
        done = subprocess.run([self.clone / "raytree", "lesson", "2"], env=self.environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, **nobody)
        self.assertEqual(done.returncode, 2)
        self.assertIn("cannot be written to", done.stderr)


if __name__ == "__main__":
    unittest.main()
