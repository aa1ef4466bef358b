// The 3D pane: the rays among the objects; drag, wheel, pinch and pick.
const MOST_LABELS = 24, CROWDED = 6;
const canvas = byId("canvas");
const isShadow = (role) => role === "reaches" || role === "blocked" || role === "beyond";
const segments = DATA.drawing.segments
  .map(([role, node, light, from, to, weight, flags, stopped]) => ({
    role: ROLES[role], node, light, from, to, weight: weight || 0,
    label: stopped || { ...LETTERS, blocked: "L", normal: "N" }[ROLES[role]] + subscript(isShadow(ROLES[role]) ? light : node),
    hasHead: (flags & 1) !== 0, fades: (flags & 2) !== 0, notTraced: (flags & 4) !== 0,
  }))
  .filter(({ from, to }) => isPoint(from) && isPoint(to));
const kindOf = (role) => (role === "beyond" ? "blocked" : role);

function stepOf(segment) {
  if (segment.notTraced) return leftOutAt.get(segment.node + "/" + segment.role);
  if (isShadow(segment.role)) return shadowAt.get(segment.node + "/" + segment.light);
  return followedAt.get(segment.node);
}

function isShown(segment) {
  if (segment.role !== "normal") return !state.hidden.has(kindOf(segment.role));
  return state.normals && (segment.node === state.node || DATA.drawing.nodes <= CROWDED);
}

// Runs of the segment that are seen, and runs behind something: [from, to, hidden].
function runsOf(segment, project, testing) {
  if (!testing) return [[0, 1, false]];
  const n = 16, runs = [];
  for (let i = 0; i < n; ++i) {
    const hidden = isHidden(project.eye, between(segment.from, segment.to, (i + 0.5) / n)), last = runs[runs.length - 1];
    if (last && last[2] === hidden) last[1] = (i + 1) / n;
    else runs.push([i / n, (i + 1) / n, hidden]);
  }
  return runs;
}

function drawSegment(context, project, segment, testing) {
  const line = project.line(segment.from, segment.to);
  if (!line) return;
  const reached = isReached(stepOf(segment)), chosen = segment.node === state.node;
  const color = palette[segment.role], shadow = isShadow(segment.role);
  const [dx, dy] = [line.to[0] - line.from[0], line.to[1] - line.from[1]], long = Math.hypot(dx, dy);
  let width = segment.role === "normal" ? 1.6 : shadow ? 1.5 : 1.3 + 2.2 * Math.sqrt(Math.min(1, segment.weight));
  let alpha = !reached ? 0.13 : segment.role === "beyond" ? 0.6 : 1;
  const crowded = DATA.drawing.nodes > CROWDED;
  if (crowded && !chosen && shadow) alpha *= 0.35;
  if (chosen && reached) width += 0.8;
  const strokeOf = (strength) => {
    if (!segment.fades) return withAlpha(color, strength);
    const fade = context.createLinearGradient(...line.from, ...line.to);
    fade.addColorStop(0, withAlpha(color, strength));
    fade.addColorStop(0.45, withAlpha(color, strength));
    fade.addColorStop(1, withAlpha(color, 0));
    return fade;
  };
  const stroke = (a, b, style, thick) => {
    context.beginPath();
    context.moveTo(line.from[0] + a * dx, line.from[1] + a * dy);
    context.lineTo(line.from[0] + b * dx, line.from[1] + b * dy);
    context.strokeStyle = style;
    context.lineWidth = thick;
    context.stroke();
  };
  context.lineCap = "round";
  if (chosen && reached && !shadow && segment.role !== "normal") stroke(0, 1, strokeOf(0.25), width + 7);
  if (segment.role === "beyond") context.setLineDash([6, 6]);
  if (segment.notTraced) context.setLineDash([2, 5]);
  for (const [a, b, hidden] of runsOf(segment, project, testing)) {
    // What is behind an object shines through it faintly.
    const p = project.line(between(segment.from, segment.to, a), between(segment.from, segment.to, b));
    if (!p) continue;
    context.beginPath();
    context.moveTo(...p.from);
    context.lineTo(...p.to);
    context.strokeStyle = strokeOf(alpha * (hidden ? 0.28 : 1));
    context.lineWidth = hidden ? width * 0.7 : width;
    context.stroke();
  }
  context.setLineDash([]);
  if (!segment.hasHead || !reached || line.t < 1 || long < 12) return;
  // The head of a ray that fades sits where it can still be seen.
  const share = segment.fades ? 0.5 : 1, size = Math.min(7 + 1.8 * width, 0.5 * long);
  const tip = [line.from[0] + share * dx, line.from[1] + share * dy], ux = dx / long, uy = dy / long;
  const hidden = testing && isHidden(project.eye, between(segment.from, segment.to, share * 0.97));
  context.beginPath();
  context.moveTo(...tip);
  context.lineTo(tip[0] - size * ux - 0.42 * size * uy, tip[1] - size * uy + 0.42 * size * ux);
  context.lineTo(tip[0] - size * ux + 0.42 * size * uy, tip[1] - size * uy - 0.42 * size * ux);
  context.closePath();
  context.fillStyle = withAlpha(color, alpha * (hidden ? 0.28 : 1));
  context.fill();
}

