// Labels that do not cover one another: each takes the first free place beside what it names.
const overlaps = (a, b) => a.x < b.x + b.w + 3 && b.x < a.x + a.w + 3 && a.y < b.y + b.h + 3 && b.y < a.y + a.h + 3;

// A request has text, size, priority, and either a `line` or a point `at` that it names.
function placeLabels(context, requests, width, height) {
  const used = [], placed = [];
  requests.sort((a, b) => b.priority - a.priority);
  for (const request of requests) {
    context.font = `${request.weight || 600} ${request.size}px system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif`;
    const w = Math.ceil(context.measureText(request.text).width) + 10, h = request.size + 6;
    for (const [x, y] of candidates(request, w, h, width, height)) {
      const box = { x: x - w / 2, y: y - h / 2, w, h };
      if (box.x < 2 || box.y < 2 || box.x + w > width - 2 || box.y + h > height - 2) continue;
      if (used.some((other) => overlaps(box, other))) continue;
      used.push(box);
      placed.push({ ...request, ...box, font: context.font });
      break;
    }
  }
  return placed;
}

function candidates({ line, at, gap = 6 }, w, h, width, height) {
  const places = [];
  if (line) {
    const [dx, dy] = [line.to[0] - line.from[0], line.to[1] - line.from[1]], long = Math.hypot(dx, dy) || 1;
    const inside = ([x, y]) => x > 0 && y > 0 && x < width && y < height;
    const spots = [0.5, 0.38, 0.62, 0.27, 0.73, 0.16, 0.84].map((t) => [line.from[0] + t * dx, line.from[1] + t * dy]).filter(inside);
    if (long > 4 * w) places.push(...spots);
    // Beside the line: half the box as it is seen across it.
    const off = gap + (w * Math.abs(dy) + h * Math.abs(dx)) / (2 * long);
    for (const [x, y] of spots)
      for (const side of [1, -1]) places.push([x - (side * off * dy) / long, y + (side * off * dx) / long]);
  }
  if (at)
    for (const far of [1, 2])
      for (let eighth = 0; eighth < 8; ++eighth) {
        const angle = (-eighth * Math.PI) / 4 - Math.PI / 2;
        places.push([at[0] + Math.cos(angle) * (far * gap + w / 2), at[1] + Math.sin(angle) * (far * gap + h / 2)]);
      }
  return places;
}

function drawLabels(context, requests, width, height) {
  for (const label of placeLabels(context, requests, width, height)) {
    context.beginPath();
    context.roundRect(label.x, label.y, label.w, label.h, 5);
    context.fillStyle = label.plate;
    context.fill();
    if (label.outlined) {
      context.lineWidth = 2;
      context.strokeStyle = palette.text;
      context.stroke();
    }
    context.font = label.font;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = label.color;
    context.fillText(label.text, label.x + label.w / 2, label.y + label.h / 2 + 0.5);
  }
}
