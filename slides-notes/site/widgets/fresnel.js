// Lesson 06: how much is reflected at each angle, exactly and after Schlick.
widget("fresnel", {
  label: "How much is reflected",
  view: [320, 262],
  sliders: [
    incidence(90, 60), index("n1", "n\u2081, where the light comes from", 1), index("n2", "n\u2082, behind", 1.5),
  ],
  numbers: [
    { id: "Fr", label: "F<sub>r</sub>, reflected", places: 4 }, { id: "Ft", label: "F<sub>t</sub> = 1 \u2212 F<sub>r</sub>", places: 4 },
    { id: "s", label: "r<sub>s</sub>\u00b2", places: 4 }, { id: "p", label: "r<sub>p</sub>\u00b2", places: 4 },
    { id: "schlick", label: "Schlick", places: 4 }, { id: "difference", label: "Schlick \u2212 F<sub>r</sub>", places: 4 },
    { id: "brewster", label: "Brewster\u2019s angle" }, { id: "critical", label: "critical angle" },
  ],
  update({ angle, n1, n2 }, show, d) {
    const [Fr, schlick, s, p, Ft, critical, brewster] = ask("fresnel", angle, n1, n2);
    Object.entries({ Fr, Ft, s, p, schlick }).forEach(([name, value]) => show(name, value));
    show("difference", schlick - Fr);
    show("brewster", brewster < 0 ? undefined : brewster, brewster < 0 ? "none" : `${digits(brewster, 2)}\u00b0`);
    show("critical", critical < 0 ? undefined : critical, critical < 0 ? "none" : `${digits(critical, 2)}\u00b0`);

    d.at(34, 188, 3.05, 165);
    for (const y of [0, 0.25, 0.5, 0.75, 1]) {
      d.line(0, y, 90, y, y ? "grid" : "rule");
      d.text(-2, y, String(y), "small", "end");
    }
    for (const x of [0, 30, 60, 90]) d.text(x, -0.06, `${x}\u00b0`, "small");
    if (critical >= 0) d.box(critical, 0, 90 - critical, 1, "forbidden");
    const curves = [[], [], [], []];
    const samples = Array.from({ length: 181 }, (_, i) => i / 2);
    if (critical >= 0) samples.push(critical - 0.01, critical - 0.1, critical, critical - 0.3);
    for (const x of samples.sort((a, b) => a - b)) {
      const at = ask("fresnel", x, n1, n2);
      [at[2], at[3], at[1], at[0]].forEach((y, i) => curves[i].push([x, y]));
    }
    ["curve thin spol", "curve thin ppol", "curve dashed schlick", "curve reflected"].forEach((className, i) => d.path(curves[i], className));
    const mark = (x, name) => {
      if (x < 0) return;
      d.line(x, 0, x, 1, "limit");
      d.text(x - 2, 0.9, name, "small halo", "end");
    };
    mark(brewster, "Brewster");
    if (critical >= 0) d.text(Math.min((critical + 90) / 2, 75), 0.6, "total reflection", "small halo");
    d.line(angle, 0, angle, 1, "here");
    d.circle(angle, schlick, 4, "dot schlick");
    d.circle(angle, Fr, 5, "dot reflected");
    [["exact", "reflected"], ["Schlick", "schlick dashed"], ["s", "spol thin"], ["p", "ppol thin"]].forEach(([name, className], i) => {
      const x = 3 + [0, 23, 51, 68][i];
      d.line(x, -0.165, x + 7, -0.165, `curve ${className}`);
      d.text(x + 9, -0.165, name, "small", "start");
    });
    d.at(34, 254, 274.5, 1);
    d.box(0, 0, Fr, 18, "bar reflected");
    d.box(Fr, 0, Ft, 18, "bar transmitted");
    d.text(-0.02, 9, "1", "small", "end");
    if (Fr > 0.2) d.text(Fr / 2, 9, "reflected", "small ink");
    if (Ft > 0.24) d.text(Fr + Ft / 2, 9, "transmitted", "small ink");
    return critical >= 0 && angle >= critical
      ? `Beyond ${digits(critical, 1)}\u00b0 all light is reflected: Fr = 1.`
      : `${digits(100 * Fr, 1)} % reflected, ${digits(100 * Ft, 1)} % transmitted, together 100 %. Schlick says ${digits(100 * schlick, 1)} %.`;
  },
});