function drawBlockers(context, project) {
  if (state.hidden.has("blocked")) return;
  for (const [node, light, point] of DATA.drawing.blockers) {
    const at = isPoint(point) && project.point(point);
    if (!at || !isReached(shadowAt.get(node + "/" + light))) continue;
    const size = node === state.node ? 6 : 4;
    for (const [style, width] of [[palette.panel, 5], [palette.blocked, 2.2]]) {
      context.beginPath();
      context.moveTo(at[0] - size, at[1] - size);
      context.lineTo(at[0] + size, at[1] + size);
      context.moveTo(at[0] - size, at[1] + size);
      context.lineTo(at[0] + size, at[1] - size);
      context.strokeStyle = style;
      context.lineWidth = width;
      context.stroke();
    }
  }
}

function labelRequests(project, width, height) {
  const requests = [], crowded = DATA.drawing.nodes > CROWDED, plate = withAlpha(palette.panel, 0.72);
  OBJECTS.lights.slice(0, 12).forEach(([position], i) => {
    const at = isPoint(position) && project.point(position);
    const r = at ? Math.min(30, Math.max(4, ((DATA.drawing.lightRadius || 0.1) * project.scale) / project.depth(position))) : 0;
    if (at) requests.push({ text: "light " + i, size: 12, weight: 500, priority: 80, color: palette.text, plate, at, gap: 6 + r });
  });
  let count = 0;
  for (const segment of segments) {
    const chosen = segment.node === state.node, main = !isShadow(segment.role) && segment.role !== "normal";
    if (segment.role === "beyond" || !isShown(segment) || !isReached(stepOf(segment))) continue;
    if (!chosen && crowded && !main) continue;
    const line = project.line(segment.from, segment.to);
    if (!line) continue;
    const long = Math.hypot(line.to[0] - line.from[0], line.to[1] - line.from[1]);
    if (!chosen && (long < 26 || ++count > MOST_LABELS)) continue;
    const half = segment.fades ? { from: line.from, to: [(line.from[0] + line.to[0]) / 2, (line.from[1] + line.to[1]) / 2] } : line;
    const priority = (chosen ? 100 : 50) + (main ? 20 : 0) - Math.min(segment.node, 30);
    if (segment.notTraced) requests.push({ text: segment.label, size: 11, priority: 40, color: palette[segment.role], plate, at: line.to });
    else if (segment.role === "normal") requests.push({ text: segment.label, size: 12, priority, color: palette.normal, plate, at: line.to });
    else
      requests.push({
        text: segment.label, size: main ? 13 : 12, priority, line: half, outlined: chosen && main && DATA.drawing.nodes > 1,
        color: main ? palette.ink : palette[segment.role], plate: main ? palette[segment.role] : plate,
      });
  }
  const met = new Set(DATA.nodes.slice(0, 200).flatMap((node) => (node.hit ? [node.hit] : [])));
  for (const shadow of DATA.shadows.slice(0, 200)) if (shadow.blocker) met.add(shadow.blocker);
  for (const sphere of OBJECTS.spheres.slice(0, 60)) {
    if (!met.has(sphere.name) || !isPoint(sphere.center)) continue;
    const at = project.point(sub(sphere.center, times(0.62 * sphere.radius, up)));
    if (at) requests.push({ text: sphere.name, size: 11, weight: 400, priority: 10, color: palette.text, plate: withAlpha(palette.panel, 0.5), at, gap: 1 });
  }
  return requests;
}

