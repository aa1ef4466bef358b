// A small SVG, redrawn at each change. Its own units: x right, y up, the origin where the widget puts it.
const SVG = "http://www.w3.org/2000/svg";

class Drawing {
  constructor(width, height) {
    this.svg = document.createElementNS(SVG, "svg");
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.setAttribute("role", "img");
    this.width = width;
    this.height = height;
    this.at(width / 2, height / 2, 1);
  }

  clear() {
    this.svg.replaceChildren();
  }

  // The origin in pixels from the top left, and pixels per unit (of each axis).
  at(left, top, scale, scaleY = scale) {
    Object.assign(this, { left, top, scale, scaleY });
    return this;
  }

  x(x) { return this.left + x * this.scale; }
  y(y) { return this.top - y * this.scaleY; }

  add(tag, className, attributes, text) {
    const made = document.createElementNS(SVG, tag);
    made.setAttribute("class", className);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, typeof value === "number" ? value.toFixed(2) : value);
    if (text !== undefined) made.textContent = text;
    this.svg.append(made);
    return made;
  }

  line(x1, y1, x2, y2, className = "rule") {
    return this.add("line", className, { x1: this.x(x1), y1: this.y(y1), x2: this.x(x2), y2: this.y(y2) });
  }

  arrow(x1, y1, x2, y2, className) {
    const [ax, ay, bx, by] = [this.x(x1), this.y(y1), this.x(x2), this.y(y2)];
    const long = Math.hypot(bx - ax, by - ay);
    if (long < 1) return;
    const [ux, uy] = [(bx - ax) / long, (by - ay) / long], head = Math.min(11, long / 2);
    const [hx, hy] = [bx - head * ux, by - head * uy];
    this.add("line", `arrow ${className}`, { x1: ax, y1: ay, x2: hx, y2: hy });
    const half = head * 0.42;
    this.add("path", `head ${className}`, { d: `M${bx.toFixed(2)} ${by.toFixed(2)}L${(hx - half * uy).toFixed(2)} ${(hy + half * ux).toFixed(2)}L${(hx + half * uy).toFixed(2)} ${(hy - half * ux).toFixed(2)}Z` });
  }

  text(x, y, text, className = "", anchor = "middle") {
    return this.add("text", className, { x: this.x(x), y: this.y(y), "text-anchor": anchor, dy: "0.35em" }, text);
  }

  circle(x, y, radius, className) {
    return this.add("circle", className, { cx: this.x(x), cy: this.y(y), r: radius });
  }

  // With a corner at (x, y) and the opposite one at (x + width, y + height).
  box(x, y, width, height, className) {
    return this.add("rect", className, { x: this.x(x), y: this.y(y + height), width: width * this.scale, height: height * this.scaleY });
  }

  path(points, className) {
    return this.add("path", className, { d: points.map(([x, y], i) => `${i ? "L" : "M"}${this.x(x).toFixed(2)} ${this.y(y).toFixed(2)}`).join("") });
  }

  // Around (0, 0), from one angle to another: degrees from up, clockwise, as in formulas.cpp.
  arc(from, to, radius, className = "angle") {
    const points = [];
    for (let i = 0; i <= 32; ++i) points.push(along(from + ((to - from) * i) / 32, radius));
    return this.path(points, className);
  }
}

// Where a drawing has the point in that direction and distance.
function along(degrees, distance) {
  const angle = (degrees * Math.PI) / 180;
  return [Math.sin(angle) * distance, Math.cos(angle) * distance];
}
