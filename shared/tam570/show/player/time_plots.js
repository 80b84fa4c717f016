// The plots beside the scene: axes on one layer, the curves so far on another.

const PAD = 6, AXIS = 16; // px around the curves, and of the time axis below them
function figure(plot) {
  const box = document.createElement("figure"), caption = document.createElement("figcaption");
  const title = document.createElement("b"), note = document.createElement("span"), now = document.createElement("span");
  title.textContent = plot.title;
  note.textContent = plot.note;
  if (plot.alarm) note.className = "alarm";
  caption.append(title, note, now);
  plot.now = now;
  const holder = document.createElement("div");
  plot.axes = document.createElement("canvas");
  plot.front = document.createElement("canvas");
  plot.axes.setAttribute("aria-hidden", "true");
  plot.front.setAttribute("role", "img");
  plot.front.setAttribute("aria-label", `${plot.title} over time. ${plot.note}`);
  holder.append(plot.axes, plot.front);
  box.append(caption, holder);
  byId("plots").append(box);
}
const plotX = (plot, time) => PAD + (plot.size.width - 2 * PAD) * time / duration;
const plotY = (plot, value) => {
  const [low, high] = plot.span;
  return PAD + (plot.size.height - 2 * PAD - AXIS) * (high - value) / (high - low);
};
const curveColor = (plot, i) => (plot.alarm && plot.curves.length === 1 ? colors.alarm : colors[`c${i}`]);
const figures = (value) => Number(value.toPrecision(2)).toString();
function drawPlotAxes(plot) {
  plot.size = fitted(plot.axes);
  plot.live = fitted(plot.front).context;
  const {context, width} = plot.size, [low, high] = plot.span;
  context.strokeStyle = colors.line;
  context.fillStyle = colors.soft;
  context.font = "12px system-ui, sans-serif";
  for (const value of [low, 0, high]) {
    line(context, [[0, plotY(plot, value)], [width, plotY(plot, value)]]);
    context.stroke();
    if (!value || Math.abs(value) > 0.15 * (high - low)) context.fillText(`${figures(value)} ${plot.unit}`, 4, plotY(plot, value) + (value < high ? -3 : 13));
  }
  drawTimes(context, plot);
  plot.curves.forEach((curve, i) => strokeCurve(context, plot, curve, i, plot.times.length - 1, 0.3));
}
// Draw about four ticks of time, at distances of 1, 2 or 5 times a power of ten.
function drawTimes(context, plot) {
  const {width, height} = plot.size, power = 10 ** Math.floor(Math.log10(duration / 4)), step = [1, 2, 5, 10].map((n) => n * power).find((n) => duration / n <= 5);
  context.textAlign = "center";
  for (let time = 0; time <= duration * 1.0001; time += step) {
    const x = plotX(plot, time), text = `${Number((scene.start + time).toPrecision(6))}${time + step > duration * 1.0001 ? " s" : ""}`;
    line(context, [[x, height - AXIS], [x, height - AXIS + 4]]);
    context.stroke();
    const half = context.measureText(text).width / 2;
    context.fillText(text, Math.min(Math.max(x, half), width - half), height - 2);
  }
  context.textAlign = "start";
}
function strokeCurve(context, plot, curve, i, last, alpha, now = []) {
  context.globalAlpha = alpha;
  context.strokeStyle = curveColor(plot, i);
  context.lineWidth = 1.8;
  line(context, plot.times.slice(0, last + 1).map((time, k) => [plotX(plot, time), plotY(plot, curve[k] * plot.scale)]).concat(now));
  context.stroke();
  context.globalAlpha = 1;
}
function drawPlotNow(plot) {
  const context = plot.live, {width, height} = plot.size;
  let k = plot.times.findIndex((time) => time > state.time) - 1;
  if (k < 0) k = Math.max(0, plot.times.length - 2);
  const share = Math.min(1, (state.time - plot.times[k]) / (plot.times[k + 1] - plot.times[k]));
  context.clearRect(0, 0, width, height);
  context.strokeStyle = colors.soft;
  context.lineWidth = 1;
  line(context, [[plotX(plot, state.time), 0], [plotX(plot, state.time), height - AXIS]]);
  context.stroke();
  const now = plot.curves.map((curve, i) => {
    const value = plot.scale * (curve[k] + share * (curve[k + 1] - curve[k]));
    const place = [[plotX(plot, state.time), plotY(plot, value)]];
    strokeCurve(context, plot, curve, i, k, 1, place);
    context.fillStyle = curveColor(plot, i);
    draw.dot(context, place, {width: 4});
    const said = `${figures(value)} ${plot.unit}`.trim();
    return plot.names[i] ? `${plot.names[i]}: ${said}` : said;
  });
  plot.now.textContent = `now ${now.join(", ")}`;
}
