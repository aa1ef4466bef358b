"""What the course consists of: lessons, exercises, slides. Read from the repository, never kept by hand."""
import functools
import pathlib
import re
import tomllib
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOTES = ROOT / "slides-notes"


class SiteError(Exception):
    """One sentence for the user."""


@dataclass(frozen=True)
class Lesson:
    number: str  # "06"
    title: str   # "Fresnel"
    idea: str    # Markdown
    slides: str
    folder: pathlib.Path
    scene: str | None = None # its first, if it has a tracer

    @property
    def notes(self):
        return NOTES / f"{self.folder.name.replace('_', '-')}.md"

    @property
    def page(self):
        return f"{self.folder.name.replace('_', '-')}.html"

    @property
    def source(self):
        """The text that the lesson is about: lesson 00 traces nothing, lesson 09 has a reference beside lesson 08's trace."""
        return self.folder / {"00": "geometry.h", "09": "reference.h"}.get(self.number, "trace.h")

    @property
    def before(self):
        """The lesson whose trace.h this one changes, or None."""
        tracing = [lesson for lesson in lessons() if lesson.source.name == "trace.h"]
        place = tracing.index(self) if self in tracing else 0
        return tracing[place - 1] if place else None

    @property
    def scenes(self):
        return sorted((self.folder / "scenes").glob("*.toml"))

    def chosen(self, scene=None):
        """(scene, x, y): the scene, by default the lesson's first, and its pixel worth clicking."""
        scene = scene or first_scene(self)
        camera = tomllib.loads(scene.read_text()).get("camera", {})
        width, height = camera.get("size", [640, 480])
        return scene, *camera.get("pixel", [width // 2, height // 2])


@functools.cache
def lessons():
    """In order, as lessons/*/lesson.toml describe them."""
    found = [(path.parent, tomllib.loads(path.read_text())) for path in sorted(ROOT.glob("lessons/[0-9][0-9]_*/lesson.toml"))]
    return [Lesson(folder.name[:2], facts["title"][0].upper() + facts["title"][1:], facts["idea"], facts["slides"], folder,
                   facts.get("scene")) for folder, facts in found]


def lesson(number):
    for candidate in lessons():
        if candidate.number == f"{int(number):02}":
            return candidate
    raise SiteError(f"there is no lesson {number}")


def first_scene(wanted):
    """The scene that a lesson's program takes by default."""
    if wanted.scene:
        return wanted.folder / "scenes" / wanted.scene
    if not wanted.scenes:
        raise SiteError(f"lesson {wanted.number} has no scene")
    return wanted.scenes[0]


@functools.cache
def exercises():
    return tomllib.loads((ROOT / "lessons/exercises.toml").read_text())["exercise"]


def section(markdown, heading):
    """The text under a heading of the second level, without the heading; empty if there is none."""
    found = re.search(rf"^## {re.escape(heading)}[^\n]*\n(.*?)(?=^## |\Z)", markdown, re.M | re.S)
    return found[1].strip() if found else ""
