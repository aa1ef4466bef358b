#!/usr/bin/env python3
"""What the course promises about its own sources: who includes whom, small steps from lesson to lesson, no epsilon."""
import difflib
import pathlib
import re
import sys
import tomllib

import texts

ROOT = pathlib.Path(__file__).resolve().parents[2]
LESSONS = sorted(ROOT.glob("lessons/[0-9][0-9]_*"))
problems = []


def sources(folder):
    return sorted(p for ending in ("h", "cpp") for p in (ROOT / folder).rglob(f"*.{ending}"))


def source(lesson):
    """The text that the lesson is about: lesson 00 traces nothing, lesson 09 has a reference beside lesson 08's trace."""
    return lesson / {"00": "geometry.h", "09": "reference.h"}.get(lesson.name[:2], "trace.h")


def includes(path):
    return re.findall(r'^#include ["<]([^">]+)[">]', path.read_text(), re.M)


# Who may include whom: each room those before it. A folder that is not named here has no place yet.
ROOMS = ["common/base", "common/search", "common/scene", "common/files", "common/tree", "common/program", "common", "lessons",
         "viz/base", "viz/state", "viz/drawing", "viz/html", "viz/export", "viz/window"]
CORE = ROOMS[:3]  # headers that a browser or a grader's box compiles, too


def room(path):
    """common/scene/scene.h -> common/scene; lessons are one room."""
    folder = str(pathlib.PurePath(path).parent)
    return "lessons" if folder.startswith("lessons") else folder


def check_arrows():
    """Arrows between rooms run one way. Core headers need glm and the standard library; only viz/ needs VTK; nothing needs tests/;
    a lesson only lesson.h."""
    for top in ("common", "lessons", "viz"):
        for path in sources(top):
            where = path.relative_to(ROOT)
            if room(where) not in ROOMS:
                problems.append(f"{where} is in no room: expected one of {', '.join(ROOMS)}")
                continue
            for include in includes(path):
                target = room(include)
                if target in ROOMS and ROOMS.index(target) > ROOMS.index(room(where)):
                    problems.append(f"{where} includes {include}: {target} stands above {room(where)}")
                if room(where) in CORE and path.suffix == ".h" and target not in ROOMS and not include.startswith("glm/") and "." in include:
                    problems.append(f"{where} includes {include}: the core needs glm and the standard library only")
    only = {"vtk": ["viz"], "OpenImageIO/": ["common/files/openimageio.cpp"], "tbb/": ["common/base/parallel.cpp"],
            "toml++/": ["common/files/scene_file.cpp", "common/files/scene_reader.h", "common/files/scene_writer.cpp"],
            "nlohmann/": ["common/tree/ray_tree_json.cpp", "common/tree/ray_tree_from_json.cpp", "viz"], "CLI/": ["common/program/command_line.cpp"],
            "lessons/": ["lessons", "viz", "tests"], "viz/": ["viz", "tests/viz", "tests/perf"], "tests/": ["tests"]}
    for folder in ("common", "lessons", "viz", "tests"):
        for path in sources(folder):
            for include in includes(path):
                where = str(path.relative_to(ROOT))
                for library, places in only.items():
                    if include.startswith(library) and not any(where.startswith(p) for p in places + ["tests"] * (library not in ("viz/",))):
                        problems.append(f"{where} includes {include}: only {', '.join(places)} may")
    for lesson in LESSONS:
        for include in includes(source(lesson)):
            if include != "common/scene/lesson.h" and "." in include:
                problems.append(f"{source(lesson).relative_to(ROOT)} includes {include}: a lesson needs common/scene/lesson.h only")


def plain(lesson):
    """The lesson's text without marks for the exercise and without its number."""
    text = (lesson / "trace.h").read_text()
    text = re.sub(r"^ *// (SOLUTION|END|EXERCISE).*\n", "", text, flags=re.M)
    text = re.sub(r"^// Lesson .*\n", "", text)
    return re.sub(r"lesson\d\d", "lessonNN", text)


def functions(text):
    """Name -> text of each member function, the comment above it not included."""
    found = re.findall(r"^    ((?:static )?[\w:<>& ]+ (\w+)\([^;{]*\)(?: const)?\n    \{\n(?:.*\n)*?    \}\n)", text, re.M)
    return {name: body for body, name in found}


