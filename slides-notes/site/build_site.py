#!/usr/bin/env python3
"""Builds the course as a site of plain files, to be read without a network: `./raytree notes`.

    build_site.py --programs DIR --cache DIR [--out DIR] [--draft] [--no-api]

Exit codes: 0 done, 2 bad usage or a mistake in a text, with one sentence that says where, 130 interrupted.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "common/program"))
try:
    from children import Children, ignore_signals, raise_at_signals
    from site_builder import Site
    from course import ROOT, SiteError
except ImportError as error:
    print(f"raytree notes: {error}; the package is in the list site_packages of ./raytree", file=sys.stderr)
    sys.exit(2)

MARKER = ".raytree-site"  # says that a folder is a site, and ours to replace


def say(text):
    print(f"raytree notes: {text}", file=sys.stderr, flush=True)


def check_place(out):
    """A folder that is something else is not touched."""
    if out.exists() and (not out.is_dir() or (any(out.iterdir()) and not (out / MARKER).exists())):
        raise SiteError(f"{out} exists and is not a site that was built here; name another folder with --out")


def replace(built, out):
    """Puts the new site in the place of the old one."""
    check_place(out)
    if out.exists():
        old = pathlib.Path(tempfile.mkdtemp(prefix=f".{out.name}-old-", dir=out.parent)) / "site"
        out.rename(old)
        built.rename(out)
        shutil.rmtree(old.parent)
    else:
        built.rename(out)


def main():
    parser = argparse.ArgumentParser(prog="./raytree notes", description="Builds the course as a site of plain files.")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/site", metavar="DIR", help="where the site goes (out/site)")
    parser.add_argument("--open", action="store_true", help="open it in the browser afterwards")
    parser.add_argument("--draft", action="store_true", help="small, rough pictures: faster the first time")
    parser.add_argument("--no-api", action="store_true", help="without the functions of common/ (needs Doxygen)")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release/bin", help=argparse.SUPPRESS)
    parser.add_argument("--cache", type=pathlib.Path, default=ROOT / "build/release/site", help=argparse.SUPPRESS)
    given = parser.parse_args()
    children = Children()
    raise_at_signals(children)
    started, out = time.time(), given.out.resolve()
    try:
        check_place(out)
        out.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=f".{out.name}-", dir=out.parent) as folder:
            built = pathlib.Path(folder) / "site"
            built.mkdir()
            api = not given.no_api and bool(shutil.which("doxygen"))
            if not api and not given.no_api:
                say("without the functions of common/: doxygen is not installed")
            count = Site(built, given.programs.resolve(), given.cache.resolve(), given.draft, api, say, children).build()
            (built / MARKER).write_text("")
            built.chmod(0o755)
            ignore_signals()
            replace(built, out)
    except SiteError as error:
        say(error)
        return 2
    except OSError as error:
        say(f"{error.filename or out}: {error.strerror}")
        return 2
    except KeyboardInterrupt:
        say("interrupted; nothing was changed")
        return 130
    say(f"{count} pages in {time.time() - started:.1f} s")
    print(out / "index.html")
    if given.open:
        subprocess.run(["xdg-open", out / "index.html"], check=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())
