#!/usr/bin/env python3
"""The site of ./raytree notes, built with small pictures and read in a browser: site_test.py PROGRAMS CACHE

Exit codes: 0 all holds, 1 something does not, 77 skipped: a package is missing (the list site_packages of ./raytree, a browser,
or a network the first time, for the accessibility checker). RAYTREE_SITE=FOLDER checks a site that is there already."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "tests/course"), str(ROOT / "slides-notes/site"), str(ROOT / "common/program")]
import browser  # noqa: E402
import npm_packages  # noqa: E402
import site_files  # noqa: E402

WIDTHS = [360, 768, 1280, 1920]
failures, skipped = [], []


def expect(truth, sentence):
    if not truth:
        failures.append(sentence)
        print("FAILED:", sentence, flush=True)


def build(programs, cache, out, *options):
    done = subprocess.run([sys.executable, "-B", ROOT / "slides-notes/site/build_site.py", "--programs", programs, "--cache", cache,
                           "--out", out, *options], capture_output=True, text=True, check=False)
    return done


def packages_missing():
    """What the generator needs and does not find, or nothing."""
    for module in ("markdown_it", "mdit_py_plugins", "pygments", "PIL"):
        try:
            __import__(module)
        except ImportError:
            return f"python module {module}"
    for program in ("node", "doxygen"):
        if not shutil.which(program):
            return program
    for path in ("/usr/share/nodejs/katex", "/usr/share/fonts-sil-charis/woff2", "/usr/share/fonts/opentype/inter",
                 "/usr/share/fonts/truetype/jetbrains-mono"):
        if not pathlib.Path(path).exists():
            return path
    return ""


def check_files(site):
    files, problems = site_files.check(site)
    for problem in problems:
        expect(False, problem)
    expect(len(files) > 60, f"there are {len(files)} pages, expected more than 60")
    for notes in sorted((ROOT / "slides-notes").glob("*.md")):
        page = site / ("slides.html" if notes.name == "README.md" else f"{notes.stem}.html")
        expect(page.is_file(), f"{notes.name} has no page")
        if page.is_file():
            text = re.sub(r"<!-- begin tables -->.*?<!-- end tables -->", "", notes.read_text(), flags=re.S)
            found, wanted = files[page].formulas, site_files.formulas_of(text)
            headings = sum(line.count("$") for line in text.splitlines() if line.startswith("##")) // 2
            expect(found == wanted + 2 * headings, f"{page.name}: {found} formulas are typeset, {notes.name} has {wanted}")
    for lesson in sorted(ROOT.glob("lessons/[0-9][0-9]_*")):
        file = files[site / f"{lesson.name.replace('_', '-')}.html"]
        expect(lesson.name.startswith("00") or file.frames, f"lesson {lesson.name} has no ray tree")
        expect(file.images > 0, f"lesson {lesson.name} has no picture")
    return files


def check_new_lines():
    """What is marked as new is what the lesson before has not: counted here in another way than the site counts."""
    import course
    import listings
    for lesson in course.lessons():
        marked, _ = listings.new_lines(lesson)
        if not lesson.before:
            expect(not marked, f"lesson {lesson.number} marks new lines, but changes no lesson")
            continue
        clean = lambda path: [re.sub(r"lesson\d\d", "", line) for line in path.read_text().splitlines()]
        old, new = set(clean(lesson.before.source)), clean(lesson.source)
        wrong = [new[n - 1] for n in marked if new[n - 1] in old and len(new[n - 1].strip()) > 30]
        expect(len(wrong) <= 2, f"lesson {lesson.number}: old lines are marked as new: {wrong}")  # a long line may move
        missed = [line for n, line in enumerate(new, 1) if line not in old and n not in marked and not re.match(r"^// Lesson|^ *// (SOLUTION|END|EXERCISE)", line)]
        expect(not missed, f"lesson {lesson.number}: new lines are not marked: {missed}")
        expect(marked, f"lesson {lesson.number} marks nothing as new")


def check_navigation():
    """Texts that come later are found: known ones in their places, others under More; none is needed."""
    import site_pages
    kept = site_pages.NOTES
    with tempfile.TemporaryDirectory() as folder:
        site_pages.NOTES = pathlib.Path(folder)
        for names in ((), ("benchmark.md", "first-hour.md", "teach-with-this.md", "zebra.md")):
            for name in names:
                (site_pages.NOTES / name).write_text("# Stripes\n")
            groups = {group: [page.address for page in pages] for group, pages in site_pages.navigation(False)}
            for group, address in (("Measured", "benchmark.html"), ("Begin", "first-hour.html"), ("Teach", "teach-with-this.html"), ("More", "zebra.html")):
                expect((address in groups.get(group, [])) == bool(names), f"{address} is {'not ' if names else ''}under {group}")
    site_pages.NOTES = kept


def check_mistakes(programs, cache, folder):
    """Mistakes in texts are told in one sentence, and a folder that is something else is left alone."""
    import course
    import directives
    from children import Children
    from formulas import Formulas
    other = folder / "mine"
    other.mkdir()
    (other / "thesis.txt").write_text("precious")
    done = build(programs, cache, other, "--draft", "--no-api")
    expect(done.returncode == 2 and "is not a site" in done.stderr and (other / "thesis.txt").exists(), "a folder that is something else stays")
    for what, words in ((lambda: directives.widget("Fancy <b>", "x.md", None), "x.md"), (lambda: directives.slider("a.png | b", "x.md", None), "LEFT RIGHT"),
                        (lambda: directives.tree("six", "x.md", None), "tree: N"), (lambda: directives.render("a.gif = lesson 1", "x.md", None), "NAME.png"),
                        (lambda: bad_formula(Formulas(Children())), r"\nonsense")):
        try:
            what()
            expect(False, f"a mistake is not told: {words}")
        except course.SiteError as error:
            expect(words in str(error), f"'{error}' does not say '{words}'")


def bad_formula(formulas):
    formulas.add(r"\nonsense{x}", False, "x.md")
    formulas.typeset()


def install_axe(folder):
    """The accessibility checker's script, or None if it cannot be had."""
    try:
        return (npm_packages.install("axe-core", folder) / "axe.min.js").read_text(encoding="utf-8")
    except npm_packages.Missing as reason:
        skipped.append(f"no page was looked at by the accessibility checker: {reason}")
        return None


