"""A copy of the project in a scratch folder, in which commands run as a reader's would, on programs that are already built.

A check that imports this module is called with FOLDER_OF_PROGRAMS as its first argument. Only compiling is left out: `cmake`
and `dpkg-query` on the PATH are stubs that say yes, the former only to programs that exist.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from texts import FILES, FOLDERS, ROOT

BIN = pathlib.Path(sys.argv.pop(1)).resolve()
STUBS = {
    "dpkg-query": 'for package; do echo "$package installed"; done\n',
    "cmake": f'''[ "$1" = --build ] || exit 0
while [ $# -gt 0 ]; do
    if [ "$1" = --target ] && ! [ -e "{BIN}/$2" ] && ! [ -e "{BIN.parent}/$2" ]; then echo "no target $2" >&2; exit 1; fi
    shift
done
''',
}


class Scratch:
    """Folders like a fresh clone with everything built; all vanish with `close`."""

    def __init__(self):
        self.place = pathlib.Path(tempfile.mkdtemp(prefix="raytree scratch "))
        self.place.chmod(0o755)  # the grader's sandbox runs as another user
        self.copy = self.place / "copy"
        self.copy.mkdir()
        for folder in FOLDERS:  # not what else lies in the clone: README's grading section leaves a class, marks and a secret there
            shutil.copytree(ROOT / folder, self.copy / folder, ignore=shutil.ignore_patterns("__pycache__"))
        for file in FILES:
            shutil.copy(ROOT / file, self.copy)
        (self.place / "stubs").mkdir()
        for stub, text in STUBS.items():
            (self.place / "stubs" / stub).write_text("#!/bin/sh\n" + text)
            (self.place / "stubs" / stub).chmod(0o755)
        self.environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        self.environment |= {"PATH": f"{self.place}/stubs:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}

    def clone(self, which):
        """A folder with the project's files, where ./raytree runs and files may be written."""
        here = self.place / which
        here.mkdir()
        for path in self.copy.iterdir():
            if path.name == "raytree":
                shutil.copy(path, here)
            else:
                (here / path.name).symlink_to(path)
        build = here / "build/release"
        build.mkdir(parents=True)
        for built in BIN.parent.iterdir():
            if built.is_dir():
                (build / built.name).symlink_to(built)
        (build / "build.ninja").touch()
        return here

    def run(self, command, here, seconds=600):
        """A line for the shell. Returns (exit code, all output); the exit code is None when the time was over."""
        try:
            done = subprocess.run(["sh", "-c", command], cwd=here, env=self.environment, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds)
        except subprocess.TimeoutExpired as late:
            return None, (late.stdout or b"").decode(errors="replace")
        return done.returncode, done.stdout.decode(errors="replace")

    def close(self):
        shutil.rmtree(self.place, ignore_errors=True)
