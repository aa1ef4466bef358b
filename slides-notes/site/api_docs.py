"""The functions and types of common/: Doxygen reads the headers, the pages are ours, so that they look and behave like all
others. A page a header."""
import hashlib
import html
import re
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from course import ROOT, SiteError
from exhibits import digest
from listings import coloured
from markdown import slug

# Doxygen 1.9.4 stumbles over specialisations of std:: templates, so it does not see them; line numbers stay.
SETTINGS = """
INPUT = {headers}
OUTPUT_DIRECTORY = "{out}"
STRIP_FROM_PATH = "{root}"
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
JAVADOC_AUTOBRIEF = YES
QUIET = YES
WARN_IF_UNDOCUMENTED = NO
WARN_AS_ERROR = FAIL_ON_WARNINGS
ENABLE_PREPROCESSING = YES
MACRO_EXPANSION = NO
INPUT_FILTER = "sed -e '/^struct std::/,/^}};/s/.*//'"
"""
INLINE = {"computeroutput": "code", "bold": "b", "emphasis": "em", "superscript": "sup", "subscript": "sub"}
SKIPPED = {"private"}


def read(cache, children):
    """The folder with Doxygen's XML of the headers as they are now."""
    headers = sorted((ROOT / "common").rglob("*.h"))
    key = hashlib.sha256((SETTINGS + "".join(header.name + digest(header) for header in headers)).encode()).hexdigest()[:32]
    folder = cache / f"doxygen-{key}"
    if folder.is_dir():
        return folder
    cache.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=cache) as place:
        settings = SETTINGS.format(headers=" ".join(str(header.relative_to(ROOT)) for header in headers), out=place, root=ROOT)
        try:
            done = children.run(["doxygen", "-"], input=settings, text=True, cwd=ROOT)
        except FileNotFoundError:
            raise SiteError("doxygen is missing; install it, or leave these pages out with --no-api") from None
        if done.returncode:
            raise SiteError(f"doxygen: {(done.stderr.strip() or 'it failed').splitlines()[0]}")
        (Path(place) / "xml").rename(folder)
    return folder


def path_of(header):
    """scene.h -> common/scene/scene.h: no name is there twice."""
    return next((ROOT / "common").rglob(header))


class Pages:
    def __init__(self, site, folder):
        self.site, self.folder = site, folder
        self.anchors = {}  # Doxygen's id -> (page, anchor)

    def words(self, element, page):
        """Text with links, as HTML."""
        if element is None:
            return ""
        out = html.escape(element.text or "")
        for child in element:
            inner = self.words(child, page)
            if child.tag == "ref" and child.get("refid") in self.anchors:
                there, anchor = self.anchors[child.get("refid")]
                out += f'<a href="{"" if there == page else there}#{anchor}">{inner}</a>'
            elif child.tag == "ulink" and child.get("url").startswith("http"):  # file:line:column: is none
                out += f'<a href="{html.escape(child.get("url"))}">{inner}</a>'
            elif child.tag in INLINE:
                out += f"<{INLINE[child.tag]}>{inner}</{INLINE[child.tag]}>"
            elif child.tag in ("para", "simplesect"):
                out += f"<p>{inner}</p>"
            elif child.tag == "itemizedlist":
                out += f"<ul>{inner}</ul>"
            elif child.tag == "listitem":
                out += f"<li>{inner}</li>"
            elif child.tag in ("verbatim", "preformatted"):
                out += f"<pre>{inner}</pre>"
            else:
                out += inner
            out += html.escape(child.tail or "")
        return out

    def told(self, element, page):
        """The whole comment; Doxygen parts it into its first sentence and the rest."""
        text = self.words(element.find("briefdescription"), page) + self.words(element.find("detaileddescription"), page)
        return re.sub(r"<p>\s*</p>", "", text.replace("<p><p>", "<p>").replace("</p></p>", "</p>"))

    def signature(self, member):
        template = member.find("templateparamlist")
        text = ""
        if template is not None:
            text = "template <" + ", ".join(
                " ".join(filter(None, ["".join(p.find("type").itertext()), p.findtext("declname") or ""])) for p in template) + ">\n"
        of = "".join(member.find("type").itertext()) if member.find("type") is not None else ""
        name = member.findtext("name")
        if member.get("kind") == "enum":
            values = ", ".join(value.findtext("name") for value in member.findall("enumvalue"))
            return f"enum class {name} {{ {values} }}"
        initial = "".join(member.find("initializer").itertext()) if member.find("initializer") is not None else ""
        if member.get("kind") == "variable" and len(initial) > 60:
            initial = "= ..." if initial.lstrip().startswith("=") else "{...}"
        if member.get("kind") == "typedef" and of:
            return f"{text}using {name} = {of}"
        if member.get("kind") == "concept":
            return f"{text}{initial}"
        return f"{text}{of + ' ' if of else ''}{name}{member.findtext('argsstring') or ''}{(' ' + initial) if initial else ''}"

    def data(self, members, page):
        """The data of a struct: declarations, and what they mean."""
        rows = []
        for member in members:
            _, anchor = self.anchors[member.get("id")]
            code = "".join(coloured(tidy(self.signature(member)) + "\n", "cpp"))
            told = re.sub(r"</?p>", " ", self.told(member, page)).strip()
            rows.append(f'<tr id="{anchor}"><td><code>{code}</code></td><td>{told}</td></tr>')
        head = '<thead><tr><th scope="col">data</th><th scope="col">meaning</th></tr></thead>'
        return f'<div class="table scrolls"><table>{head}<tbody>{"".join(rows)}</tbody></table></div>' if rows else ""

    def member(self, member, page, level):
        code = "\n".join(coloured(tidy(self.signature(member)) + "\n", "cpp"))
        place = member.find("location")
        line = place.get("line")
        source = f"../{self.site.address_of(path_of(page.removesuffix('.html')))}#L{line}"
        _, anchor = self.anchors[member.get("id")]
        told = self.told(member, page)
        values = "".join(f"<dt><code>{html.escape(v.findtext('name'))}</code></dt><dd>{self.told(v, page)}</dd>"
                         for v in member.findall("enumvalue") if self.told(v, page).strip())
        return (f'<section class="member"><h{level} id="{anchor}">{html.escape(member.findtext("name"))}</h{level}>'
                f'<pre class="code scrolls" role="group" aria-label="Declaration"><code>{code}</code></pre>{told}{f"<dl>{values}</dl>" if values else ""}'
                f'<p class="facts"><a href="{source}">line {line}<span class="hidden"> of {html.escape(member.findtext("name"))}</span></a></p></section>')


