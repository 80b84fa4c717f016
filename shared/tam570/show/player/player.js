const shownFirst = JSON.parse(byId("data").textContent), {slider} = shownFirst;
const sums = (steps) => { let sum = 0; return steps.map((step) => (sum += step)); };

// The data: differences between the stored samples. A slider has a scene for each of its values.
let scene, keys, tracks, duration, plots;
const state = {time: 0, speed: 1, playing: false, last: 0};
function read(chosen) {
  scene = chosen;
  keys = sums(scene.keys);
  tracks = scene.tracks.map((track) => track.map(sums));
  duration = keys[keys.length - 1] * scene.step;
  plots = scene.time_plots.map((plot) => ({...plot, curves: plot.curves.map(sums)}));
  state.time = Math.min(state.time, duration);
}

// Positions

function keyBefore(time) {
  let low = 0, high = keys.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (keys[middle] * scene.step <= time) low = middle; else high = middle;
  }
  return low;
}

// The position of a point, a fraction of the time after a key, as [x, y(, z)] in half pixels of the large screen.
function place(point, key, share) {
  const index = Math.floor(point / 3), kind = point % 3;
  if (kind === 1) return scene.fixed[index];
  if (kind === 0) {
    return tracks[index].map((axis) => (share ? axis[key] + share * (axis[key + 1] - axis[key]) : axis[key]));
  }
  const sum = [0, 0, 0];
  for (const [shape, weight] of scene.mixed[index]) {
    place(shape, key, share).forEach((value, axis) => { sum[axis] += weight * value; });
  }
  return sum;
}

// Colours, canvases and panels

let colors = {};
function readColors() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["paper", "ink", "soft", "line", "alarm", "c0", "c1", "c2", "c3", "c4", "c5"]) {
    colors[name] = style.getPropertyValue(`--${name}`).trim();
  }
}
const colorOf = (number) => (number === -1 ? colors.ink : number === -2 ? colors.soft : colors[`c${number}`]);

// Give a canvas the resolution of the screen; return its context, which draws in CSS pixels.
function fitted(canvas) {
  const {width, height} = canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.lineCap = context.lineJoin = "round";
  return {context, width, height};
}

// The size of a panel, in half pixels of the large screen.
const sizeNow = ({size, flat}) => (flat ? size : sizeSeen(size)).map((side) => side || 1);

// The rectangles of the panels, in the grid of rows and columns in which they are largest.
const MARGIN = 14, TITLE = 20;
function layout(width, height) {
  const panels = live.alone ? scene.panels.slice(0, 1) : scene.panels;
  const titled = panels.some((panel) => panel.title) ? TITLE : 0, count = panels.length;
  let best = null;
  for (let columns = 1; columns <= count; columns++) {
    const w = width / columns, h = height / Math.ceil(count / columns);
    const scales = panels.map(sizeNow).map((size) => Math.min((w - 2 * MARGIN) / size[0], (h - titled - 2 * MARGIN) / size[1]));
    const smallest = Math.min(...scales);
    if (!best || smallest > best.smallest) best = {smallest, scales, columns, w, h};
  }
  return panels.map((panel, i) => ({
    panel, scale: best.scales[i], left: (i % best.columns) * best.w, top: Math.floor(i / best.columns) * best.h,
    width: best.w, bottom: (Math.floor(i / best.columns) + 1) * best.h,
    x: (i % best.columns + 0.5) * best.w, y: (Math.floor(i / best.columns) + 0.5) * best.h + titled / 2,
  }));
}

// Drawing

