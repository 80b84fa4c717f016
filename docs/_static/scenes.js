"use strict";
// A still gives way to its scene, once that is loaded, while it is near the screen, and comes back when it is left.
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
// The theme's menus open by an arrow that has no name.
document.querySelectorAll("details > summary").forEach((summary) => {
  const link = summary.closest("li")?.querySelector("a");
  if (!summary.textContent.trim() && link) summary.setAttribute("aria-label", `Pages of ${link.textContent.trim()}`);
});
document.querySelectorAll("figure.scene").forEach((figure) => watched.observe(figure));
