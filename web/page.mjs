// The page: numbers in, the whole shot out; Python runs in here, and the page only draws.
import { loadPyodide } from "./pyodide/pyodide.mjs";
import { drawGraph } from "./graph.mjs";
import { Table } from "./table.mjs";

const WORDS = await (await fetch("words.json")).json();

const get = (id) => document.getElementById(id);
const RANGES = { speed: [0.1, 10, 0.1], angle: [-180, 180, 0.1], follow: [-10, 10, 0.1], masse: [-6, 6, 0.1], side: [-10, 10, 0.1] };
const table = new Table(get("table"));
const state = { language: "en", setup: "carom", law: "table", shot: {}, places: null, time: 0, playing: false, result: null };
let lab, said = "loading", before = 0;

// -- words ----------------------------------------------------------------------------------

const words = () => WORDS[state.language];

function speak() {
  document.documentElement.lang = state.language;
  document.querySelectorAll("[data-word]").forEach((element) => { element.textContent = words()[element.dataset.word]; });
  get("language").textContent = words().other;
  options("setup", words().setups);
  options("law", words().laws);
  get("heads").replaceChildren(...words().heads.map((head, k) => cell(head, k % 3 === 0, "th")));
  for (const [key, [name, unit]] of Object.entries(words().numbers)) {
    get(`name-${key}`).textContent = name;
    get(`unit-${key}`).textContent = unit;
  }
  say(said);
  show();
}

function options(id, names) {
  get(id).replaceChildren(...Object.entries(names).map(([value, text]) => new Option(text, value, false, value === state[id])));
}

function say(word, more = "") {
  said = word;
  get("status").textContent = more || (words()[word] ?? word);
  get("status").classList.toggle("wrong", !(word in words()));
}

function cell(text, number = false, kind = "td") {
  const made = document.createElement(kind);
  made.textContent = text;
  if (number) made.className = "number";
  return made;
}

// -- the shot ---------------------------------------------------------------------------------

function lay(name) {
  state.setup = name;
  const laid = JSON.parse(lab.laid(name));
  state.places = null;
  state.shot = laid.shot;
  table.lay(laid);
  fill();
}

function fill() {
  for (const key of Object.keys(RANGES)) for (const kind of ["range", "number"]) get(`${kind}-${key}`).value = state.shot[key];
}

function play() {
  const found = JSON.parse(lab.played(state.setup, state.law, JSON.stringify(state.shot), JSON.stringify(state.places)));
  if (found.error) {
    state.result = null;
    say(found.error);
  } else {
    state.result = found;
    say("ready");
  }
  state.time = 0;
  state.playing = false;
  remember();
  show();
}

function remember() {
  const { setup, law, shot, places, language } = state;
  history.replaceState(null, "", "#" + encodeURIComponent(JSON.stringify({ setup, law, shot, places, language })));
}

function recall() {
  try {
    return JSON.parse(decodeURIComponent(location.hash.slice(1)));
  } catch {
    return {};
  }
}

// -- what is shown ----------------------------------------------------------------------------

function show() {
  const { result } = state;
  get("play").disabled = get("time").disabled = !result;
  get("play").textContent = state.playing ? words().pause : words().play;
  if (!table.table) return;
  get("desk").hidden = !result?.code;
  get("code").textContent = result?.code ?? "";
  get("sum").textContent = result?.sum ?? "";
  get("rest").tBodies[0].replaceChildren(...(result ? result.rest.map(restRow) : []));
  get("events").querySelector("tbody").replaceChildren(...(result ? result.log.map(eventRow) : []));
  moment();
}

const named = (name) => words().names[name] ?? name;

function restRow([x, y], k) {
  const row = document.createElement("tr"), name = table.table.balls[k][0];
  row.append(cell(named(name)), ...(state.result.gone[k] ? [cell(words().gone), cell("")] : [cell(x, true), cell(y, true)]));
  return row;
}

function eventRow([time, kind, balls, wall, closing]) {
  const row = document.createElement("tr");
  row.append(cell(time.toFixed(4), true), cell(words().events[kind] ?? kind),
    cell([...balls, ...(wall ? [wall] : [])].map(named).join(" · ")), cell(closing ? closing.toFixed(3) : "", true));
  return row;
}

// What changes from frame to frame.
function moment() {
  const { result, time } = state;
  const radians = (state.shot.angle * Math.PI) / 180, [, x, y, radius] = table.table.balls[0];
  const aim = time === 0 ? { x, y, radius, angle: radians, back: 0.012 * state.shot.speed } : null;
  table.draw(result, time, aim);
  drawGraph(get("graph"), table.table.balls, result, time);
  if (!result) return;
  get("time").max = result.end;
  get("time").value = time;
  get("clock").textContent = `${time.toFixed(2)} / ${result.end.toFixed(2)} s`;
  const rows = get("events").querySelectorAll("tbody tr");
  let last = null;
  result.log.forEach(([when], k) => {
    rows[k].className = when > time ? "later" : "";
    if (when <= time) last = rows[k];
  });
  if (last && state.playing) {
    last.className = "now";
    get("events").scrollTop = last.offsetTop - 90;
  }
}