def tidy(code):
    """As the course writes it, without Doxygen's blanks."""
    code = re.sub(r"< ", "<", code)
    code = re.sub(r"(?<![<=&|-]) >", ">", code)
    return re.sub(r" ([&*]+)(?=\w|,|\))", r"\1 ", code).replace("& ,", "&,").replace("& )", "&)")


def members_of(compound, kinds=("function", "variable", "enum", "typedef")):
    """Public ones, in the order of the file."""
    found = [m for m in compound.iter("memberdef")
             if m.get("prot") not in SKIPPED and m.get("kind") in kinds and m.findtext("name") and not m.findtext("name").startswith("@")]
    return sorted(found, key=lambda m: int(m.find("location").get("line")))


def write(site):
    folder = read(site.cache, site.children)
    compounds = [ElementTree.parse(folder / f"{one.get('refid')}.xml").getroot()[0]
                 for one in ElementTree.parse(folder / "index.xml").getroot() if one.get("kind") != "dir"]
    types = [c for c in compounds if c.get("kind") in ("struct", "class", "concept") and c.get("prot") not in SKIPPED]
    free = {m.get("id"): m for c in compounds if c.get("kind") == "namespace" for m in members_of(c)}
    by_header = {}
    for one in [*types, *free.values()]:
        file = Path(one.find("location").get("file")).name
        by_header.setdefault(file, []).append(one)
    pages = Pages(site, folder)
    for header, found in by_header.items():
        taken = set()
        for one in found:
            for each in [one, *(members_of(one) if one in types else [])]:
                name = each.findtext("name") or each.findtext("compoundname").split("::", 1)[-1]
                anchor = slug(name if each is one else f"{one.findtext('compoundname').split('::')[-1]}-{name}")
                while anchor in taken:
                    anchor += "-too"
                taken.add(anchor)
                pages.anchors[each.get("id")] = (f"{header}.html", anchor)
    rows = []
    for header in sorted(by_header, key=path_of):
        title, body, headings, names = header_page(pages, header, by_header[header], types)
        rows.append(f'<tr><td><a href="{header}.html"><code>{path_of(header).relative_to(ROOT / "common")}</code></a></td><td>{names}</td></tr>')
        from site_pages import Page
        site.write(Page(f"api/{header}.html", title, "api"), (title, body, headings))
    intro = ("<h1>Functions and types of common/</h1><p>What the lecture does not show: scenes, pictures, rays, the ray tree. "
             "Taken from the comments in the headers. A lesson includes one of them, "
             '<a href="lesson.h.html"><code>lesson.h</code></a>.</p>' if "lesson.h" in by_header else
             "<h1>Functions and types of common/</h1><p>What the lecture does not show: scenes, pictures, rays, the ray tree. "
             "Taken from the comments in the headers.</p>")
    table = f'<div class="table scrolls"><table><thead><tr><th scope="col">header</th><th scope="col">what is in it</th></tr></thead><tbody>{"".join(rows)}</tbody></table></div>'
    page = next(page for page in site.order if page.kind == "api")
    site.write(page, ("Functions of common/", intro + table, []))


def header_page(pages, header, found, types):
    page, headings, parts, names = f"{header}.html", [], [], []
    for one in sorted(found, key=lambda one: int(one.find("location").get("line"))):
        _, anchor = pages.anchors[one.get("id")]
        name = one.findtext("name") or one.findtext("compoundname").split("::", 1)[-1]
        headings.append((2, anchor, html.escape(name)))
        names.append(f'<a href="{page}#{anchor}">{html.escape(name)}</a>')
        if one not in types:
            parts.append(pages.member(one, page, 2))
            continue
        inner = pages.data(members_of(one, ("variable",)), page)
        inner += "".join(pages.member(m, page, 3) for m in members_of(one, ("function", "enum", "typedef")))
        parts.append(f'<section class="type"><h2 id="{anchor}">{one.get("kind") or "concept"} {html.escape(name)}</h2>{pages.told(one, page)}{inner}</section>')
    source = pages.site.address_of(path_of(header))
    title = str(path_of(header).relative_to(ROOT))
    body = f'<h1 class="file">{title}</h1><p><a href="../{source}">The file itself</a> · <a href="index.html">all headers</a></p>{"".join(parts)}'
    return title, body, headings, ", ".join(dict.fromkeys(names))
