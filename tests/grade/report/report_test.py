#!/usr/bin/env python3
"""The reports as others read them: spreadsheets, XML parsers, and a browser in which no stranger's text may run. The part
in a browser is skipped (77) without Chromium, its driver or selenium. With RAYTREE_HTML_SHOTS=FOLDER screenshots are
written there.

usage: report_test.py FOLDER_OF_PROGRAMS"""
import base64
import csv
import hashlib
import html.parser
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests"))
import browser  # noqa: E402

PROGRAMS = pathlib.Path(sys.argv[1])
WIDTHS = (360, 768, 1280)
problems = []


def check(truth, what):
    if not truth:
        problems.append(what)
        print("FAILED:", what[:500])


def equal(got, expected, what):
    check(got == expected, f"{what}: expected {expected!r}, got {got!r}")


def run(program, *arguments):
    return subprocess.run([PROGRAMS / program, *map(str, arguments)], capture_output=True, text=True)


def rows(folder):
    with open(folder / "gradebook.csv", newline="", encoding="utf-8") as file:
        return list(csv.reader(file, strict=True))


def check_csv(out):
    table = rows(out / "class")
    equal(len(table), 14, "rows of the gradebook")
    equal({len(row) for row in table}, {11}, "cells of each row")
    equal(table[0], ["student", "lesson", "state", "points", "most", "percent", "06-fresnel", "06-schlick", "06-scene", "sandbox", "remarks"], "header")
    equal(table[1][:9], ["ada", "6", "graded", "6", "11", "54.5", "1.2", "4.8", "0"], "a row")
    equal(table[3][:9], ["charles", "6", "not compiled", "0", "11", "0.0", "0", "0", "0"], "a row of who did not compile")
    equal(len(rows(out / "empty")), 1, "the gradebook of nobody has a header")
    hostile = rows(out / "hostile")
    equal(len(hostile), 3, "rows of the hostile gradebook")
    equal({len(row) for row in hostile}, {len(hostile[0])}, "cells of each hostile row")
    equal(hostile[2][0], "'=cmd|' /C calc'!A0", "a formula is text")
    for row in hostile[1:]:
        for cell in row:
            check(not cell.strip().startswith(("=", "+", "-", "@")), f"a cell is a formula: {cell[:60]}")
            check(len(cell.encode()) < 20000, f"a cell is too long: {cell[:60]}")


def check_xml(out):
    root = xml.etree.ElementTree.parse(out / "class" / "junit.xml").getroot()
    suites = {suite.get("name"): suite for suite in root}
    equal(len(suites), 13, "test suites")
    for suite in root:
        equal(int(suite.get("tests")), len(suite.findall("testcase")), f"tests of {suite.get('name')}")
        equal(int(suite.get("failures")), len(suite.findall("testcase/failure")), f"failures of {suite.get('name')}")
        equal(int(suite.get("errors")), len(suite.findall("testcase/error")), f"errors of {suite.get('name')}")
    equal(suites["ada"].find("testcase/failure").get("type"), "wrong", "type of a failure")
    check("refelct" in suites["charles"].find("testcase/error").text, "the compiler's message is there")
    check("debug" not in (out / "class" / "junit.xml").read_text(), "what the program printed is not there")
    text = (out / "hostile" / "junit.xml").read_text(encoding="utf-8")
    root = xml.etree.ElementTree.fromstring(text)
    equal([element.tag for element in root.iter() if element.tag not in ("testsuites", "testsuite", "testcase", "failure", "error")], [], "hostile elements")
    check("<script>" in root[0].get("name"), "a hostile name is text")
    check(not any(ord(c) < 32 and c not in "\n\t" for c in text) and "\u202e" not in text, "control characters")


