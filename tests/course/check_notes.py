#!/usr/bin/env python3
"""What the course promises about its texts: excerpts are the code's, links lead somewhere, every slide has its row, every
lesson its page, every erratum its test, and commands name words, lessons, options and scenes that exist."""
import difflib
import pathlib
import json
import re
import shlex
import sys
import tomllib

import texts as project

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOTES = ROOT / "slides-notes"
LESSONS = sorted(ROOT.glob("lessons/[0-9][0-9]_*"))
problems = []

# The headings of the lecture's slides in their order, and what its three pseudocode slides leave to do. A row of
# slides-notes/README.md may add something in parentheses.
REFLECTIONS, DIELECTRICS, RECURSION, SHADING = "Reflections", "Refraction: Dielectrics", "Recursion", "Shading"
PSEUDOCODE = f"{RECURSION}: Whitted-style Ray Tracing, Pseudocode"
SLIDES = [
    "Welcome!",
    "Today's Agenda: Reflections",
    REFLECTIONS,
    f"{REFLECTIONS}: Light Transport",
    f"{REFLECTIONS}: Reflected Vector",
    f"{REFLECTIONS}: Light Transport",
    f"{REFLECTIONS}: What is the color of a bathroom mirror?",
    f"{REFLECTIONS}: Light Transport",
    REFLECTIONS,
    f"{REFLECTIONS}: Partially Reflective Surfaces",
    f"{REFLECTIONS}: Reflecting a HDR Sky",
    "Today's Agenda: Refraction",
    *[DIELECTRICS] * 6,
    "Today's Agenda: Recursion",
    PSEUDOCODE,
    "Todo: Implement IntersectScene",
    "Todo: Implement IsVisible",
    PSEUDOCODE,
    "Todo: Handle partially reflective surfaces",
    PSEUDOCODE,
    "Todo: Implement reflect",
    "Todo: Implement refract",
    "Todo: Implement Fresnel",
    "Todo: Cap recursion",
    f"{RECURSION}: Spheres: pure specular",
    f"{RECURSION}: Spheres: 50% specular",
    f"{RECURSION}: Spheres: one 50% specular, one glass sphere",
    RECURSION,
    f"{RECURSION}: Ray Tree",
    "Today's Agenda: Shading models",
    f"{SHADING}: Diffuse Material",
    f"{SHADING}: Specular Material",
    SHADING,
    f"{SHADING}: Glossy Material",
    f"{SHADING}: Phong Shading",
    "Today's Agenda: TODO",
    *["TODO: Limitations of Whitted-style"] * 5,
    "Tutorial 2 - Geometry: Exercise 1",
    "Tutorial 2 - Geometry: Exercise 2",
    "Tutorial 2 - Geometry: Exercise 3",
    'END of "Ray Tracing (3)"',
]
NO_LESSON = ("Welcome!", "Today's Agenda", "END of")


def name(path):
    return str(path.relative_to(ROOT))


def texts():
    """All Markdown files of the project, and none that a user has beside them."""
    yield from sorted([ROOT / file for file in project.FILES if file.endswith(".md")]
                      + [path for folder in project.FOLDERS for path in (ROOT / folder).rglob("*.md")])


def prose(text):
    """The text without code, whose brackets are no links."""
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S))


def rows(path):
    """The cells of all rows of the file's tables, heads and rules left out."""
    lines = path.read_text().splitlines() if path.exists() else []
    for number, line in enumerate(lines):
        following = lines[number + 1] if number + 1 < len(lines) else ""
        if line.startswith("|") and not line.startswith("| ---") and not following.startswith("| ---"):
            yield [cell.strip() for cell in line.strip().strip("|").split("|")]


def check_excerpts():
    """A cpp block after <!-- from FILE --> stands in that file. In the notes every cpp block says where it is from."""
    block = re.compile(r"(?:^<!-- from (\S+) -->\s*\n)?^```cpp\n(.*?)^```", re.M | re.S)
    for path in texts():
        for match in block.finditer(path.read_text()):
            source, excerpt = match.groups()
            where = f"{name(path)}:{path.read_text().count(chr(10), 0, match.start()) + 1}"
            if source is None:
                if NOTES in path.parents:
                    problems.append(f"{where}: a cpp block does not say where it is from: {excerpt.splitlines()[0].strip()}")
                continue
            if not (ROOT / source).is_file():
                problems.append(f"{where}: an excerpt is from {source}, which does not exist")
                continue
            code = re.sub(r"^ *// (SOLUTION|END|EXERCISE)\b.*\n", "", (ROOT / source).read_text(), flags=re.M)
            trimmed = lambda text: "\n" + "\n".join(line.rstrip() for line in text.splitlines()) + "\n"
            if trimmed(excerpt) not in trimmed(code):
                problems.append(f"{where}: an excerpt does not stand in {source}: {excerpt.splitlines()[0].strip()}")


