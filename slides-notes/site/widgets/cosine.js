// Lesson 01: what a lamp brings to a point of a floor.
widget("cosine", {
  label: "Angle and distance of a lamp",
  view: [320, 212],
  sliders: [
    { id: "angle", label: "angle from N to L", unit: "\u00b0", min: -110, max: 110, step: 1, value: 40 },
    { id: "distance", label: "distance (scene units)", min: 0.5, max: 3, step: 0.05, value: 1.5, places: 2 },
  ],
  numbers: [{ id: "NL", label: "max(0, N\u00b7L)" }, { id: "attenuation", label: "1 / dist\u00b2" }, { id: "direct", label: "product: the light that arrives", wide: true }],
  update({ angle, distance }, show, d) {
    const [NL, attenuation, direct, Lx, Ly] = ask("cosine", angle, distance);
    show("NL", NL);
    show("attenuation", attenuation);
    show("direct", direct);
    d.at(160, 150, 45);
    d.box(-3.6, -1.4, 7.2, 1.4, "ground");
    // As bright as the floor is there; above 1 it is simply white.
    d.add("ellipse", "spot", { cx: 160, cy: 154, rx: 30, ry: 4, "fill-opacity": Math.min(1, direct).toFixed(3) });
    d.line(-3.6, 0, 3.6, 0, "rule");
    const [x, y] = [Lx * distance, Ly * distance];
    d.line(0, 0, x, y, NL > 0 ? "ray reaches" : "ray blocked");
    d.arc(0, angle, 0.55);
    d.arrow(0, 0, 0, 1, "normal");
    d.text(0.22, 1.02, "N", "name normal");
    d.arrow(0, 0, Lx, Ly, NL > 0 ? "reaches" : "blocked");
    d.text(Lx * 0.72 + Ly * 0.24, Ly * 0.72 - Lx * 0.24, "L", `name ${NL > 0 ? "reaches" : "blocked"}`);
    d.circle(x, y, 8, "lamp");
    d.text(0, -0.42, "I", "name");
    if (NL === 0) return "The lamp is behind the surface: max(0, N\u00b7L) = 0, nothing arrives.";
    return `${digits(NL)} \u00b7 ${digits(attenuation)} = ${digits(direct)} of the lamp\u2019s light arrives.`;
  },
});
