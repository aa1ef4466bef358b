"""The four things that are measured. Each gives rows for a CSV file."""
import json
import os
import shutil

from bench_run import Failed, in_turns, instructions, median, povray

KINDS = ("camera", "shadow", "reflected", "transmitted")


def short(scene):
    return scene.rsplit("/", 1)[-1]


def variants_of(runner, options):
    """Who traces: (name, program, options)."""
    found = [("double", "bench_picture", ()), ("float", "bench_picture", ("--real", "float")),
             ("long double", "bench_picture", ("--real", "long-double")),
             ("double, baseline", "bench_picture", ("--instructions", "baseline")),
             ("double, 2 threads", "bench_picture", ("--threads", "2"))]
    if (os.cpu_count() or 1) < 2:
        found.pop()
    if options.peers and runner.has("bench_embree"):
        found.append(("Embree", "bench_embree", ()))
    if options.peers and shutil.which("povray"):
        found.append(("POV-Ray", "povray", ()))
    return found


def measure_pictures(runner, options, progress):
    """All variants in turns, scene by scene; speed, rays by kind, PSNR against double."""
    rows, variants = [], variants_of(runner, options)
    for n, scene in enumerate(options.scenes, 1):
        ours, psnr, counted = {}, {}, {}
        turns = [list(variant) for variant in variants]

        def first_look(name, program, extra):
            """Rays and picture, which are the same in every round."""
            out = f"{program}{len(counted)}." + ("png" if program == "povray" else "exr")
            if program == "povray":
                runner.run("scene_to_pov", scene, "--size", options.size, "--out", "scene.pov")
                counted[name] = povray(runner, "scene.pov", options.size, out)
            else:
                count = ("--count",) if program == "bench_picture" else ()
                counted[name] = runner.json(program, scene, "--size", options.size, "--out", out, *count, *extra)
            ours.setdefault("picture", out)
            if out != ours["picture"]:
                psnr[name] = json.loads(runner.run("picture_psnr", out, ours["picture"])[0])["psnr"]

        left_out = []
        for variant in turns:
            try:
                first_look(*variant)
            except Failed as error:
                if variant[1] == "bench_picture":
                    raise
                left_out.append(variant)
                progress(f"{short(scene)}: {error}", 1, 1)
        turns = [variant for variant in turns if variant not in left_out]

        def once(variant):
            name, program, extra = variant
            if program == "povray":
                return povray(runner, "scene.pov", options.size, "turn.png")
            said = runner.json(program, scene, "--size", options.size, *extra)
            return {"cpu": said["cpu"][0], "wall": said["wall"][0]}

        results = in_turns(options.rounds, turns, once,
                           lambda step, steps: progress(f"pictures {n}/{len(options.scenes)} {short(scene)}", step, steps))
        base = counted["double"]
        work = sum(base["rays"].values())
        for (name, program, _), found in zip(turns, results):
            said = counted[name]
            row = {"scene": short(scene), "who": name, "size": options.size, "rounds": options.rounds,
                   "spheres": base["spheres"], "instructions": said.get("instructions", "")}
            if program == "povray":
                # It counts the rays that it makes, also those too deep to be followed.
                row.update({kind: said[kind] for kind in ("reflected", "transmitted")})
                row["rays_equal"] = all(said[kind] == base["rays"][kind] + base["capped"][kind]
                                        for kind in ("reflected", "transmitted"))
            else:
                row.update(said["rays"])
                row["too_deep"] = sum(said["capped"].values())
                row["rays_equal"] = said["rays"] == base["rays"]
                row["bytes"] = said["bytes"]
                row["bytes_a_sphere"] = round(said["bytes"] / max(1, said["spheres"]), 1)
            row["psnr_db"] = psnr.get(name, "")
            cpu, wall = [r["cpu"] for r in found], [r["wall"] for r in found]
            # One divisor for all: the work is the picture's. Ratios are taken within a round.
            row["cpu_seconds"], row["wall_seconds"] = median(cpu), median(wall)
            row["ns_a_ray"] = median(cpu) / work * 1e9
            row["mray_per_second"] = work / max(median(cpu), 1e-9) / 1e6
            row["cpu_by_double"] = median([c / max(r["cpu"], 1e-9) for c, r in zip(cpu, results[0])])
            row["wall_by_double"] = median([w / max(r["wall"], 1e-9) for w, r in zip(wall, results[0])])
            rows.append(row)
    return rows


