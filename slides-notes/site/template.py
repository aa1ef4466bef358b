"""What all pages share: head, navigation, contents, previous and next."""
import html

# Before anything is drawn: the look that the reader chose last.
EARLY = ('try{const t=localStorage.getItem("raytree-theme");if(t==="dark"||t==="light")document.documentElement.dataset.theme=t}'
         'catch(e){}document.documentElement.classList.add("js")')


def navigation(groups, current, root):
    """groups: [(title, [(address, name, number)])]."""
    parts = []
    for title, entries in groups:
        items = "".join(
            f'<li><a href="{root}{address}"{" aria-current=page" if address == current else ""}>'
            f'{f"<span class=number>{number}</span> " if number else ""}{html.escape(name)}</a></li>' for address, name, number in entries)
        heading = f"<h2>{html.escape(title)}</h2>" if title else ""
        parts.append(f"{heading}<ul>{items}</ul>")
    return "".join(parts)


def contents(headings):
    shown = [(level, anchor, words) for level, anchor, words in headings if level in (2, 3)]
    if len(shown) < 3:
        return ""
    items = "".join(f'<li class="l{level}"><a href="#{anchor}">{words}</a></li>' for level, anchor, words in shown)
    # Beside the text where there is room, else folded above it; CSS shows one of the two.
    return (f'<nav class="toc" aria-labelledby="toc-name"><h2 id="toc-name">On this page</h2><ol>{items}</ol></nav>'
            f'<details class="toc"><summary>On this page</summary><ol>{items}</ol></details>')


def neighbours(before, after, root):
    def link(page, way, word):
        return (f'<a class="{way}" rel="{way}" href="{root}{page.address}"><span>{word}</span> {html.escape(page.full_name)}</a>'
                if page else "<span></span>")
    if not before and not after:
        return ""
    return f'<nav class="neighbours" aria-label="Previous and next">{link(before, "prev", "Previous")}{link(after, "next", "Next")}</nav>'


def page(title, body, *, root, current, groups, headings=(), before=None, after=None, widgets=False, kind="", description=""):
    """A whole page. root: the way from the page to the site's first folder, "" or "../"."""
    extra = ""
    if widgets:
        extra = f'<link rel="stylesheet" href="{root}widgets/widgets.css">\n<script defer src="{root}widgets/widgets.js"></script>\n'
    toc = contents(headings)
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="description" content="{html.escape(description, quote=True)}">
<title>{html.escape(title)}{"" if current == "index.html" else " · raytree"}</title>
<link rel="icon" href="{root}assets/icon.svg" type="image/svg+xml">
<script>{EARLY}</script>
<link rel="stylesheet" href="{root}assets/katex.css">
<link rel="stylesheet" href="{root}assets/style.css">
{extra}<script defer src="{root}assets/site.js"></script>
</head>
<body class="{kind}{" has-toc" if toc else ""}{"" if widgets else " no-widgets"}">
<a class="skip" href="#main">Skip to the text</a>
<header class="top">
<a class="menu-open" href="#contents" aria-label="All pages"><span aria-hidden="true">☰</span></a>
<a class="brand" href="{root}index.html"><img src="{root}assets/icon.svg" alt="" width="26" height="26"> raytree</a>
<button id="theme" type="button" aria-label="Switch between dark and light" title="Dark or light"><span aria-hidden="true">◐</span></button>
</header>
<nav class="pages" id="contents" aria-label="All pages" tabindex="-1">
<a class="menu-close" href="#main" aria-label="Close the list of pages"><span aria-hidden="true">✕</span></a>
{navigation(groups, current, root)}
</nav>
<main id="main" tabindex="-1">
{toc}
<article>
{body}
</article>
{neighbours(before, after, root)}
</main>
<footer class="foot"><p>raytree, MIT licence. Built by <code>./raytree notes</code> from the texts, code and programs of the course.</p></footer>
</body>
</html>
"""