const stage = {};
const toScreen = (frame, [x, y, z]) => {
  const [right, up] = seen(x, y, z, frame.panel.flat);
  return [frame.x + frame.scale * right, frame.y - frame.scale * up];
};
function line(context, points) {
  context.beginPath();
  points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
}
// A smooth line through points: parabolas between the middles of the segments.
function curve(context, points) {
  if (points.length < 3) return line(context, points);
  context.beginPath();
  context.moveTo(...points[0]);
  for (let i = 1; i + 1 < points.length; i++) {
    const [x, y] = points[i], [nx, ny] = points[i + 1];
    context.quadraticCurveTo(x, y, (x + nx) / 2, (y + ny) / 2);
  }
  context.lineTo(...points[points.length - 1]);
}
const draw = {
  lines(context, points) {
    context.beginPath();
    for (let i = 0; i + 1 < points.length; i += 2) {
      context.moveTo(...points[i]);
      context.lineTo(...points[i + 1]);
    }
    context.stroke();
  },
  path(context, points) { line(context, points); context.stroke(); },
  fill(context, points) { line(context, points); context.closePath(); context.fill(); },
  dot(context, points, shape) {
    for (const [x, y] of points) {
      context.beginPath();
      context.arc(x, y, shape.width, 0, 7);
      context.fill();
    }
  },
  arrow(context, points, shape) {
    for (let i = 0; i + 1 < points.length; i += 2) arrow(context, points[i], points[i + 1], shape.width);
  },
  text(context, points, shape) {
    context.font = "600 14px system-ui, sans-serif";
    const right = stage.live.width - context.measureText(shape.words).width - 2; // beyond, the text would be cut off
    context.fillText(shape.words, Math.min(points[0][0] + 8, right), points[0][1] - 8);
  },
};
function arrow(context, [x, y], [ex, ey], width) {
  const length = Math.hypot(ex - x, ey - y), head = Math.min(4 + 2.5 * width, length);
  if (length < 0.5) return;
  const ux = (ex - x) / length, uy = (ey - y) / length, bx = ex - head * ux, by = ey - head * uy;
  line(context, [[x, y], [bx, by]]);
  context.stroke();
  line(context, [[ex, ey], [bx - 0.45 * head * uy, by + 0.45 * head * ux], [bx + 0.45 * head * uy, by - 0.45 * head * ux]]);
  context.fill();
}
function drawShape(context, frame, shape, key, share) {
  context.strokeStyle = context.fillStyle = colorOf(shape.color);
  context.lineWidth = shape.width;
  context.globalAlpha = shape.faint ? 0.22 : 1;
  if (shape.kind === "trail") drawTrail(context, frame, shape, key, share);
  else draw[shape.kind](context, shape.at.map((point) => toScreen(frame, place(point, key, share))), shape);
  context.globalAlpha = 1;
}

// Draw the path so far, the last second more strongly.
function drawTrail(context, frame, shape, key, share) {
  const recent = keyBefore(keys[key] * scene.step - 1);
  for (const point of shape.at) {
    const points = [];
    for (let k = 0; k <= key; k++) points.push(toScreen(frame, place(point, k, 0)));
    points.push(toScreen(frame, place(point, key, share)));
    context.globalAlpha = 0.45;
    curve(context, points);
    context.stroke();
    context.globalAlpha = 1;
    curve(context, points.slice(recent));
    context.stroke();
  }
}
const moves = (shape) => shape.kind === "trail" || shape.at.some((point) => point % 3 !== 1);

// Draw the layer of fixed shapes, which changes only with the view; the other layer is drawn in every frame.
function drawStill() {
  Object.assign(stage, {still: fitted(byId("still")), live: fitted(byId("live"))});
  stage.frames = layout(stage.live.width, stage.live.height);
  const {context} = stage.still;
  if (live.on) return drawLiveScene();
  for (const frame of stage.frames) {
    for (const shape of frame.panel.shapes) if (!moves(shape)) drawShape(context, frame, shape, 0, 0);
    context.fillStyle = colors.soft;
    context.font = "14px system-ui, sans-serif";
    context.fillText(frame.panel.title, frame.left + 4, frame.top + 15, frame.width - 8);
    drawRuler(context, frame);
  }
  plots.forEach(drawPlotAxes);
  drawLive();
}

// Draw a reference length: 1, 2 or 5 times a power of ten, a tenth to a third of the panel.
function drawRuler(context, frame) {
  if (!frame.panel.ruler) return;
  const perMetre = frame.scale / frame.panel.unit, about = 110 / perMetre, power = 10 ** Math.floor(Math.log10(about));
  const metres = power * [5, 2, 1].find((step) => step * power <= about);
  const x = frame.left + 6, y = frame.bottom - 6, text = `${Number(metres.toPrecision(1))} m`;
  context.strokeStyle = colors.soft;
  context.lineWidth = 1.5;
  line(context, [[x, y - 4], [x, y], [x + metres * perMetre, y], [x + metres * perMetre, y - 4]]);
  context.stroke();
  context.fillText(text, x + 4, y - 6);
}
function drawLive() {
  const {context, width, height} = stage.live;
  const key = keyBefore(state.time), from = keys[key] * scene.step, to = keys[Math.min(key + 1, keys.length - 1)] * scene.step;
  const share = to > from ? Math.min(1, (state.time - from) / (to - from)) : 0;
  context.clearRect(0, 0, width, height);
  for (const frame of stage.frames) {
    for (const shape of frame.panel.shapes) if (moves(shape)) drawShape(context, frame, shape, key, share);
  }
  drawHandles();
  plots.forEach(drawPlotNow);
  showTime();
}

