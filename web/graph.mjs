// The speed of every ball against time, with a line at the moment on show.
import { stateAt } from "./motion.mjs";
import { inkOf } from "./table.mjs";

const HIGH = 150, LEFT = 34, BELOW = 20, TOP = 8;  // px

export function drawGraph(canvas, balls, shot, time) {
  const ratio = window.devicePixelRatio || 1, wide = canvas.clientWidth, pen = canvas.getContext("2d");
  canvas.width = wide * ratio; canvas.height = HIGH * ratio; canvas.style.height = `${HIGH}px`;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.font = "11px system-ui, sans-serif";
  const curves = shot ? shot.legs.map((legs) => curve(legs, shot.end)) : [];
  const most = nice(Math.max(1, ...curves.flat().map(([, speed]) => speed)));
  const end = shot ? Math.max(shot.end, 0.1) : 10;
  const x = (t) => LEFT + (t / end) * (wide - LEFT - 6), y = (v) => HIGH - BELOW - (v / most) * (HIGH - BELOW - TOP);
  pen.strokeStyle = "#2a323d"; pen.fillStyle = "#a9b4c0"; pen.textAlign = "right";
  for (let k = 0; k <= 4; k++) rule(pen, LEFT, y((most * k) / 4), wide - 6, y((most * k) / 4), `${(most * k) / 4}`, LEFT - 6);
  pen.textAlign = "center";
  const step = nice(end / 5);
  for (let t = 0; t <= end; t += step) pen.fillText(String(+t.toFixed(2)), x(t), HIGH - 5);
  curves.forEach((points, k) => {
    if (!points.some(([, speed]) => speed > 0)) return;
    pen.strokeStyle = inkOf(balls[k][0]); pen.lineWidth = 1.6;
    pen.beginPath();
    points.forEach(([t, v], i) => pen[i ? "lineTo" : "moveTo"](x(t), y(v)));
    pen.stroke();
  });
  if (!shot) return;
  pen.strokeStyle = "#7cc4ff"; pen.lineWidth = 1;
  pen.beginPath(); pen.moveTo(x(time), TOP); pen.lineTo(x(time), HIGH - BELOW); pen.stroke();
}

function rule(pen, x0, y0, x1, y1, text, at) {
  pen.lineWidth = 1;
  pen.beginPath(); pen.moveTo(x0, y0); pen.lineTo(x1, y1); pen.stroke();
  pen.fillText(text, at, y0 + 4);
}

// (time, speed) along all legs, both sides of each jump.
function curve(legs, end) {
  const points = [];
  legs.forEach((leg, k) => {
    const until = k + 1 < legs.length ? legs[k + 1][0] : end, parts = 8;
    for (let i = 0; i <= parts; i++) {
      const t = leg[0] + ((until - leg[0]) * i) / parts;
      points.push([t, stateAt([leg], t).speed]);
    }
  });
  return points;
}

// 1, 2 or 5 times a power of ten, not less.
function nice(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].find((k) => k * power >= value - 1e-9) * power;
}