OVERFLOW = """
  const wide = document.documentElement.clientWidth, problems = [];
  if (document.documentElement.scrollWidth > wide) {
    problems.push(`scrolls sideways by ${document.documentElement.scrollWidth - wide}`);
    for (const e of document.querySelectorAll('main *'))
      if (e.getBoundingClientRect().right > wide + 1 && !e.closest('.scrolls, .hidden')) { problems.push(`${e.tagName}.${e.className}`); break; }
  }
  for (const e of document.querySelectorAll('article img, article iframe, article .table, article .drawing'))
    if (e.getBoundingClientRect().right > wide + 1 && !e.matches('.drawing *')) problems.push(`${e.tagName} ${e.getAttribute('src') || e.className} leaves the page`);
  return problems;"""

AXE_RUN = """
  const done = arguments[arguments.length - 1];
  // Formulas have the colours of the text around them, and code the same few everywhere: looking at each letter takes most of the time.
  const [page, theme] = arguments, exclude = page.includes('02-mirrors') ? ['.katex'] : ['.katex', '.code code'];
  const rules = theme === 'dark' ? {runOnly: ['color-contrast', 'link-in-text-block']} : {};
  axe.run({include: [document], exclude}, {iframes: false, preload: false, resultTypes: ['violations'], ...rules}).then(
    (found) => done(found.violations.map((v) => `${v.id}: ${v.nodes.length} x ${v.nodes[0].html.slice(0, 120)} ${(v.nodes[0].any[0] || v.nodes[0].all[0] || v.nodes[0].none[0] || {message: ''}).message}`)),
    (error) => done([String(error)]));"""


