// The ray tree as a drawing: circles are rays, squares shadow rays. Only what lies in the pane is drawn.
const MOST_DRAWN = 1500;
// Pixels: between leaves, shadow rays and levels, growing downwards or to the right.
const DOWN = { leaf: 46, square: 21, capped: 40, level: 76 }, SIDEWAYS = { leaf: 34, square: 19, capped: 22, level: 86 };
const svg = byId("tree");
const content = draw("g");
const overlay = draw("g");
svg.append(content, overlay);

const grouped = (items, keyOf) => {
  const groups = new Map();
  items.forEach((item, i) => {
    const key = keyOf(item);
    if (!groups.has(key)) groups.set(key, []);
    groups.get(key).push([item, i]);
  });
  return groups;
};
const childrenOf = grouped(DATA.nodes, (node) => node.parent);
const shadowsOf = grouped(DATA.shadows, (shadow) => shadow.node);
const cappedOf = grouped(DATA.capped, (capped) => capped.node);
const listOf = (groups, key) => groups.get(key) || [];
const inTree = (node) => node.parent >= 0 && nodes.has(node.parent);

// Without recursion: a tree may be as deep as it likes. Widths from the leaves up, places from the roots down.
function layTree(sizes) {
  const width = new Map(), place = new Map(), level = new Map(), start = new Map();
  // Shadow rays hang on a node like children, or stand beside it if there are children.
  const squaresOf = (id) => listOf(shadowsOf, id), hasChildren = (id) => childrenOf.has(id);
  const own = (id) => (hasChildren(id) ? 0 : sizes.square * squaresOf(id).length) + sizes.capped * listOf(cappedOf, id).length;
  const least = (id) => (hasChildren(id) ? 2 * (20 + sizes.square * squaresOf(id).length) : sizes.leaf);
  const below = (id) => listOf(childrenOf, id).reduce((sum, [child]) => sum + width.get(child.id), 0);
  for (let i = DATA.nodes.length - 1; i >= 0; --i) {
    const { id } = DATA.nodes[i];
    width.set(id, Math.max(least(id), own(id) + below(id)));
  }
  let next = 0, deepest = 0;
  for (const node of DATA.nodes) {
    const { id } = node, room = width.get(id);
    if (!inTree(node)) { start.set(id, next); next += room; }
    let at = start.get(id) + (room - own(id) - below(id)) / 2;
    const take = (size) => { at += size; return at - size / 2; };
    const across = start.get(id) + room / 2, along = (inTree(node) ? level.get(node.parent) + 1 : 0) * sizes.level;
    const squares = squaresOf(id).map(([, i], j) =>
      hasChildren(id) ? [i, across + 20 + sizes.square * (j + 0.5), along, j ? across + 28 + sizes.square * (j - 0.5) : across + 14]
        : [i, take(sizes.square), along + 35]);
    for (const [child] of listOf(childrenOf, id)) { start.set(child.id, at); at += width.get(child.id); }
    const capped = listOf(cappedOf, id).map(([, i]) => [i, take(sizes.capped)]);
    level.set(id, inTree(node) ? level.get(node.parent) + 1 : 0);
    deepest = Math.max(deepest, level.get(id));
    place.set(id, { across, along, squares, capped });
  }
  return { place, sizes, across: Math.max(next, sizes.leaf), along: deepest * sizes.level };
}
const layouts = [layTree(DOWN), layTree(SIDEWAYS)];
let laid = layouts[0];
const isSideways = () => laid === layouts[1];
// From the tree's directions to x and y.
const spot = (across, along) => (isSideways() ? [along, across] : [across, along]);
const spotOf = (id) => spot(laid.place.get(id).across, laid.place.get(id).along);
// `sx` and `sy` differ only in the overview of a large tree, where rays are dots.
const treeView = { x: 0, y: 0, sx: 1, sy: 1, chosen: false };
const LEGIBLE = 0.4, DETAILED = 0.6, LARGE = 150;
const isOverview = () => treeView.sx !== treeView.sy;
let whole = { sx: 1, sy: 1, isLarge: false };

