// Lesson 02: the reflected vector, and the part of D along N that is turned round.
widget("reflect", {
  label: "The reflected vector",
  view: [320, 230],
  sliders: [
    { id: "arrival", label: "D comes from (angle from up)", unit: "\u00b0", min: -85, max: 85, step: 1, value: -40 },
    { id: "tilt", label: "N leans (angle from up)", unit: "\u00b0", min: -40, max: 40, step: 1, value: 0 },
  ],
  numbers: [
    { id: "DN", label: "D\u00b7N" }, { id: "angle", label: "angle in = out", places: 1 },
    { id: "Rx", label: "R<sub>x</sub>" }, { id: "Ry", label: "R<sub>y</sub>" },
  ],
  update({ arrival, tilt }, show, d) {
    const [Dx, Dy, Nx, Ny, DN, Rx, Ry, angle] = ask("reflect", arrival, tilt);
    show("DN", DN);
    show("angle", angle, `${digits(angle, 1)}\u00b0`);
    show("Rx", Rx);
    show("Ry", Ry);
    const behind = DN > 0, one = 1.15;
    d.at(160, 132, 80);
    d.path([[-3 * Ny, 3 * Nx], [3 * Ny, -3 * Nx], [3 * Ny - 3 * Nx, -3 * Nx - 3 * Ny], [-3 * Ny - 3 * Nx, 3 * Nx - 3 * Ny]], "ground");
    d.line(-3 * Ny, 3 * Nx, 3 * Ny, -3 * Nx, "rule");
    // A = (D.N)N and B = D - A, drawn at the tip that D would have.
    d.line(-Dx * one, -Dy * one, -Dx * one + DN * Nx * one, -Dy * one + DN * Ny * one, "measure");
    d.line(Rx * one, Ry * one, (Rx + DN * Nx) * one, (Ry + DN * Ny) * one, "measure");
    d.arc(arrival, tilt, 0.34);
    d.arc(tilt, 2 * tilt - arrival, 0.34);
    d.arrow(0, 0, Nx, Ny, "normal");
    d.text(Nx * 1.12, Ny * 1.12, "N", "name normal");
    d.arrow(-Dx * one, -Dy * one, 0, 0, "camera");
    d.text(-Dx * one * 0.6 - Dy * 0.13, -Dy * one * 0.6 + Dx * 0.13, "D", "name camera halo");
    d.arrow(0, 0, Rx * one, Ry * one, "reflected");
    d.text(Rx * one * 0.6 + Ry * 0.13, Ry * one * 0.6 - Rx * 0.13, "R", "name reflected halo");
    if (behind) return "D\u00b7N > 0: the ray comes from behind. The tracer flips N first, so that it faces the ray.";
    return `D\u00b7N = ${digits(DN)}; R = D \u2212 2(D\u00b7N)N = (${digits(Rx, 2)}, ${digits(Ry, 2)}).`;
  },
});
