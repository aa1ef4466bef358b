// What is shown and what is selected. Views draw it; actions change it; the address holds it.
"use strict";

const DATA = JSON.parse(document.getElementById("data").textContent);
const FOLLOW = 0, SHADOW = 1, LEFT_OUT = 2, RETURNS = 3;
const ROLES = ["camera", "reflected", "transmitted", "reaches", "blocked", "beyond", "normal"];
const LETTERS = { camera: "D", reflected: "R", transmitted: "T", reaches: "L", blocked: "L×" };
const KIND_NAMES = { camera: "camera", reflected: "reflected", transmitted: "transmitted", reaches: "light", blocked: "shadow" };
const KINDS = Object.keys(LETTERS);

const byId = (id) => document.getElementById(id);
const nodes = new Map(DATA.nodes.map((node) => [node.id, node]));
const order = DATA.nodes.map((node) => node.id);
const events = DATA.events.map(([kind, node, index, line, text]) => ({ kind, node, index, line, text }));
const LAST = events.length;

// The step at which each thing happens.
const followedAt = new Map(), shadowAt = new Map(), leftOutAt = new Map();
events.forEach((event, i) => {
  const keep = (map, key) => { if (!map.has(key)) map.set(key, i + 1); };
  if (event.kind === FOLLOW) keep(followedAt, event.node);
  if (event.kind === SHADOW) keep(shadowAt, event.node + "/" + DATA.shadows[event.index].light);
  if (event.kind === LEFT_OUT) keep(leftOutAt, event.node + "/" + DATA.capped[event.index].kind);
});

const state = {
  node: order.length ? order[0] : -1,
  step: LAST,
  normals: true,
  hidden: new Set(),
  playing: false,
  theme: "",
  view: "",
};

const views = [];
function onChange(view) { views.push(view); }

let hashTimer = 0;
function changed() {
  for (const view of views) view();
  document.title = titleText();
  clearTimeout(hashTimer);
  hashTimer = setTimeout(writeHash, 60);
}

const isReached = (step) => step === undefined || step <= state.step;
const currentEvent = () => (state.step > 0 ? events[state.step - 1] : undefined);
const subscript = (number) => String(number).replace(/[0-9]/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]);
const labelOf = (node) => LETTERS[node.kind] + subscript(node.id);
const rayName = (node) => `${node.kind} ray [${node.id}]`;
// A number with so many digits, as short as it can be.
function show(x, digits = 4) {
  if (x === null || x === undefined) return "not a number";
  if (x === 0) return "0";
  const isOdd = Math.abs(x) < 1e-3 || Math.abs(x) >= 1e6;
  return isOdd ? x.toExponential(digits - 1).replace(/\.?0*e/, "e").replace("e+", "e") : String(Number(x.toPrecision(digits)));
}

function titleText() {
  const where = DATA.pixel ? `pixel ${DATA.pixel[0]},${DATA.pixel[1]}` : "ray";
  if (state.node < 0) return `${where} · nothing was traced - raytree`;
  return `${where} · node ${state.node} · step ${state.step}/${LAST} - raytree`;
}

function selectNode(id) {
  if (!nodes.has(id)) return;
  stop();
  state.node = id;
  const followed = followedAt.get(id);
  if (!isReached(followed)) state.step = followed;
  changed();
}

function goToStep(step) {
  if (LAST === 0) return;
  state.step = Math.min(LAST, Math.max(1, step));
  state.node = events[state.step - 1].node;
  changed();
}

function selectBeside(offset) {
  const at = order.indexOf(state.node) + offset;
  if (at >= 0 && at < order.length) selectNode(order[at]);
}

function selectParent() {
  const node = nodes.get(state.node);
  if (node && node.parent >= 0) selectNode(node.parent);
}

function toggleKind(kind) {
  if (!state.hidden.delete(kind)) state.hidden.add(kind);
  changed();
}

function toggleNormals() {
  state.normals = !state.normals;
  changed();
}

let playTimer = 0;
function stop() {
  clearInterval(playTimer);
  state.playing = false;
}

function togglePlay() {
  if (LAST === 0) return;
  if (state.playing) { stop(); changed(); return; }
  state.playing = true;
  goToStep(state.step >= LAST ? 1 : state.step + 1);
  playTimer = setInterval(() => {
    if (state.step + 1 >= LAST) stop();
    goToStep(state.step + 1);
  }, 900);
}

function step(to) {
  stop();
  goToStep(to);
}

function writeHash() {
  const parts = [];
  if (state.node >= 0) parts.push(`node=${state.node}`, `step=${state.step}`);
  if (state.view) parts.push("view=" + state.view);
  if (state.hidden.size) parts.push("hide=" + KINDS.filter((kind) => state.hidden.has(kind)).join(","));
  if (!state.normals) parts.push("normals=0");
  if (state.theme) parts.push("theme=" + state.theme);
  try {
    history.replaceState(null, "", "#" + parts.join("&"));
  } catch {
    // A frame that may not have an address works as well.
  }
}

// What the address does not say, or says wrongly, keeps its default.
function readHash() {
  const given = new URLSearchParams(location.hash.slice(1));
  const whole = (key) => (/^[0-9]{1,9}$/.test(given.get(key) || "") ? Number(given.get(key)) : undefined);
  const at = whole("step"), node = whole("node");
  state.step = at >= 1 && at <= LAST ? at : LAST;
  state.node = nodes.has(node) ? node : at === state.step ? events[at - 1].node : order.length ? order[0] : -1;
  if (!isReached(followedAt.get(state.node))) state.step = followedAt.get(state.node);
  state.hidden = new Set((given.get("hide") || "").split(",").filter((kind) => KINDS.includes(kind)));
  state.normals = given.get("normals") !== "0";
  state.theme = ["dark", "light"].includes(given.get("theme")) ? given.get("theme") : "";
  state.view = given.get("view") || "";
}

// An element with attributes and children; texts are only ever text.
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

function draw(tag, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}
