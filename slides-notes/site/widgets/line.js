// Lesson 00: a line through two points, its implicit form, normal and distance.
const coordinate = (id, label, value) => ({ id, label, min: -5, max: 5, step: 1, value });

widget("line", {
  label: "A line through P and Q",
  view: [320, 260],
  sliders: [coordinate("px", "P<sub>x</sub>", -3), coordinate("py", "P<sub>y</sub>", 0), coordinate("qx", "Q<sub>x</sub>", 2), coordinate("qy", "Q<sub>y</sub>", 2)],
  numbers: [
    { id: "slope", label: "slope a = \u0394y/\u0394x" }, { id: "intercept", label: "intercept b" },
    { id: "A", label: "A", places: 0 }, { id: "B", label: "B", places: 0 }, { id: "C", label: "C", places: 0 },
    { id: "distance", label: "distance |C| / |n|" },
  ],
  update({ px, py, qx, qy }, show, d) {
    const [A, B, C, distance, isLine, hasSlope, a, b, unitC] = ask("line", px, py, qx, qy);
    show("slope", hasSlope ? a : undefined);
    show("intercept", hasSlope ? b : undefined);
    show("A", A);
    show("B", B);
    show("C", C);
    show("distance", isLine ? distance : undefined);
    d.at(160, 130, 21);
    for (let i = -7; i <= 7; ++i) {
      d.line(i, -6, i, 6, i ? "grid" : "axis");
      if (Math.abs(i) < 7) d.line(-7.4, i, 7.4, i, i ? "grid" : "axis");
    }
    if (isLine) {
      const long = Math.hypot(qx - px, qy - py), [ux, uy] = [((qx - px) / long) * 20, ((qy - py) / long) * 20];
      d.line(px - ux, py - uy, px + ux, py + uy, "curve camera");
      // The foot of the origin: -C n for the form with a unit normal.
      const n = C === 0 ? 0 : unitC / C, [nx, ny] = [A * n || A / long, B * n || B / long];
      d.line(0, 0, -unitC * nx, -unitC * ny, "measure");
      d.arrow((px + qx) / 2, (py + qy) / 2, (px + qx) / 2 + nx * 2, (py + qy) / 2 + ny * 2, "normal");
      d.text((px + qx) / 2 + nx * 2.7, (py + qy) / 2 + ny * 2.7, "n", "name normal");
    }
    for (const [x, y, name] of [[px, py, "P"], [qx, qy, "Q"]]) {
      d.circle(x, y, 5, "dot camera");
      d.text(x, y + 0.9, name, "name camera");
    }
    if (!isLine) return "P and Q are the same point: there is no line through them alone.";
    const signed = (value) => `${value < 0 ? "\u2212" : "+"} ${digits(Math.abs(value), 0)}`;
    const implicit = `${digits(A, 0)} x ${signed(B)} y ${signed(C)} = 0`;
    return `${implicit}. ${hasSlope ? "" : "A vertical line has no slope. "}The normal is n = (${digits(A, 0)}, ${digits(B, 0)}); the line is ${digits(distance, 2)} from the origin.`;
  },
});
