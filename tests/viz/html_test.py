#!/usr/bin/env python3
"""The page of a ray tree in a browser: what a reader does, and what strangers' texts must not do. Skipped (77) without
Chromium, its driver or selenium. With RAYTREE_HTML_SHOTS=FOLDER screenshots of several lessons are written there.

usage: html_test.py WRITE_HTML"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
WIDTHS = [(360, 800), (768, 1024), (1280, 720), (1920, 1080)]
GLASS = "lessons/06_fresnel/scenes/half_and_glass.toml"
SHOTS = ["2 lessons/02_mirrors/scenes/pure_specular.toml", "3 lessons/03_partial_reflection/scenes/half_specular.toml",
         "5 lessons/05_refraction/scenes/glass_ball.toml", "6 " + GLASS, "6 lessons/06_fresnel/scenes/gem.toml", "7 lessons/07_recursion_caps/scenes/mirror_box.toml",
         "8 lessons/08_phong/scenes/everything.toml"]

sys.path.insert(0, str(ROOT / "tests"))
import browser  # noqa: E402

if browser.missing():
    print(f"skipped: {browser.missing()}")
    sys.exit(77)
from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402


class Browser:
    def __init__(self, folder, write_html):
        self.driver = browser.start("browser", "performance")
        self.folder, self.write_html, self.problems = folder, write_html, []

    def page(self, name, *arguments):
        """Writes a page and returns its address."""
        path = self.folder / f"{name}.html"
        if not path.exists():
            subprocess.run([self.write_html, arguments[0], *arguments[1:3], str(path), *arguments[3:]], check=True, cwd=ROOT)
        return path.as_uri()

    def open(self, address, width=1280, height=720, theme="dark"):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                    {"features": [{"name": "prefers-color-scheme", "value": theme}]})
        self.driver.get("about:blank")
        self.driver.get(address)
        self.settle()

    def settle(self):
        """Until what was changed is drawn."""
        self.driver.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 80)));")

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait(self, script):
        """Whether it comes true; only what hangs takes all of the time."""
        end = time.monotonic() + browser.PATIENCE
        while not (truth := self.run(script)) and time.monotonic() < end:
            time.sleep(0.05)
        return truth

    def check(self, truth, what):
        if not truth:
            self.problems.append(what)
            print("FAILED:", what)

    def equal(self, got, expected, what):
        self.check(got == expected, f"{what}: expected {expected!r}, got {got!r}")

    def press(self, *keys):
        for key in keys:
            ActionChains(self.driver).send_keys(key).perform()
        self.settle()

    def title(self):
        return self.driver.title

    def hash(self):
        return self.run("return location.hash")

    def count_steps(self):
        return self.run("return LAST")

    def status(self):
        return self.driver.find_element(By.ID, "status").text

    def lit(self):
        return self.run("const line = document.querySelector('#code .lit b'); return line ? Number(line.textContent) : 0")

    def click(self, css):
        self.driver.find_element(By.CSS_SELECTOR, css).click()
        self.settle()


def check_selection(b):
    b.open(b.page("glass", GLASS, "6", "420,196"))
    last = b.count_steps()
    b.equal(b.title(), f"pixel 420,196 · node 0 · step {last}/{last} - raytree", "title at first")
    b.click("#tree [data-node='3'] text")
    b.equal(b.title(), f"pixel 420,196 · node 3 · step {last}/{last} - raytree", "title after a click on a node")
    b.equal(b.hash(), f"#node=3&step={last}", "address after a click on a node")
    b.check("reflected ray [3]" in b.driver.find_element(By.ID, "numbers").text, "the numbers are those of the node")
    b.check("Snell" in b.driver.find_element(By.ID, "numbers").text, "formulas are shown")
    b.press(Keys.PAGE_UP)
    b.check("· node 2 ·" in b.title(), "Page Up selects the parent")
    b.press(Keys.ARROW_DOWN, Keys.ARROW_DOWN)
    b.check("· node 4 ·" in b.title(), "Down selects the next node")
    b.press(Keys.ARROW_UP)
    b.check("· node 3 ·" in b.title(), "Up selects the node before")


def check_steps(b):
    b.open(b.page("glass", GLASS, "6", "420,196"))
    last, lines = b.count_steps(), set()
    b.press(Keys.HOME)
    b.equal(b.title(), f"pixel 420,196 · node 0 · step 1/{last} - raytree", "title after Home")
    for step in range(2, 7):
        b.press(Keys.ARROW_RIGHT)
        b.check(f"step {step}/{last}" in b.title(), f"Right goes to step {step}")
        lines.add(b.lit())
        text = b.run("return DATA.events[arguments[0]][4]", step - 1)
        b.equal(b.status(), f"Step {step}/{last}: {text}", "the live region says the step")
        b.equal(b.lit(), b.run("return DATA.events[arguments[0]][3]", step - 1), "the lit line is the step's")
    b.check(len(lines) > 1, "the lit line moves")
    visible = "const l = document.querySelector('#code .lit').getBoundingClientRect(), p = document.getElementById('code').getBoundingClientRect(); return l.top >= p.top && l.bottom <= p.bottom"
    b.check(b.run(visible), "the lit line is scrolled into its pane")
    b.press(Keys.ARROW_LEFT)
    b.check("step 5/" in b.title(), "Left goes back")
    b.check(b.run("return document.querySelectorAll('#tree .later').length") > 0, "what is not reached yet is faint")
    b.press(Keys.END)
    b.check(f"step {last}/" in b.title(), "End goes to the last step")
    b.equal(b.run("return document.querySelectorAll('#tree .later').length"), 0, "at the end nothing is faint")
    b.click("#first")
    b.check("step 1/" in b.title(), "the button goes to the first step")
    b.click("#next")
    b.check("step 2/" in b.title(), "the button goes on")
    b.run("document.activeElement.blur()")
    b.press(" ")
    b.equal(b.driver.find_element(By.ID, "play").get_attribute("aria-label"), "Pause", "Space plays")
    b.check(b.wait("return state.step >= 4"), "playing goes on by itself")
    b.press(" ")
    step = b.run("return state.step")
    time.sleep(1.0)  # two steps, if it played
    b.equal(b.run("return state.step"), step, "Space pauses")


def check_space(b):
    """A click on a ray selects it, a drag turns the scene, both are kept in the address."""
    b.open(b.page("glass", GLASS, "6", "420,196"))
    before = b.hash()
    place = """
      const wanted = segments.find((s) => s.role === 'reflected' && s.node === 1), box = canvas.getBoundingClientRect();
      const line = lastProject.line(wanted.from, wanted.to);
      return [0, 1].map((i) => Math.round(line.from[i] * .7 + line.to[i] * .3 + [box.left, box.top][i]));"""
    x, y = b.run(place)
    ActionChains(b.driver).move_by_offset(x, y).click().perform()
    b.settle()
    b.check("· node 1 ·" in b.title(), "a click on a ray selects its node")
    b.equal(b.run("return document.activeElement.id"), "canvas", "and gives the pane the focus")
    picture = b.driver.find_element(By.ID, "canvas").screenshot_as_base64
    ActionChains(b.driver).click_and_hold().move_by_offset(60, 25).release().perform()
    b.settle()
    b.check("· node 1 ·" in b.title(), "a drag selects nothing")
    b.check("&view=" in b.hash() and b.hash() != before, "a drag changes the view in the address")
    b.check(b.driver.find_element(By.ID, "canvas").screenshot_as_base64 != picture, "a drag turns the scene")
    address, turned = b.driver.current_url, b.run("return {...orbit}")
    b.open(address)
    again = b.run("return {...orbit}")
    b.check(all(abs(turned[key] - again[key]) < 1e-3 for key in ("azimuth", "elevation", "distance")), "the address keeps the view")
    b.check("· node 1 ·" in b.title(), "the address keeps the node")
    far = b.run("return orbit.distance")
    b.run("canvas.dispatchEvent(new WheelEvent('wheel', {deltaY: -200, bubbles: true, cancelable: true}))")
    b.check(b.run("return orbit.distance") < far, "the wheel zooms")
    b.press("2")
    b.check("hide=reflected" in b.run("writeHash(); return location.hash"), "2 hides reflected rays")
    b.press("n")
    b.equal(b.run("return state.normals"), False, "n hides normals")
    b.press("?")
    b.check(b.run("return document.getElementById('keys').open"), "? opens the help")
    b.press(Keys.ESCAPE)
    b.check(not b.run("return document.getElementById('keys').open"), "Escape closes the help")


def check_hostile_address(b):
    address = b.page("glass", GLASS, "6", "420,196")
    for text in ("node=1e9&step=-3&view=1,2", "node=<b>&step=nan&view=a,b,c,d,e,f&hide=x&theme=<script>", "step=999999999999"):
        b.open(address + "#" + text)
        last = b.count_steps()
        b.equal(b.title(), f"pixel 420,196 · node 0 · step {last}/{last} - raytree", f"title with #{text}")


def check_odd_trees(b):
    for variant in ("empty", "nan", "huge", "orphans", "large", "hostile"):
        address = b.page(variant, GLASS, "6", "420,196", variant)
        started = time.monotonic()
        b.open(address)
        opening = time.monotonic() - started
        b.check(str(ROOT) not in (b.folder / f"{variant}.html").read_text(), f"{variant}: the page names no folder of this machine")
        b.press(Keys.HOME, Keys.ARROW_RIGHT, Keys.ARROW_DOWN)
        b.check(b.run("return canvas.width > 100 && canvas.height > 100"), f"{variant}: the scene is drawn")
        if variant == "empty":
            b.equal(b.title(), "pixel 420,196 · nothing was traced - raytree", "empty: title")
            b.check("Nothing was traced" in b.status(), "empty: says so")
        else:
            b.check("step 2/" in b.title() or "node" in b.title(), f"{variant}: steps")
        if variant == "large":
            b.check("10000 rays" in b.driver.find_element(By.ID, "tree-note").text, "large: says how many")
            b.press(Keys.HOME)
            steps = []
            for _ in range(3):
                started = time.monotonic()
                b.press(Keys.ARROW_RIGHT)
                steps.append(time.monotonic() - started)
            b.check(min(steps) < opening, f"large: a step takes {min(steps):.2f} s, to open the page took {opening:.2f} s")
            b.run("for (let i = 0; i < 40; ++i) zoomTree(.8, 600, 600)")
            b.settle()
            drawn = b.run("return document.querySelectorAll('#tree [role=button]').length")
            b.check(1 <= drawn <= 1501, f"large: at most 1501 rays are elements, not {drawn}")
        if variant == "hostile":
            b.check("onerror=alert(1)" in b.driver.find_element(By.ID, "title").text, "hostile: the title is text")
            b.check("onerror=alert(1)" in b.driver.find_element(By.ID, "numbers").text, "hostile: names are text")
            b.equal(b.run("return document.images.length"), 1, "hostile: no image is made")
            b.equal(b.run("return document.scripts.length"), 2, "hostile: no script is made")
    b.open(b.page("one", GLASS, "6", "0,0"))
    b.equal(b.run("return document.getElementById('picture').naturalWidth"), 1, "a picture of one pixel")


LAYOUT = """
  const boxes = [...document.querySelectorAll('.pane, header, #strip')].map((e) => [e.id || e.tagName, e.getBoundingClientRect()]);
  const problems = [], wide = document.documentElement.clientWidth, main = document.getElementById('main');
  if (document.documentElement.scrollWidth > wide || main.scrollWidth > main.clientWidth) problems.push('scrolls sideways');
  const clip = main.getBoundingClientRect();
  for (const [name, box] of boxes) {
    if (box.width < 60 || box.height < 20) problems.push(name + ' is too small');
    if (box.left < -0.5 || box.right > wide + 0.5) problems.push(name + ' leaves the page');
  }
  const shown = boxes.map(([name, b]) => [name, name === 'strip' ? b : {left: b.left, right: b.right, top: Math.max(b.top, clip.top), bottom: Math.min(b.bottom, clip.bottom)}]);
  for (let i = 0; i < shown.length; ++i)
    for (let j = 0; j < i; ++j) {
      const [p, a] = shown[i], [q, c] = shown[j];
      if (Math.min(a.right, c.right) - Math.max(a.left, c.left) > 0.5 && Math.min(a.bottom, c.bottom) - Math.max(a.top, c.top) > 0.5)
        problems.push(p + ' overlaps ' + q);
    }
  for (const button of document.querySelectorAll('button'))
    if (!(button.getAttribute('aria-label') || button.textContent.trim())) problems.push('a button has no name');
  return problems;"""

# WCAG 2.1: the contrast of each text that is shown against what is behind it.
CONTRAST = """
  const rgb = (text) => (text.match(/[\\d.]+/g) || []).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((c) => (c /= 255) <= .04045 ? c / 12.92 : ((c + .055) / 1.055) ** 2.4)
    .reduce((sum, c, i) => sum + c * [.2126, .7152, .0722][i], 0);
  const behind = (e) => { for (; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor); if (c.length === 3 || c[3] > .9) return c; } return [255, 255, 255]; };
  const low = [];
  for (const e of document.querySelectorAll('h1, h2, h3, h4, p, dt, dd, td, th, button, .symbolic, .filled, #code span, #code b, .key')) {
    if (!e.textContent.trim() || e.closest('dialog') || e.disabled || !e.offsetParent) continue;
    const a = light(rgb(getComputedStyle(e).color)), b = light(behind(e)), ratio = (Math.max(a, b) + .05) / (Math.min(a, b) + .05);
    if (ratio < 4.5) low.push(`${e.tagName}.${e.className} "${e.textContent.slice(0, 20)}" ${ratio.toFixed(2)}`);
  }
  return [...new Set(low)].slice(0, 5);"""


def check_layout(b):
    for width, height in WIDTHS:
        for theme in ("dark", "light"):
            b.open(b.page("glass", GLASS, "6", "420,196") + "#node=5", width, height, theme)
            b.equal(b.run("return document.documentElement.dataset.theme"), theme, f"{width} follows the system")
            b.equal(b.run(LAYOUT), [], f"layout of {width}x{height} {theme}")
            b.equal(b.run(CONTRAST), [], f"contrast of {width}x{height} {theme}")
    b.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    b.run("dispatchEvent(new Event('beforeprint'))")
    b.settle()
    b.equal(b.run(LAYOUT), [], "layout on paper")
    b.equal(b.run("return document.documentElement.dataset.theme"), "light", "paper is light")
    b.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    b.run("dispatchEvent(new Event('afterprint'))")
    b.click("#theme")
    b.equal(b.run("return document.documentElement.dataset.theme"), "dark", "the button switches")
    b.check("theme=dark" in b.hash(), "the address keeps the theme")


def check_frame(b):
    """Within another page, in a frame that may run scripts and nothing else."""
    address = b.page("glass", GLASS, "6", "420,196")
    frame = b.folder / "frame.html"
    frame.write_text(f'<iframe sandbox="allow-scripts" width=600 height=500 src="{address}"></iframe>')
    b.open(frame.as_uri())
    b.driver.switch_to.frame(0)
    b.press(Keys.HOME)
    b.check(b.run("return LAST > 0 && canvas.width > 100"), "it works in a frame")
    b.driver.switch_to.default_content()


def check_quiet(b):
    """No error on the console, no request but for the files themselves."""
    for entry in b.driver.get_log("browser"):
        b.check(False, "console: " + entry["message"])
    for entry in b.driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            url = message["params"]["request"]["url"]
            b.check(url.startswith((b.folder.as_uri(), "data:", "about:")), "request: " + url[:100])


def take_shots(b, folder):
    for shot in SHOTS:
        lesson, scene = shot.split()
        for width, height in ((1920, 1080), (1280, 720), (360, 800)):
            for theme in ("dark", "light"):
                b.open(b.page("lesson" + lesson, scene, lesson, "-"), width, height, theme)
                b.driver.save_screenshot(f"{folder}/lesson{lesson}-{width}-{theme}.png")


def main():
    with tempfile.TemporaryDirectory(prefix="raytree-html-") as folder:
        b = Browser(pathlib.Path(folder), sys.argv[1])
        try:
            for check in (check_selection, check_steps, check_space, check_hostile_address, check_odd_trees, check_layout, check_frame):
                started = time.time()
                check(b)
                check_quiet(b)
                print(f"{check.__name__}: {time.time() - started:.1f} s")
            if "RAYTREE_HTML_SHOTS" in os.environ:
                take_shots(b, os.environ["RAYTREE_HTML_SHOTS"])
        finally:
            b.driver.quit()
    print(f"{len(b.problems)} problems")
    return bool(b.problems)


if __name__ == "__main__":
    sys.exit(main())