def check_small_steps():
    """Neighbouring lessons differ by at most 40 lines; a function of the same name has the same text, unless the later
    lesson's README says "changes `name`"."""
    tracing = [lesson for lesson in LESSONS if (lesson / "trace.h").exists()]
    for after in tracing[1:]:
        # Lesson 10 is a study with a tracer of its own, without an entry: none builds on it.
        before = [one for one in tracing if one < after and "brings" in (one / "lesson.toml").read_text()][-1]
        a, b = plain(before), plain(after)
        changed = [line for line in difflib.ndiff(a.splitlines(), b.splitlines()) if line[0] in "+-" and line[2:].strip()]
        if len(changed) > 40:
            problems.append(f"{after.name}/trace.h differs from {before.name} by {len(changed)} lines, at most 40 may")
        earlier, later = functions(a), functions(b)
        if "trace" not in later:
            problems.append(f"{after.name}/trace.h: no function trace was found")
        readme = (after / "README.md").read_text() if (after / "README.md").exists() else ""
        for name in sorted(earlier.keys() & later.keys()):
            if earlier[name] != later[name] and f"changes `{name}`" not in readme:
                problems.append(f"{after.name}/README.md does not say that the lesson changes `{name}`")


# Constants that look like an epsilon and are none: file -> why. No ray ever meets one of them.
NOT_TRACING = {
    "common/base/image.cpp": "where the straight part of sRGB's curve ends",
    "lessons/09_limitations/reference.h": "53 random bits become a fraction",
    "common/tree/tree_diff.h": "tolerances of a comparison of two finished trees",
    "common/tree/tree_diff.cpp": "tolerances of a comparison of two finished trees",
    "common/tree/tree_pairing.cpp": "which branches of two finished trees belong together",
}


def check_no_epsilon():
    """No 1e-4, 0.001 or 0x1p-20 in the core or in a lesson's text. Rounding bounds are multiples of numeric_limits::epsilon,
    and DESIGN.md lists them."""
    constant = re.compile(r"(?<![\w.])(\d+(\.\d*)?e-\d+|\.\d+e-\d+|0?\.00+\d+|0x[\da-f.]+p-\d+)[fFL]?\b", re.I)
    found = set()
    for path in sources("common") + [source(lesson) for lesson in LESSONS if "10_" not in lesson.name]:
        name = str(path.relative_to(ROOT))
        for number, line in enumerate(path.read_text().splitlines(), 1):
            code = re.sub(r'"[^"]*"', '""', line).split("//")[0]
            if constant.search(code):
                found.add(name)
                if name not in NOT_TRACING:
                    problems.append(f"{name}:{number}: a constant like an epsilon: {code.strip()}")
    for name in sorted(NOT_TRACING.keys() - found):
        problems.append(f"{name} is allowed a constant like an epsilon and has none: take it off the list")


def check_lessons_are_complete():
    for lesson in LESSONS:
        scenes = source(lesson).name != "geometry.h"
        made = "brings" in (lesson / "lesson.toml").read_text()  # its main, too
        for name in ("README.md", source(lesson).name) + ("main.cpp",) * (not made) + ("scenes",) * scenes:
            if not (lesson / name).exists():
                problems.append(f"{lesson.name}/{name} is missing")
        if scenes and len(list(lesson.glob("scenes/*.toml"))) < 2:
            problems.append(f"{lesson.name} has fewer than two scenes")


def check_cases_belong_to_exercises():
    """Each group of a lesson's own cases (but Picture) is about an exercise, and exercises name no others. "A + B" is two."""
    groups = {}
    for path in [ROOT / "tests/cases/lesson00_cases.cpp", *sorted(ROOT.glob("tests/cases/cases_*.cpp"))]:
        text = path.read_text()
        lesson = 0 if path.stem == "lesson00_cases" else int((re.match(r"// Lesson (\d\d)\b", text) or [0, -1])[1])
        if lesson < 0:
            problems.append(f"tests/lessons/{path.name}:1: expected a first line like // Lesson 08: what its cases are about")
            continue
        groups[lesson] = set(re.findall(r'\{"([A-Z]\w*)",\s*"[A-Z]\w*",', text)) - {"Picture"}
    with open(ROOT / "lessons/exercises.toml", "rb") as file:
        exercises = tomllib.load(file)["exercise"]
    for lesson, own in groups.items():
        named = {group for e in exercises if e["lesson"] == lesson for cases in e["cases"] for group in cases.split(" + ")}
        if not own or own != named:
            problems.append(f"lessons/exercises.toml: the cases of lesson {lesson:02} are of the groups {sorted(own)}, "
                            f"its exercises name {sorted(named)}")


# Programs without a guard: file -> why. A student's process in the box (*.student.cpp) must end as its code ends it: the grader
# tells of its death.
UNGUARDED = {"tests/grade/box/launch_main.cpp": "it calls C only, and becomes another program"}


