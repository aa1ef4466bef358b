"""Pictures and ray trees, made by the course's own programs: two at a time, and each only once as long as what it is made
of stays the same."""
import concurrent.futures
import functools
import hashlib
import pathlib
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass

from PIL import Image

from course import NOTES, ROOT, SiteError, first_scene, lesson

JOBS = 2
SECONDS = 600  # for one picture; the slowest takes a minute on one core
SIZES = {9: (320, 240), 10: (480, 360)}  # of either half of a pair; the references of lesson 09 take their time


@functools.cache
def digest(path):
    """Of a file, or of all files in a folder."""
    files = sorted(p for p in path.rglob("*") if p.is_file()) if path.is_dir() else [path]
    return hashlib.sha256(b"".join(hashlib.sha256(file.read_bytes()).digest() for file in files)).hexdigest()


@dataclass(frozen=True)
class Exhibit:
    """A file that a program writes. `made` are the words after the program, with OUT for the file's place."""
    target: str        # in the site
    program: str
    made: tuple
    reads: tuple = ()  # files and folders
    half: str = ""     # "left", "right": of a pair of pictures

    def key(self, programs):
        parts = [self.program, digest(programs / self.program), *self.made, self.half, *(digest(path) for path in self.reads)]
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:32]


class Exhibits:
    def __init__(self, programs, cache, draft, children):
        self.programs, self.cache, self.draft, self.children = programs, cache, draft, children
        self.wanted = {}  # target -> Exhibit

    def add(self, exhibit):
        if self.wanted.setdefault(exhibit.target, exhibit) != exhibit:
            raise SiteError(f"{exhibit.target} is to be made in two ways: {' '.join(self.wanted[exhibit.target].made)}, and {' '.join(exhibit.made)}")
        if not (self.programs / exhibit.program).is_file():
            raise SiteError(f"{exhibit.target} needs the program {exhibit.program}, which is not in {self.programs}")
        return exhibit.target

    def size(self, width, height):
        return f"{width // 4}x{height // 4}" if self.draft else f"{width}x{height}"

    def command(self, name, words):
        """`render: NAME = WORDS`, the words of ./raytree: lesson N [SCENE] [options] [| left half]."""
        words, half = re.fullmatch(r"(.*?)(?:\s*\|\s*(left|right) half)?", words.strip()).groups()
        words = words.split()
        if len(words) < 2 or words[0] != "lesson" or not words[1].isdigit():
            raise SiteError(f"render: {name}: expected 'lesson N', got '{' '.join(words)}'")
        number, rest = int(words[1]), words[2:]
        if "--size" not in rest:
            rest += ["--size", self.size(*SIZES.get(number, (720, 540)) if not half else (720, 540))]
        if number == 9 and self.draft:
            rest += ["--spp", "4"]
        reads = [lesson(number).folder / "scenes", *(ROOT / word for word in rest if word.endswith(".toml"))]
        return self.add(Exhibit(f"pictures/{name}", f"lesson{number:02}", (*rest, "--out", "OUT"), tuple(reads), half or ""))

    def picture(self, name):
        """A picture of the notes: made afresh where its name says how (NN_scene, NN_limitation, NN_exhibit, 00_figure)."""
        if f"pictures/{name}" in self.wanted:
            return f"pictures/{name}"
        path = NOTES / "pictures" / name
        found = re.fullmatch(r"(\d\d)_(\w+)\.(png|svg)", name)
        if found:
            number, what, _ = found.groups()
            scene = lesson(number).folder / "scenes" / f"{what}.toml"
            if number == "00":
                return self.add(Exhibit(f"pictures/{name}", "lesson00", ("--figures", "FOLDER/" + name)))
            if number == "09":
                return self.command(name, f"lesson 9 --limitation {what}")
            if number == "10" and path.suffix == ".png":
                return self.command(name, f"lesson 10 --exhibit {what}")
            if scene.exists():
                return self.command(name, f"lesson {int(number)} {scene.relative_to(ROOT)}")
        if not path.is_file():
            raise SiteError(f"there is no picture {name}, and nothing says how it is made")
        return self.add(Exhibit(f"pictures/{name}", "lesson00", ("COPY", name), (path,)))

    def tree(self, number, scene=None, pixel=None):
        """The page of a ray tree, by the viewer."""
        scene = scene or first_scene(lesson(number))
        _, x, y = lesson(number).chosen(scene)
        x, y = pixel or (x, y)
        name = f"trees/{number}-{scene.stem}-{x}-{y}.html"
        made = (str(int(number)), str(scene.relative_to(ROOT)), "--pixel", f"{x},{y}", "--export", "OUT")
        return self.add(Exhibit(name, "viewer", made, (scene.parent, ROOT / "viz/html", lesson(number).source)))

    def json_example(self):
        """The ray tree of lesson 01's chosen pixel, as text."""
        target = "json/lesson01.json"
        if target not in self.wanted:
            scenes = lesson(1).folder / "scenes"
            self.add(Exhibit(target, "lesson01", (str(first_scene(lesson(1)).relative_to(ROOT)), "--tree", "json", "STDOUT"), (scenes,)))
        return target

    def make(self, out, say):
        """All that is wanted, into the folder."""
        self.cache.mkdir(parents=True, exist_ok=True)
        missing = [e for e in self.wanted.values() if not self.cached(e).exists()]
        done = 0
        with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
            running = {pool.submit(self.run, exhibit): exhibit for exhibit in missing}
            try:
                for finished in concurrent.futures.as_completed(running):
                    finished.result()
                    done += 1
                    say(f"{running[finished].target} ({done} of {len(missing)})")
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                raise
        for exhibit in self.wanted.values():
            target = out / exhibit.target
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(self.cached(exhibit), target)

    def cached(self, exhibit):
        return self.cache / (exhibit.key(self.programs) + pathlib.Path(exhibit.target).suffix)

    def run(self, exhibit):
        target = self.cached(exhibit)
        with tempfile.TemporaryDirectory(dir=self.cache) as folder:
            part = pathlib.Path(folder) / f"part{target.suffix}"
            if exhibit.made[0] == "COPY":
                shutil.copyfile(exhibit.reads[0], part)
            else:
                self.call(exhibit, pathlib.Path(folder), part)
            if exhibit.half:
                with Image.open(part) as pair:
                    width = (pair.width - 4) // 2  # four columns part the halves
                    left = 0 if exhibit.half == "left" else pair.width - width
                    pair.crop((left, 0, left + width, pair.height)).save(part)
            part.replace(target)

    def call(self, exhibit, folder, part):
        if exhibit.made[0] == "--figures":
            words = ["--figures", str(folder)]
        else:
            words = [str(part) if word == "OUT" else word for word in exhibit.made if word != "STDOUT"]
        shown = f"{exhibit.program} {' '.join(exhibit.made)}"
        try:
            done = self.children.run([self.programs / exhibit.program, *words], cwd=ROOT, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            raise SiteError(f"{shown}: not done after {SECONDS} s") from None
        if done.returncode:
            reason = (done.stderr.strip() or "no reason given").splitlines()[-1]
            raise SiteError(f"{shown}: exit code {done.returncode}: {reason}")
        if "STDOUT" in exhibit.made:
            part.write_text(done.stdout)
        if exhibit.made[0] == "--figures":
            (folder / exhibit.made[1].split("/")[1]).replace(part)


def dimensions(path):
    """Width and height in pixels, for the page to keep the place free."""
    if path.suffix == ".svg":
        head = path.read_text()[:2000]
        box = re.search(r'viewBox="[-\d.]+ [-\d.]+ ([\d.]+) ([\d.]+)"', head)
        return round(float(box[1])), round(float(box[2]))
    with Image.open(path) as image:
        return image.size
