// The objects of the scene: planes as fading grids, spheres as shaded discs, triangles, camera and lights.
const OBJECTS = DATA.objects;
const OPAQUE = OBJECTS.spheres.filter((sphere) => sphere.look !== "glass" && isPoint(sphere.center));
const MOST_HIDING_TESTS = 400000;

// Sutherland and Hodgman: what of a polygon lies on the inner side of each edge of a convex outline.
function clipped(polygon, outline) {
  const centre = times(1 / outline.length, outline.map(([u, v]) => [u, v, 0]).reduce(add));
  let kept = polygon;
  outline.forEach((from, i) => {
    const to = outline[(i + 1) % outline.length], normal = [from[1] - to[1], to[0] - from[0]];
    const height = (p) => (p[0] - from[0]) * normal[0] + (p[1] - from[1]) * normal[1];
    const sign = height(centre) < 0 ? -1 : 1, next = [];
    kept.forEach((p, j) => {
      const q = kept[(j + 1) % kept.length], a = sign * height(p), b = sign * height(q);
      if (a >= 0) next.push(p);
      if (a < 0 !== b < 0) next.push([p[0] + (a / (a - b)) * (q[0] - p[0]), p[1] + (a / (a - b)) * (q[1] - p[1])]);
    });
    kept = next;
  });
  return kept;
}

// A width of cells such that about ten of them reach from the middle to the edge: 1, 2 or 5 times a power of ten.
function niceSize(radius) {
  const power = 10 ** Math.floor(Math.log10(radius / 7));
  return [1, 2, 5, 10].map((n) => n * power).find((size) => size >= radius / 8) || power;
}

// The cells of a plane, once: corners in space, coverage, and whether it has the checker's colour.
function cellsOf(plane) {
  const { origin, u, v, outline, centre, radius } = plane;
  if (![origin, u, v].every(isPoint) || !(radius > 0) || !outline.flat().every(Number.isFinite)) return [];
  const checker = plane.checker && radius / plane.checker[1] <= 16 ? plane.checker : null;
  const size = checker ? checker[1] : niceSize(radius), cells = [];
  const first = (x) => Math.floor((x - radius) / size), last = (x) => Math.floor((x + radius) / size);
  for (let i = first(centre[0]); i <= last(centre[0]); ++i)
    for (let j = first(centre[1]); j <= last(centre[1]); ++j) {
      const square = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(([x, y]) => [x * size, y * size]);
      const far = Math.hypot((i + 0.5) * size - centre[0], (j + 0.5) * size - centre[1]) / radius;
      const fade = Math.min(1, Math.max(0, (1 - far) / 0.5));
      const corners = fade > 0 ? clipped(square, outline) : [];
      if (corners.length >= 3)
        cells.push({
          points: corners.map(([x, y]) => add(origin, add(times(x, u), times(y, v)))),
          alpha: fade * fade * (3 - 2 * fade),
          odd: checker !== null && (i + j) % 2 !== 0,
        });
    }
  return cells;
}

const planes = OBJECTS.planes.map((plane) => ({ ...plane, cells: cellsOf(plane) }));

function drawPlanes(context, project) {
  const isLight = currentTheme() === "light", ground = palette["sky-low"];
  for (const plane of planes) {
    if (!isPoint(plane.normal)) continue;
    const faces = plane.cells.length && dot(plane.normal, sub(project.eye, plane.cells[0].points[0])) > 0;
    const strength = (plane.look === "matte" ? 0.62 : 0.3) * (faces ? (plane.floor ? 1 : 0.6) : 0);
    // Not as bright as the picture: the rays are what is looked at.
    const shade = (color) => mixed(color, ground, isLight ? 0.25 : 0.5);
    for (const cell of plane.cells) {
      const corners = cell.points.map(project.point);
      if (corners.includes(null)) continue;
      context.beginPath();
      corners.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
      context.closePath();
      if (strength > 0) {
        context.fillStyle = withAlpha(shade(cell.odd ? plane.checker[0] : plane.color), strength * cell.alpha);
        context.fill();
      }
      context.lineWidth = 1;
      context.strokeStyle = withAlpha(palette.dim, (faces ? 0.3 : 0.1) * cell.alpha);
      context.stroke();
    }
  }
}

function lightDirection(centre) {
  const lamp = OBJECTS.lights.find(([position]) => isPoint(position));
  return unit(lamp ? sub(lamp[0], centre) : add(up, times(0.5, ahead)));
}

