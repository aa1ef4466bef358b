// The picture with a cross-hair at the pixel.
function layPicture() {
  const image = byId("picture"), figure = byId("figure"), [width, height] = DATA.size;
  if (!image.getAttribute("src")) {
    figure.replaceWith(make("p", { class: "none" }, "This tree comes without a picture."));
    return;
  }
  image.alt = DATA.pixel ? `The picture; the cross-hair is at pixel ${DATA.pixel[0]},${DATA.pixel[1]}` : "The picture";
  const pane = byId("picture-pane").querySelector(".body");
  const fit = () => {
    const room = pane.clientWidth - 16, isFixed = getComputedStyle(byId("picture-pane")).flexGrow === "0";
    const most = printing ? 240 : Math.max(120, (isFixed ? 0.4 : 0.34) * innerHeight);
    const w = Math.max(20, Math.min(room, (most * width) / height));
    figure.style.width = w + "px";
    figure.style.height = (w * height) / width + "px";
    image.style.imageRendering = image.naturalWidth && image.naturalWidth * 2 < w ? "pixelated" : "auto";
  };
  new ResizeObserver(fit).observe(pane);
  addEventListener("resize", fit);
  onChange(fit);
  image.addEventListener("load", fit);
  fit();
  if (!DATA.pixel) return;
  const at = [(100 * (DATA.pixel[0] + 0.5)) / width, (100 * (DATA.pixel[1] + 0.5)) / height];
  const cross = draw("svg", { "aria-hidden": "true" });
  for (const layer of ["below", "above"]) {
    const arm = (x1, y1, x2, y2) => draw("line", { class: layer, x1, y1, x2, y2 });
    const ring = draw("svg", { x: at[0] + "%", y: at[1] + "%", overflow: "visible" }, draw("circle", { class: layer, r: 7 }),
      arm(0, -4000, 0, -11), arm(0, 11, 0, 4000), arm(-4000, 0, -11, 0), arm(11, 0, 4000, 0));
    cross.append(ring);
  }
  figure.append(cross);
}

function fillHeader() {
  const parts = [DATA.scene, DATA.sceneFile, DATA.real].filter(Boolean);
  byId("subtitle").textContent = parts.join(" · ");
  byId("pixel").hidden = !order.length;
  if (!order.length) return;
  const root = DATA.nodes[0], where = DATA.pixel ? `pixel ${DATA.pixel[0]},${DATA.pixel[1]}` : "ray";
  byId("pixel-text").textContent = `${where} = ${root.returned}`;
  paintSwatch(byId("pixel-swatch"), root.swatch);
}

function paintSwatch(swatch, color) {
  swatch.style.background = color || "";
  swatch.classList.toggle("none", !color);
}