class Browser:
    def __init__(self, site):
        self.driver, self.site = browser.start("browser", "performance"), site
        self.run = self.driver.execute_script

    def size(self, width, height=900):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def theme(self, theme):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": theme}]})

    def open(self, page):
        self.driver.get((self.site / page).as_uri())
        self.driver.execute_async_script("const done = arguments[0]; document.fonts.ready.then(() => requestAnimationFrame(() => done()));")

    def quiet(self, where):
        """No error on the console, no request that leaves the site."""
        for entry in self.driver.get_log("browser"):
            expect(False, f"{where}: console: {entry['message']}")
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                url = message["params"]["request"]["url"]
                expect(url.startswith((self.site.as_uri(), "data:", "about:", "blob:")), f"{where}: a request leaves the site: {url[:100]}")


def check_pages(b, pages, axe):
    """The accessibility checker on each page in the light look, and on the course's own in the dark one; all widths."""
    for theme in ("light", "dark"):
        b.theme(theme)
        for page in [page for page in pages if theme == "light" or re.match(r"index|\d\d-", page)]:
            b.size(1280)
            b.open(page)
            if axe:
                b.run(axe)
                for problem in b.driver.execute_async_script(AXE_RUN, page, theme):
                    expect(False, f"{page} ({theme}): {problem}")
            b.quiet(page)
            if theme == "light":
                for width in WIDTHS:
                    b.size(width)
                    for problem in b.run(OVERFLOW):
                        expect(False, f"{page} at {width}: {problem}")


def check_switch(b):
    """The button switches the look, it is remembered on the next page, and the ray tree follows it."""
    b.theme("light")
    b.size(1280)
    b.open("glossary.html")
    paper = "return getComputedStyle(document.body).backgroundColor"
    light = b.run(paper)
    b.driver.find_element("id", "theme").click()
    dark = b.run(paper)
    expect(light != dark, "the button switches the look")
    # Chromium may lose what a page of a file stored (on busy cores 1 of 10 tries, up to 5 s after it): carried over by hand.
    kept = b.run("return JSON.stringify(localStorage)")
    carry = b.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": f"Object.assign(localStorage, {kept})"})
    b.open("errata.html")
    expect(b.run(paper) == dark, "the look is remembered")
    b.open("02-mirrors.html")
    for look in ("dark", "light"):
        b.run("document.querySelector('figure.tree').scrollIntoView()")
        frame_is_ready(b)
        expect(b.run("return document.documentElement.dataset.theme") == look, f"the ray tree follows the {look} look")
        b.driver.switch_to.default_content()
        # Chromium gives frames the colours of the page by itself, others have to be told.
        told = b.run("return [...document.querySelectorAll('figure.tree iframe')].map((frame) => frame.src.split('#')[1])")
        expect(set(told) == {f"theme={look}"}, f"ray trees are told of the {look} look: {told}")
        b.driver.find_element("id", "theme").click()
    b.driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", carry)
    b.run("localStorage.clear()")


def wait(condition):
    """Until it holds; only what hangs takes all of the time, and what is expected then is not there."""
    until = time.monotonic() + browser.PATIENCE
    while not condition() and time.monotonic() < until:
        time.sleep(0.05)


def frame_is_ready(b):
    """Goes into the page's ray tree once it is there."""
    b.driver.switch_to.frame(b.driver.find_element("css selector", "figure.tree iframe"))
    wait(lambda: b.run("return typeof LAST !== 'undefined' && document.readyState === 'complete'"))


def check_trees(b, files):
    """The ray tree on its page steps on, and all of them can be opened."""
    b.open("02-mirrors.html")
    b.run("document.querySelector('figure.tree').scrollIntoView()")
    frame_is_ready(b)
    last = b.run("return LAST")
    b.run("document.getElementById('first').click()")
    b.run("document.getElementById('next').click()")
    wait(lambda: b.driver.find_element("id", "status").text.startswith("Step 2/"))
    status = b.driver.find_element("id", "status").text
    expect(last > 5 and status.startswith(f"Step 2/{last}:"), f"a step in the embedded ray tree: '{status}'")
    b.driver.switch_to.default_content()
    b.quiet("02-mirrors.html, stepping")
    for tree in sorted({(path.parent / frame).resolve() for path, file in files.items() for frame in file.frames}):
        b.open(str(tree.relative_to(b.site)))
        expect(b.run("return LAST") > 0 and "node" in b.driver.title, f"{tree.name} shows a ray tree")
        b.quiet(tree.name)


