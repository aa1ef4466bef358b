#!/usr/bin/env python3
"""./raytree bench: how fast, by whole pictures, parts, growth and instructions, side by side with POV-Ray and Embree.

    bench.py --programs FOLDER [--quick] [--out DIR] [--scenes s1,s5] [--no-peers] ...
"""
import argparse
import os
import pathlib
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent), str(pathlib.Path(__file__).resolve().parents[2] / "common/program")]
import bench_page
from bench_phases import count_instructions, measure_growth, measure_parts, measure_pictures
from bench_report import csv_text, replace_section
from children import Children, ignore_signals, raise_at_signals
from bench_run import Failed, Progress, Runner, machine, missing

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE, PICTURES = ROOT / "slides-notes/benchmark.md", ROOT / "slides-notes/pictures"


def arguments():
    parser = argparse.ArgumentParser(
        prog="bench", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Measures the tracer: whole pictures of s1 to s6 beside POV-Ray 3.7 and Embree where these are installed,\n"
                    "its parts, how cost grows, and instructions a ray. All in interleaved rounds, CPU time, medians.",
        epilog="Examples:\n"
               "  bench --quick                       rough, two minutes\n"
               "  bench --scenes s4,s5:1000 --no-growth --no-parts\n"
               "  bench --notes                       the page slides-notes/benchmark.md anew: ten minutes on a quiet machine\n"
               "Exit codes: 0 done, 2 bad input or usage, 130 interrupted.")
    parser.error = lambda message: fail(f"bench: {message} (see --help)")
    parser.add_argument("--programs", default=str(ROOT / "build/release/bin"), metavar="DIR", help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help="small pictures, few rounds")
    parser.add_argument("--out", default="out/bench", metavar="DIR", help="folder for the report, default out/bench")
    parser.add_argument("--scenes", default="s1,s2,s3,s4,s5,s6", metavar="A,B",
                        help="s1 .. s6, s5:N, s6:LEVELS or files, default all six")
    parser.add_argument("--size", metavar="WxH", help="of the whole pictures, default 1024x768, 256x192 with --quick")
    parser.add_argument("--rounds", type=int, metavar="N", help="default 7, 3 with --quick")
    for what, text in (("peers", "no POV-Ray, no Embree"), ("parts", "no parts by Google Benchmark"), ("growth", "no growth"),
                       ("instructions", "no instructions by callgrind")):
        parser.add_argument(f"--no-{what}", dest=what, action="store_false", help=text)
    parser.add_argument("--notes", action="store_true", help="also put tables and plots into slides-notes/benchmark.md")
    options = parser.parse_args()
    options.scenes = [scene for scene in options.scenes.split(",") if scene]
    if not options.scenes:
        fail("bench: --scenes: expected at least one scene, as in s1,s5")
    options.scenes = [str(pathlib.Path(scene).resolve()) if scene.endswith(".toml") else scene for scene in options.scenes]
    options.size = options.size or ("256x192" if options.quick else "1024x768")
    sides = options.size.split("x")
    if len(sides) != 2 or not all(side.isdigit() and 1 <= int(side) <= 16384 for side in sides):
        fail(f"bench: --size: expected WxH, each from 1 to 16384, as in 640x480; got \"{options.size}\"")
    options.rounds = (3 if options.quick else 7) if options.rounds is None else options.rounds
    if not 1 <= options.rounds <= 1000:
        fail(f"bench: --rounds: expected 1 to 1000, got {options.rounds}")
    return options


def fail(message):
    print(message, file=sys.stderr)
    sys.exit(2)


def check_folder(folder):
    """The folder exists and is writable, or can be made."""
    there = pathlib.Path(folder).absolute()
    while not there.exists():
        there = there.parent
    if not there.is_dir():
        fail(f"bench: {folder}: expected a folder, but {there} is a file")
    if not os.access(there, os.W_OK):
        fail(f"bench: {folder}: the folder {there} is not writable")


def write(path, text):
    """Whole or not at all."""
    part = path.with_name(path.name + ".part")
    part.write_text(text)
    part.replace(path)


def measure(runner, options):
    """File name -> text, of all that was asked for."""
    progress, rows, files = Progress(), {}, {}
    rows["pictures"] = measure_pictures(runner, options, progress)
    if options.instructions and shutil.which("valgrind"):
        rows["instructions"] = count_instructions(runner, options, progress)
    if options.parts and runner.has("bench_parts"):
        rows["parts"] = measure_parts(runner, options, progress)
    if options.growth:
        rows["growth"] = measure_growth(runner, options, progress)
    for name, found in rows.items():
        files[f"{name}.csv"] = csv_text(found)
    files.update(bench_page.plots(rows))
    files["benchmark.md"] = bench_page.page(rows, options, machine(runner), "")
    return rows, files


def main():
    children = Children()
    raise_at_signals(children)
    options = arguments()
    check_folder(options.out)
    with tempfile.TemporaryDirectory(prefix="raytree-bench-") as folder:
        runner = Runner(options.programs, folder, children)
        try:
            for line in missing(runner):
                print(line, file=sys.stderr)
            if not runner.has("bench_picture"):
                raise Failed(f"{options.programs} has no program bench_picture; build bench_programs first")
            rows, files = measure(runner, options)
        finally:
            children.stop()
        about = machine(runner)
    # From here on files are written, each whole; that takes no time worth an interruption.
    ignore_signals()
    out = pathlib.Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        write(out / name, text)
        print(out / name)
    if options.notes:
        for name, text in files.items():
            if name.endswith(".svg"):
                write(PICTURES / f"benchmark_{name}", text)
        tables = bench_page.page(rows, options, about, "pictures/benchmark_")
        write(PAGE, replace_section(PAGE.read_text(), "tables", tables))


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        print("\ninterrupted: nothing was written", file=sys.stderr)
        sys.exit(130)
    except (Failed, OSError) as error:
        fail(f"bench: {error}")
