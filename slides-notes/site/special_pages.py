"""How a page of each kind comes about. Every maker returns (title, HTML, headings)."""
import html
import json
import re

import listings
from course import NOTES, ROOT, exercises, lesson, lessons
from page_context import Context
from schema_reference import reference
from site_pages import SPEED, title_of

TABLES = re.compile(r"<!-- begin tables -->\n(.*?)<!-- end tables -->", re.S)


def without_title(text):
    return re.sub(r"\A# [^\n]*\n", "", text)


def text_page(site, page):
    context = Context(site, page)
    text = page.source.read_text()
    title = title_of(page.source)
    body = f"<h1>{context.inline(title)}</h1>\n" + context.render(without_title(text))
    return title.replace("`", ""), body, context.headings


def lesson_page(site, page):
    """The notes, with the exercise as the lesson's README has it and then the lesson's source before the questions."""
    one = next(lesson for lesson in lessons() if lesson.notes == page.source)
    context, text = Context(site, page), without_title(page.source.read_text())
    text = TABLES.sub("", text)
    name = one.source.name
    parts = f"## Exercise\n\n<!-- exercises: {one.number} -->\n\n## All of `{name}`\n\n<!-- listing: {one.number} -->\n\n"
    if re.search(r"^## Exercise\n", text, re.M):
        text = re.sub(r"^## Exercise\n.*?(?=^## |\Z)", parts, text, flags=re.M | re.S)
    else:
        text = re.sub(r"^## Questions", lambda match: parts + match[0], text, flags=re.M)
    if one.number == "10":
        text = re.sub(r"^## The tables\n.*?(?=^## )", f"## The tables\n\nAll that was measured: [speed and accuracy, measured](#tables).\n\n", text, flags=re.M | re.S)
    points = sum(entry["points"] for entry in exercises() if entry["lesson"] == int(one.number))
    run = f"./raytree lesson {int(one.number)}"
    facts = [("New idea", context.inline(one.idea)), ("Slides", html.escape(one.slides)), ("Run it", f"<code>{run}</code>")]
    if points:
        facts.append(("Write it", f'<code>./raytree exercise {int(one.number)}</code> · {points} points'))
    rows = "".join(f"<div><dt>{term}</dt><dd>{words}</dd></div>" for term, words in facts)
    head = f'<header class="lesson-head"><p class="eyebrow">Lesson {one.number}</p><h1>{html.escape(one.title)}</h1><dl class="facts">{rows}</dl></header>\n'
    body = context.render(text).replace('href="#tables"', f'href="{SPEED}"')
    return f"{one.number} {one.title}", head + body, context.headings


def speed_page(site, page):
    """The measurements of lesson 10: the front as a plot, what it says, and all tables."""
    context, text = Context(site, page), page.source.read_text()
    tables = TABLES.search(text)
    says = re.search(r"^## What the front says\n(.*?)(?=^## )", text, re.M | re.S)
    intro = (f"What each approximation costs and buys, measured. [Lesson 10]({page.source.name}) shows the poor choices as pictures; "
             "`./raytree trade --quick` measures on your machine.\n")
    whole = f"{intro}\n## What the front says\n{says[1] if says else ''}\n## All tables\n\n{tables[1] if tables else ''}"
    return "Speed and accuracy, measured", "<h1>Speed and accuracy, measured</h1>\n" + context.render(whole), context.headings


def home_page(site, page):
    context = Context(site, page)
    cards = []
    for one in lessons():
        picture = {"00": "00_exercise_1.svg"}.get(one.number) or next(iter(re.findall(r"!\[[^]]*\]\(pictures/([\w.]+)\)", one.notes.read_text())), "")
        image = context.image(context.picture(picture), "") if picture else ""
        context.inside_link = True
        idea = context.inline(one.idea)
        context.inside_link = False
        cards.append(f'<li><a href="{one.page}"><span class="thumb">{image}</span><span class="words"><b><span class="number">{one.number}</span> '
                     f"{html.escape(one.title)}</b> <span>{idea}</span></span></a></li>")
    body = context.render(page.source.read_text())
    hero = context.image(context.picture("viewer_glass.png"), "The viewer on one pixel of a glass ball: its ray tree in the scene and as a graph, and each formula with its numbers")
    return ("raytree: ray tracing, one ray at a time",
            body.replace("<p>@lessons@</p>", f'<ol class="cards">{"".join(cards)}</ol>').replace("<p>@hero@</p>", f'<figure class="picture wide hero">{hero}</figure>'),
            context.headings)


def schema_page(site, page):
    context = Context(site, page)
    example = f"\ue004{site.exhibits.json_example()}\ue005"
    body = context.render(reference(json.loads(page.source.read_text())))
    return "RayTree JSON", body.replace("<p>@example@</p>", example), context.headings


def json_listing(path):
    """A ray tree that a program wrote."""
    rows = [f'<span class="line">{piece}\n</span>' for piece in listings.coloured(compact_json(path.read_text()), "json")]
    return f'<div class="listing json">{listings.block(rows, "A ray tree as JSON")}</div>'


def compact_json(text):
    """Indented, but what holds no objects stays on its line."""
    text = json.dumps(json.loads(text), indent=2)
    return re.sub(r"\[[^\[\]{}]*\]", lambda match: " ".join(match[0].split()).replace("[ ", "[").replace(" ]", "]"), text)


def source_page(site, page):
    name = str(page.source.relative_to(ROOT))
    try:
        listing = listings.whole_file(page.source)
    except UnicodeDecodeError:
        listing = "<p>This file is not text.</p>"
    one = listings.lesson_of(page.source)
    root = "../" * page.address.count("/")
    note = ""
    if one and one.before:
        note = f' What is new against lesson {one.before.number} is marked.'
    if one:
        note = f'<p>The source of <a href="{root}{one.page}">lesson {one.number}, {html.escape(one.title)}</a>.{note}</p>'
    return name, f'<h1 class="file">{html.escape(name)}</h1>{note}<figure class="listing">{listing}</figure>', []


def folder_page(site, page):
    context = Context(site, page, page.source / "-")
    name = str(page.source.relative_to(ROOT))
    rows = []
    for path in sorted(page.source.iterdir()):
        if not path.name.startswith((".", "__")):
            shown = html.escape(path.name + ("/" if path.is_dir() else ""))
            text = path.is_dir() or path.suffix in (".h", ".cpp", ".toml", ".md", ".py", ".json", ".txt", ".css", ".js", ".cmake")
            rows.append(f'<li><a href="{context.link_to(path)}">{shown}</a></li>' if text and not path.is_dir() else f"<li>{shown}</li>")
    return name, f'<h1 class="file">{html.escape(name)}/</h1><ul>{"".join(rows)}</ul>', []


MAKERS = {"text": text_page, "lesson": lesson_page, "speed": speed_page, "home": home_page, "schema": schema_page,
          "source": source_page, "folder": folder_page}