// All of the tree in its pane, in the direction in which it is drawn larger.
function fitTree() {
  const { clientWidth: width, clientHeight: height } = svg;
  if (width < 2 || height < 2) return;
  const [down, sideways] = layouts;
  const bareDown = Math.min((width - 24) / down.across, (height - 100) / (down.along || 1), 1.2);
  const bareSideways = Math.min((height - 16) / sideways.across, (width - 150) / (sideways.along || 1), 1.2);
  const before = laid, bare = Math.max(bareDown, bareSideways);
  laid = bareSideways > 1.05 * bareDown ? sideways : down;
  if (laid !== before) forgetDrawn();
  const [w, h] = spot(laid.across, laid.along);
  const least = Math.max(bare, LEGIBLE);
  whole = { sx: least, sy: least, isLarge: bare < LEGIBLE && DATA.nodes.length > LARGE };
  if (whole.isLarge) {
    whole.sx = Math.min(1, (width - 24) / (w || 1));
    whole.sy = Math.min(1, (height - 40) / (h || 1));
    if (whole.sx === whole.sy) whole.sx *= 0.999;
  }
  Object.assign(treeView, { sx: whole.sx, sy: whole.sy });
  treeView.x = isSideways() && !whole.isLarge ? Math.max(30, (width - w * treeView.sx - 90) / 2) : (width - w * treeView.sx) / 2;
  treeView.y = isSideways() || whole.isLarge ? (height - h * treeView.sy) / 2 : 28 + Math.max(0, (height - 90 - h * treeView.sy) / 2) * 0.6;
  showInTree(state.node);
}

const onPane = ([x, y]) => [treeView.x + x * treeView.sx, treeView.y + y * treeView.sy];

// Moves the tree so that the node lies within the pane.
function showInTree(id) {
  if (!laid.place.has(id)) return;
  const { clientWidth: width, clientHeight: height } = svg, [x, y] = onPane(spotOf(id)), overview = isOverview();
  const right = width - (isSideways() && !overview ? 90 : 20), bottom = height - (isSideways() || overview ? 16 : 66);
  if (x < 16 || x > right) treeView.x += width * (isSideways() ? 0.4 : 0.5) - x;
  if (y < 16 || y > bottom) treeView.y += height * (isSideways() ? 0.5 : 0.4) - y;
}

const edgeWidth = (node) => (1 + 4 * Math.sqrt(Math.min(1, Math.max(0, node.weight || 0)))).toFixed(2);
const endOf = (node) => [node.tir ? "TIR" : "", node.end === "none" ? "" : node.end].filter(Boolean).join(", ");

// From below a circle to above another one.
function curve(from, to) {
  const half = (to[1] - from[1]) / 2;
  const points = [from, [from[0], from[1] + half], [to[0], to[1] - half], to].map(([across, along]) => spot(across, along).join(" "));
  return `M${points[0]}C${points[1]} ${points[2]} ${points[3]}`;
}

// A text beyond what hangs on a node: below it, or to its right.
function endText(text, across, along) {
  const [x, y] = spot(across, along);
  return draw("text", { class: "end", x, y, ...(isSideways() ? { style: "text-anchor: start" } : {}) }, text);
}

function squareElement([i, at, down, from], { across, along }) {
  const shadow = DATA.shadows[i], kind = shadow.visible ? "reaches" : "blocked", [x, y] = spot(at, down);
  const beside = from && `M${spot(from, along).join(" ")}L${spot(at - 8, down).join(" ")}`;
  return draw("g", { class: "square " + kind },
    draw("path", { class: "edge " + kind, "stroke-width": 1.3, d: beside || curve([across, along + 14], [at, down - 8]),
      ...(shadow.visible ? {} : { "stroke-dasharray": "3 3" }) }),
    draw("rect", { x: x - 8, y: y - 8, width: 16, height: 16, rx: 3, "stroke-width": 1.5 }),
    draw("text", { x, y: y + 0.5 }, (shadow.visible ? "L" : "×") + subscript(shadow.light)),
    draw("title", {}, `shadow ray to light ${shadow.light}: ` +
      (shadow.visible ? "visible" : "blocked" + (shadow.blocker ? " by " + shadow.blocker : ""))));
}

// A short piece of the ray that was not followed, with a bar across its end.
function cappedElement(at, i, { across, along }) {
  const capped = DATA.capped[i], end = along + 36, bar = [spot(at - 7, end), spot(at + 7, end)].map((p) => p.join(" "));
  return draw("g", { class: "capped " + capped.kind },
    draw("path", { class: "edge", "stroke-width": 1.5, d: curve([across, along + 14], [at, end]), "stroke-dasharray": "2 4" }),
    draw("path", { class: "edge", "stroke-width": 2.5, d: `M${bar[0]}L${bar[1]}` }), endText(capped.reason, at, along + (isSideways() ? 42 : 46)),
    draw("title", {}, `${capped.kind} ray not followed: ${capped.reason}`));
}

// The circle with its letter: a button.
function nodeMark(node, x, y) {
  const end = endOf(node), size = node.id > 999 ? 8 : node.id > 99 ? 10 : 12;
  const name = `${rayName(node)}, depth ${node.depth}` + (node.hit ? `, hits ${node.hit}` : "") + `, weight ${show(node.weight, 3)}` +
    (end ? ", " + end : "") + (node.orphan ? ", orphan" : "");
  return draw("g", { class: "node " + node.kind, role: "button", tabindex: "-1", "data-node": node.id, "aria-label": name },
    draw("title", {}, name), draw("circle", { class: "halo", cx: x, cy: y, r: 18 }), draw("circle", { cx: x, cy: y, r: 14 }),
    draw("text", { class: "letter", x, y: y + 0.5, style: `font-size: ${size}px` }, labelOf(node)));
}

