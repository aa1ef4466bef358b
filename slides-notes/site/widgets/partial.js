// Lesson 03: a share s is the mirror image, the rest the surface's own light; and what is left after several bounces.
// Pictures are encoded as sRGB; the numbers stay linear.
const encoded = (rgb) => `rgb(${rgb.map((v) => { const c = Math.min(1, Math.max(0, v)); return Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055)); }).join(" ")})`;

widget("partial", {
  label: "A share s is reflected",
  view: [320, 236],
  sliders: [{ id: "s", label: "share s", min: 0, max: 1, step: 0.01, value: 0.5, places: 2 }],
  numbers: [
    { id: "own", label: "(1 \u2212 s) \u00b7 direct light", wide: true }, { id: "mirror", label: "s \u00b7 mirror image", wide: true },
    { id: "sum", label: "the colour of the pixel", wide: true }, { id: "left", label: "s\u2077, after 7 bounces", places: 5, wide: true },
  ],
  update({ s }, show, d) {
    const result = ask("partial", s), rgb = [0, 3, 6].map((i) => result.slice(i, i + 3)), left = result.slice(9, 16);
    const triple = (values) => `(${values.map((v) => digits(v, 2)).join(", ")})`;
    ["own", "mirror", "sum"].forEach((name, i) => show(name, rgb[i][0], triple(rgb[i])));
    show("left", left[6]);
    d.at(0, 0, 1, -1); // plain pixels, y down
    rgb.forEach((color, i) => {
      d.add("rect", "swatch", { x: 14 + i * 108, y: 22, width: 76, height: 54, rx: 6, style: `fill:${encoded(color)}` });
      d.text(52 + i * 108, 10, ["direct", "mirror", "together"][i], "small");
      if (i) d.text(i * 108 - 2, 50, i === 1 ? "+" : "=", "sign");
    });
    d.text(14, 98, "throughput after 1, 2, .. 7 bounces", "small", "start");
    d.line(14, 214, 306, 214, "rule");
    left.forEach((value, i) => {
      const x = 20 + i * 41.5;
      d.add("rect", "bar reflected", { x, y: 214 - 84 * value, width: 30, height: 84 * value });
      d.text(x + 15, 206 - 84 * value, value >= 0.995 ? "1" : value < 0.005 ? "0" : digits(value, 2), "small");
      d.text(x + 15, 226, `s${"\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077"[i]}`, "small");
    });
    return `${digits(100 * (1 - s), 0)} % direct light and ${digits(100 * s, 0)} % mirror image. After two bounces ${digits(100 * left[1], 1)} % of the light is left, after seven ${digits(100 * left[6], 2)} %.`;
  },
});
