// Draws the table, its balls and their paths on a canvas; metres in, pixels out.
import { path, stateAt } from "./motion.mjs";

const CLOTHS = { carom: "#1b6292", pool: "#1e6b9f" };
const POOL = ["#f4f1e6", "#eab61c", "#1f4fa3", "#c4152c", "#5b2d82", "#e2701c", "#157a3c", "#7c1c2b", "#1b1d21"];
const CAROM = { white: "#f4f1e6", yellow: "#f6c328", red: "#d2203a", "red 2": "#d2203a" };
const RAIL = 0.13, MARGIN = 0.02;  // m

export function colour(name) {
  return CAROM[name] ?? (name === "cue" ? POOL[0] : POOL[(Number(name) - 1) % 8 + 1]);
}
// The black ball's path would not be seen.
export const inkOf = (name) => (name === "8" || name === "16" ? "#9aa4ae" : colour(name));
const striped = (name) => Number(name) > 8;

export class Table {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d");
  }

  // Take a table as lab.py lays it.
  lay(table) {
    this.table = table;
    this.resize();
  }

  resize() {
    const { length, width } = this.table, wide = length + 2 * (RAIL + MARGIN), high = width + 2 * (RAIL + MARGIN);
    const pixels = this.canvas.clientWidth * (window.devicePixelRatio || 1);
    this.scale = pixels / wide;
    this.canvas.width = Math.round(pixels);
    this.canvas.height = Math.round(high * this.scale);
  }

  at(x, y) {
    return [this.canvas.width / 2 + x * this.scale, this.canvas.height / 2 - y * this.scale];
  }

  // Where on the table a pointer is, m.
  from(event) {
    const box = this.canvas.getBoundingClientRect(), ratio = this.canvas.width / box.width;
    return [((event.clientX - box.left) * ratio - this.canvas.width / 2) / this.scale,
            (this.canvas.height / 2 - (event.clientY - box.top) * ratio) / this.scale];
  }

  draw(shot, time, aim) {
    this.bed();
    if (shot) this.paths(shot, time);
    if (aim) this.cue(aim);
    this.table.balls.forEach(([name, x, y, radius], k) => {
      const state = shot ? stateAt(shot.legs[k], time) : { x, y };
      if (!state.gone) this.ball(name, state.x, state.y, radius);
    });
  }

  bed() {
    const { pen, table, scale } = this, [left, top] = this.at(-table.length / 2 - RAIL, table.width / 2 + RAIL);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    const wood = pen.createLinearGradient(0, top, 0, top + (table.width + 2 * RAIL) * scale);
    wood.addColorStop(0, "#6d4830"); wood.addColorStop(1, "#4b2f1f");
    pen.fillStyle = wood;
    pen.beginPath();
    pen.roundRect(left, top, (table.length + 2 * RAIL) * scale, (table.width + 2 * RAIL) * scale, 0.05 * scale);
    pen.fill();
    this.diamonds();
    const cloth = CLOTHS[table.kind] ?? CLOTHS.carom;
    this.around(table.length / 2 + 0.045, table.width / 2 + 0.045);
    pen.fillStyle = "#0d3a5a";
    pen.fill();
    pen.fillStyle = cloth;
    this.line(table.outline);
    pen.fill();
    pen.save();  // a side pocket's hole ends at its leather, inside the rail
    this.around(table.length / 2 + RAIL - 0.025, table.width / 2 + RAIL - 0.025);
    pen.clip();
    for (const [x, y, radius] of table.pockets) this.disc(x, y, radius, "#07090c");
    pen.restore();
    for (const [x, y] of table.spots) this.disc(x, y, 0.006, "#ffffff44");
    if (table.kind === "pool" && table.line !== null) {
      pen.strokeStyle = "#ffffff22"; pen.lineWidth = 1;
      this.line([[table.line, -table.width / 2], [table.line, table.width / 2]], true);
      pen.stroke();
    }
  }

  diamonds() {
    const { length, width } = this.table, off = 0.088;
    for (let i = 1; i < 8; i++) for (const side of [-1, 1]) {
      if (i !== 4 || !this.table.pockets.length) this.disc(length * (i / 8 - 0.5), side * (width / 2 + off), 0.008, "#e9e2d2");
    }
    for (let i = 1; i < 4; i++) for (const side of [-1, 1]) this.disc(side * (length / 2 + off), width * (i / 4 - 0.5), 0.008, "#e9e2d2");
  }

  paths({ legs, end }, time) {
    this.table.balls.forEach(([name], k) => {
      for (const [until, alpha] of [[end, "70"], [Math.min(time, end), "e0"]]) {
        const points = path(legs[k], until);
        if (points.length < 2) continue;
        this.pen.strokeStyle = inkOf(name) + alpha;
        this.pen.lineWidth = 0.006 * this.scale;
        this.pen.lineJoin = "round";
        this.line(points, true);
        this.pen.stroke();
      }
    });
  }

  cue({ x, y, angle, radius, back }) {
    const { pen } = this, [c, s] = [Math.cos(angle), Math.sin(angle)];
    const near = radius + 0.02 + back, far = near + 0.9;
    const [x0, y0] = this.at(x - c * near, y - s * near), [x1, y1] = this.at(x - c * far, y - s * far);
    pen.lineCap = "round";
    for (const [width, ink] of [[0.022, "#14100c"], [0.017, "#d9b57e"]]) {
      pen.strokeStyle = ink; pen.lineWidth = width * this.scale;
      pen.beginPath(); pen.moveTo(x0, y0); pen.lineTo(x1, y1); pen.stroke();
    }
  }

  ball(name, x, y, radius) {
    const { pen, scale } = this, [cx, cy] = this.at(x, y), r = radius * scale;
    pen.fillStyle = "#00000050";
    pen.beginPath(); pen.ellipse(cx + 0.14 * r, cy + 0.2 * r, 1.04 * r, 1.0 * r, 0, 0, 7); pen.fill();
    pen.save();
    pen.beginPath(); pen.arc(cx, cy, r, 0, 7); pen.clip();
    pen.fillStyle = striped(name) ? POOL[0] : colour(name);
    pen.fillRect(cx - r, cy - r, 2 * r, 2 * r);
    if (striped(name)) { pen.fillStyle = colour(name); pen.fillRect(cx - r, cy - 0.56 * r, 2 * r, 1.12 * r); }
    const light = pen.createRadialGradient(cx - 0.35 * r, cy - 0.4 * r, 0.05 * r, cx, cy, 1.15 * r);
    light.addColorStop(0, "#ffffff90"); light.addColorStop(0.35, "#ffffff10"); light.addColorStop(1, "#00000070");
    pen.fillStyle = light;
    pen.fillRect(cx - r, cy - r, 2 * r, 2 * r);
    pen.restore();
    if (Number(name)) {
      this.disc(x, y, 0.46 * radius, POOL[0]);
      pen.fillStyle = "#15171b"; pen.font = `600 ${0.62 * r}px system-ui, sans-serif`;
      pen.textAlign = "center"; pen.textBaseline = "middle";
      pen.fillText(name, cx, cy + 0.04 * r);
    }
  }

  around(x, y) {
    this.line([[x, -y], [x, y], [-x, y], [-x, -y]]);
  }

  line(points, open = false) {
    this.pen.beginPath();
    points.forEach(([x, y], k) => this.pen[k ? "lineTo" : "moveTo"](...this.at(x, y)));
    if (!open) this.pen.closePath();
  }

  disc(x, y, radius, ink) {
    const { pen } = this;
    pen.fillStyle = ink;
    pen.beginPath(); pen.arc(...this.at(x, y), radius * this.scale, 0, 7); pen.fill();
  }
}