def check_folding(b):
    """Answers and hints are folded, and open; the menu of a phone opens and closes, without a script too."""
    b.size(1280)
    b.open("06-fresnel.html")
    expect(b.run("return document.querySelectorAll('details.answer').length") >= 6, "lesson 06 has answers and hints")
    expect(b.run("return document.querySelectorAll('details.answer[open]').length") == 0, "answers are folded at first")
    expect(b.run("const d = document.querySelector('details.answer'); d.querySelector('summary').click(); return d.open"), "an answer opens")
    b.size(360)
    shown = "return getComputedStyle(document.getElementById('contents')).display !== 'none'"
    expect(not b.run(shown), "on a phone the list of pages is away")
    b.driver.find_element("css selector", ".menu-open").click()
    expect(b.run(shown), "on a phone the list of pages opens")
    b.driver.find_element("css selector", ".menu-close").click()
    expect(not b.run(shown), "on a phone the list of pages closes")


def check_paper(b):
    """Printed, a page is dark on white, whichever look was chosen; what needs a screen is not there."""
    b.size(1280)
    colours = {}
    for theme in ("light", "dark"):
        b.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print", "features": [{"name": "prefers-color-scheme", "value": theme}]})
        for chosen in ("", "dark"):
            b.open("02-mirrors.html")
            colours[theme, chosen] = b.run("""
              const style = (selector) => getComputedStyle(document.querySelector(selector));
              if (arguments[0]) document.documentElement.dataset.theme = arguments[0];
              return [style('body').color, style('body').backgroundColor, style('.code .line').color, style('.code').backgroundColor,
                      style('.code .k-kt, .code .k-k').color, document.querySelector('.widget') ? style('.widget').backgroundColor : ''];""", chosen)
            expect(b.run("return getComputedStyle(document.querySelector('figure.tree')).display") == "none", "paper has no ray tree to step through")
    expect(len({tuple(found) for found in colours.values()}) == 1, f"paper has one look: {colours}")
    b.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


def check_browser(site, files, axe):
    if browser.missing():
        skipped.append(f"no page was opened in a browser: {browser.missing()}")
        return
    b = Browser(site)
    try:
        names = [str(path.relative_to(site)) for path in files]
        pages = [name for name in names if "/" not in name] + [name for name in names if name.startswith("api/")][:2] \
            + [name for name in names if name.startswith("source/lessons/06")][:1]
        for check, arguments in ((check_pages, (pages, axe)), (check_trees, (files,)), (check_switch, ()), (check_paper, ()), (check_folding, ())):
            started = time.time()
            check(b, *arguments)
            print(f"{check.__name__}: {time.time() - started:.1f} s", flush=True)
    finally:
        b.driver.quit()


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: site_test.py PROGRAMS CACHE")
    missing = packages_missing()
    if missing:
        print(f"skipped: {missing} is not installed")
        return 77
    programs, cache = map(pathlib.Path, sys.argv[1:])
    with tempfile.TemporaryDirectory(prefix="raytree-site-") as folder:
        site = pathlib.Path(os.environ.get("RAYTREE_SITE", pathlib.Path(folder) / "site")).resolve()
        started = time.time()
        done = None
        if "RAYTREE_SITE" not in os.environ:
            done = build(programs, cache, site, "--draft")
            print(done.stderr, end="")
            if done.returncode:
                print("FAILED: the site was not built")
                return 1
            print(f"built in {time.time() - started:.1f} s")
        check_new_lines()
        check_navigation()
        check_mistakes(programs, cache, pathlib.Path(folder))
        if not (site / "widgets/widgets.js").is_file():
            said = [line for line in (done.stderr if done else "").splitlines() if "without widgets" in line]
            skipped.append(f"the site has no widgets: {(said or ['none were made'])[0]}")
        files = check_files(site)
        axe = install_axe(cache / "axe")
        check_browser(site, files, axe)
        print(f"{len(files)} pages, {len(failures)} problems, {time.time() - started:.1f} s")
    for reason in skipped:
        print("skipped:", reason)
    return 1 if failures else 77 if skipped else 0


sys.exit(main())
