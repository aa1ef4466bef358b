"""What can be said of the site's files without a browser: links lead somewhere, formulas are typeset, pictures have sizes."""
import collections
import html.parser
import re
import urllib.parse

VOID = {"img", "link", "meta", "br", "hr", "input", "wbr"}
RAW = {"code", "pre", "script", "style", "annotation", "title"}


class File(html.parser.HTMLParser):
    """Anchors, links and words of one page."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.problems, self.open = collections.Counter(), [], [], []
        self.formulas, self.words, self.images, self.frames = 0, [], 0, []
        self.feed(path.read_text())
        self.problems += [f"an id stands twice: {anchor}" for anchor, times in self.anchors.items() if times > 1]

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        if tag not in VOID:
            self.open.append(tag)
        if "id" in given:
            self.anchors[given["id"]] += 1
        self.links += [given[name] for name in ("href", "src") if name in given]
        if "katex" in (given.get("class") or "").split():
            self.formulas += 1
        if "katex-error" in (given.get("class") or ""):
            self.problems.append("a formula is not typeset")
        if tag == "img":
            self.images += 1
            if "alt" not in given:
                self.problems.append(f"a picture has no words: {given.get('src')}")
            if not given.get("width", "").isdigit() or not given.get("height", "").isdigit():
                self.problems.append(f"a picture has no size: {given.get('src')}")
        if tag == "iframe":
            self.frames.append(given.get("src"))
            if not given.get("title"):
                self.problems.append("a frame has no title")

    def handle_endtag(self, tag):
        if tag in self.open:
            while self.open.pop() != tag:
                pass

    def handle_data(self, text):
        if not RAW & set(self.open):
            self.words.append(text)
            if "$" in text:
                self.problems.append(f"a raw $: {text.strip()[:60]}")
        if re.search("[\ue000-\ue005]", text):
            self.problems.append(f"a place was not filled: {text.strip()[:60]!r}")


def check(site):
    """Returns (path -> File, problems)."""
    files = {path: File(path) for path in sorted(site.rglob("*.html")) if path.parent.name != "trees"}
    problems = []
    for path, file in files.items():
        name = path.relative_to(site)
        problems += [f"{name}: {problem}" for problem in file.problems]
        for link in file.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("http", "https") or link.startswith("data:"):
                continue
            if parts.scheme or link.startswith("//"):
                problems.append(f"{name}: a link of an unknown kind: {link}")
                continue
            there = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if not there.is_file() or site not in there.parents:
                problems.append(f"{name}: a link leads nowhere: {link}")
            elif parts.fragment and there in files and parts.fragment not in files[there].anchors:
                problems.append(f"{name}: a link leads to no place of its page: {link}")
    return files, problems


def formulas_of(markdown):
    """How many formulas a text has, counted without the site's own Markdown."""
    blocks = len(re.findall(r"^ *```math$", markdown, re.M))
    text = re.sub(r"^ *```.*?^ *```", "", markdown, flags=re.M | re.S)
    text = re.sub(r"`[^`\n]*`|<!--.*?-->", "", text, flags=re.S)
    return blocks + len(re.findall(r"\$[^$\n]+\$", text))
