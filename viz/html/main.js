// Steps, keys, and the first drawing.
const KEY_HELP = [
  ["← →", "step back, step on"], ["Home End", "first, last step"], ["Space", "play, pause"], ["↑ ↓", "ray before, next ray"],
  ["PageUp", "parent of the ray"], ["1 - 5", "kinds of rays"], ["n", "normals"], ["r", "whole scene"], ["t", "whole tree"],
  ["+ -", "zoom"], ["Shift + arrows", "turn the scene, when it has the focus"], ["?", "this help"],
];

function toggleHelp() {
  const dialog = byId("keys");
  if (dialog.open) dialog.close();
  else dialog.showModal();
}

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "?") { toggleHelp(); event.preventDefault(); return; }
  if (byId("keys").open) return;
  const target = event.target, tag = target.tagName;
  // Sliders and panes that scroll keep their own keys.
  if (tag === "INPUT" || (event.shiftKey && target === canvas && event.key.startsWith("Arrow"))) return;
  if (target.classList.contains("scrolls") && ["ArrowUp", "ArrowDown", "PageUp", " "].includes(event.key)) return;
  if (event.key === " " && (tag === "BUTTON" || target.getAttribute("role") === "button")) return;
  const actions = {
    ArrowLeft: () => step(state.step - 1), ArrowRight: () => step(state.step + 1), Home: () => step(1), End: () => step(LAST),
    " ": togglePlay, ArrowUp: () => selectBeside(-1), ArrowDown: () => selectBeside(1), PageUp: selectParent, n: toggleNormals,
    r: fitScene, t: wholeTree, "+": () => zoom(0.8), "-": () => zoom(1.25),
  };
  const kind = KINDS["12345".indexOf(event.key)];
  const action = kind && event.key !== "" ? () => toggleKind(kind) : actions[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

function fillStrip() {
  const event = currentEvent();
  byId("first").disabled = byId("previous").disabled = state.step <= 1;
  byId("next").disabled = byId("last").disabled = state.step >= LAST;
  byId("play").disabled = byId("slider").disabled = LAST === 0;
  byId("play").querySelector("path").setAttribute("d", state.playing ? "M8 5v14M16 5v14" : "M8 5l11 7-11 7z");
  byId("play").setAttribute("aria-label", state.playing ? "Pause" : "Play");
  byId("slider").value = state.step;
  byId("slider").setAttribute("aria-valuetext", event ? `step ${state.step} of ${LAST}: ${event.text}` : "");
  const status = byId("status"), text = event ? event.text : "Nothing was traced. An exercise that has not been attempted looks like this.";
  // While it plays a screen reader would never be done.
  status.setAttribute("aria-live", state.playing ? "off" : "polite");
  status.replaceChildren(...(event ? [make("b", {}, `Step ${state.step}/${LAST}:`), " "] : []), text);
}

function start() {
  layPicture();
  fillHeader();
  layCode();
  layChart();
  for (const [keys, what] of KEY_HELP)
    byId("key-list").append(
      make("dt", {}, ...keys.split(" ").map((key) => (key === "-" && keys !== "+ -" ? " - " : make("kbd", {}, key)))),
      make("dd", {}, what));
  byId("slider").max = Math.max(1, LAST);
  byId("slider").addEventListener("input", () => step(Number(byId("slider").value)));
  const buttons = { first: () => step(1), previous: () => step(state.step - 1), play: togglePlay, next: () => step(state.step + 1),
    last: () => step(LAST), help: toggleHelp };
  for (const [id, action] of Object.entries(buttons)) byId(id).addEventListener("click", action);
  byId("close").addEventListener("click", () => byId("keys").close());
  document.addEventListener("keydown", onKey);
  addEventListener("hashchange", restore);
  onChange(fillStrip);
  restore();
}

function restore() {
  stop();
  readHash();
  startDirection();
  viewIsChosen = readView(state.view);
  if (!viewIsChosen) state.view = "";
  changed();
}

start();