def check_merge(out, folder):
    merged = folder / "merged"
    done = run("grade_merge", merged, out / "class")
    equal((done.returncode, done.stderr), (0, ""), "merge of a class")
    first, second = rows(out / "class"), rows(merged)
    equal(sorted(first[1:]), sorted(second[1:]), "the gradebook of a merged class")
    equal(len(list((merged / "instructor").glob("*.html"))), 13, "pages for the instructor of a merged class")
    equal(run("grade_merge", merged, out / "class", out / "class" / "results" / "ada" / "results.json").returncode, 0, "the same file twice")

    def changed(name, change):
        path = folder / name / "results.json"
        path.parent.mkdir()
        result = json.loads((out / "class/results/ada/results.json").read_text())
        change(result["extra_data"]["raytree"])
        path.write_text(json.dumps(result))
        return run("grade_merge", folder / ("to-" + name), out / "class", path.parent), path

    def refused(name, change, words):
        done, path = changed(name, change)
        equal(done.returncode, 2, f"{name} is refused")
        check(str(path) in done.stderr and words in done.stderr and done.stderr.count("\n") == 1, f"{name}: {done.stderr}")
        check(not (folder / ("to-" + name)).exists(), f"{name}: nothing is written")

    refused("lesson", lambda r: r.update(lesson=7), "expected one lesson")
    refused("version", lambda r: r.update(grader="c" * 64, student="eve"), "expected results of one version")
    refused("twice", lambda r: r.update(remarks=[]), 'the student "ada"')
    refused("broken", lambda r: r.update(points=11), "unknown field")
    equal(changed("times", lambda r: r.update(seconds=999))[0].returncode, 0, "only the time differs")
    for arguments in ((merged, folder / "nowhere"), (merged, ROOT / "lessons"), (merged,), ()):
        equal(run("grade_merge", *arguments).returncode, 2, f"grade_merge {arguments}")
    check("results.json" in run("grade_merge", merged, ROOT / "lessons").stderr, "a folder without results")


class Elements(html.parser.HTMLParser):
    """What a browser would make of a page, without one."""
    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.tags, self.attributes, self.style, self.policy, self.inside = [], [], "", "", ""

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.attributes += [(tag, *pair) for pair in attributes]
        self.inside = tag
        if ("http-equiv", "Content-Security-Policy") in attributes:
            self.policy = dict(attributes)["content"]

    def handle_endtag(self, tag):
        self.inside = ""

    def handle_data(self, data):
        if self.inside == "style":
            self.style += data


def check_pages(out):
    for path in out.rglob("*.html"):
        name = str(path.relative_to(out))[:60]
        text = path.read_text(encoding="utf-8")
        page = Elements()
        page.feed(text)
        equal([tag for tag in page.tags if tag in ("script", "iframe", "object", "embed", "form", "base", "template", "button")], [], f"{name}: elements")
        equal([a for a in page.attributes if a[1].startswith("on") or a[1] == "style"], [], f"{name}: attributes")
        for tag, key, value in page.attributes:
            if key in ("src", "href") and tag != "a":
                check(value.startswith("data:image/png;base64,") or value == "data:,", f"{name}: {tag} {key}={value[:40]}")
            if key == "href" and tag == "a":
                check(re.fullmatch(r"(reports|instructor)/[\w%=.-]+\.html", value), f"{name}: a link to {value[:60]}")
        digest = base64.b64encode(hashlib.sha256(page.style.encode()).digest()).decode()
        equal(page.policy, f"default-src 'none'; img-src data:; style-src 'sha256-{digest}'; base-uri 'none'; form-action 'none'", f"{name}: policy")
        check(len(text) < 2_000_000, f"{name}: {len(text)} bytes")
        check(not any(ord(c) < 32 and c not in "\n\t" for c in text) and "\u202e" not in text, f"{name}: control characters")
        check(str(ROOT) not in text, f"{name}: the page names no folder of this machine")
    student = (out / "class/reports/ada.html").read_text()
    check("debug: n1" not in student and "93" not in re.sub(r'base64,[^"]*', "", student.split("</style>")[1]),
          "a student sees neither what the program printed nor counts of hidden cases")
    teacher = (out / "class/instructor/ada.html").read_text()
    check("debug: n1" in teacher and "30 of 93" in teacher and "for the instructor only" in teacher, "the instructor does")
    check("without a sandbox" in (out / "class/reports/edsger.html").read_text(), "no sandbox is said")


