// The tracer's source with the current line lit, as in a debugger.
// Words of C++, texts, numbers and comments: enough to read by.
const KEYWORDS = "alignas auto bool break case catch class concept const constexpr continue default do " +
  "double else enum explicit false float for if inline int namespace operator private " +
  "public requires return static struct switch template this throw true try typename using void while";
const WORDS = new RegExp([
  /(\/\/.*)/, /("(?:[^"\\]|\\.)*"|#\w+)/,
  new RegExp(`\\b(${KEYWORDS.replaceAll(" ", "|")})\\b`),
  /\b(\d[\w.]*)\b/,
].map((part) => part.source).join("|"), "g");

function coloured(text) {
  const parts = [];
  let at = 0;
  for (const match of text.matchAll(WORDS)) {
    parts.push(text.slice(at, match.index));
    const which = ["c", "s", "k", "n"][match.slice(1).findIndex((group) => group !== undefined)];
    parts.push(make("span", { class: which }, match[0]));
    at = match.index + match[0].length;
  }
  parts.push(text.slice(at));
  return parts;
}

const codeLines = [];
function layCode() {
  byId("code-file").textContent = DATA.source.file;
  byId("code-file").title = DATA.source.file;
  if (!DATA.source.text) {
    byId("code").append(make("p", { class: "nothing" }, "This tree comes without its source."));
    return;
  }
  const list = make("ol");
  const hidden = new Set(DATA.source.hidden);
  DATA.source.text.replace(/\n$/, "").split("\n").forEach((text, i) => {
    const words = make("span", {}, ...coloured(text));
    // What is too long for the pane goes on below, further in.
    words.style.setProperty("--hang", `${text.search(/\S|$/) + 8}ch`);
    const line = make("li", {}, make("b", { "aria-hidden": "true" }, String(i + 1)), words);
    line.hidden = hidden.has(i + 1);
    codeLines.push(line);
    list.append(line);
  });
  byId("code").append(list);
}

function currentLine() {
  const event = currentEvent(), node = nodes.get(state.node);
  if (event && event.node === state.node) return event.line;
  return node ? node.line : 0;
}

let litLine;
function lightLine() {
  const line = codeLines[currentLine() - 1], pane = byId("code");
  if (litLine === line) return;
  if (litLine) { litLine.classList.remove("lit"); litLine.removeAttribute("aria-current"); }
  litLine = line;
  if (!line) return;
  line.classList.add("lit");
  line.setAttribute("aria-current", "true");
  const top = line.offsetTop - pane.offsetTop, bottom = top + line.offsetHeight;
  const from = line.getBoundingClientRect().top - pane.getBoundingClientRect().top;
  if (from < 30 || from > pane.clientHeight - 50) pane.scrollTop += from - pane.clientHeight * 0.4;
}
new ResizeObserver(() => {
  const line = litLine;
  litLine = undefined;
  if (line) lightLine();
}).observe(byId("code"));
onChange(lightLine);