let lastProject = null;
function paintScene() {
  const { clientWidth: width, clientHeight: height } = canvas, ratio = Math.min(3, devicePixelRatio || 1);
  if (width < 2 || height < 2) return;
  if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
  if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
  if (!viewIsChosen) fitOrbit(width / height);
  const context = canvas.getContext("2d"), project = projector(width, height);
  lastProject = project;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const sky = context.createLinearGradient(0, 0, 0, height);
  sky.addColorStop(0, palette["sky-high"]);
  sky.addColorStop(1, palette["sky-low"]);
  context.fillStyle = sky;
  context.fillRect(0, 0, width, height);
  drawObjects(context, project);
  const shown = segments.filter(isShown);
  const testing = OPAQUE.length > 0 && shown.length * OPAQUE.length * 16 <= MOST_HIDING_TESTS;
  const depth = (segment) => project.depth(between(segment.from, segment.to, 0.5));
  // The selected node's rays last, the others from far to near.
  const rank = new Map(shown.map((segment) => [segment, (segment.node === state.node ? -1e30 : 0) + depth(segment)]));
  shown.sort((a, b) => rank.get(b) - rank.get(a));
  for (const segment of shown) drawSegment(context, project, segment, testing);
  drawBlockers(context, project);
  drawLabels(context, labelRequests(project, width, height), width, height);
}

let frame = 0;
function repaint() {
  if (!frame) frame = requestAnimationFrame(() => { frame = 0; paintScene(); });
}

function viewChanged() {
  viewIsChosen = true;
  state.view = viewText();
  changed();
}

function turn(dx, dy) {
  orbit.azimuth -= dx;
  orbit.elevation = Math.min(STEEPEST, Math.max(-STEEPEST, orbit.elevation + dy));
  viewChanged();
}

function zoom(factor) {
  const size = DATA.drawing.size || 1;
  orbit.distance = Math.min(1e4 * size, Math.max(1e-3 * size, orbit.distance * factor));
  viewChanged();
}

function pan(dx, dy) {
  const back = towards(), right = unit(cross(up, back)), above = cross(back, right);
  const unitsPerPixel = (2 * TAN * orbit.distance) / canvas.clientHeight;
  orbit.target = add(orbit.target, add(times(-dx * unitsPerPixel, right), times(dy * unitsPerPixel, above)));
  viewChanged();
}

function fitScene() {
  viewIsChosen = false;
  state.view = "";
  startDirection();
  changed();
}

// The nearest ray of those at most `tolerance` pixels away; rays of the tree before shadow rays.
function pick(x, y, tolerance) {
  let found = null, nearest = tolerance;
  for (const segment of segments) {
    const line = isShown(segment) && lastProject && lastProject.line(segment.from, segment.to);
    if (!line) continue;
    const [dx, dy] = [line.to[0] - line.from[0], line.to[1] - line.from[1]], square = dx * dx + dy * dy;
    const t = square > 0 ? Math.min(1, Math.max(0, ((x - line.from[0]) * dx + (y - line.from[1]) * dy) / square)) : 0;
    const far = Math.hypot(line.from[0] + t * dx - x, line.from[1] + t * dy - y) + (isShadow(segment.role) || segment.role === "normal" ? 0.25 * tolerance : 0);
    if (far < nearest) { nearest = far; found = segment; }
  }
  return found;
}

