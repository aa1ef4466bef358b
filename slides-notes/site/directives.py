"""What an HTML comment on a line of its own, invisible elsewhere, asks of the site. README.md lists them.

    <!-- widget: NAME -->                         <!-- slider: LEFT.png RIGHT.png | left | right | caption -->
    <!-- tree: N [scene.toml] [x,y] | caption --> <!-- render: NAME.png = lesson N ... [| left half] -->
"""
import html
import re

from course import ROOT, SiteError, lesson

COMMENT = re.compile(r"<!--\s*(widget|slider|tree|render|listing|exercises|from)(?::| )\s*(.*?)\s*-->\s*\Z", re.S)


def parse(text):
    """(name, argument) of a comment that is a directive, or None."""
    found = COMMENT.fullmatch(text.strip())
    return (found[1], " ".join(found[2].split())) if found else None


def widget(argument, where, page):
    if not re.fullmatch(r"[a-z][a-z0-9-]*", argument):
        raise SiteError(f"{where}: expected the name of a widget, got '{argument}'")
    return f'<div class="widget" data-widget="{argument}"></div>' if page.site.widgets else ""


def slider(argument, where, page):
    parts = [part.strip() for part in argument.split("|")]
    files = parts[0].split()
    if len(files) != 2 or len(parts) != 4:
        raise SiteError(f"{where}: expected 'slider: LEFT RIGHT | left | right | caption', got '{argument}'")
    images = "".join(page.image(page.picture(file), alt) for file, alt in zip(files, parts[1:3]))
    return f'<figure class="slider">{images}<figcaption>{page.inline(parts[3])}</figcaption></figure>'


def tree(argument, where, page):
    words, _, caption = argument.partition("|")
    found = re.fullmatch(r"(\d+)(?: (\S+\.toml))?(?: (\d+),(\d+))?", words.strip())
    if not found:
        raise SiteError(f"{where}: expected 'tree: N [scene.toml] [x,y] | caption', got '{argument}'")
    number, scene, x, y = found.groups()
    if scene and not (ROOT / scene).is_file():
        raise SiteError(f"{where}: there is no scene {scene}")
    scene = ROOT / scene if scene else None
    pixel = (int(x), int(y)) if x else None
    shown, px, py = lesson(number).chosen(scene)
    px, py = pixel or (px, py)
    address = page.root + page.exhibits.tree(f"{int(number):02}", scene, pixel)
    title = f"Ray tree of pixel {px}, {py} of {shown.name}"
    said = page.inline(caption.strip()) if caption.strip() else html.escape(title) + "."
    return (f'<figure class="tree wide"><iframe src="{address}" title="{html.escape(title)}" loading="lazy" sandbox="allow-scripts"></iframe>'
            f'<figcaption>{said} <a href="{address}">On a page of its own</a></figcaption></figure>')


def render(argument, where, page):
    name, equals, words = argument.partition("=")
    if not equals or not re.fullmatch(r"[\w-]+\.png", name.strip()):
        raise SiteError(f"{where}: expected 'render: NAME.png = lesson N ...', got '{argument}'")
    page.exhibits.command(name.strip(), words)
    return ""