def check_mains():
    """No program ends by an uncaught exception: all that a main does is to return what common/program/guarded_main.h guards."""
    guarded = re.compile(r"int main\(int(?: argc)?, char\*\* argv\)\n\{\n(?:    using namespace [\w:]+;\n)*    return (?:rt::)?guarded\(\s*argv, .*?\);\n\}\n", re.S)
    unguarded = set()
    for path in sorted(p for folder in ("common", "lessons", "viz", "tests", "slides-notes") for p in sources(folder) + list((ROOT / folder).rglob("*.cpp.in"))):
        name, text = str(path.relative_to(ROOT)), path.read_text()
        for start in re.finditer(r"^(?:int|auto|void) main\b", text, re.M):
            if path.name.endswith(".student.cpp") or guarded.match(text, start.start()):
                continue
            unguarded.add(name)
            if name not in UNGUARDED:
                line = text[:start.start()].count("\n") + 1
                problems.append(f"{name}:{line}: main may end by an uncaught exception, expected: return rt::guarded(argv, [&] {{ ... }});")
    for name in sorted(UNGUARDED.keys() - unguarded):
        problems.append(f"{name} is allowed a main without a guard and has none: take it off the list")


PATIENCE = 300  # seconds; a bound of that many says "it hangs" and nothing of speed
# Comparisons with fewer seconds that say nothing of speed: file -> why.
OF_LIMITS = {"tests/grade/box/child_test.cpp": "processor time under a limit of one second"}


def check_no_seconds():
    """No test asserts how fast something is: on a slow or busy machine it would fail. Bounds against hanging are large."""
    compared = [re.compile(r"(?:EXPECT|ASSERT)_L[TE]\(.*(?:[sS]econds|steady_clock|elapsed|[tT]ook)\b.*?, *([\d.]+)\)"),
                re.compile(r"assertLess(?:Equal)?\(time\.\w+\(\) - \w+, *([\d.]+)"),
                re.compile(r"(?:check|expect|assert\w*)\(.*time\.(?:time|monotonic|perf_counter)\(\) - \w+ <=? *([\d.]+)"),
                re.compile(r"\b(?:timeout|seconds)=([\d.]+)\b"), re.compile(r"^(?:PATIENCE|SECONDS) = ([\d.]+)"), re.compile(r"\bwait_for\(([\d.]+)s\)")]
    found = set()
    for path in sorted(path for ending in ("cpp", "h", "py") for path in (ROOT / "tests").rglob(f"*.{ending}")):
        name = str(path.relative_to(ROOT))
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if any(float(match[1]) < PATIENCE for pattern in compared for match in pattern.finditer(line)):
                found.add(name)
                if name not in OF_LIMITS:
                    problems.append(f"{name}:{number}: a bound of seconds, expected at least {PATIENCE} or a comparison with another time: {line.strip()}")
    for name in sorted(OF_LIMITS.keys() - found):
        problems.append(f"{name} is allowed bounds of seconds and has none: take it off the list")


def check_folders():
    """Nothing at the top but what a newcomer is told of. Without git nobody knows which files are the project's."""
    tops = {path.split("/")[0] + "/" * ("/" in path) for path in texts.committed() if not path.startswith(".")}
    for top in sorted(tops - set(texts.FILES) - {folder + "/" for folder in texts.FOLDERS}):
        problems.append(f"{top} is committed: expected {', '.join(texts.FOLDERS)} and the files in tests/course/texts.py only")


def types_of(text):
    """(namespace, name) of the types that a file defines for the whole program: not those within {} of others, nor unnamed ones."""
    spaces, found = [], []
    for line in text.splitlines():
        if opened := re.match(r"(?:inline )?namespace ?([\w:]*)", line):
            spaces.append(opened[1] or "(unnamed)")
        elif line.startswith("} // namespace"):
            spaces.pop()
        elif defined := re.match(r"(?:struct|class|enum(?: class)?|union) (?:alignas\(\w+\) )?(\w+)(?! ?;)(?: final)?(?: : .*)?$", line):
            if "(unnamed)" not in spaces:
                found.append(("::".join(spaces), defined[1]))
    return found


def check_one_name_one_type():
    """Two types of one name would be one to the linker, which takes any of the two destructors: it saw class runs of schools and of
    questions. Programs of their own, as students' and widgets', may say the same name."""
    places = {}
    for folder in ("common", "lessons", "viz", "tests"):
        for path in sources(folder):
            for name in types_of(path.read_text()):
                places.setdefault(name, set()).add(str(path.relative_to(ROOT)))
    for (space, name), where in sorted(places.items()):
        if len(where) > 1:
            problems.append(f"{space}::{name} is defined in {', '.join(sorted(where))}: expected one type of that name")


for check in (check_one_name_one_type, check_folders, check_mains, check_no_seconds, check_arrows, check_small_steps, check_no_epsilon, check_lessons_are_complete, check_cases_belong_to_exercises):
    check()
for problem in problems:
    print(problem, file=sys.stderr)
print(f"{len(LESSONS)} lessons checked, {len(problems)} problems")
sys.exit(bool(problems))