def check_links():
    for path in texts():
        for target in re.findall(r"\]\(<?([^)>\s]+)>?(?:\s+\"[^\"]*\")?\)", prose(path.read_text())):
            if re.match(r"[a-z][a-z+.-]*:", target) or target.startswith("#"):
                continue
            place = target.split("#")[0]
            if not (ROOT / place.lstrip("/") if place.startswith("/") else path.parent / place).exists():
                problems.append(f"{name(path)}: a link leads nowhere: {target}")


def check_pictures():
    everything = "".join(path.read_text() for path in texts())
    for picture in sorted((NOTES / "pictures").glob("*.*")):
        if picture.suffix != ".md" and f"pictures/{picture.name}" not in everything:
            problems.append(f"{name(picture)} is not used in any text")


def check_slides():
    """Every slide has its row, in order; the row leads to a lesson, and to functions that exist."""
    table = NOTES / "README.md"
    found = [row for row in rows(table) if len(row) == 3]
    headings = [re.sub(r" \([^()]*\)$", "", row[0]) if row[0] not in SLIDES else row[0] for row in found]
    for operation, i1, i2, j1, j2 in difflib.SequenceMatcher(None, SLIDES, headings, autojunk=False).get_opcodes():
        if operation != "equal":
            problems.extend(f"{name(table)}: no row, or not in its place, for the slide '{slide}'" for slide in SLIDES[i1:i2])
            problems.extend(f"{name(table)}: a row that is no slide's, or not in its place: '{row}'" for row in headings[j1:j2])
    for heading, lesson, where in found:
        if not lesson and not heading.startswith(NO_LESSON) and heading != REFLECTIONS:
            problems.append(f"{name(table)}: the row '{heading}' names no lesson")
        file = None
        for quoted in re.findall(r"`([^`]+)`", where):
            if "/" in quoted:
                file = ROOT / quoted
                if not file.is_file():
                    problems.append(f"{name(table)}: '{heading}' leads to {quoted}, which does not exist")
            elif file and file.is_file() and re.fullmatch(r"\w+", quoted) and not re.search(rf"\b{quoted}\b", file.read_text()):
                problems.append(f"{name(table)}: '{heading}' leads to {quoted} in {name(file)}, which is not there")


def check_lessons():
    """Each lesson has a README, a page of notes, a row in the project's README and one in the table of slides."""
    front, slides = (ROOT / "README.md").read_text(), (NOTES / "README.md").read_text()
    for lesson in LESSONS:
        page = f"{lesson.name.replace('_', '-')}.md"
        if not (lesson / "README.md").is_file():
            problems.append(f"{name(lesson)}/README.md is missing")
        if not (NOTES / page).is_file():
            problems.append(f"slides-notes/{page} is missing")
        description = lesson / "lesson.toml"
        if not description.is_file():
            problems.append(f"{name(description)} is missing")
            continue
        facts = tomllib.loads(description.read_text())
        keys = ["title", "idea", "slides"] + ["scene", "brings"] * ("brings" in facts)
        if list(facts) != keys or any(f"\n{key} = {json.dumps(facts[key], ensure_ascii=False)}\n" not in "\n" + description.read_text() for key in keys):
            problems.append(f"{name(description)}: expected the keys {', '.join(keys)}, each on a line of its own, with strings in \"\"")
            continue
        row = f"| [{lesson.name[:2]} {facts['title']}]({name(lesson)}/README.md) | {facts['idea']} | {facts['slides']} | `./raytree lesson {int(lesson.name[:2])}`"
        if row not in front:
            problems.append(f"README.md has no row {row}")
        if not re.search(rf"^\|.*\]\({re.escape(page)}\)", slides, re.M):
            problems.append(f"slides-notes/README.md has no row for slides-notes/{page}")


