// A scene in space, seen from the direction of an azimuth and an elevation, without perspective.
const camera = {azimuth: 0, elevation: 0, begin: allowTurning, onKey: turnByKey, keys: "; shift and arrows, or the mouse, turn the view"};
function seen(x, y, z, flat) {
  if (flat) return [x, y];
  const ca = Math.cos(camera.azimuth), sa = Math.sin(camera.azimuth);
  const ce = Math.cos(camera.elevation), se = Math.sin(camera.elevation);
  return [ca * y - sa * x, ce * z - se * (ca * x + sa * y)];
}

// The directions in space that point right and up on the screen.
function directionsSeen() {
  const ca = Math.cos(camera.azimuth), sa = Math.sin(camera.azimuth), ce = Math.cos(camera.elevation), se = Math.sin(camera.elevation);
  return [[-sa, ca, 0], [-se * ca, -se * sa, ce]];
}

// The size does not depend on the azimuth, so that the scale is constant while the view turns.
function sizeSeen([width, height]) {
  return [width, height * Math.cos(camera.elevation) + width * Math.abs(Math.sin(camera.elevation))];
}
function turn(right, up) {
  camera.azimuth -= right;
  camera.elevation = Math.max(-1.55, Math.min(1.55, camera.elevation + up));
  drawStill();
}
function resetView() {
  [camera.azimuth, camera.elevation] = scene.view;
  drawStill();
}
function turnByKey(event) {
  const turns = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]}[event.key];
  if (!event.shiftKey || !turns) return false;
  turn(...turns);
  return true;
}
function allowTurning() {
  const canvas = byId("live");
  let from = null;
  [camera.azimuth, camera.elevation] = scene.view;
  canvas.classList.add("space");
  byId("reset").hidden = false;
  byId("reset").addEventListener("click", resetView);
  canvas.addEventListener("pointerdown", (event) => { from = event; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointermove", (event) => {
    if (!from) return;
    turn((event.clientX - from.clientX) / 150, (event.clientY - from.clientY) / 150);
    from = event;
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { from = null; });
}