def count_instructions(runner, options, progress):
    """Instructions a ray: two sizes, of which the difference leaves out start-up, reading and building."""
    sizes = ("24x18", "48x36") if options.quick else ("128x96", "256x192")
    # valgrind computes long double in 64 bits: directions do not have unit length then, and nothing is found by boxes.
    variants = [v for v in variants_of(runner, options) if "threads" not in v[0] and v[0] != "long double"]
    rows, steps = [], len(options.scenes) * len(variants)
    for scene in options.scenes:
        rays = [sum(runner.json("bench_picture", scene, "--size", size, "--count")["rays"].values()) for size in sizes]
        for name, program, extra in variants:
            counts = []
            try:
                for size in sizes:
                    if program == "povray":
                        runner.run("scene_to_pov", scene, "--size", size, "--out", "c.pov")
                        width, height = size.split("x")
                        # .ppm: no time goes into compression.
                        command = ("povray", "+Ic.pov", "+Oc.ppm", "+FP16", f"+W{width}", f"+H{height}", "-A", "-D", "+WT1")
                    else:
                        command = (program, scene, "--size", size, *extra)
                    counts.append(instructions(runner, *command))
            except Failed as error:
                if program == "bench_picture":
                    raise
                progress(f"{short(scene)}: {error}", 1, 1)
                continue
            rows.append({"scene": short(scene), "who": name, "sizes": " ".join(sizes), "rays": rays[1] - rays[0],
                         "instructions_a_ray": round((counts[1] - counts[0]) / (rays[1] - rays[0]), 1)})
            progress("instructions", min(len(rows), steps), steps)
    return rows


def measure_parts(runner, options, progress):
    """Google Benchmark's medians."""
    least = "0.005" if options.quick else "0.1"
    progress("parts", 0, 1)
    said = json.loads(runner.run("bench_parts", f"--benchmark_min_time={least}", "--benchmark_format=json",
                                 f"--benchmark_repetitions={1 if options.quick else 5}",
                                 "--benchmark_enable_random_interleaving=true")[0])
    progress("parts", 1, 1)
    found = {}
    for run in said["benchmarks"]:
        if run["run_type"] == "iteration":
            found.setdefault(run["run_name"], []).append(run["cpu_time"])
    rows = []
    for name, times in found.items():
        words = name.split("/")
        rows.append({"part": words[0], "scene": words[1] if len(words) > 2 else "", "real": words[-1],
                     "cpu_ns": round(median(times), 2), "rounds": len(times)})
    return rows


def growth_plan(options):
    """(what, x, arguments of bench_picture)"""
    size = "64x48" if options.quick else "512x384"
    plan = [("spheres", n, (f"s5:{n}", "--size", size)) for n in
            (10 ** k for k in range(0, 4 if options.quick else 7))]
    plan += [(f"depth of {scene}", d, (scene, "--size", size, "--depth", d)) for scene in ("s4", "s5")
             for d in ((1, 4) if options.quick else (1, 2, 4, 8, 16, 32))]
    plan += [("pixels of s4", w * w * 3 // 4, ("s4", "--size", f"{w}x{w * 3 // 4}")) for w in
             ((32, 64) if options.quick else (64, 128, 256, 512, 1024, 2048))]
    plan += [("lights of s4", n, ("s4", "--size", size, "--lights", n)) for n in ((1, 4) if options.quick else (1, 2, 4, 8, 16, 32))]
    threads, cores = [1], os.cpu_count() or 1
    while threads[-1] < cores:
        threads.append(min(2 * threads[-1], cores))
    plan += [("threads on s5", t, ("s5", "--size", size if options.quick else "1024x768", "--threads", t)) for t in threads]
    return plan


def measure_growth(runner, options, progress):
    """What a ray costs as one number grows, in double."""
    plan = growth_plan(options)
    rays = [sum(runner.json("bench_picture", *command, "--count")["rays"].values()) for _, _, command in plan]
    results = in_turns(max(1, options.rounds // 2), plan, lambda item: runner.json("bench_picture", *item[2]),
                       lambda step, steps: progress("growth", step, steps))
    rows = []
    for (what, x, _), count, found in zip(plan, rays, results):
        cpu, wall = median([r["cpu"][0] for r in found]), median([r["wall"][0] for r in found])
        rows.append({"what": what, "x": x, "rays": count, "cpu_seconds": cpu, "wall_seconds": wall,
                     "ns_a_ray": cpu / count * 1e9, "spheres": found[0]["spheres"], "bytes": found[0]["bytes"],
                     "bytes_a_sphere": round(found[0]["bytes"] / max(1, found[0]["spheres"]), 1),
                     "build_cpu_seconds": median([r["build_cpu"] for r in found]), "rounds": len(found)})
    return rows
