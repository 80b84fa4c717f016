"use strict";
// Replace a still by its scene near the viewport, as soon as the scene has loaded; restore the still away from it.
function play(figure) {
  if (figure.querySelector("iframe")) return;
  const frame = document.createElement("iframe");
  frame.src = figure.dataset.page;
  frame.title = `${figure.dataset.title}, a scene that plays`;
  frame.setAttribute("sandbox", "allow-scripts");
  frame.addEventListener("load", () => figure.classList.add("playing"));
  figure.append(frame);
}
function stop(figure) {
  const frame = figure.querySelector("iframe");
  if (!frame || frame === document.activeElement) return;
  frame.remove();
  figure.classList.remove("playing");
}
const watched = new IntersectionObserver((entries) => {
  for (const {target, isIntersecting} of entries) (isIntersecting ? play : stop)(target);
}, {rootMargin: "100px"});
// The theme gives the arrows that open its menus no label.
document.querySelectorAll("details > summary").forEach((summary) => {
  const link = summary.closest("li")?.querySelector("a");
  if (!summary.textContent.trim() && link) summary.setAttribute("aria-label", `Pages of ${link.textContent.trim()}`);
});
document.querySelectorAll("figure.scene").forEach((figure) => watched.observe(figure));
