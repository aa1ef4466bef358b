"""Which pages there are and how they are called, in the order of reading."""
import re
from dataclasses import dataclass
from pathlib import Path

from course import NOTES, ROOT, SiteError, lessons


@dataclass
class Page:
    address: str   # in the site
    name: str      # in the navigation
    kind: str      # lesson, text, home, speed, schema, api, source
    source: Path = None
    number: str = ""

    @property
    def full_name(self):
        return f"{self.number} {self.name}".strip()


# Notes that are known: file -> (name, group). All others come under "More", by their own headings.
BEGIN, LESSONS, REFERENCE, MEASURED, TEACHING, MORE = "Begin", "Lessons", "Look up", "Measured", "Teach", "More"
KNOWN = {"first-hour.md": ("First hour", BEGIN), "README.md": ("From slides to code", REFERENCE), "glossary.md": ("Glossary", REFERENCE),
         "errata.md": ("Errata of the slides", REFERENCE), "benchmark.md": ("Benchmark", MEASURED),
         "teach-with-this.md": ("Teach with this", TEACHING)}
ADDRESSES = {"README.md": "slides.html"}
SPEED = "speed-and-accuracy.html"


def title_of(path):
    found = re.search(r"^# (.+)$", path.read_text(), re.M)
    return found[1] if found else path.stem


def navigation(api):
    """[(group, [Page])]; api: whether there are pages of the programming interface."""
    groups = {name: [] for name in (BEGIN, LESSONS, REFERENCE, MEASURED, TEACHING, MORE)}
    groups[BEGIN].append(Page("index.html", "Start", "home", NOTES / "site/home.md"))
    for lesson in lessons():
        if not lesson.notes.is_file():
            raise SiteError(f"lesson {lesson.number} has no notes: {lesson.notes.name} is missing")
        groups[LESSONS].append(Page(lesson.page, lesson.title, "lesson", lesson.notes, lesson.number))
    named = {lesson.notes for lesson in lessons()}
    files = [NOTES / name for name in KNOWN if (NOTES / name).is_file()]
    for path in files + [path for path in sorted(NOTES.glob("*.md")) if path not in files and path not in named]:
        name, group = KNOWN.get(path.name, (title_of(path), MORE))
        groups[group].append(Page(ADDRESSES.get(path.name, f"{path.stem}.html"), name, "text", path))
    groups[REFERENCE].append(Page("scenes.html", "Scene files", "text", ROOT / "common/SCENES.md"))
    groups[REFERENCE].append(Page("ray-tree-json.html", "RayTree JSON", "schema", ROOT / "common/tree/ray_tree.schema.json"))
    if api:
        groups[REFERENCE].append(Page("api/index.html", "Functions of common/", "api"))
    groups[MEASURED].insert(0, Page(SPEED, "Lesson 10, measured", "speed", NOTES / "10-speed-and-accuracy.md"))
    groups[TEACHING].append(Page("grading.html", "Grading", "text", ROOT / "tests/grade/README.md"))
    groups[TEACHING].append(Page("design.html", "Why it is as it is", "text", ROOT / "common/DESIGN.md"))
    return [(group, pages) for group, pages in groups.items() if pages]
