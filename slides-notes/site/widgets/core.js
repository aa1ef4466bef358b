// A widget is a drawing, sliders and numbers. It declares them; everything that it shows comes from the lessons' C++.

const widgets = {};
let lesson = null; // the exports of the module

// widget("name", { label, view: [width, height], sliders, numbers, update(values, results) })
function widget(name, declaration) {
  widgets[name] = declaration;
}

// The numbers that a function of formulas.cpp leaves behind.
function ask(name, ...values) {
  lesson[name](...values);
  return Array.from(new Float64Array(lesson.memory.buffer, lesson.results(), 16));
}

function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

// As a reader writes it: a real minus sign, and no minus before what is shown as zero.
function digits(value, places = 3) {
  const text = value.toFixed(places);
  return (/^-0(\.0*)?$/.test(text) ? text.slice(1) : text).replace("-", "\u2212");
}

function sliderRow(id, slider, onInput) {
  const input = element("input", { type: "range", id, min: slider.min, max: slider.max, step: slider.step, value: slider.value });
  const output = element("output", { htmlFor: id });
  const show = () => {
    const text = slider.text ? slider.text(read()) : digits(read(), slider.places ?? 0) + (slider.unit ?? "");
    output.textContent = text;
    input.dataset.value = read(); // as it goes to the lesson
    input.setAttribute("aria-valuetext", text);
  };
  const read = () => (slider.value_of ? slider.value_of(input.valueAsNumber) : input.valueAsNumber);
  input.dataset.slider = slider.id;
  input.addEventListener("input", () => { show(); onInput(); });
  show();
  return { row: element("div", { className: "widget-slider" }, element("label", { htmlFor: id, innerHTML: slider.label }), input, output), read, input };
}

function numberRow(number) {
  const cell = element("dd");
  cell.dataset.number = number.id;
  const row = element("div", { className: number.wide ? "wide" : "" }, element("dt", { innerHTML: number.label }), cell);
  return { row, cell };
}

let made = 0;

function build(place) {
  const name = place.dataset.widget, declared = widgets[name];
  if (!declared) {
    place.append(element("p", { className: "widget-says", textContent: `There is no widget "${name}".` }));
    return;
  }
  const id = `widget-${++made}-${name}`;
  const drawing = new Drawing(...declared.view);
  const rows = {}, cells = {};
  const sliders = element("div", { className: "widget-sliders" });
  for (const slider of declared.sliders) {
    rows[slider.id] = sliderRow(`${id}-${slider.id}`, slider, () => update());
    sliders.append(rows[slider.id].row);
  }
  const numbers = element("dl", { className: "widget-numbers" });
  for (const number of declared.numbers) {
    cells[number.id] = numberRow(number);
    numbers.append(cells[number.id].row);
  }
  const says = element("p", { className: "widget-says" }), aloud = element("p", { className: "widget-aloud" });
  aloud.setAttribute("aria-live", "polite");
  place.setAttribute("role", "group");
  place.setAttribute("aria-label", declared.label);
  place.replaceChildren(element("p", { className: "widget-title", textContent: declared.label }), drawing.svg,
    element("div", { className: "widget-side" }, sliders, numbers), says, aloud);

  // A number is kept as computed beside what is shown of it; `undefined` does not exist here.
  const show = (number, value, text) => {
    const cell = cells[number].cell;
    cell.dataset.value = value;
    cell.textContent = text ?? (value === undefined ? "\u2014" : digits(value, declared.numbers.find((n) => n.id === number).places ?? 3));
  };
  let later = 0;
  const update = () => {
    const values = Object.fromEntries(Object.entries(rows).map(([key, row]) => [key, row.read()]));
    drawing.clear();
    says.textContent = declared.update(values, show, drawing);
    drawing.svg.setAttribute("aria-label", says.textContent);
    clearTimeout(later); // it is read aloud after a drag, not at each of its steps, and not as the page opens
    if (place.dataset.ready) later = setTimeout(() => { aloud.textContent = says.textContent; }, 500);
  };
  update();
  place.dataset.ready = "yes";
}

function start() {
  for (const figure of document.querySelectorAll("figure.slider")) comparePictures(figure);
  const places = [...document.querySelectorAll(".widget[data-widget]")];
  if (!places.length) return;
  const bytes = Uint8Array.from(atob(MODULE), (c) => c.charCodeAt(0));
  // The C++ library would like to write messages; nothing here does. 52 is WASI's "not supported".
  const silent = new Proxy({}, { get: () => () => 52 });
  const imports = { wasi_snapshot_preview1: silent };
  const show = (instance) => {
    lesson = instance.exports;
    lesson._initialize();
    places.forEach(build);
  };
  const giveUp = (error) => {
    for (const place of places) {
      if (!place.dataset.ready) place.append(element("p", { className: "widget-says", textContent: `This figure cannot run here: ${error.message}` }));
    }
  };
  // At once where the browser allows it, so that the page does not jump; older ones insist on waiting.
  let instance = null;
  try {
    instance = new WebAssembly.Instance(new WebAssembly.Module(bytes), imports);
  } catch {
    Promise.resolve().then(() => WebAssembly.instantiate(bytes, imports)).then((made) => show(made.instance)).catch(giveUp);
  }
  if (instance) show(instance);
}
