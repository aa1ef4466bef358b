// Lesson 05: Snell's law, and what happens where it has no answer.
const incidence = (max, value) => ({ id: "angle", label: "angle of incidence \u03b8\u2081", unit: "\u00b0", min: 0, max, step: 0.5, value, places: 1 });
const index = (id, label, value) => ({ id, label, min: 1, max: 2.5, step: 0.01, value, places: 2 });

// Two media, a boundary and its normal. The denser one is darker.
function drawMedia(d, n1, n2) {
  d.box(-3, 0, 6, 3, "medium").setAttribute("fill-opacity", (0.04 + (n1 - 1) * 0.2).toFixed(3));
  d.box(-3, -3, 6, 3, "medium").setAttribute("fill-opacity", (0.04 + (n2 - 1) * 0.2).toFixed(3));
  d.line(-3, 0, 3, 0, "rule");
  d.line(0, 0, 0, -1.2, "measure");
  d.arrow(0, 0, 0, 0.75, "normal");
  d.text(0.13, 0.75, "N", "name normal");
  d.text(-1.62, 1.18, `n\u2081 = ${digits(n1, 2)}`, "small", "start");
  d.text(-1.62, -1.18, `n\u2082 = ${digits(n2, 2)}`, "small", "start");
}

widget("refract", {
  label: "The transmitted vector",
  view: [320, 250],
  sliders: [
    incidence(89, 45), index("n1", "n\u2081, where D travels", 1), index("n2", "n\u2082, behind", 1.5),
  ],
  numbers: [
    { id: "k", label: "k = cos\u00b2\u03b8\u2082" }, { id: "angle2", label: "\u03b8\u2082" },
    { id: "Tx", label: "T<sub>x</sub>" }, { id: "Ty", label: "T<sub>y</sub>" },
    { id: "critical", label: "critical angle", wide: true },
  ],
  update({ angle, n1, n2 }, show, d) {
    const [k, exists, Tx, Ty, angle2, critical, Dx, Dy, Rx, Ry] = ask("refract", angle, n1, n2);
    show("k", k);
    show("angle2", exists ? angle2 : undefined, exists ? `${digits(angle2, 2)}\u00b0` : "none");
    show("Tx", exists ? Tx : undefined);
    show("Ty", exists ? Ty : undefined);
    show("critical", critical < 0 ? undefined : critical, critical < 0 ? "none: n\u2082 is not smaller" : `${digits(critical, 2)}\u00b0`);
    d.at(160, 125, 95);
    drawMedia(d, n1, n2);
    if (critical >= 0) {
      const [x, y] = along(-critical, 1.5);
      d.line(0, 0, x, y, "limit");
      d.text(...along(-critical, 1.22), "critical", "small halo");
    }
    d.arc(0, -angle, 0.36);
    d.text(...along(-angle / 2, 0.5), "\u03b8\u2081", "small halo");
    const one = 1.2;
    d.arrow(-Dx * one, -Dy * one, 0, 0, "camera");
    d.text(-Dx * 0.85 + 0.13 * Dy, -Dy * 0.85 - 0.13 * Dx, "D", "name camera halo");
    if (exists) {
      d.arc(180, 180 - angle2, 0.36);
      d.text(...along(180 - angle2 / 2, 0.5), "\u03b8\u2082", "small halo");
      d.arrow(0, 0, Tx * one, Ty * one, "transmitted");
      d.text(Tx * 0.95 + 0.13, Ty * 0.95 + 0.05, "T", "name transmitted");
      return `sin\u03b8\u2082 = n\u2081/n\u2082 \u00b7 sin\u03b8\u2081, so \u03b8\u2082 = ${digits(angle2, 1)}\u00b0: ${n1 === n2 ? "the ray goes straight on." : angle2 < angle ? "bent towards the normal." : angle === 0 ? "straight through." : "bent away from the normal."}`;
    }
    d.arrow(0, 0, Rx * one, Ry * one, "reflected");
    d.text(Rx * 0.95 + 0.12, Ry * 0.95 - 0.06, "R", "name reflected");
    d.text(0, -0.8, "total internal reflection", "name reflected halo");
    return `k = ${digits(k)} < 0: cos\u03b8\u2082 does not exist, and neither does T. Beyond ${digits(critical, 1)}\u00b0 everything is reflected.`;
  },
});
