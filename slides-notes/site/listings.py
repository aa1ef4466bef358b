"""Code: coloured, and which of its lines are new against the lesson before."""
import difflib
import functools
import html
import re

import pygments
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name, get_lexer_for_filename
from pygments.util import ClassNotFound

from course import ROOT, lessons

MARK = re.compile(r"^ *// (SOLUTION|END|EXERCISE)\b")
FOLD = 8   # unchanged lines in a row that are folded away
MARGIN = 2  # of them stay on either side


def lexer(name):
    """By language ("cpp") or by file name."""
    try:
        return get_lexer_for_filename(name) if "." in name else get_lexer_by_name(name)
    except ClassNotFound:
        return get_lexer_by_name("text")


def coloured(code, language):
    """A piece of HTML for each line."""
    text = pygments.highlight(code, lexer("x.cpp" if language.endswith(".h") else language), HtmlFormatter(nowrap=True, classprefix="k-"))
    found = text.rstrip("\n").split("\n")
    return found + [""] * (len(code.rstrip("\n").split("\n")) - len(found))


def lines_of(path):
    """(number, text) of each line, without the marks for the exercises."""
    return [(n, line) for n, line in enumerate(path.read_text().splitlines(), 1) if not MARK.match(line)]


def compared(path):
    """The lines as they are compared: the lesson's own number says nothing new."""
    return [re.sub(r"lesson\d\d", "lessonNN", re.sub(r"^// Lesson .*", "// Lesson", line)) for _, line in lines_of(path)]


def added(old, new):
    """(places of the lines that only `new` has, how many lines with words only `old` has)."""
    places, gone = [], 0
    for operation, i1, i2, j1, j2 in difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        # Where both say the same, a function ends with its own last lines instead of those of the one before it.
        while operation == "insert" and j2 < len(new) and new[j1] == new[j2]:
            j1, j2 = j1 + 1, j2 + 1
        if operation != "equal":
            places += range(j1, j2)
            gone += sum(1 for line in old[i1:i2] if line.strip())
    return places, gone


@functools.cache
def new_lines(lesson):
    """(numbers of the lines that the lesson before has not, how many of its lines are gone)."""
    if not lesson.before:
        return frozenset(), 0
    new, numbers = compared(lesson.source), [n for n, _ in lines_of(lesson.source)]
    places, gone = added(compared(lesson.before.source), new)
    return frozenset(numbers[j] for j in places if new[j].strip()), gone


def find(path, excerpt):
    """The numbers of the excerpt's lines in the file; empty if it does not stand there."""
    numbered = lines_of(path)
    wanted, have = [line.rstrip() for line in excerpt.rstrip("\n").split("\n")], [line.rstrip() for _, line in numbered]
    for at in range(len(have) - len(wanted) + 1):
        if have[at:at + len(wanted)] == wanted:
            return [n for n, _ in numbered[at:at + len(wanted)]]
    return []


def lesson_of(path):
    return next((lesson for lesson in lessons() if lesson.source == path), None)


def row(number, text, new, shown_number=True, anchor=False):
    classes = "line new" if new else "line"
    label = f' id="L{number}"' if anchor else ""
    said = '<span class="hidden">new: </span>' if new else ""
    gutter = f'<span class="n" data-n="{number}"></span>' if shown_number else ""
    return f'<span class="{classes}"{label}>{gutter}{said}{text}\n</span>'


def block(rows, label):
    return f'<pre class="code scrolls" aria-label="{html.escape(label)}" role="group"><code>{"".join(rows)}</code></pre>'


def excerpt(path, text, caption):
    """An excerpt of a file, its new lines marked if the file is a lesson's; caption is HTML."""
    numbers, lesson = find(path, text), lesson_of(path)
    new = new_lines(lesson)[0] if lesson else frozenset()
    name = path.relative_to(ROOT)
    dedent = min((len(line) - len(line.lstrip()) for line in text.splitlines() if line.strip()), default=0)
    pieces = coloured("\n".join(line[dedent:] for line in text.rstrip("\n").split("\n")) + "\n", path.name)
    rows = [row(n, piece, n in new) for n, piece in zip(numbers or range(1, len(pieces) + 1), pieces)]
    return f'<figure class="listing">{block(rows, f"Excerpt of {name}")}<figcaption>{caption}</figcaption></figure>'


def whole_file(path):
    """All of a file, every line with an anchor, the new ones marked."""
    lesson = lesson_of(path)
    new = new_lines(lesson)[0] if lesson else frozenset()
    return block([row(n, piece, n in new, anchor=True) for n, piece in enumerate(coloured(path.read_text(), path.name), 1)],
                 str(path.relative_to(ROOT)))


def lesson_listing(lesson, caption):
    """The lesson's source; what it shares with the lesson before is folded where it is long."""
    new = new_lines(lesson)[0]
    pieces = coloured(lesson.source.read_text(), lesson.source.name)
    rows = [(n, pieces[n - 1]) for n, _ in lines_of(lesson.source)]
    parts, run = [], []

    def flush(first, last):
        """The unchanged lines that were collected, folded in their middle."""
        before, after = 0 if first else MARGIN, 0 if last else MARGIN
        hidden = run[before:len(run) - after]
        shown = [row(n, piece, False) for n, piece in run]
        if not new or len(hidden) < FOLD:
            parts.extend(shown)
        else:
            end = before + len(hidden)
            parts.extend(shown[:before])
            parts.append(f'<details class="fold"><summary>{len(hidden)} lines as before</summary>{"".join(shown[before:end])}</details>')
            parts.extend(shown[end:])
        run.clear()

    for n, piece in rows:
        if n in new:
            flush(not parts, False)
            parts.append(row(n, piece, True))
        else:
            run.append((n, piece))
    flush(not parts, True)
    name = lesson.source.relative_to(ROOT)
    # A details element may not stand in a pre.
    listing = f'<div class="code scrolls" role="group" aria-label="{name}"><code>{"".join(parts)}</code></div>'
    return f'<figure class="listing">{listing}<figcaption>{caption}</figcaption></figure>'