function drawSphere(context, project, sphere) {
  const disc = project.sphere(sphere.center, sphere.radius);
  if (!disc) return;
  const d = lightDirection(sphere.center), color = sphere.color || "#808080";
  context.save();
  context.translate(disc.x, disc.y);
  context.rotate(disc.angle);
  context.scale(disc.long, disc.short);
  context.rotate(-disc.angle);
  const lx = 0.55 * dot(d, project.right), ly = -0.55 * dot(d, project.above);
  context.beginPath();
  context.arc(0, 0, 1, 0, 2 * Math.PI);
  let fill;
  if (sphere.look === "glass") {
    fill = context.createRadialGradient(0, 0, 0.2, 0, 0, 1);
    const tint = mixed(mixed(color, palette.camera, 0.35), palette.text, currentTheme() === "light" ? 0.25 : 0.1);
    fill.addColorStop(0, withAlpha(tint, 0.05));
    fill.addColorStop(0.75, withAlpha(tint, 0.12));
    fill.addColorStop(1, withAlpha(tint, 0.38));
  } else if (sphere.look === "chrome") {
    fill = context.createRadialGradient(lx, ly, 0, lx * 0.3, ly * 0.3, 1.15);
    fill.addColorStop(0, "#ffffff");
    fill.addColorStop(0.18, mixed(color, "#dfe8f2", 0.35));
    fill.addColorStop(0.55, mixed(mixed(color, "#6f8399", 0.55), "#000000", 0.12));
    fill.addColorStop(0.8, mixed(mixed(color, "#2a3646", 0.7), "#000000", 0.1));
    fill.addColorStop(1, mixed(color, "#93a5b8", 0.6));
  } else {
    fill = context.createRadialGradient(lx, ly, 0, lx * 0.4, ly * 0.4, 1.4);
    fill.addColorStop(0, mixed(color, "#ffffff", 0.22));
    fill.addColorStop(0.35, mixed(color, "#000000", 0.06));
    fill.addColorStop(1, mixed(color, "#05080d", 0.72));
  }
  context.fillStyle = fill;
  context.fill();
  if (sphere.look === "glass") {
    const glint = context.createRadialGradient(lx, ly, 0, lx, ly, 0.28);
    glint.addColorStop(0, "rgba(255, 255, 255, .75)");
    glint.addColorStop(1, "rgba(255, 255, 255, 0)");
    context.fillStyle = glint;
    context.fill();
  }
  context.restore();
  context.beginPath();
  context.ellipse(disc.x, disc.y, disc.long, disc.short, disc.angle, 0, 2 * Math.PI);
  context.lineWidth = 1.2;
  context.strokeStyle = withAlpha(sphere.look === "glass" ? palette.text : palette.dim, sphere.look === "glass" ? 0.55 : 0.7);
  context.stroke();
}

function drawTriangle(context, project, [a, b, c, color, look]) {
  const corners = [a, b, c].map(project.point);
  if (corners.includes(null)) return;
  const normal = unit(cross(sub(b, a), sub(c, a))), lit = Math.abs(dot(normal, lightDirection(a)));
  context.beginPath();
  corners.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
  context.closePath();
  context.fillStyle = withAlpha(mixed(color, "#05080d", 0.6 - 0.5 * lit), look === "glass" ? 0.2 : 0.9);
  context.fill();
  context.lineWidth = 0.8;
  context.strokeStyle = withAlpha(palette.dim, 0.6);
  context.stroke();
}

