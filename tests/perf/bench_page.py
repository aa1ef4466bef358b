"""The page of the docs: our own figures, the goals beside them, and how to repeat them."""
import math

from bench_report import number, svg, table

# Instructions a ray of the best single-ray tracers that were tried as prototypes, in float.
BEST_INSTRUCTIONS = {"s4": 167, "s5": 327, "s6": 398}
PARTS = ("sphere", "box", "node", "intersect", "occluded", "trace", "tree")


def only(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def one(rows, **wanted):
    found = only(rows, **wanted)
    return found[0] if found else None


def in_order(values):
    return list(dict.fromkeys(values))


CAPTIONS = {"spheres": "What a ray costs among one to a million spheres", "memory": "Memory a sphere takes, with its share of the scene",
            "depth": "The time of a picture as rays may go deeper", "resolution": "The time of a picture of more pixels",
            "lights": "The time of a picture with more lamps", "threads": "Pictures a second with more threads"}


def plots(rows):
    """File name -> SVG."""
    files, growth = {}, rows.get("growth", [])
    def curve(what, y):
        return [(row["x"], y(row)) for row in only(growth, what=what) if y(row) > 0]
    plan = {"spheres": ("Spheres", "spheres", "ns a ray, CPU time", {"double": ("spheres", lambda r: r["ns_a_ray"])}),
            "memory": ("Memory", "spheres", "bytes a sphere", {"double": ("spheres", lambda r: r["bytes_a_sphere"])}),
            "depth": ("MAXDEPTH", "MAXDEPTH", "CPU seconds a picture",
                      {s: (f"depth of {s}", lambda r: r["cpu_seconds"]) for s in ("s4", "s5")}),
            "resolution": ("Resolution", "pixels", "CPU seconds a picture", {"s4": ("pixels of s4", lambda r: r["cpu_seconds"])}),
            "lights": ("Lights", "lights", "CPU seconds a picture", {"s4": ("lights of s4", lambda r: r["cpu_seconds"])}),
            "threads": ("Threads", "threads", "pictures a second", {"s5": ("threads on s5", lambda r: 1 / max(1e-9, r["wall_seconds"]))})}
    for name, (title, x, y, wanted) in plan.items():
        curves = {key: points for key, (what, f) in wanted.items() if len(points := curve(what, f)) > 1}
        if curves:
            files[f"{name}.svg"] = svg(title, x, y, curves)
    return files


def cell(row, key):
    return number(row[key]) if row and row.get(key) not in (None, "") else "-"


def pictures_text(rows):
    scenes, names = in_order(row["scene"] for row in rows), in_order(row["who"] for row in rows)
    text = "Million rays a second of CPU time: camera, shadow, reflected and transmitted rays. In parentheses how many times the CPU time of double.\n\n"
    text += table(["", *scenes], [[name, *(f"{cell(r, 'mray_per_second')} ({cell(r, 'cpu_by_double')})"
                                           for r in (one(rows, scene=s, who=name) for s in scenes))] for name in names])
    text += "\nThe same as nanoseconds a ray.\n\n"
    text += table(["", *scenes], [[name, *(cell(one(rows, scene=s, who=name), "ns_a_ray") for s in scenes)] for name in names])
    text += "\nRays of one picture, and memory of the scene in double.\n\n"
    base = [one(rows, scene=s, who="double") for s in scenes]
    text += table(["", *scenes], [[kind.replace("_", " "), *(f"{r[kind]:,}" for r in base)]
                                  for kind in ("camera", "shadow", "reflected", "transmitted", "too_deep")] +
                  [["spheres", *(f"{r['spheres']:,}" for r in base)], ["bytes a sphere", *(number(r["bytes_a_sphere"]) for r in base)]])
    peers = [name for name in names if name in ("POV-Ray", "Embree", "float", "long double")]
    text += ("\n**The same picture?** PSNR against double in dB on linear values, peak 1, and whether all rays are as many. POV-Ray's "
             "picture has 16 bits a channel, which alone are 107 dB; it counts reflected and refracted rays, those too deep to be followed too.\n\n")
    def same(row):
        if not row:
            return "-"
        # 999 stands for no difference in the 24 bits of an .exr.
        return f"{'same' if row['psnr_db'] == 999 else cell(row, 'psnr_db')}, {'equal' if row['rays_equal'] else 'not equal'}"
    text += table(["", *scenes], [[name, *(same(one(rows, scene=s, who=name)) for s in scenes)] for name in peers])
    return text


def growth_text(rows, folder, files):
    spheres = only(rows, what="spheres")
    text = table(["spheres", "ns a ray", "bytes a sphere", "built in, CPU ms"],
                 [[f"{r['x']:,}", number(r["ns_a_ray"]), number(r["bytes_a_sphere"]), number(r["build_cpu_seconds"] * 1e3)] for r in spheres])
    for name in files:
        text += f"\n![{CAPTIONS[name[:-4]]}]({folder}{name})\n"
    return text


def goals(rows):
    """(goal, figure, met) for each goal that was measured."""
    found, pictures = [], rows["pictures"]
    def add(goal, values, least=None, most=None):
        values = [(s, v) for s, v in values if v is not None]
        if not values:
            return
        met = all((least is None or v >= least) and (most is None or v <= most) for _, v in values)
        found.append([goal, ", ".join(f"{s} {number(v)}".strip() for s, v in values), "yes" if met else "no"])
    def ratio(scene, who, key="cpu_by_double"):
        row = one(pictures, scene=scene, who=who)
        return row[key] if row else None
    for peer, scenes, least in (("POV-Ray", ("s1", "s2", "s3", "s4"), 15), ("POV-Ray", ("s5", "s6"), 10), ("Embree", ("s5", "s6"), 1.5)):
        add(f"double at least {least} times as fast as {peer}", [(s, ratio(s, peer)) for s in scenes], least=least)
    for scene, best in BEST_INSTRUCTIONS.items():
        row = one(rows.get("instructions", []), scene=scene, who="float")
        add(f"float: at most {best * 1.25:.0f} instructions a ray", [(scene, row["instructions_a_ray"] if row else None)], most=best * 1.25)
    two = [(s, ratio(s, "double, 2 threads", "wall_by_double")) for s in in_order(r["scene"] for r in pictures)]
    add("2 threads at least 1.9 times as fast as 1", [(s, 1 / v) for s, v in two if v], least=1.9)
    spheres = {r["x"]: r for r in only(rows.get("growth", []), what="spheres")}
    if 100 in spheres and 1_000_000 in spheres:
        add("cost per ray grows like log N: at most 3 times from 10² to 10⁶ spheres",
            [("", spheres[1_000_000]["ns_a_ray"] / spheres[100]["ns_a_ray"])], most=math.log(1e6) / math.log(1e2))
        add("at most 200 bytes a sphere, 10⁶ spheres", [("", spheres[1_000_000]["bytes_a_sphere"])], most=200)
        add("10⁶ spheres built in at most 3 s of CPU time", [("", spheres[1_000_000]["build_cpu_seconds"])], most=3)
    return found


def page(rows, options, machine, folder):
    text = f"Measured on: {machine}. Pictures of {options.size} pixels, depth 8, {options.rounds} interleaved rounds, medians"
    text += "; **quick, so rough**.\n\n" if options.quick else ".\n\n"
    text += "## Goals\n\n" + table(["goal", "measured", "met"], goals(rows))
    text += "\n## Whole pictures\n\n" + pictures_text(rows["pictures"])
    if "instructions" in rows:
        found = rows["instructions"]
        scenes, names = in_order(r["scene"] for r in found), in_order(r["who"] for r in found)
        text += "\n## Instructions a ray\n\nBy callgrind, one thread; two sizes, of which the difference leaves out start-up and building.\n\n"
        text += table(["", *scenes], [[n, *(cell(one(found, scene=s, who=n), "instructions_a_ray") for s in scenes)] for n in names])
    if "parts" in rows:
        found = rows["parts"]
        reals = [real for real in ("float", "double", "long-double") if only(found, real=real)]
        text += "\n## Parts\n\nNanoseconds of CPU time a call. Box: one box in scalar code, as in textbooks; node: a tree of eight spheres.\n\n"
        text += table(["part", "scene", *(real.replace("-", " ") for real in reals)],
                      [[part, scene, *(cell(one(found, part=part, scene=scene, real=real), "cpu_ns") for real in reals)]
                       for part in PARTS for scene in sorted({r["scene"] for r in only(found, part=part)})])
    if "growth" in rows:
        text += "\n## Growth\n\nIn double. Plots have two logarithmic axes.\n\n" + growth_text(rows["growth"], folder, plots(rows))
    return text
