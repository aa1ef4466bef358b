// What the pages can do besides being read. Without it everything is there but the switch of colours.
(() => {
  const root = document.documentElement;
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const shown = () => root.dataset.theme || (dark.matches ? "dark" : "light");

  // The embedded ray trees follow the page.
  function tell(frame) {
    const address = frame.getAttribute("src").split("#")[0];
    frame.src = `${address}#theme=${shown()}`;
  }
  const frames = [...document.querySelectorAll("figure.tree iframe")];
  const tellAll = () => frames.forEach(tell);  // by itself a ray tree is as dark as the system

  const button = document.getElementById("theme");
  button.addEventListener("click", () => {
    root.dataset.theme = shown() === "dark" ? "light" : "dark";
    try { localStorage.setItem("raytree-theme", root.dataset.theme); } catch (error) { /* not remembered, that is all */ }
    tellAll();
  });
  if (root.dataset.theme) tellAll();

  // What scrolls sideways can be reached with the keyboard.
  function reach() {
    for (const box of document.querySelectorAll(".scrolls"))
      if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
      else box.removeAttribute("tabindex");
  }
  for (const event of ["resize", "load"]) addEventListener(event, reach);
  if (document.fonts) {
    document.fonts.addEventListener("loadingdone", reach);
    document.fonts.ready.then(reach);
  }
  reach();

  // The list of pages opens where the current one is; Escape closes it where it covers the text.
  const pages = document.getElementById("contents");
  const current = pages.querySelector("[aria-current]");
  if (current) pages.scrollTop = Math.max(0, current.offsetTop - pages.clientHeight / 2);
  addEventListener("keydown", (event) => {
    if (event.key === "Escape" && location.hash === "#contents") location.hash = "#main";
  });

  // On paper everything is open.
  addEventListener("beforeprint", () => document.querySelectorAll("details:not([open])").forEach((d) => { d.open = true; d.dataset.printed = ""; }));
  addEventListener("afterprint", () => document.querySelectorAll("details[data-printed]").forEach((d) => { d.open = false; delete d.dataset.printed; }));

  // Where on the page the reader is.
  const links = new Map([...document.querySelectorAll(".toc a")].map((link) => [link.getAttribute("href").slice(1), link]));
  if (links.size && "IntersectionObserver" in window) {
    const seen = new IntersectionObserver((entries) => {
      for (const entry of entries)
        if (entry.isIntersecting) {
          links.forEach((link) => link.removeAttribute("aria-current"));
          links.get(entry.target.id).setAttribute("aria-current", "location");
        }
    }, { rootMargin: "-10% 0px -75% 0px" });
    links.forEach((_, id) => { const heading = document.getElementById(id); if (heading) seen.observe(heading); });
  }

  // Commands can be taken along.
  for (const box of document.querySelectorAll(".listing.sh")) {
    if (!navigator.clipboard) break;
    const copy = document.createElement("button");
    copy.type = "button";
    copy.className = "copy";
    copy.textContent = "Copy";
    copy.addEventListener("click", () => navigator.clipboard.writeText(box.querySelector("code").innerText.replace(/\n\n/g, "\n"))
      .then(() => { copy.textContent = "Copied"; setTimeout(() => { copy.textContent = "Copy"; }, 1500); }, () => {}));
    box.append(copy);
  }
})();
