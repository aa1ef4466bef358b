// The selected node: what it is worth, and each formula of the lecture with its numbers.
function fact(list, name, ...value) {
  list.append(make("dt", {}, name), make("dd", {}, ...value));
}

function formulaBlock([which, filled]) {
  const [title, symbolic] = DATA.formulas[which];
  return make("section", { class: "formula" }, make("h4", {}, title), make("div", { class: "symbolic" }, symbolic),
    make("div", { class: "filled" }, filled));
}

let shownNode;
function fillNumbers() {
  if (shownNode === state.node) return;
  shownNode = state.node;
  const pane = byId("numbers"), node = nodes.get(state.node);
  pane.scrollTop = 0;
  if (!node) {
    pane.replaceChildren(make("p", { class: "nothing" }, "Nothing was traced. An exercise that has not been attempted looks like this."));
    return;
  }
  const facts = make("dl", { class: "facts" }), swatch = make("span", { class: "swatch" });
  paintSwatch(swatch, node.swatch);
  fact(facts, "depth", node.parent >= 0 ? `${node.depth}, from [${node.parent}]` : String(node.depth));
  fact(facts, "weight", node.parent >= 0 ? `${show(node.share)} of its parent, ${show(node.weight)} of the pixel` : show(node.weight));
  fact(facts, "returns", swatch, node.returned);
  fact(facts, "adds itself", node.added);
  const parts = [make("h3", { class: node.kind }, make("span", { class: "key" }, labelOf(node)), rayName(node)), facts];
  if (node.note) parts.push(make("p", { class: "note" }, node.note));
  if (node.formulas) parts.push(...node.formulas.map(formulaBlock));
  else parts.push(make("p", { class: "aside-note" },
    `This page has formulas for the ${DATA.nodes.length - DATA.unexplained} rays that weigh most; this one weighs less.`));
  pane.replaceChildren(...parts);
}
onChange(fillNumbers);
