"""The project's texts and what stands in them, each with its line, for the checks of this folder."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOTES = ROOT / "slides-notes"
LESSONS = sorted(ROOT.glob("lessons/[0-9][0-9]_*"))
# Where readers meet commands and figures.
READ = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(NOTES.glob("*.md")), *(lesson / "README.md" for lesson in LESSONS),
        ROOT / "tests/grade/README.md", ROOT / "tests/grade/recipes/README.md"]
# What the project consists of. Whatever else lies in a user's clone is the user's: a class, marks, a secret, pictures.
FOLDERS = ("common", "lessons", "slides-notes", "tests", "viz")
FILES = ("CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json", "CONTRIBUTING.md", "LICENSE", "README.md", "raytree")
problems = []


def committed():
    """The files that git knows, whoever owns the clone; none without git or where this is no clone."""
    try:
        done = subprocess.run(["git", "-c", "safe.directory=*", "-C", ROOT, "ls-files", "-z"], capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return []
    return done.stdout.split("\0")[:-1]


def name(path):
    return str(path.relative_to(ROOT))


def problem(path, line, sentence):
    problems.append(f"{name(path)}:{line}: {sentence}")


def finish(summary):
    """Prints all problems and what was checked; the exit code says whether there were any."""
    for one in problems:
        print(one, file=sys.stderr)
    print(f"{summary}, {len(problems)} problems")
    sys.exit(bool(problems))


def edits(path):
    """(line number, file, line to replace, new lines) of each C++ block below <!-- instead of LINE in FILE -->: what the reader writes."""
    text = path.read_text()
    for match in re.finditer(r"^<!-- instead of (.+) in (\S+) -->\n(?:<!-- .* -->\n)?```cpp\n(.*?)^```", text, re.M | re.S):
        yield text.count("\n", 0, match.start()) + 1, match[2], match[1], match[3]


def blocks(path):
    """(line number of the first line, language, text) of each fenced block."""
    text = path.read_text()
    for match in re.finditer(r"^```(\w*)\n(.*?)^```", text, re.M | re.S):
        yield text.count("\n", 0, match.start(2)) + 1, match[1], match[2]


def inline_commands(path):
    """(line number, command) of each `./raytree ...` outside of fenced blocks."""
    fenced = False
    for number, line in enumerate(path.read_text().splitlines(), 1):
        fenced ^= line.startswith("```")
        if not fenced:
            for command in re.findall(r"`(\./raytree[^`]*)`", line):
                yield number, command
