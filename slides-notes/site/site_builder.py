"""All pages, from texts and programs to files."""
import hashlib
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

import special_pages
import template
from course import NOTES, ROOT, SiteError, lessons
from exhibits import Exhibits, digest, dimensions
from formulas import Formulas
from site_pages import Page, navigation

HERE = NOTES / "site"
KATEX = "/usr/share/javascript/katex/katex.min.css"
KATEX_FONTS = "/usr/share/fonts/truetype/katex"
FONTS = {"/usr/share/fonts-sil-charis/woff2": ["CharisSIL-Regular.woff2", "CharisSIL-Italic.woff2", "CharisSIL-Bold.woff2",
                                               "CharisSIL-BoldItalic.woff2"],
         "/usr/share/fonts/opentype/inter": ["Inter-Regular.otf", "Inter-SemiBold.otf"],
         "/usr/share/fonts/truetype/jetbrains-mono": ["JetBrainsMono-Regular.ttf"]}


class Site:
    def __init__(self, out, programs, cache, draft, api, say, children):
        self.out, self.cache, self.say, self.api, self.children = out, cache, say, api, children
        self.exhibits, self.formulas = Exhibits(programs, cache, draft, children), Formulas(children)
        self.groups = navigation(api)
        self.order = [page for _, pages in self.groups for page in pages]
        self.by_source = {page.source: page for page in self.order if page.source and page.kind != "speed"}
        for lesson in lessons():  # a lesson's README is part of its page
            self.by_source[lesson.folder / "README.md"] = self.by_source[lesson.notes]
            self.by_source[lesson.folder] = self.by_source[lesson.notes]
        self.by_source[ROOT / "README.md"] = self.by_source[NOTES] = self.order[0]
        self.waiting = []   # pages that others lead to
        self.written = {}   # address -> HTML with placeholders

    def address_of(self, path):
        """The page of a file; it is made if nobody asked before."""
        if path.suffix in (".png", ".svg") and path.parent == NOTES / "pictures":
            return self.exhibits.picture(path.name)
        if path not in self.by_source:
            name = str(path.relative_to(ROOT))
            kind = "text" if path.suffix == ".md" else "folder" if path.is_dir() else "source"
            page = Page(f"source/{name}.html" if not path.is_dir() else f"source/{name}/index.html", name, kind, path)
            self.by_source[path] = page
            self.waiting.append(page)
        return self.by_source[path].address

    def build(self):
        """Returns the number of pages."""
        self.assets()
        for page in self.order:
            if page.kind != "api":
                self.write(page, special_pages.MAKERS[page.kind](self, page))
        if self.api:
            import api_docs
            api_docs.write(self)
        while self.waiting:
            page = self.waiting.pop()
            self.write(page, special_pages.MAKERS[page.kind](self, page))
        self.exhibits.make(self.out, self.say)
        self.formulas.typeset()
        for address, text in self.written.items():
            path = self.out / address
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(self.filled(self.formulas.fill(text)))
        return len(self.written)

    def filled(self, text):
        """Sizes of pictures, and contents of files that programs wrote."""
        def size(match):
            width, height = dimensions(self.out / match[1])
            return f'width="{width}" height="{height}"'
        text = re.sub("\ue002(.*?)\ue003", size, text)
        return re.sub("\ue004(.*?)\ue005", lambda match: special_pages.json_listing(self.out / match[1]), text)

    def write(self, page, made):
        """made: (title, HTML, headings)."""
        title, body, headings = made
        place = self.order.index(page) if page in self.order else -1
        groups = [(name, [(p.address, p.name, p.number) for p in pages]) for name, pages in self.groups]
        self.written[page.address] = template.page(
            title, body, root="../" * page.address.count("/"), current=page.address, groups=groups, headings=headings,
            before=self.order[place - 1] if place > 0 else None,
            after=self.order[place + 1] if 0 <= place < len(self.order) - 1 else None,
            widgets=self.widgets and ('class="widget"' in body or 'class="slider"' in body), kind=page.kind,
            description=self.description(page, title))

    def description(self, page, title):
        for lesson in lessons():
            if lesson.page == page.address:
                return f"Whitted-style ray tracing, lesson {lesson.number}: {lesson.idea}"
        return f"{title}: Whitted-style ray tracing, one ray at a time"

    def assets(self):
        folder = self.out / "assets"
        shutil.copytree(HERE / "assets", folder)
        (folder / "fonts").mkdir()
        for place, names in FONTS.items():
            if all(Path(place, name).is_file() for name in names):
                for name in names:
                    shutil.copyfile(f"{place}/{name}", folder / "fonts" / name)
            else:
                self.say(f"without the fonts of {place}, which are not installed: browsers take others")
        try:
            css = open(KATEX).read()
            # One format is enough: every browser of the last ten years reads it.
            css = re.sub(r'src:url\(fonts/([\w-]+)\.woff2\) format\("woff2"\)[^}]*', r'src:url(fonts/\1.woff2) format("woff2")', css)
            (folder / "katex.css").write_text(css)
            for name in re.findall(r"url\(fonts/([\w.-]+)\)", css):
                shutil.copyfile(f"{KATEX_FONTS}/{name}", folder / "fonts" / name)
        except FileNotFoundError as error:
            raise SiteError(f"{error.filename} is missing; its package is in the list site_packages of ./raytree") from None
        self.widgets = self.make_widgets()

    def make_widgets(self):
        """widgets/build.py compiles the lessons for the browser, once as long as they stay the same; or the files are there."""
        source, out = HERE / "widgets", self.out / "widgets"
        if (source / "build.py").is_file():
            key = "".join(digest(folder) for folder in (source, ROOT / "common", *(lesson.source for lesson in lessons())))
            made = self.cache / f"widgets-{hashlib.sha256(key.encode()).hexdigest()[:32]}"
            if not made.is_dir():
                self.say("widgets: compiling the lessons for the browser")
                self.cache.mkdir(parents=True, exist_ok=True)
                with tempfile.TemporaryDirectory(dir=self.cache) as folder:
                    part = Path(folder) / "widgets"
                    done = self.children.run([sys.executable, "-B", source / "build.py", part], text=True,
                                             env={**os.environ, "TMPDIR": folder})
                    if done.returncode == 3:  # a package is missing
                        self.say(f"without widgets: {done.stderr.strip().removeprefix('build.py: ')}")
                        return False
                    if done.returncode:
                        raise SiteError(f"widgets: {(done.stderr.strip() or 'build.py failed').splitlines()[0]}")
                    part.rename(made)
            shutil.copytree(made, out)
        elif source.is_dir():
            shutil.copytree(source, out, ignore=shutil.ignore_patterns("*.py", "*.md", "__pycache__"))
        return (out / "widgets.js").is_file() and (out / "widgets.css").is_file()
