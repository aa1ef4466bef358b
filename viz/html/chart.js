// Energy per depth: what the rays of each depth carry, and what they add to the pixel.
const chartRows = new Map();

function bar(value, most) {
  const fill = make("span", { class: "fill", style: `width: ${value > 0 && most > 0 ? Math.max(1, (100 * value) / most) : 0}%` });
  return make("div", { class: "bar" }, make("div", { class: "track" }, fill), make("span", {}, show(value, 3)));
}

function layChart() {
  if (!DATA.energy.depths.length) {
    byId("chart").append(make("p", { class: "definition" }, DATA.energy.broken ? "No ray has finite numbers." : "Nothing was traced."));
    return;
  }
  const most = (key) => Math.max(...DATA.energy.depths.map((row) => row[key] || 0));
  const body = make("tbody");
  for (const row of DATA.energy.depths) {
    const line = make("tr", {}, make("td", {}, String(row.depth)), make("td", {}, String(row.rays)),
      make("td", { class: "weight" }, bar(row.weight, most("weight"))), make("td", { class: "gathered" }, bar(row.gathered, most("gathered"))));
    chartRows.set(row.depth, line);
    body.append(line);
  }
  const heads = ["depth", "rays", "weight carried", "radiance gathered"].map((text) => make("th", { scope: "col" }, text));
  const notes = ["Weight: what the pixel would gain if radiance 1 came along every ray of the depth. Radiance: what it does gain " +
    "from the surfaces they hit. Both as brightness, 0.2126 r + 0.7152 g + 0.0722 b."];
  if (DATA.energy.share) notes.unshift(DATA.energy.share + " of the pixel.");
  if (DATA.energy.grouped) notes.push("The last row stands for all deeper ones.");
  if (DATA.energy.broken) notes.push(`${DATA.energy.broken} rays are left out: a number of theirs is not finite.`);
  byId("chart").append(make("table", {}, make("thead", {}, make("tr", {}, ...heads)), body),
    ...notes.map((text) => make("p", { class: "definition" }, text)));
}

onChange(() => {
  const node = nodes.get(state.node);
  for (const [depth, row] of chartRows) row.classList.toggle("current", node !== undefined && node.depth === depth);
});
