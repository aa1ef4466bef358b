// Two pictures of one size, one above the other: a native slider moves the edge between them. Without script, side by side.
function comparePictures(figure) {
  const [before, after] = figure.querySelectorAll("img");
  if (!before || !after) return;
  const stack = element("div", { className: "slider-stack" });
  const top = element("div", { className: "slider-top" });
  const input = element("input", { type: "range", min: 0, max: 100, step: 1, value: 50 });
  const edge = element("div", { className: "slider-edge" });
  const names = [before, after].map((image) => image.dataset.label || image.alt);
  const labels = names.map((name, i) => element("span", { className: `slider-label ${i ? "right" : "left"}`, textContent: name }));
  edge.setAttribute("aria-hidden", "true");
  labels.forEach((label) => label.setAttribute("aria-hidden", "true"));
  input.setAttribute("aria-label", `Edge between the two pictures: left ${names[0]}, right ${names[1]}`);
  const move = () => {
    stack.style.setProperty("--edge", `${input.value}%`);
    input.setAttribute("aria-valuetext", `${input.value} % ${names[0]}`);
  };
  input.addEventListener("input", move);
  before.before(stack);
  top.append(before);
  stack.append(after, top, edge, ...labels, input);
  // The box has the shape of the pictures as soon as one of them is known, so that nothing jumps.
  const shape = (image) => { if (image.naturalWidth) stack.style.aspectRatio = `${image.naturalWidth} / ${image.naturalHeight}`; };
  for (const image of [before, after]) {
    image.loading = "eager"; // the hidden half of a lazy picture would come late
    image.draggable = false;
    shape(image);
    image.addEventListener("load", () => shape(image));
  }
  move();
  figure.classList.add("ready");
}