// Pointers on a pane: one drags, with Shift or the middle button it pans, two pinch and pan, a short one taps.
function follow(element, { drag, pan: move, pinch, tap }) {
  const down = new Map();
  let moved = 0;
  element.addEventListener("pointerdown", (event) => {
    if (event.button > 1) return;
    if (event.button === 1) event.preventDefault();
    if (down.size === 0) moved = 0;
    down.set(event.pointerId, [event.clientX, event.clientY]);
  });
  element.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY], [dx, dy] = [now[0] - before[0], now[1] - before[1]];
    moved += Math.hypot(dx, dy);
    if (moved > 4 && !element.hasPointerCapture(event.pointerId)) element.setPointerCapture(event.pointerId);
    if (moved <= 4) return;
    if (down.size === 2) {
      const [other] = [...down].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      const spread = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]) || 1;
      pinch(spread(before) / spread(now), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
      move(dx / 2, dy / 2);
    } else if (event.shiftKey || (event.buttons & 4)) move(dx, dy);
    else drag(dx, dy);
    element.classList.add("dragging");
    down.set(event.pointerId, now);
  });
  const release = (event) => {
    if (!down.delete(event.pointerId)) return;
    if (down.size === 0) element.classList.remove("dragging");
    if (event.type === "pointerup" && moved <= 4 && down.size === 0) tap(event);
  };
  element.addEventListener("pointerup", release);
  element.addEventListener("pointercancel", release);
}

// Where the page itself scrolls, the wheel zooms only what was clicked, or with Ctrl.
function onWheel(element, zoomBy) {
  element.addEventListener("wheel", (event) => {
    const main = byId("main"), pageScrolls = main.scrollHeight > main.clientHeight + 1;
    if (pageScrolls && !event.ctrlKey && document.activeElement !== element && !element.contains(document.activeElement)) return;
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    zoomBy(Math.exp(Math.max(-80, Math.min(80, event.deltaY * lines)) * 0.0025), event.clientX, event.clientY);
  }, { passive: false });
}

follow(canvas, {
  drag: (dx, dy) => turn(dx * 0.008, dy * 0.008),
  pan,
  pinch: (factor) => zoom(factor),
  tap(event) {
    canvas.focus({ preventScroll: true });
    const box = canvas.getBoundingClientRect();
    const found = pick(event.clientX - box.left, event.clientY - box.top, event.pointerType === "touch" ? 16 : 8);
    if (found) selectNode(found.node);
  },
});
onWheel(canvas, zoom);
canvas.addEventListener("keydown", (event) => {
  const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
  if (!event.shiftKey || !turns) return;
  turn(...turns);
  event.preventDefault();
  event.stopPropagation();
});

byId("zoom-in").addEventListener("click", () => zoom(0.8));
byId("zoom-out").addEventListener("click", () => zoom(1.25));
byId("fit").addEventListener("click", fitScene);
byId("picture").addEventListener("load", repaint);
new ResizeObserver(repaint).observe(canvas);

// The legend: which kinds are shown.
KINDS.forEach((kind, i) => {
  const button = make("button", { "aria-pressed": "true", title: `Show or hide (${i + 1})` },
    make("span", { class: "key", style: `background: var(--${kind})` }, LETTERS[kind]), KIND_NAMES[kind]);
  button.addEventListener("click", () => toggleKind(kind));
  byId("legend").append(button);
  onChange(() => button.setAttribute("aria-pressed", String(!state.hidden.has(kind))));
});
const normalsButton = make("button", { "aria-pressed": "true", title: "Show or hide normals (n)" },
  make("span", { class: "key", style: "background: var(--normal)" }, "N"), "normals");
normalsButton.addEventListener("click", toggleNormals);
byId("legend").append(normalsButton);
onChange(() => normalsButton.setAttribute("aria-pressed", String(state.normals)));

onChange(() => {
  const node = nodes.get(state.node);
  canvas.setAttribute("aria-label", "Rays in space. " + (node ? "Selected: " + rayName(node) : "Nothing was traced."));
});
// At once when printing: there is no next frame.
onChange(() => (printing ? paintScene() : repaint()));
