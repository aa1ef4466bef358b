#!/usr/bin/env python3
"""Every row of lessons/exercises.toml is complete, and the exercises are as the rows say: a TODO with the row's title and
points in exercise.h, in the manifest's order; a solution in the lesson; cases and points. Whether an exercise is unsolved as
shipped and solved by its lesson, tests/lessons/exercises_test.cpp and the cases of the solved exercises ask by running them;
here it is asked of the text: no line of a solution may stand in the TODO's place."""
import re
import tomllib

from texts import LESSONS, ROOT, finish, name, problem

MANIFEST = ROOT / "lessons/exercises.toml"
FIELDS = {"id": str, "lesson": int, "points": int, "title": str, "slide": str, "cases": list, "hint": str}
MOST_POINTS = 10  # for one exercise: a slip of the pen otherwise


def case_groups():
    """Names of the groups of all cases."""
    text = "".join(path.read_text() for path in ROOT.glob("tests/cases/*cases*.cpp"))
    return set(re.findall(r'\{"([A-Z]\w*)",\s*"[A-Z]\w*",', text))


def line_of(row):
    """Where the row with this id begins."""
    lines = MANIFEST.read_text().splitlines()
    return next((i for i, line in enumerate(lines, 1) if line == f'id = "{row.get("id")}"'), 1)


def check_row(row, groups, seen):
    where = line_of(row)
    for field, kind in FIELDS.items():
        if not isinstance(row.get(field), kind) or row[field] in ("", [], 0) and field != "lesson":
            problem(MANIFEST, where, f"the exercise {row.get('id')} has no {field}")
            return
    for field in row.keys() - FIELDS.keys():
        problem(MANIFEST, where, f"the exercise {row['id']} has a field '{field}' that nobody reads")
    if row["id"] in seen:
        problem(MANIFEST, where, f"there are two exercises {row['id']}")
    if not re.fullmatch(rf"{row['lesson']:02}-[a-z0-9-]+", row["id"]):
        problem(MANIFEST, where, f"the id {row['id']} does not begin with the lesson's number {row['lesson']:02}")
    if not 1 <= row["points"] <= MOST_POINTS:
        problem(MANIFEST, where, f"the exercise {row['id']} has {row['points']} points; expected 1 to {MOST_POINTS}")
    for group in (part for cases in row["cases"] for part in cases.split(" + ")):
        if group not in groups:
            problem(MANIFEST, where, f"the exercise {row['id']} names the cases {group}; there is no such group")


def solutions(lesson):
    """id -> lines of the solution, of the lesson's own text and of the core headers that it borrows from."""
    files = [lesson / "trace.h", lesson / "geometry.h", ROOT / "common/base/shapes.h", ROOT / "common/scene/sky.h"]
    text = "".join(file.read_text() for file in files if file.exists())
    found = re.findall(r"^ *// SOLUTION (\S+)\n(.*?)^ *// END\n", text, re.M | re.S)
    return {which: [line.strip() for line in body.splitlines()] for which, body in found}


def check_lesson(lesson, rows):
    exercise = lesson / "exercise.h"
    if not exercise.exists():
        for row in rows:
            problem(MANIFEST, line_of(row), f"the exercise {row['id']} belongs to {name(lesson)}, which has no exercise.h")
        return
    lines = exercise.read_text().splitlines()
    solved = solutions(lesson)
    todos = {match[1]: (i, match[2], match[3]) for i, line in enumerate(lines)
             if (match := re.fullmatch(r" *// TODO (\S+) \((\d+) points?\): (.*)", line))}
    for row in rows:
        if row["id"] not in solved:
            problem(MANIFEST, line_of(row), f"nothing in {name(lesson)} is marked // SOLUTION {row['id']}: no lesson solves the exercise")
        if row["id"] not in todos:
            problem(exercise, 1, f"there is no TODO for {row['id']}")
            continue
        at, points, title = todos[row["id"]]
        if (points, title) != (str(row["points"]), row["title"]):
            problem(exercise, at + 1, f"the TODO says {points} points and \"{title}\"; the manifest {row['points']} and \"{row['title']}\"")
        after = lines[at + 2].strip() if at + 2 < len(lines) else ""
        if after != f'todo("{row["id"]}");':
            problem(exercise, at + 3, f"expected todo(\"{row['id']}\"); got: {after}")
        place = " ".join(lines[at:at + 4])
        for line in solved.get(row["id"], []):
            if len(line) > 12 and line in place:
                problem(exercise, at + 1, f"the solution of {row['id']} is left in the exercise: {line}")
    for which, (at, _, _) in todos.items():
        if which not in {row["id"] for row in rows}:
            problem(exercise, at + 1, f"the TODO {which} has no row in {name(MANIFEST)}")


with open(MANIFEST, "rb") as file:
    exercises = tomllib.load(file)["exercise"]
groups, seen = case_groups(), set()
for row in exercises:
    check_row(row, groups, seen)
    seen.add(row.get("id"))
if [row["lesson"] for row in exercises] != sorted(row["lesson"] for row in exercises):
    problem(MANIFEST, 1, "the exercises are not in the order of the lessons")
for lesson in LESSONS:
    check_lesson(lesson, [row for row in exercises if row.get("lesson") == int(lesson.name[:2])])
finish(f"{len(exercises)} exercises of {sum(row['points'] for row in exercises)} points checked")