// The picture on the image plane, in small cells of which each is drawn without perspective.
function drawImagePlane(context, project) {
  const corners = OBJECTS.camera.corners, image = byId("picture");
  if (!corners.every(isPoint) || !isPoint(OBJECTS.camera.eye)) return;
  const eye = project.point(OBJECTS.camera.eye), frame = corners.map(project.point);
  if (frame.includes(null)) return;
  const at = (x, y) => project.point(between(between(corners[0], corners[1], x), between(corners[3], corners[2], x), y));
  if (image && image.complete && image.naturalWidth > 0) {
    const n = 6, w = image.naturalWidth / n, h = image.naturalHeight / n;
    context.save();
    context.globalAlpha = 0.9;
    for (let i = 0; i < n; ++i)
      for (let j = 0; j < n; ++j) {
        const p = at(i / n, j / n), q = at((i + 1) / n, j / n), r = at((i + 1) / n, (j + 1) / n), s = at(i / n, (j + 1) / n);
        if (!p || !q || !r || !s) continue;
        const grow = 0.4, middle = [(p[0] + r[0]) / 2, (p[1] + r[1]) / 2];
        context.save();
        context.beginPath();
        for (const [x, y] of [p, q, r, s]) {
          const far = Math.hypot(x - middle[0], y - middle[1]) || 1;
          context.lineTo(x + (grow * (x - middle[0])) / far, y + (grow * (y - middle[1])) / far);
        }
        context.clip();
        context.transform((q[0] - p[0]) / w, (q[1] - p[1]) / w, (s[0] - p[0]) / h, (s[1] - p[1]) / h, p[0], p[1]);
        context.drawImage(image, i * w, j * h, w, h, -0.5, -0.5, w + 1, h + 1);
        context.restore();
      }
    context.restore();
  }
  context.strokeStyle = withAlpha(palette.dim, 0.85);
  context.lineWidth = 1.2;
  context.beginPath();
  frame.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
  context.closePath();
  if (eye)
    for (const [x, y] of frame) {
      context.moveTo(...eye);
      context.lineTo(x, y);
    }
  context.stroke();
  if (eye) {
    context.beginPath();
    context.arc(eye[0], eye[1], 4, 0, 2 * Math.PI);
    context.fillStyle = palette.dim;
    context.fill();
  }
  if (DATA.pixel) {
    const spot = at((DATA.pixel[0] + 0.5) / DATA.size[0], (DATA.pixel[1] + 0.5) / DATA.size[1]);
    if (!spot) return;
    context.beginPath();
    context.arc(spot[0], spot[1], 3.5, 0, 2 * Math.PI);
    context.lineWidth = 3.5;
    context.strokeStyle = "rgba(0, 0, 0, .6)";
    context.stroke();
    context.lineWidth = 1.5;
    context.strokeStyle = "#ffffff";
    context.stroke();
  }
}

function drawLights(context, project) {
  const radius = DATA.drawing.lightRadius || 0.1;
  for (const [position, color] of OBJECTS.lights) {
    const at = isPoint(position) && project.point(position);
    if (!at) continue;
    const r = Math.min(30, Math.max(4, (radius * project.scale) / project.depth(position)));
    const glow = context.createRadialGradient(at[0], at[1], r * 0.6, at[0], at[1], r * 3);
    glow.addColorStop(0, withAlpha(color, 0.5));
    glow.addColorStop(1, withAlpha(color, 0));
    context.fillStyle = glow;
    context.beginPath();
    context.arc(at[0], at[1], r * 3, 0, 2 * Math.PI);
    context.fill();
    context.beginPath();
    context.arc(at[0], at[1], r, 0, 2 * Math.PI);
    context.fillStyle = color;
    context.fill();
    context.lineWidth = 1.2;
    context.strokeStyle = withAlpha(palette.dim, 0.9);
    context.stroke();
  }
}

// Painter's order: what is far away first.
function drawObjects(context, project) {
  drawPlanes(context, project);
  const items = [];
  for (const sphere of OBJECTS.spheres)
    if (isPoint(sphere.center) && sphere.radius > 0)
      items.push([norm(sub(sphere.center, project.eye)), () => drawSphere(context, project, sphere)]);
  for (const triangle of OBJECTS.triangles)
    if (triangle.slice(0, 3).every(isPoint)) {
      const middle = times(1 / 3, add(add(triangle[0], triangle[1]), triangle[2]));
      items.push([norm(sub(middle, project.eye)), () => drawTriangle(context, project, triangle)]);
    }
  if (isPoint(OBJECTS.camera.corners[0]))
    items.push([norm(sub(OBJECTS.camera.corners[0], project.eye)), () => drawImagePlane(context, project)]);
  items.sort((a, b) => b[0] - a[0]);
  for (const [, paint] of items) paint();
  drawLights(context, project);
}

// Is there an opaque sphere between the viewer and the point?
function isHidden(eye, point) {
  const way = sub(point, eye), far = norm(way), d = times(1 / far, way);
  return OPAQUE.some(({ center, radius }) => {
    const toCentre = sub(center, eye), along = dot(toCentre, d), square = radius * radius - (dot(toCentre, toCentre) - along * along);
    return square > 0 && along - Math.sqrt(square) > 0 && along - Math.sqrt(square) < far - 0.02 * radius;
  });
}
