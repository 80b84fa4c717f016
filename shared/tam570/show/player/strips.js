// The strips beside the scene: axes on one layer, what has been so far on another.

const PAD = 6;
function figure(strip) {
  const box = document.createElement("figure"), caption = document.createElement("figcaption");
  const title = document.createElement("b"), note = document.createElement("span"), now = document.createElement("span");
  title.textContent = strip.title;
  note.textContent = strip.note;
  if (strip.alarm) note.className = "alarm";
  caption.append(title, note, now);
  strip.now = now;
  const holder = document.createElement("div");
  strip.axes = document.createElement("canvas");
  strip.front = document.createElement("canvas");
  strip.axes.setAttribute("aria-hidden", "true");
  strip.front.setAttribute("role", "img");
  strip.front.setAttribute("aria-label", `${strip.title} over time. ${strip.note}`);
  holder.append(strip.axes, strip.front);
  box.append(caption, holder);
  byId("strips").append(box);
}
const stripX = (strip, time) => PAD + (strip.size.width - 2 * PAD) * time / duration;
const stripY = (strip, value) => {
  const [low, high] = strip.span;
  return PAD + (strip.size.height - 2 * PAD) * (high - value) / (high - low);
};
const curveColor = (strip, i) => (strip.alarm && strip.curves.length === 1 ? colors.alarm : colors[`c${i}`]);
const figures = (value) => Number(value.toPrecision(2)).toString();
function drawStripAxes(strip) {
  strip.size = fitted(strip.axes);
  strip.live = fitted(strip.front).context;
  const {context, width} = strip.size, [low, high] = strip.span;
  context.strokeStyle = colors.line;
  context.fillStyle = colors.soft;
  context.font = "12px system-ui, sans-serif";
  for (const value of [low, 0, high]) {
    line(context, [[0, stripY(strip, value)], [width, stripY(strip, value)]]);
    context.stroke();
    if (!value || Math.abs(value) > 0.15 * (high - low)) context.fillText(`${figures(value)} ${strip.unit}`, 4, stripY(strip, value) + (value < high ? -3 : 13));
  }
  strip.curves.forEach((curve, i) => strokeCurve(context, strip, curve, i, strip.times.length - 1, 0.3));
}
function strokeCurve(context, strip, curve, i, last, alpha) {
  context.globalAlpha = alpha;
  context.strokeStyle = curveColor(strip, i);
  context.lineWidth = 1.8;
  line(context, strip.times.slice(0, last + 1).map((time, k) => [stripX(strip, time), stripY(strip, curve[k] * strip.scale)]));
  context.stroke();
  context.globalAlpha = 1;
}
function drawStripNow(strip) {
  const context = strip.live, {width, height} = strip.size;
  let k = strip.times.findIndex((time) => time > state.time) - 1;
  if (k < 0) k = Math.max(0, strip.times.length - 2);
  const share = Math.min(1, (state.time - strip.times[k]) / (strip.times[k + 1] - strip.times[k]));
  context.clearRect(0, 0, width, height);
  context.strokeStyle = colors.soft;
  context.lineWidth = 1;
  line(context, [[stripX(strip, state.time), 0], [stripX(strip, state.time), height]]);
  context.stroke();
  const now = strip.curves.map((curve, i) => {
    strokeCurve(context, strip, curve, i, k, 1);
    const value = strip.scale * (curve[k] + share * (curve[k + 1] - curve[k]));
    context.fillStyle = curveColor(strip, i);
    draw.dot(context, [[stripX(strip, state.time), stripY(strip, value)]], {width: 4});
    const said = `${figures(value)} ${strip.unit}`.trim();
    return strip.names[i] ? `${strip.names[i]}: ${said}` : said;
  });
  strip.now.textContent = `now ${now.join(", ")}`;
}