function nodeElement(node) {
  const place = laid.place.get(node.id), { across, along } = place, [x, y] = spotOf(node.id), group = draw("g");
  if (inTree(node)) {
    const above = laid.place.get(node.parent), from = [above.across, above.along + 14], to = [across, along - 14];
    group.append(draw("path", { class: "edge " + node.kind, "stroke-width": edgeWidth(node), d: curve(from, to) }));
    const [mx, my] = isSideways() ? spot(across - 9, along - 33) : spot((from[0] + to[0]) / 2 + 9, (from[1] + to[1]) / 2);
    const share = node.share === null ? "NaN" : show(node.share, 2);
    if (DATA.nodes.length <= 80 && node.share !== 1)
      group.append(draw("text", { class: "share", x: mx, y: my, ...(isSideways() ? {} : { style: "text-anchor: start" }) }, share));
  }
  const squares = place.squares.map((square) => [squareElement(square, place), DATA.shadows[square[0]], SHADOW, square[0]]);
  const capped = place.capped.map(([i, at]) => [cappedElement(at, i, place), DATA.capped[i], LEFT_OUT, i]);
  const end = endOf(node), button = nodeMark(node, x, y);
  const choose = (event) => { selectNode(node.id); event.stopPropagation(); };
  const marks = [...squares, ...capped];
  for (const [mark] of marks) mark.addEventListener("click", choose);
  button.addEventListener("click", choose);
  button.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    choose(event);
  });
  group.append(...marks.map(([mark]) => mark), button);
  // Where a ray that was not followed says why, the node need not.
  if (node.orphan) group.append(draw("text", { class: "end", x, y: y - 23 }, "orphan"));
  if (end && !(capped.length && !node.tir))
    group.append(endText(end, across, along + (squares.length ? (isSideways() ? 48 : 53) : isSideways() ? 20 : 25)));
  return { group, button, marks };
}

const drawn = new Map();
function forgetDrawn() {
  content.replaceChildren();
  drawn.clear();
}

function visibleNodes() {
  const { clientWidth: width, clientHeight: height } = svg, reach = 60;
  const shown = [];
  for (const node of DATA.nodes) {
    const [x, y] = onPane(spotOf(node.id)), [px, py] = inTree(node) ? onPane(spotOf(node.parent)) : [x, y];
    if (Math.max(x, px) > -reach && Math.min(x, px) < width + reach && Math.max(y, py) > -reach && Math.min(y, py) < height + reach) shown.push(node);
  }
  if (shown.length <= MOST_DRAWN) return { shown, left: 0 };
  shown.sort((a, b) => laid.place.get(a.id).along - laid.place.get(b.id).along);
  const kept = shown.slice(0, MOST_DRAWN);
  if (nodes.has(state.node) && !kept.includes(nodes.get(state.node))) kept.push(nodes.get(state.node));
  return { shown: kept, left: shown.length - kept.length };
}

