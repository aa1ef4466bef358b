// Typesets formulas: [[tex, display], ...] as JSON on standard input, [{html} or {error}, ...] on standard output.
const katex = require("katex");
const formulas = JSON.parse(require("fs").readFileSync(0, "utf8"));
const options = { throwOnError: true, strict: "error", output: "htmlAndMathml" };
console.log(JSON.stringify(formulas.map(([tex, displayMode]) => {
  try {
    return { html: katex.renderToString(tex, { ...options, displayMode }) };
  } catch (error) {
    return { error: error.message };
  }
})));