function frame(now) {
  if (state.playing) {
    state.time = Math.min(state.result.end, state.time + (now - before) / 1000);
    if (state.time >= state.result.end) { state.playing = false; show(); } else moment();
  }
  before = now;
  requestAnimationFrame(frame);
}

// -- hands ------------------------------------------------------------------------------------

function numbers() {
  for (const [key, [least, most, step]] of Object.entries(RANGES)) {
    const label = document.createElement("label");
    label.innerHTML = `<span id="name-${key}"></span><input id="range-${key}" type="range" min="${least}" max="${most}" step="${step}">`
      + `<input id="number-${key}" type="number" step="any" aria-labelledby="name-${key}"><small id="unit-${key}"></small>`;
    get("numbers").append(label);
    for (const kind of ["range", "number"]) get(`${kind}-${key}`).addEventListener("input", (event) => {
      if (event.target.value === "") return;
      state.shot[key] = Number(event.target.value);
      get(`${kind === "range" ? "number" : "range"}-${key}`).value = event.target.value;
      play();
    });
  }
}

function pointer() {
  let held = null;
  const canvas = get("table");
  canvas.addEventListener("pointerdown", (event) => {
    if (!table.table) return;
    const [x, y] = table.from(event);
    held = table.table.balls.findIndex(([, bx, by, radius]) => Math.hypot(x - bx, y - by) < radius);
    canvas.setPointerCapture(event.pointerId);
    drag(event);
  });
  canvas.addEventListener("pointermove", (event) => { if (held !== null) drag(event); });
  canvas.addEventListener("pointerup", () => { held = null; });
  canvas.addEventListener("pointercancel", () => { held = null; });
  const drag = (event) => {
    const [x, y] = table.from(event), { balls } = table.table, [, cx, cy] = balls[0];
    if (held >= 0) {
      balls[held][1] = x; balls[held][2] = y;
      state.places = balls.map(([, bx, by]) => [bx, by]);
    } else if (Math.hypot(x - cx, y - cy) > 0.05) {
      state.shot.angle = Number(((Math.atan2(y - cy, x - cx) * 180) / Math.PI).toFixed(2));
      fill();
    }
    play();
  };
}

function hands() {
  get("shot").addEventListener("submit", (event) => event.preventDefault());
  get("setup").addEventListener("change", (event) => { lay(event.target.value); play(); });
  get("law").addEventListener("change", (event) => { state.law = event.target.value; play(); });
  get("again").addEventListener("click", () => { lay(state.setup); play(); });
  get("language").addEventListener("click", () => { state.language = state.language === "en" ? "ko" : "en"; speak(); remember(); });
  get("link").addEventListener("click", async () => { await navigator.clipboard?.writeText(location.href); say("copied"); });
  get("play").addEventListener("click", () => {
    if (state.time >= state.result.end) state.time = 0;
    state.playing = !state.playing;
    show();
  });
  get("time").addEventListener("input", (event) => { state.playing = false; state.time = Number(event.target.value); show(); });
  window.addEventListener("resize", () => { if (table.table) { table.resize(); moment(); } });
}

// -- Python -----------------------------------------------------------------------------------

async function python() {
  const pyodide = await loadPyodide({ indexURL: new URL("pyodide/", location.href).href });
  pyodide.unpackArchive(await (await fetch("physics.zip")).arrayBuffer(), "zip", { extractDir: "/danggu" });
  pyodide.FS.writeFile("/danggu/lab.py", await (await fetch("lab.py")).text());
  pyodide.runPython("import sys; sys.path.insert(0, '/danggu')");
  return pyodide.pyimport("lab");
}

async function begin() {
  const asked = recall();
  state.language = WORDS[asked.language] ? asked.language : navigator.language.startsWith("ko") ? "ko" : "en";
  numbers();
  hands();
  pointer();
  speak();
  try {
    lab = await python();
    lay(WORDS.en.setups[asked.setup] ? asked.setup : state.setup);
    state.law = WORDS.en.laws[asked.law] ? asked.law : state.law;
    Object.assign(state.shot, asked.shot);
    if (asked.places?.length === table.table.balls.length) {
      state.places = asked.places;
      asked.places.forEach(([x, y], k) => { table.table.balls[k][1] = x; table.table.balls[k][2] = y; });
    }
    fill();
    play();
    speak();
    window.lab = lab;  // for a check, and for the curious
    requestAnimationFrame(frame);
  } catch (error) {
    say("", `${words().failed} ${error}`);
  }
}

begin();