// Controls

function showTime() {
  const text = `${(scene.start + state.time).toFixed(2)} s`;
  byId("scrub").max = duration;
  byId("scrub").value = state.time;
  byId("scrub").setAttribute("aria-valuetext", `${text} of ${(scene.start + duration).toFixed(2)} s`);
  byId("clock").textContent = text;
}
function goTo(time) {
  if (live.on) return;
  state.time = Math.max(0, Math.min(duration, time));
  drawLive();
}
function setPlaying(playing) {
  state.playing = playing;
  byId("play").textContent = playing ? "Pause" : "Play";
  if (playing) {
    if (!live.on && state.time >= duration) state.time = 0;
    state.last = performance.now();
    requestAnimationFrame(advance);
  }
}
function advance(now) {
  if (!state.playing) return;
  const time = state.time + state.speed * Math.max(0, now - state.last) / 1000;
  const seconds = state.speed * Math.min(0.1, Math.max(0, now - state.last) / 1000);
  state.last = now;
  if (live.on) { advanceLive(seconds); requestAnimationFrame(advance); return; }
  goTo(time > duration ? 0 : time);
  requestAnimationFrame(advance);
}
function onKey(event) {
  if (["INPUT", "SELECT", "BUTTON"].includes(event.target.tagName) || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === " ") setPlaying(!state.playing);
  else if (camera && camera.onKey(event)) { /* it turned the view */ }
  else if (event.key === "ArrowLeft") goTo(state.time - 1 / 30);
  else if (event.key === "ArrowRight") goTo(state.time + 1 / 30);
  else if (event.key === "Home") goTo(0);
  else if (event.key === "End") goTo(duration);
  else if (slider && !live.on && (event.key === "[" || event.key === "]")) choose(Number(byId("value").value) + (event.key === "]" ? 1 : -1));
  else return;
  event.preventDefault();
}
function choose(wanted) {
  const index = Math.max(0, Math.min(slider.values.length - 1, wanted));
  const text = `${slider.values[index]} ${slider.unit}`.trim();
  byId("value").value = index;
  byId("value").setAttribute("aria-valuetext", text);
  byId("chosen").textContent = text;
  show(slider.scenes[index] || shownFirst);
  drawStill();
}
function show(chosen) {
  read(chosen);
  byId("legend").replaceChildren();
  byId("plots").replaceChildren();
  showLegend(scene.panels);
  plots.forEach(figure);
}
function beginSlider() {
  byId("choice").hidden = false;
  byId("name").textContent = slider.name;
  byId("value").max = slider.values.length - 1;
  byId("value").addEventListener("input", (event) => choose(Number(event.target.value)));
  choose(slider.chosen);
}
function showLegend(panels) {
  const named = panels.flatMap((panel) => panel.shapes).filter((shape) => shape.name);
  for (const shape of new Map(named.map((shape) => [shape.name, shape])).values()) {
    const item = document.createElement("li"), swatch = document.createElement("i");
    swatch.style.borderColor = shape.color < 0 ? `var(--${shape.color === -1 ? "ink" : "soft"})` : `var(--c${shape.color})`;
    item.append(swatch, shape.name);
    byId("legend").append(item);
  }
}
function begin() {
  readColors();
  show(shownFirst);
  beginLive();
  if (camera) camera.begin();
  byId("keys").textContent = `Keys: space plays and pauses, ← → step, Home, End${camera ? camera.keys : ""}${slider ? `; [ and ] change ${slider.name}` : ""}.${grasped && grasped.handles.length ? " Drag what has a ring to another start." : ""}`;
  byId("scrub").step = "any";
  byId("scrub").addEventListener("input", (event) => { setPlaying(false); goTo(Number(event.target.value)); });
  byId("play").addEventListener("click", () => setPlaying(!state.playing));
  byId("speed").addEventListener("change", (event) => { state.speed = Number(event.target.value); });
  document.addEventListener("keydown", onKey);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { readColors(); drawStill(); });
  new ResizeObserver(drawStill).observe(byId("stage"));
  drawStill();
  if (slider) beginSlider();
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) setPlaying(true);
}
begin();
