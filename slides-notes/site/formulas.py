"""Formulas are typeset when the site is built, by KaTeX, all at once: starting it for each would take minutes."""
import json
import re
import subprocess

import typography
from course import SiteError

SCRIPT = __file__.rsplit("/", 1)[0] + "/typeset.js"
MODULES = "/usr/share/nodejs"  # where Debian's packages put them


class Formulas:
    def __init__(self, children):
        self.children = children
        self.waiting = {}  # (tex, display) -> (number, where it stands first)

    def add(self, tex, display, where):
        """A placeholder for the formula, until `fill`."""
        number, _ = self.waiting.setdefault((tex.strip(), display), (len(self.waiting), where))
        return f"\ue000{number}\ue001"

    def typeset(self):
        """Raises SiteError with the place of the first formula that KaTeX does not understand."""
        formulas = list(self.waiting)
        try:
            done = self.children.run(["node", SCRIPT], input=json.dumps(formulas), text=True,
                                     env={"NODE_PATH": MODULES, "PATH": "/usr/local/bin:/usr/bin:/bin"})
            done.check_returncode()
        except (OSError, subprocess.CalledProcessError) as error:
            reason = (getattr(error, "stderr", "") or str(error)).strip().splitlines()
            raise SiteError(f"KaTeX could not be run: {next((line for line in reason if 'Error' in line), reason[-1])}") from None
        self.results = []
        for (tex, display), result in zip(formulas, json.loads(done.stdout)):
            if "error" in result:
                raise SiteError(f"{self.waiting[tex, display][1]}: the formula {tex} cannot be typeset: {result['error']}")
            html = result["html"]
            self.results.append(f'<div class="formula scrolls">{html}</div>' if display else typography.formula(tex, html))

    def fill(self, html):
        return re.sub("\ue000(\\d+)\ue001", lambda match: self.results[int(match[1])], html)