def check_questions():
    """Each page of notes ends with questions, numbered, each with an answer to unfold."""
    for path in (NOTES / f"{lesson.name.replace('_', '-')}.md" for lesson in LESSONS):
        text = path.read_text() if path.exists() else ""
        head, heading, part = text.partition("\n## Questions\n")
        questions = list(re.finditer(r"^(\d+)\. (?:.*)\n\n(<details><summary>Answer</summary>\n\n(?:(?!\d+\. ).*\n)*?</details>)?", part, re.M))
        if len(questions) < 3:
            problems.append(f"{name(path)} has {len(questions)} questions; expected 3 at least, under ## Questions")
        for i, one in enumerate(questions, 1):
            line = head.count("\n") + part.count("\n", 0, one.start()) + 3
            if not one[2]:
                problems.append(f"{name(path)}:{line}: question {one[1]} has no answer between <details><summary>Answer</summary> and </details>")
            if int(one[1]) != i:
                problems.append(f"{name(path)}:{line}: this is question {i}, not {one[1]}")


def check_errata():
    """Each erratum names a test that exists, and each test has its erratum."""
    errata, tests = NOTES / "errata.md", ROOT / "tests/lessons/errata_test.cpp"
    existing = set(re.findall(r"^TEST\(Errata, (\w+)\)", tests.read_text(), re.M)) if tests.exists() else set()
    named = set()
    for row in rows(errata):
        test = re.fullmatch(r"`Errata\.(\w+)`", row[-1])
        if not test:
            problems.append(f"{name(errata)}: an erratum names no test: {row[0]}, {row[1]}")
        elif test[1] not in existing:
            problems.append(f"{name(errata)}: Errata.{test[1]} is not in {name(tests)}")
        else:
            named.add(test[1])
    if not named:
        problems.append(f"{name(errata)} has no errata")
    problems.extend(f"{name(errata)} has no row for Errata.{test}" for test in sorted(existing - named))


def known_words():
    """The words of ./raytree: the labels of its `case "$word"`."""
    script = (ROOT / "raytree").read_text()
    cases = script.split('case "$word" in')[-1]
    return {word for labels in re.findall(r"^    ([\w| -]+)\)", cases, re.M) for word in re.split(r"[ |]+", labels) if word}


def known_options():
    files = [ROOT / "raytree"] + [p for folder in ("common", "lessons", "viz") for p in (ROOT / folder).rglob("*.cpp")]
    files += [*(ROOT / "tests/grade").rglob("*_main.cpp"), *(ROOT / "tests/learn").glob("*_main.cpp")]  # programs, unlike the tests beside them
    files += (ROOT / "tests/perf").glob("*.py")
    return {option for file in files for option in re.findall(r"--[a-z][a-z0-9-]*", file.read_text())}


def check_command(where, line, words, options):
    """One command line: a known word, then perhaps a lesson's number, options and scene files that exist."""
    try:
        arguments = shlex.split(line, comments=True)[1:]
    except ValueError as error:
        problems.append(f"{where}: {error}: {line}")
        return
    if not arguments:
        return
    word, rest = arguments[0], arguments[1:]
    if word not in words:
        problems.append(f"{where}: ./raytree has no word '{word}': {line}")
    if word in ("lesson", "exercise"):
        number = rest[0] if rest else ""
        folders = [lesson for lesson in LESSONS if number.isdigit() and lesson.name.startswith(f"{int(number):02}_")]
        if not folders:
            problems.append(f"{where}: there is no lesson '{number}': {line}")
        elif word == "exercise" and not (folders[0] / "exercise.h").is_file():
            problems.append(f"{where}: lesson {number} has no exercise: {line}")
    for argument in rest:
        if argument.startswith("--") and argument.split("=")[0] not in options:
            problems.append(f"{where}: there is no option {argument}: {line}")
        if argument.endswith(".toml") and not (ROOT / argument).is_file():
            problems.append(f"{where}: there is no scene {argument}: {line}")


def check_commands():
    words, options = known_words(), known_options()
    files = [ROOT / "README.md", *(lesson / "README.md" for lesson in LESSONS), *sorted(NOTES.glob("*.md"))]
    for path in (file for file in files if file.is_file()):
        text = path.read_text()
        blocks = re.findall(r"^```sh\n(.*?)^```", text, re.M | re.S)
        lines = [line for block in blocks for line in block.splitlines() if line.startswith("./raytree")]
        for line in lines + re.findall(r"`(\./raytree[^`\n]*)`", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)):
            check_command(name(path), line, words, options)


for check in (check_excerpts, check_links, check_pictures, check_slides, check_lessons, check_questions, check_errata, check_commands):
    check()
for problem in problems:
    print(problem, file=sys.stderr)
print(f"{len(SLIDES)} slides, {len(LESSONS)} lessons, {sum(1 for _ in texts())} texts checked, {len(problems)} problems")
sys.exit(bool(problems))
