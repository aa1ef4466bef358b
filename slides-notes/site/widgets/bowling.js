// Lesson 04: a dark mirror shows a bright sun, unless somebody cut the sun to 1 on the way.
widget("bowling", {
  label: "A dark ball reflects a bright sun",
  view: [320, 170],
  sliders: [
    { id: "color", label: "colour of the ball", min: 0.002, max: 0.1, step: 0.002, value: 0.01, places: 3 },
    { id: "sun", label: "radiance of the sun", min: 0, max: 3, step: 0.05, value: 2, value_of: (v) => 10 ** v, places: 1 },
  ],
  numbers: [{ id: "hdr", label: "colour \u00b7 sun", places: 4 }, { id: "clamped", label: "sun cut to 1 first", places: 4 }],
  update({ color, sun }, show, d) {
    const [hdr, clamped] = ask("bowling", color, sun);
    show("hdr", hdr);
    show("clamped", clamped);
    d.at(0, 0, 1, -1);
    [[hdr, 90, "HDR sky"], [clamped, 230, "8 bit sky"]].forEach(([value, x, name]) => {
      d.add("circle", "ball", { cx: x, cy: 82, r: 54, style: `fill:${encoded([color, color, color])}` });
      d.add("ellipse", "glint", { cx: x - 18, cy: 62, rx: 13, ry: 10, transform: `rotate(-35 ${x - 18} 62)`, style: `fill:${encoded([value, value, value])}` });
      d.text(x, 14, name, "small");
      d.text(x, 154, value < 0.0005 ? "0" : digits(value, 3), "name");
    });
    const seen = hdr >= 1 ? "as white as the picture can show" : `${digits(100 * hdr, 1)} % of white`;
    return `The highlight is ${digits(hdr, 3)}: ${seen}. With a sun cut to 1 it would be ${digits(clamped, 3)}, next to nothing.`;
  },
});
