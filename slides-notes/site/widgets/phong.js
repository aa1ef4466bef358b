// Lesson 08: the light that leaves in each direction.
widget("phong", {
  label: "Diffuse and glossy",
  view: [320, 212],
  sliders: [
    { id: "exponent", label: "exponent \u03b1", min: 0, max: 3, step: 0.05, value: 1.3, value_of: (v) => 10 ** v, places: 1 },
    { id: "glossy", label: "glossy share f", min: 0, max: 1, step: 0.01, value: 0.7, places: 2 },
    { id: "light", label: "lamp L, from N", unit: "\u00b0", min: -80, max: 80, step: 1, value: -35 },
    { id: "eye", label: "eye V, from N", unit: "\u00b0", min: -89, max: 89, step: 1, value: 45 },
  ],
  numbers: [
    { id: "diffuse", label: "N\u00b7L" }, { id: "gloss", label: "(V\u00b7R)<sup>\u03b1</sup>" },
    { id: "value", label: "(1 \u2212 f)(N\u00b7L) + f (V\u00b7R)<sup>\u03b1</sup>", wide: true },
    { id: "half", label: "half as bright at", wide: true },
  ],
  update({ exponent, glossy, light, eye }, show, d) {
    const [value, diffuse, gloss, half, mirror] = ask("phong", exponent, glossy, light, eye);
    show("value", value);
    show("diffuse", diffuse);
    show("gloss", gloss);
    show("half", half, `${digits(half, 1)}\u00b0 beside R`);
    d.at(160, 178, 128);
    d.box(-2, -1, 4, 1, "ground");
    d.line(-2, 0, 2, 0, "rule");
    const lobe = [[0, 0]], soft = [];
    for (let a = -90; a <= 90; a += 0.5) {
      const at = ask("phong", exponent, glossy, light, a);
      lobe.push(along(a, at[0]));
      soft.push(along(a, (1 - glossy) * at[1]));
    }
    d.path(lobe, "lobe");
    d.path(soft, "curve thin dashed normal");
    d.line(0, 0, 0, 1.15, "measure");
    d.text(0, 1.2, "N", "name normal");
    d.line(0, 0, ...along(light, 1.1), "ray reaches");
    d.circle(...along(light, 1.16), 8, "lamp");
    d.arrow(0, 0, ...along(light, 0.85), "reaches");
    d.text(...along(light + (light < 0 ? -8 : 8), 0.78), "L", "name reaches");
    d.line(0, 0, ...along(mirror, 1.1), "ray reflected");
    d.text(...along(mirror, 1.18), "R", "name reflected halo");
    d.arrow(0, 0, ...along(eye, 1.1), "camera");
    d.text(...along(eye + (eye < mirror ? -7 : 7), 1.0), "V", "name camera halo");
    d.circle(...along(eye, value), 5, "dot camera");
    return `Towards the eye: ${digits(value)}. The highlight has half its strength ${digits(half, 1)}\u00b0 beside R; a larger \u03b1 makes it narrower.`;
  },
});
