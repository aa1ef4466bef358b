"""What Markdown needs to know about the page it stands on: links, pictures, formulas, and the parts that are computed."""
import html
import os
import re
from pathlib import Path

import directives
import listings
from course import NOTES, ROOT, SiteError, exercises, lesson, lessons, section
from markdown import Renderer

PICTURES = {".png", ".svg", ".jpg", ".webp"}


class Context:
    """`base` is the file that the text is from: links are relative to its folder."""

    def __init__(self, site, page, base=None, headings=None):
        self.site, self.current, self.base = site, page, base or page.source
        self.exhibits, self.root = site.exhibits, "../" * page.address.count("/")
        self.headings = [] if headings is None else headings
        self.inside_link = False
        self.where = str(self.base.relative_to(ROOT)) if self.base else page.address
        self.renderer = Renderer(self, self.where, self.headings)

    def render(self, text):
        return self.renderer.render(text)

    def inline(self, text):
        return self.renderer.inline(text)

    def formula(self, tex, display, where):
        return self.site.formulas.add(tex, display, where)

    def link(self, address, where):
        """Where a link of the text leads in the site."""
        if re.match(r"[a-z][a-z+.-]*:", address) or address.startswith("#"):
            return address
        place, _, anchor = address.partition("#")
        path = Path(os.path.normpath(self.base.parent / place))
        if not path.exists() or ROOT not in [path, *path.parents]:
            raise SiteError(f"{where}: a link leads nowhere: {address}")
        return self.link_to(path) + (f"#{anchor}" if anchor else "")

    def link_to(self, path):
        return self.root + self.site.address_of(path)

    def picture_at(self, source, where):
        if re.match(r"[a-z]+:", source):
            raise SiteError(f"{where}: a picture from elsewhere would need a network: {source}")
        path = Path(os.path.normpath(self.base.parent / source))
        if path.parent != NOTES / "pictures":
            raise SiteError(f"{where}: a picture is not in slides-notes/pictures: {source}")
        return self.exhibits.picture(path.name)

    def picture(self, name):
        return self.exhibits.picture(name)

    def is_wide(self, address):
        """Pairs, drawings and windows need more than the column of text."""
        return bool(re.search(r"pictures/(00|09|10)_|pictures/viewer", address))

    def image(self, address, words):
        """Sizes are filled in once the picture is made, so that nothing moves while it loads."""
        lazy = ' loading="lazy"' if self.current.kind != "home" else ""
        return f'<img src="{self.root}{address}" alt="{html.escape(words, quote=True)}" \ue002{address}\ue003{lazy}>'

    def excerpt_caption(self, path, text):
        numbers = listings.find(path, text)
        owner = next((one for one in lessons() if one.folder in path.parents), None)
        place = f'<a href="{self.link_to(path)}#L{numbers[0]}"><code>{path.relative_to(ROOT)}</code></a>'
        lines = f"line {numbers[0]}" if len(numbers) == 1 else f"lines {numbers[0]} to {numbers[-1]}"
        new = ""
        if owner and listings.lesson_of(path) and owner.before:
            fresh = len(listings.new_lines(owner)[0] & set(numbers))
            new = f" {fresh} of them new." if 0 < fresh < len(numbers) else " All of them new." if fresh else " None of them new."
            new = new if len(numbers) > 1 else " New." if fresh else ""
        slide = f" Slides: {html.escape(owner.slides)}." if owner and owner.number != "10" else ""
        return f"{place}, {lines}.{new}{slide}"

    def listing(self, number):
        """A lesson's whole source, folded where it holds the solutions of exercises."""
        one = lesson(number)
        new, gone = listings.new_lines(one)
        place = f'<a href="{self.link_to(one.source)}"><code>{one.source.relative_to(ROOT)}</code></a>'
        if one.before:
            count = f"{len(new)} lines are new" + (f" and {gone} gone" if gone else "")
            said = f'{place}. Against <a href="{self.root}{one.before.page}">lesson {one.before.number}</a>, {count}; what is new is marked.'
        else:
            said = f"{place}. All of it is new here."
        slide = f" Slides: {html.escape(one.slides)}." if one.number != "10" else ""
        listing = listings.lesson_listing(one, said + slide)
        if not any(entry["lesson"] == int(number) for entry in exercises()):
            return listing
        return f'<details class="answer whole"><summary>Show it: the solutions of the exercises stand in it</summary>{listing}</details>'

    def exercise_cards(self, number):
        """What the lesson's README says about the exercise, and each part with its hint."""
        one = lesson(number)
        readme = one.folder / "README.md"
        text = section(readme.read_text(), "Exercise")
        if not text:
            named = re.search(r"^## (Exercise: [^\n]*)\n(.*?)(?=^## |\Z)", readme.read_text(), re.M | re.S)
            text = named[2].strip() if named else ""
        parts = [Context(self.site, self.current, readme, [(0, a, "") for _, a, _ in self.headings]).render(text)]
        for entry in exercises():
            if entry["lesson"] == int(number):
                points = f'{entry["points"]} point{"s" if entry["points"] > 1 else ""}'
                slide = html.escape(entry["slide"].rstrip("."))
                parts.append(
                    f'<section class="task" aria-labelledby="x-{entry["id"]}"><h3 id="x-{entry["id"]}">{html.escape(entry["title"])}</h3>'
                    f'<p class="facts"><code>{entry["id"]}</code> · {points} · slide: {slide}</p>'
                    f'<details class="answer"><summary>Hint</summary><p>{self.inline(entry["hint"])}</p></details></section>')
        return "".join(parts)
