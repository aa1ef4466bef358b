"""Markdown as GitHub reads it, plus formulas, the course's excerpts, its questions, and what comments ask for."""
import html
import re

from markdown_it import MarkdownIt
from markdown_it.token import Token
from mdit_py_plugins.dollarmath import dollarmath_plugin

import directives
import listings
import typography
from course import ROOT, SiteError

parser = MarkdownIt("commonmark", {"html": True}).enable("table").use(
    dollarmath_plugin, allow_labels=False, allow_space=False)  # allow_digits=False looks at the wrong letter


def slug(text):
    return re.sub(r"[^\w]+", "-", text.lower()).strip("-") or "section"


def plain(inline):
    """The words of an inline token."""
    return "".join(child.content if child.type in ("text", "code_inline", "math_inline") else " " if child.type == "softbreak" else ""
                   for child in inline.children or [])


def raw(markup):
    """HTML that is ready."""
    token = Token("ready", "", 0)
    token.content = markup
    return token


def keep_punctuation(tokens):
    """What follows a formula without a space becomes part of it: a browser may break the line after a formula."""
    for formula, text in zip(tokens, tokens[1:]):
        if formula.type == "math_inline" and text.type == "text" and (mark := re.match(r"[,.;:)?!]+", text.content)):
            formula.content += rf"\text{{{mark[0]}}}"
            text.content = text.content[mark.end():]


