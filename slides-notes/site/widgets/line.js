// Lesson 00: a line through two points, its implicit form, normal and distance.
const coordinate = (id, label, value) => ({ id, label, min: -5, max: 5, step: 1, value });

widget("line", {
  label: "A line through P and Q",
  view: [320, 260],
  sliders: [coordinate("px", "P<sub>x</sub>", -3), coordinate("py", "P<sub>y</sub>", 0), coordinate("qx", "Q<sub>x</sub>", 2), coordinate("qy", "Q<sub>y</sub>", 2)],
  numbers: [
    { id: "slope", label: "slope a = \u0394y/\u0394x" }, { id: "intercept", label: "intercept b" },
    { id: "A", label: "A", places: 0 }, { id: "B", label: "B", places: 0 }, { id: "C", label: "C", places: 0 },
    { id: "distance", label: "d = |C| / |n|" },
  ],
  update({ px, py, qx, qy }, show, d) {
    const [A, B, C, distance, isLine, hasSlope, a, b, unitC] = ask("line", px, py, qx, qy);
    show("slope", hasSlope ? a : undefined);
    show("intercept", hasSlope ? b : undefined);
    show("A", A);
    show("B", B);
    show("C", C);
    show("distance", isLine ? distance : undefined);
    d.at(160, 130, 17.5);
    for (let i = -9; i <= 9; ++i) {
      d.line(i, -7.4, i, 7.4, i ? "grid" : "axis");
      if (Math.abs(i) < 8) d.line(-9.1, i, 9.1, i, i ? "grid" : "axis");
    }
    if (isLine) {
      const long = Math.hypot(qx - px, qy - py), [ux, uy] = [((qx - px) / long) * 20, ((qy - py) / long) * 20];
      d.line(px - ux, py - uy, px + ux, py + uy, "curve camera");
      // The foot of the origin: -C n for the form with a unit normal.
      const n = C === 0 ? 0 : unitC / C, [nx, ny] = [A * n || A / long, B * n || B / long];
      d.line(0, 0, -unitC * nx, -unitC * ny, "measure");
      if (distance > 0.6) d.text((-unitC * nx) / 2 - ny * 0.6, (-unitC * ny) / 2 + nx * 0.6, "d", "small halo");
      // The normal stands where there is room: away from the foot, inside the figure.
      const places = [0.5, 0.5 - 3 / long, 0.5 + 3 / long].map((t) => [px + t * (qx - px), py + t * (qy - py)]);
      const room = ([x, y]) => (Math.abs(x) > 7 || Math.abs(y) > 5.3 ? -1 : Math.hypot(x + unitC * nx, y + unitC * ny));
      const [x, y] = places.reduce((best, place) => (room(place) > room(best) ? place : best));
      d.arrow(x, y, x + nx * 1.4, y + ny * 1.4, "normal");
      d.text(x + nx * 1.85, y + ny * 1.85, "n", "name normal halo");
    }
    const long = Math.hypot(qx - px, qy - py) || 1; // names stand on the side to which n does not point
    for (const [x, y, name] of [[px, py, "P"], [qx, qy, "Q"]]) {
      d.circle(x, y, 5, "dot camera");
      d.text(x - (0.85 * A) / long, y - (0.85 * B) / long + (isLine ? 0 : 0.9), name, "name camera halo");
    }
    if (!isLine) return "P and Q are the same point: there is no line through them alone.";
    const signed = (value) => `${value < 0 ? "\u2212" : "+"} ${digits(Math.abs(value), 0)}`;
    const implicit = `${digits(A, 0)} x ${signed(B)} y ${signed(C)} = 0`;
    return `${implicit}. ${hasSlope ? "" : "A vertical line has no slope. "}The normal is n = (${digits(A, 0)},\u00a0${digits(B, 0)}); the line is ${digits(distance, 2)} from the origin.`;
  },
});