// A large tree as a whole: lines and dots of each kind as one path; strokes keep their width.
function paintOverview() {
  const lines = new Map();
  const put = (key, text) => { if (!lines.has(key)) lines.set(key, []); lines.get(key).push(text); };
  for (const node of DATA.nodes) {
    const key = node.kind + (isReached(followedAt.get(node.id)) ? "" : " later"), at = spotOf(node.id).join(" ");
    if (inTree(node)) put(key + " edge", `M${spotOf(node.parent).join(" ")}L${at}`);
    put(key + " dot", `M${at}h0`);
  }
  const dot = DATA.nodes.length > 3000 ? 3 : 5, keys = [...lines.keys()].sort().reverse();
  forgetDrawn();
  content.append(...keys.map((key) => draw("path", {
    class: "edge " + key, d: lines.get(key).join(""), "vector-effect": "non-scaling-stroke", "stroke-linecap": "round",
    "stroke-width": key.endsWith("dot") ? dot : 1, "stroke-opacity": key.endsWith("dot") ? 1 : 0.5,
  })));
  const node = nodes.get(state.node), [x, y] = onPane(spotOf(state.node));
  const mark = nodeMark(node, 0, 0);
  mark.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)}) scale(.75)`);
  mark.classList.add("selected");
  mark.setAttribute("tabindex", "0");
  overlay.replaceChildren(mark);
}

function paintTree() {
  if (!order.length || svg.clientWidth < 2) return;
  content.setAttribute("transform", `translate(${treeView.x.toFixed(2)} ${treeView.y.toFixed(2)}) scale(${treeView.sx} ${treeView.sy})`);
  if (isOverview()) {
    paintOverview();
    noteTree(["zoom in for names"]);
    return;
  }
  if (!drawn.size) content.replaceChildren();
  overlay.replaceChildren();
  const { shown, left } = visibleNodes(), wanted = new Set(shown.map((node) => node.id));
  for (const [id, { group, button }] of drawn)
    if (!wanted.has(id) && button !== document.activeElement) {
      group.remove();
      drawn.delete(id);
    }
  const event = currentEvent();
  for (const node of shown) {
    if (!drawn.has(node.id)) {
      drawn.set(node.id, nodeElement(node));
      content.append(drawn.get(node.id).group);
    }
    const { group, button, marks } = drawn.get(node.id), chosen = node.id === state.node;
    group.classList.toggle("later", !isReached(followedAt.get(node.id)));
    button.classList.toggle("selected", chosen);
    button.setAttribute("tabindex", chosen ? "0" : "-1");
    if (chosen) button.setAttribute("aria-current", "true");
    else button.removeAttribute("aria-current");
    for (const [mark, entry, kind, i] of marks) {
      const at = kind === SHADOW ? shadowAt.get(entry.node + "/" + entry.light) : leftOutAt.get(entry.node + "/" + entry.kind);
      mark.classList.toggle("later", !isReached(at) && isReached(followedAt.get(node.id)));
      mark.classList.toggle("current", event !== undefined && event.kind === kind && event.index === i);
    }
  }
  noteTree(left ? [`${left} of them not drawn: zoom in`] : []);
}

function noteTree(notes) {
  const count = `${DATA.nodes.length} ${DATA.nodes.length === 1 ? "ray" : "rays"}`;
  const hidden = DATA.hidden ? [`${DATA.hidden} deeper ones are not in this page`] : [];
  byId("tree-note").textContent = [count, ...hidden, ...notes].join(" · ");
}

let treeFrame = 0;
function repaintTree() {
  if (!treeFrame) treeFrame = requestAnimationFrame(() => { treeFrame = 0; paintTree(); });
}

function zoomTree(factor, clientX, clientY) {
  const box = svg.getBoundingClientRect(), x = clientX - box.left, y = clientY - box.top;
  let [sx, sy] = [treeView.sx / factor, treeView.sy / factor];
  if (isOverview()) {
    // Names are legible once rays beside one another stand far enough apart.
    if (spot(sx, sy)[0] >= LEGIBLE) sx = sy = DETAILED;
    else [sx, sy] = [Math.max(whole.sx, sx), Math.min(1, Math.max(whole.sy, sy))];
  } else if (whole.isLarge && sx < LEGIBLE) [sx, sy] = isSideways() ? [whole.sx, 0.9 * LEGIBLE] : [0.9 * LEGIBLE, whole.sy];
  else sx = sy = Math.min(4, Math.max(0.2, sx));
  treeView.x = x - ((x - treeView.x) * sx) / treeView.sx;
  treeView.y = y - ((y - treeView.y) * sy) / treeView.sy;
  Object.assign(treeView, { sx, sy, chosen: true });
  repaintTree();
}

// In the overview a tap chooses the nearest dot.
function tapTree(event) {
  if (!isOverview()) return;
  const box = svg.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
  let found = -1, nearest = 14;
  for (const { id } of DATA.nodes) {
    const [px, py] = onPane(spotOf(id)), far = Math.hypot(px - x, py - y);
    if (far < nearest) { nearest = far; found = id; }
  }
  selectNode(found);
}

function moveTree(dx, dy) {
  treeView.x += dx;
  treeView.y += dy;
  treeView.chosen = true;
  repaintTree();
}

follow(svg, { drag: moveTree, pan: moveTree, pinch: zoomTree, tap: tapTree });
onWheel(svg, zoomTree);
byId("tree-fit").addEventListener("click", () => wholeTree());
function wholeTree() {
  treeView.chosen = false;
  fitTree();
  repaintTree();
}

new ResizeObserver(() => {
  if (!treeView.chosen) fitTree();
  paintTree();
}).observe(svg);

let lastShown = -1;
onChange(() => {
  const hadFocus = svg.contains(document.activeElement);
  if (state.node !== lastShown && svg.clientWidth > 0) showInTree(state.node);
  lastShown = state.node;
  paintTree();
  if (hadFocus) svg.querySelector(".selected")?.focus({ preventScroll: true });
});
if (!order.length)
  byId("tree-pane").querySelector(".body").append(make("p", { class: "nothing" }, "Nothing was traced. An exercise that has not been attempted looks like this."));