class Renderer:
    """Markdown of one file -> HTML. `page` knows links, pictures and formulas; `where` is for messages."""

    def __init__(self, page, where, headings):
        self.page, self.where, self.headings = page, where, headings
        self.source = None  # of the next code block
        self.file, self.row = None, False  # the last file in a row of a table
        self.rules = {"fence": self.fence, "code_block": self.fence, "html_block": self.html_block, "html_inline": self.html_inline, "ready": lambda token: token.content,
                      "image": self.image, "code_inline": self.code_inline, "math_inline": self.math, "math_block": self.math,
                      "math_inline_double": self.math}

    def render(self, text):
        return self.blocks(parser.parse(text))

    def inline(self, text):
        return "".join(self.inlines(token.children) for token in parser.parse(text) if token.type == "inline")

    def blocks(self, tokens):
        out = []
        tokens = self.figures(tokens)
        for place, token in enumerate(tokens):
            if token.type == "heading_open":
                self.heading(token, tokens[place + 1])
            if token.type == "tr_open":
                self.file, self.row = None, True
            if token.type == "tr_close":
                self.file, self.row = None, False
            if token.type == "table_open":
                out.append('<div class="table scrolls">')
            out.append(self.one(token, tokens, place))
            if token.type == "table_close":
                out.append("</div>")
        return "".join(out)

    def one(self, token, tokens, place):
        if token.type == "inline":
            return self.inlines(token.children)
        if token.type in self.rules:
            return self.rules[token.type](token)
        if token.type == "link_open":
            self.link(token)
        if token.type == "td_open" or token.type == "th_open":
            style = token.attrs.pop("style", None)
            if style:
                token.attrs["class"] = style.replace("text-align:", "")
            if token.type == "th_open":
                token.attrs["scope"] = "col"
                if not tokens[place + 1].children:  # a head without words is no head
                    return "<td>"
        if token.type == "th_close" and not tokens[place - 1].children:
            return "</td>"
        return parser.renderer.renderToken(tokens, place, parser.options, {})

    def inlines(self, tokens):
        keep_punctuation(tokens or [])
        return "".join(typography.words(token.content) if token.type == "text"
                       else parser.renderer.rules[token.type](tokens, place, parser.options, {})
                       if token.type in ("softbreak", "hardbreak") else self.one(token, tokens, place)
                       for place, token in enumerate(tokens or []))

    def heading(self, token, inline):
        words, level = plain(inline), int(token.tag[1])
        anchor, taken = slug(words), {anchor for _, anchor, _ in self.headings}
        while anchor in taken:
            anchor += "-again"
        token.attrs["id"] = anchor
        self.headings.append((level, anchor, self.inlines([c for c in inline.children if not c.type.startswith("link")])))

    def figures(self, tokens):
        """A paragraph that is only an image is a figure; its words are for those who see the picture, too."""
        result, place = [], 0
        while place < len(tokens):
            token = tokens[place]
            if token.type == "paragraph_open" and [c.type for c in tokens[place + 1].children] == ["image"]:
                image = tokens[place + 1].children[0]
                result.append(raw(self.figure(image)))
                place += 3
            else:
                result.append(token)
                place += 1
        return result

    def figure(self, image):
        words, address = plain(image), self.page.picture_at(image.attrs["src"], self.where)
        wide = " wide" if self.page.is_wide(address) else ""
        shown = self.page.image(address, words)
        if address.endswith(".svg"):  # its words must stay readable
            shown = f'<div class="drawing scrolls">{shown}</div>'
        return (f'<figure class="picture{wide}">{shown}'
                f'<figcaption aria-hidden="true">{html.escape(words)}</figcaption></figure>\n')

    def image(self, token):
        return self.page.image(self.page.picture_at(token.attrs["src"], self.where), plain(token))

    def math(self, token):
        return self.page.formula(token.content, token.type != "math_inline", self.where)

    def link(self, token):
        token.attrs["href"] = self.page.link(token.attrs["href"], self.where)

    def code_inline(self, token):
        """The name of a file leads to the file, and the name of a function after it in a table's row to its line."""
        words, address = token.content, ""
        if re.fullmatch(r"(?!out/|build/)[\w.-]+(/[\w.-]+)+", words) and (ROOT / words).is_file():
            self.file, address = ROOT / words if self.row else None, self.page.link_to(ROOT / words)
        elif self.file and re.fullmatch(r"\w+", words):
            found = definition(self.file, words)
            address = self.page.link_to(self.file) + f"#L{found}" if found else ""
        code = f"<code>{typography.code(words, self.row, bool(address))}</code>"
        return f'<a href="{address}">{code}</a>' if address and not self.page.inside_link else code

    def fence(self, token):
        language, source, self.source = token.info.strip() or "text", self.source, None
        if language == "math":
            return self.page.formula(token.content, True, self.where)
        if source:
            path = ROOT / source
            if not path.is_file() or not listings.find(path, token.content):
                raise SiteError(f"{self.where}: an excerpt does not stand in {source}")
            return listings.excerpt(path, token.content, self.page.excerpt_caption(path, token.content))
        pieces = listings.coloured(token.content, language)
        rows = [f'<span class="line">{piece}\n</span>' for piece in (map(typography.command, pieces) if language == "sh" else pieces)]
        return f'<div class="listing {language}">{listings.block(rows, "Commands" if language == "sh" else "Code")}</div>\n'

    def html_block(self, token):
        found = directives.parse(token.content)
        if not found:
            return "" if token.content.startswith("<!--") else token.content.replace("<details>", '<details class="answer">')
        name, argument = found
        if name == "from":
            self.source = argument
            return ""
        if name == "listing":
            return self.page.listing(argument)
        if name == "exercises":
            return self.page.exercise_cards(argument)
        return {"widget": directives.widget, "slider": directives.slider, "tree": directives.tree, "render": directives.render}[name](argument, self.where, self.page)

    def html_inline(self, token):
        return "" if token.content.startswith("<!--") else token.content


def definition(path, name):
    """The line where a function, type or member of this name begins; 0 if there is none."""
    if path.suffix not in (".h", ".cpp"):
        return 0
    shape = re.compile(rf"^\s*(?!return\b|//)(?:[\w:<>&*,\[\] ]+[ &*>])?{name}(?:\(|\b.*[;{{=]|$)")
    return next((n for n, line in listings.lines_of(path) if shape.match(line)), 0)
