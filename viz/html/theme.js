// Dark and light: as the system says, unless the reader chose.
const systemIsLight = matchMedia("(prefers-color-scheme: light)");
let printing = false;
let palette = {};

function currentTheme() {
  if (printing) return "light";
  return state.theme || (systemIsLight.matches ? "light" : "dark");
}

function applyTheme() {
  const theme = currentTheme();
  if (document.documentElement.dataset.theme === theme && palette.text) return;
  document.documentElement.dataset.theme = theme;
  const style = getComputedStyle(document.documentElement);
  palette = {};
  for (const name of ["window", "panel", "raised", "line", "sky-low", "sky-high", "text", "dim", "faint", "accent", "ink",
    "camera", "reflected", "transmitted", "reaches", "blocked", "normal"])
    palette[name] = style.getPropertyValue("--" + name).trim();
  palette.beyond = palette.blocked;
}

byId("theme").addEventListener("click", () => {
  state.theme = currentTheme() === "dark" ? "light" : "dark";
  changed();
});
systemIsLight.addEventListener("change", changed);
addEventListener("beforeprint", () => { printing = true; changed(); });
addEventListener("afterprint", () => { printing = false; changed(); });
onChange(applyTheme);

// "#rrggbb" with coverage; an empty colour is no number and becomes grey.
function withAlpha(color, alpha) {
  const value = parseInt((color || "#808080").slice(1), 16);
  return `rgba(${value >> 16}, ${(value >> 8) & 255}, ${value & 255}, ${alpha})`;
}

function mixed(a, b, share) {
  const p = parseInt((a || "#808080").slice(1), 16), q = parseInt(b.slice(1), 16);
  const channel = (shift) => Math.round(((p >> shift) & 255) * (1 - share) + ((q >> shift) & 255) * share);
  return "#" + ((1 << 24) | (channel(16) << 16) | (channel(8) << 8) | channel(0)).toString(16).slice(1);
}
