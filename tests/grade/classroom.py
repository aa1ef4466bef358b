"""A small class for tests of the grader: submissions as students hand them in, and what grading them left."""
import json
import pathlib
import re
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE / "attacks"))
from attack_test import exercise_text, replaced, results_of
from packages import PACKAGES

SECRET = "the tests' secret, not a course's"
HOSTILE = "=cmd|' <img src=x onerror=alert(1)> ;rm"
TIMES = ("seconds", "compile_seconds", "execution_time")


def mistaken(lesson, mutant):
    """The solved exercise with one known mistake of tests/lessons/mutants.toml."""
    with open(ROOT / "tests/lessons/mutants.toml", "rb") as file:
        one = next(one for one in tomllib.load(file)["mutant"] if one["id"] == mutant)
    return replaced(exercise_text(lesson, "solved"), one["find"], one["replace"], mutant)


def make_class(folder):
    """Five submissions of lesson 02 in `folder`, by name."""
    solved = exercise_text(2, "solved")
    texts = {"ada": solved, "bob": mistaken(2, "02-mirror-colour-lost"), "cem": exercise_text(2, "exercise"),
             "dora": solved + "\nthis is no C++\n"}
    folder.mkdir(parents=True)
    for name, text in texts.items():
        PACKAGES["folder"](folder / name, text.encode())
    PACKAGES["zip"](folder / HOSTILE, (solved + "// zipped\n").encode())
    return sorted([*texts, HOSTILE])


def without_times(value):
    """A result as far as it must be the same again."""
    if isinstance(value, dict):
        return {key: without_times(one) for key, one in value.items() if key not in TIMES}
    return [without_times(one) for one in value] if isinstance(value, list) else value


def outputs(out):
    """All files below `out`, by path, without the times in them."""
    found = {}
    for path in sorted(path for path in out.rglob("*") if path.is_file()):
        text = path.read_text()
        if path.name == "results.json":
            text = json.dumps(without_times(json.loads(text)))
        elif path.parent.name == "instructor":
            text = re.sub(r"[\d.]+ in all, [\d.]+ of processor", "", text)
        elif path.name == "junit.xml":
            text = re.sub(r' time="[\d.]+"', "", text)
        found[str(path.relative_to(out))] = text
    return found


def data_of(out):
    """What the grader keeps of each result, by the student's name."""
    return {name: result["extra_data"]["raytree"] for name, (result, _) in results_of(out).items()}
