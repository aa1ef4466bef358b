// Lesson 07: what a cap costs and what it leaves out, between two facing mirrors that are also diffuse.
widget("cap", {
  label: "The depth cap",
  view: [320, 236],
  sliders: [
    { id: "depth", label: "MAXDEPTH", min: 0, max: 10, step: 1, value: 4 },
    { id: "s", label: "share s of the mirrors", min: 0, max: 0.99, step: 0.01, value: 0.6, places: 2 },
    { id: "lamp", label: "brightest radiance", min: 1, max: 100, step: 1, value: 1 },
  ],
  numbers: [
    { id: "tree", label: "rays if all split", places: 0 }, { id: "chain", label: "rays of mirrors", places: 0 },
    { id: "left", label: "throughput left", places: 5 }, { id: "error", label: "the pixel lacks", places: 4 },
  ],
  update({ depth, s, lamp }, show, d) {
    const [tree, chain, left, pixel, error] = ask("cap", depth, s, lamp);
    show("tree", tree);
    show("chain", chain);
    show("left", left);
    show("error", error);
    // The tree, as far as there is room: deeper levels are hatched by their number.
    d.at(0, 0, 1, -1);
    const shown = Math.min(depth, 5), step = 22;
    for (let level = 0; level <= shown + 1; ++level) {
      const cut = level > depth;
      if (level === shown + 1 && !cut) continue;
      const count = 2 ** level, wide = 292 / count;
      for (let i = 0; i < count; ++i) {
        const x = 14 + wide * (i + 0.5), y = 14 + level * step;
        if (level) d.add("line", `twig ${cut ? "cut" : i % 2 ? "transmitted" : "reflected"}`, { x1: 14 + 2 * wide * (Math.floor(i / 2) + 0.5), y1: y - step, x2: x, y2: y });
      }
    }
    for (let level = 0; level <= shown; ++level) {
      const count = 2 ** level, wide = 292 / count;
      for (let i = 0; i < count; ++i) d.add("circle", `dot ${level ? (i % 2 ? "transmitted" : "reflected") : "camera"}`, { cx: 14 + wide * (i + 0.5), cy: 14 + level * step, r: level > 4 ? 3 : 4 });
    }
    if (depth > 5) d.text(160, 14 + 5 * step + 17, `.. and so on, ${depth - 5} more ${depth === 6 ? "level" : "levels"}`, "small");
    d.text(14, 172, "the pixel between the mirrors", "small", "start");
    d.at(14, 204, 292, 1);
    d.box(0, 0, 1, 20, "rest");
    d.box(0, 0, pixel / lamp, 20, "bar camera");
    d.text(0, -14, `${digits(pixel, 3)} of ${digits(lamp, 0)}`, "small", "start");
    d.text(1, -14, `missing ${digits(error, 3)}`, "small blocked", "end");
    return `MAXDEPTH = ${depth}: up to ${tree} ${tree === 1 ? "ray" : "rays"} through glass, ${chain} between mirrors. What is not traced counts ${digits(left, 4)}: the pixel lacks ${digits(error, 3)}.`;
  },
});