def check_palette():
    """The pages have the colours of the window."""
    source = (ROOT / "viz/base/palette.cpp").read_text()
    css = (ROOT / "tests/grade/report/page.css").read_text()
    names = {"window": "window", "panel": "panel", "raised": "panelRaised", "line": "line", "text": "text", "dim": "textDim",
             "accent": "accent", "warning": "warning", "lit": "lit"}
    for theme, block in (("light", css.split("@media")[0]), ("dark", css.split("@media")[1])):
        colors = source.split(f"{theme}Theme{{")[1].split("};")[0]
        for ours, theirs in names.items():
            rgb = re.search(rf"\.{theirs} = {{(\d+), (\d+), (\d+)}}", colors).groups()
            equal(re.search(rf"--{ours}: (#\w+)", block)[1], "#%02x%02x%02x" % tuple(map(int, rgb)), f"{theme} {ours}")


LAYOUT = """
  const wide = document.documentElement.clientWidth, bad = [];
  if (document.documentElement.scrollWidth > wide || document.body.scrollWidth > wide) bad.push('the page scrolls sideways');
  for (const card of document.querySelectorAll('.card, footer, figure, h1, h3')) {
    const box = card.getBoundingClientRect();
    if (box.left < 0 || box.right > wide + .5) bad.push(card.tagName + ' leaves the page');
    if (getComputedStyle(card).backgroundColor === '' ) bad.push('no style');
  }
  if (getComputedStyle(document.querySelector('.card')).borderRadius !== '9px') bad.push('the style sheet is not applied');
  return bad;"""

# WCAG 2.1: the contrast of each text against what is behind it.
CONTRAST = """
  const rgb = (text) => (text.match(/[\\d.]+/g) || []).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((c) => (c /= 255) <= .04045 ? c / 12.92 : ((c + .055) / 1.055) ** 2.4)
    .reduce((sum, c, i) => sum + c * [.2126, .7152, .0722][i], 0);
  const behind = (e) => { for (; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor); if (c.length === 3 || c[3] > .9) return c; } return [255, 255, 255]; };
  const low = [];
  let seen = 0;
  for (const e of document.querySelectorAll('body *')) {
    if (![...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim()) || !e.getClientRects().length) continue;
    ++seen;
    const a = light(rgb(getComputedStyle(e).color)), b = light(behind(e)), ratio = (Math.max(a, b) + .05) / (Math.min(a, b) + .05);
    if (ratio < 4.5) low.push(`${e.tagName}.${e.criterionName} "${e.textContent.slice(0, 20)}" ${ratio.toFixed(2)}`);
  }
  if (seen < 3) low.push('there is no text');
  return [...new Set(low)].slice(0, 5);"""


class Browser:
    def __init__(self, folder):
        self.driver = browser.start("browser", "performance")
        self.folder = folder

    def open(self, path, width, theme):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": False})
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": theme}]})
        self.driver.get(path.as_uri())

    def shot(self, file):
        height = self.driver.execute_script("return document.documentElement.scrollHeight")
        image = self.driver.execute_cdp_cmd("Page.captureScreenshot", {"captureBeyondViewport": True, "clip": {
            "x": 0, "y": 0, "width": self.driver.execute_script("return innerWidth"), "height": min(height, 4000), "scale": 1}})
        pathlib.Path(file).write_bytes(base64.b64decode(image["data"]))

    def check_quiet(self):
        """No error on the console, no request but for the pages themselves."""
        for entry in self.driver.get_log("browser"):
            check(False, "console: " + entry["message"])
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                url = message["params"]["request"]["url"]
                check(url.startswith((self.folder.as_uri(), "data:", "about:")), "request: " + url[:100])


