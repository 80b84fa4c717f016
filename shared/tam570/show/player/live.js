// The interactive scene: the user drags handles, sliders change parameters, and the motion continues from there.
// `program` has rates(t, s, p), drawn(t, s, p) and grab(t, s, p, q): state s, parameters p, pointer position q.

const grasped = JSON.parse(byId("data").textContent).live, TRAIL = 1500, WINDOW = 10, PIECE = 0.2, STEPS = 500; // s, s; most steps in a call
// alone: only the first panel is shown; set after a drag, because the handle would move away from the pointer.
const live = {on: false, alone: false, held: null, s: [], p: [], t: Infinity, trails: [], past: [], zoom: 1, most: 0};

// Dormand and Prince's pair of orders 5 and 4; the error determines the step size.
const DP = {
  c: [0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1, 1],
  a: [[], [1 / 5], [3 / 40, 9 / 40], [44 / 45, -56 / 15, 32 / 9], [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
    [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656], [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84]],
  e: [71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40],
};
function integrate(s, p, from, to, tolerance = 1e-10) {
  let t = from, h = Math.min(to - from, 0.01), y = s, first = program.rates(t, y, p);
  for (let count = 0; t < to - 1e-12 && count < STEPS; count++) {
    h = Math.min(h, to - t);
    const k = [first];
    let next = y;
    for (let stage = 1; stage < 7; stage++) {
      next = y.map((value, i) => value + h * DP.a[stage].reduce((sum, weight, j) => sum + weight * k[j][i], 0));
      k.push(program.rates(t + DP.c[stage] * h, next, p));
    }
    const error = y.reduce((worst, value, i) => Math.max(worst, Math.abs(h * DP.e.reduce((sum, weight, j) => sum + weight * k[j][i], 0)) / (tolerance * (1 + Math.abs(value)))), 0);
    if (!(error < Infinity)) { h /= 10; if (h < 1e-9) return y; continue; }
    if (error <= 1) { t += h; y = next; first = k[6]; }
    h *= Math.max(0.2, Math.min(5, 0.9 * (error || 1e-9) ** -0.2));
  }
  return y;
}

// Integrate to the state that the recorded scene shows, and begin there.
function followFilm() {
  if (!(live.t <= state.time)) Object.assign(live, {t: 0, s: grasped.start});
  while (live.t < state.time) { // in pieces, as a call takes at most STEPS steps; a chaotic motion needs all digits
    const next = Math.min(live.t + PIECE, state.time);
    live.s = integrate(live.s, live.p, live.t, next, 1e-12);
    live.t = next;
  }
  live.values = program.drawn(live.t, live.s, live.p);
}
function drawHandles() {
  if (!grasped || !grasped.handles.length) return;
  followFilm();
  for (const handle of grasped.handles) ring(stage.live.context, handlePlace(handle));
}
function goLive() {
  if (live.on || !grasped) return;
  live.zoom = 1;
  followFilm();
  live.on = true;
  forget();
  byId("restart").hidden = false;
  byId("time").hidden = byId("choice").hidden = true;
  byId("legend").replaceChildren();
  showLegend([grasped]);
  liveFigure();
  drawStill();
  setPlaying(true);
}
function forget() { Object.assign(live, {t: 0, trails: [], past: [], zoom: 1, most: 0}); }
function backToFilm() {
  Object.assign(live, {on: false, alone: false, held: null, p: grasped.parameters.map(({value}) => value), t: Infinity, zoom: 1});
  byId("restart").hidden = true;
  byId("time").hidden = false;
  byId("choice").hidden = !slider;
  sliders();
  show(shownFirst);
  drawStill();
}

// Drawing
const livePoint = (numbers) => {
  const frame = stage.frames[0], {middle, unit} = frame.panel;
  const [x, y, z] = numbers.map((value, i) => (value - middle[i]) / unit / live.zoom);
  return toScreen(frame, [x, y, z || 0]);
};
function drawLiveScene() {
  const {context, width, height} = stage.live, frame = stage.frames[0], values = program.drawn(live.t, live.s, live.p);
  const world = ({at, dim}) => at.map((i) => values.slice(i, i + dim));
  context.clearRect(0, 0, width, height);
  live.values = values;
  live.zoom = fitting(frame, grasped.shapes.flatMap(world));
  grasped.shapes.forEach((shape, number) => {
    const points = world(shape);
    context.strokeStyle = context.fillStyle = colorOf(shape.color);
    context.lineWidth = shape.width;
    context.globalAlpha = shape.faint ? 0.22 : 1;
    if (shape.kind === "trail") {
      const trail = (live.trails[number] ||= []);
      if (!live.held) trail.push(points);
      if (trail.length > TRAIL) trail.shift();
      points.forEach((_, i) => { curve(context, trail.map((one) => livePoint(one[i]))); context.stroke(); });
    } else draw[shape.kind](context, points.map(livePoint), shape);
    context.globalAlpha = 1;
  });
  context.fillStyle = colors.soft;
  context.font = "14px system-ui, sans-serif";
  context.fillText(frame.panel.title, frame.left + 4, frame.top + 15, frame.width - 8);
  for (const handle of grasped.handles) ring(context, handlePlace(handle));
  drawMeasures();
  byId("clock").textContent = `${live.t.toFixed(2)} s`;
}
function ring(context, [x, y]) {
  context.strokeStyle = colors.soft;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(x, y, 17, 0, 7);
  context.stroke();
}
// The factor by which the panel is drawn smaller, so that all of it is visible; it returns to 1 slowly.
function fitting(frame, points) {
  const [w, h] = sizeNow(frame.panel), {middle, unit} = frame.panel;
  const far = Math.max(1, ...points.map((numbers) => {
    const [right, up] = seen(...[0, 1, 2].map((i) => ((numbers[i] ?? 0) - (middle[i] ?? 0)) / unit), frame.panel.flat);
    return Math.max(Math.abs(right) / (w / 2), Math.abs(up) / (h / 2)) / 1.04;
  }).filter(Number.isFinite));
  return Math.max(far, 0.995 * live.zoom);
}
const handlePlace = ({at, dim}) => livePoint(live.values.slice(at, at + dim));

// The plot of the measures over the last seconds
function liveFigure() {
  byId("plots").replaceChildren();
  if (!grasped.measures.length) return;
  const box = document.createElement("figure"), caption = document.createElement("figcaption"), holder = document.createElement("div");
  live.now = document.createElement("span");
  live.canvas = document.createElement("canvas");
  live.canvas.setAttribute("role", "img");
  live.canvas.setAttribute("aria-label", `${grasped.measures.join(", ")} over the last ${WINDOW} seconds`);
  caption.append(Object.assign(document.createElement("b"), {textContent: grasped.measures.join(", ")}), live.now);
  holder.append(live.canvas);
  box.append(caption, holder);
  byId("plots").append(box);
}
function drawMeasures() {
  if (!grasped.measures.length) return;
  const now = live.values.slice(grasped.first);
  if (!live.held) live.past.push([live.t, ...now]);
  while (live.past.length && live.past[0][0] < live.t - WINDOW) live.past.shift();
  const {context, width, height} = fitted(live.canvas), rows = live.past.flatMap((row) => row.slice(1)).filter(Number.isFinite);
  const low = Math.min(0, ...rows), high = Math.max(...rows, low + 1e-12), start = Math.max(0, live.t - WINDOW);
  grasped.measures.forEach((_, i) => {
    context.strokeStyle = colors[`c${i}`];
    context.lineWidth = 1.8;
    line(context, live.past.map((row) => [(row[0] - start) / WINDOW * width, 4 + (height - 8) * (high - row[i + 1]) / (high - low)]));
    context.stroke();
  });
  const first = live.past.map((row) => row[1]), drift = Math.max(...first) - Math.min(...first);
  live.now.textContent = grasped.measures.map((name, i) => `${name}: ${Number(now[i].toPrecision(5))} J`).join(", ")
    + (grasped.constant && first.length ? `; ${grasped.measures[0]} drifts by ${Number(drift.toPrecision(1))}` : "");
}

// Dragging, and sliders
const REACH = 30; // px
function nearest({clientX, clientY}) {
  const {left, top} = byId("live").getBoundingClientRect();
  const far = grasped.handles.map((handle) => {
    const [x, y] = handlePlace(handle);
    return [Math.hypot(x + left - clientX, y + top - clientY), handle];
  });
  const [distance, handle] = far.sort(([a], [b]) => a - b)[0] || [Infinity];
  return distance < REACH ? handle : null;
}
function hold(event) {
  if (!grasped) return;
  if (!live.on) followFilm();
  const near = nearest(event);
  if (!near) return;
  event.stopImmediatePropagation();
  event.preventDefault();
  byId("live").setPointerCapture(event.pointerId);
  goLive();
  live.held = {handle: near, x: event.clientX, y: event.clientY, place: live.values.slice(near.at, near.at + near.dim)};
}
function drag(event) {
  if (!live.held) return;
  event.stopImmediatePropagation();
  const {handle, place} = live.held, frame = stage.frames[0], perMetre = frame.scale / frame.panel.unit / live.zoom;
  const right = (event.clientX - live.held.x) / perMetre, up = (live.held.y - event.clientY) / perMetre;
  const [rx, ux] = handle.dim === 3 ? directionsSeen() : [[1, 0], [0, 1]];
  const q = place.map((value, i) => value + right * rx[i] + up * ux[i]), k = live.s.length, at = k * grasped.handles.indexOf(handle);
  live.s = program.grab(live.t, live.s, live.p, q).slice(at, at + k);
  forget();
  drawLiveScene();
}
function letGo() {
  if (!live.held) return;
  live.held = null;
  stand();
}
function stand() {
  live.alone = true;
  drawStill();
}
// Friction ends a motion in a finite time; near it an explicit method would take ever smaller steps.
function atRest() {
  const now = Math.abs(live.values[grasped.first]);
  live.most = Math.max(live.most, now);
  return grasped.rests && now < 1e-8 * live.most;
}
function advanceLive(seconds) {
  if (!live.held) {
    if (!atRest()) live.s = integrate(live.s, live.p, live.t, live.t + seconds, 1e-9);
    live.t += seconds;
  }
  drawLiveScene();
}
function sliders() {
  byId("sliders").replaceChildren(...grasped.parameters.map(({name, value, range}, i) => {
    const label = document.createElement("label"), input = document.createElement("input"), output = document.createElement("output");
    Object.assign(input, {type: "range", min: range[0], max: range[1], step: "any", value});
    output.textContent = Number(value.toPrecision(3));
    input.addEventListener("input", () => {
      goLive();
      if (!live.alone) stand();
      live.p[i] = Number(input.value);
      output.textContent = Number(live.p[i].toPrecision(3));
      live.past = [];
      drawLiveScene();
    });
    label.append(name, input, output);
    return label;
  }));
  byId("sliders").hidden = !grasped.parameters.length;
}
function beginLive() {
  if (!grasped) return;
  live.p = grasped.parameters.map(({value}) => value);
  sliders();
  const canvas = byId("live");
  canvas.classList.add("grab");
  canvas.addEventListener("pointerdown", hold);
  canvas.addEventListener("touchstart", (event) => { if (nearest(event.touches[0])) event.preventDefault(); }, {passive: false});
  canvas.addEventListener("pointermove", drag);
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, letGo);
  byId("restart").addEventListener("click", backToFilm);
}