def check_browser(b, out):
    pages = [out / "class/class.html", out / "class/reports/ada.html", out / "class/instructor/ada.html",
             out / "class/reports/charles.html", out / "class/reports/grace.html", out / "empty/class.html", *sorted((out / "hostile").rglob("*.html"))]
    for path in pages:
        name = str(path.relative_to(out))[:40]
        for width in WIDTHS:
            for theme in ("dark", "light"):
                b.open(path, width, theme)
                equal(b.driver.execute_script(LAYOUT), [], f"{name} at {width}, {theme}")
                equal(b.driver.execute_script(CONTRAST), [], f"contrast of {name} at {width}, {theme}")
        check(b.driver.title.endswith("raytree"), f"{name}: the title is {b.driver.title[:60]}")
        facts = b.driver.execute_script("return [document.scripts.length, document.documentElement.lang, document.querySelectorAll('h1').length, "
                                        "[...document.images].filter((i) => !i.naturalWidth || !i.alt || !i.offsetWidth).length, "
                                        "[...document.querySelectorAll('th')].filter((h) => !h.scope).length]")
        equal(facts, [0, "en", 1, 0, 0], f"{name}: scripts, language, headings, broken pictures, headers without scope")
    b.open(out / "class/reports/ada.html", 1280, "light")
    equal(b.driver.execute_script("return [...document.images].map((i) => [i.naturalWidth, getComputedStyle(i).imageRendering])"),
          [[64, "pixelated"]] * 3, "the three pictures")
    b.open(out / "class/class.html", 1280, "light")
    links = b.driver.execute_script("return [...document.querySelectorAll('a')].map((a) => a.href)")
    equal(len(links), 26, "links to students' pages")
    b.driver.get(next(link for link in links if "ren" in link and "reports" in link))
    check("Søren" in b.driver.title, "a link with other letters leads to its page")
    b.check_quiet()
    # The test of the test: a policy that lets nothing run has something to say about what would.
    text = (out / "class/reports/ada.html").read_text().replace("</h1>", "</h1><script>document.title='broken out'</script><p style='color:red'>x</p>", 1)
    (out / "broken.html").write_text(text)
    b.open(out / "broken.html", 1280, "light")
    check("broken out" not in b.driver.title, "the policy stops scripts that got into the page")
    equal(len([e for e in b.driver.get_log("browser") if "Content Security Policy" in e["message"]]), 2, "the policy says so")


def take_shots(b, out, folder):
    for name, path in (("class", "class/class.html"), ("student", "class/reports/ada.html"), ("full", "class/reports/tony.html"),
                       ("compile", "class/reports/charles.html"), ("instructor", "class/instructor/ada.html")):
        for width in (360, 1280):
            for theme in ("dark", "light"):
                b.open(out / path, width, theme)
                b.shot(f"{folder}/{name}-{width}-{theme}.png")
    b.open(next((out / "hostile/reports").glob("=3C*")), 768, "light")
    b.shot(f"{folder}/hostile.png")


def main():
    with tempfile.TemporaryDirectory(prefix="raytree-reports-") as temporary:
        folder = pathlib.Path(temporary)
        out = folder / "out"
        done = run("write_reports", out)
        equal((done.returncode, done.stderr), (0, ""), "write_reports")
        check_csv(out)
        check_xml(out)
        check_merge(out, folder)
        check_pages(out)
        check_palette()
        if not browser.missing():
            b = Browser(folder)
            try:
                check_browser(b, out)
                if "RAYTREE_HTML_SHOTS" in os.environ:
                    take_shots(b, out, os.environ["RAYTREE_HTML_SHOTS"])
            finally:
                b.driver.quit()
    print(f"{len(problems)} problems")
    if problems:
        return 1
    if browser.missing():
        print(f"skipped: pages were not opened in a browser: {browser.missing()}")
        return 77
    return 0


if __name__ == "__main__":
    sys.exit(main())
