// Open the lab in Chromium without a window and print as JSON what it plays; see browser.py.
import { readFileSync } from "node:fs";
import { chromium } from "playwright-core";

const { address, browser: executablePath, shots, pictures } = JSON.parse(readFileSync(process.argv[2]));
const flags = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const browser = await chromium.launch({ executablePath, args: flags });
const page = await browser.newPage({ viewport: { width: 1360, height: 900 } });
const faults = [];
page.on("pageerror", (error) => faults.push(String(error)));
page.on("console", (message) => { if (message.type() === "error") faults.push(message.text()); });
page.on("requestfailed", (request) => faults.push(`${request.url()} could not be loaded`));

async function ready(hash) {
  await page.goto("about:blank");
  await page.goto(address + (hash ? "#" + encodeURIComponent(JSON.stringify(hash)) : ""));
  await page.waitForFunction(() => window.lab, null, { timeout: 120000 });
}

async function picture(name, hash, time) {
  if (!pictures) return;
  await ready(hash);
  await page.locator("#time").evaluate((slider, when) => {
    slider.value = when;
    slider.dispatchEvent(new Event("input"));
  }, time);
  await page.screenshot({ path: `${pictures}/${name}.png` });
}

await ready();
const played = await page.evaluate((asked) => asked.map((one) => window.lab.played(...one)), shots);
// a hand's way through it: type a speed, play, wait until the balls move
await page.fill("#number-speed", "2.5");
await page.click("#play");
await page.waitForFunction(() => Number(document.getElementById("time").value) > 0.2, null, { timeout: 20000 });
const box = await page.locator("#table").boundingBox();  // 2.84 m wide with its rails, for 2.54 m of cloth
const at = (x, y) => [box.x + box.width / 2 + (x * box.width) / 2.84, box.y + box.height / 2 - (y * box.width) / 2.84];
async function drag(from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 5 });
  await page.mouse.up();
}
await drag(at(0, 0.5), at(-0.6, 0.5));
const angle = await page.inputValue("#number-angle");
if (Math.abs(angle - 90) > 2) faults.push(`a drag to straight above the cue ball aims at ${angle}°`);
await drag(at(-0.2, 0.3), at(0.6, 0.02));
const wrong = await page.textContent("#status.wrong");
if (!wrong?.includes("overlap")) faults.push(`a ball on another is ${wrong}`);
if (await page.isEnabled("#play")) faults.push("what cannot be played can be played");
await page.click("#again");
if (!(await page.isEnabled("#play"))) faults.push("no way back from what cannot be played");
await page.click("#language");
const title = await page.textContent("h1");
if (!title.includes("실험실")) faults.push(`the title is ${title} in Korean`);
await picture("lab-en", { language: "en" }, 0);
await picture("lab-ko", { language: "ko", setup: "three-cushion" }, 2.2);
await picture("lab-break", { language: "en", setup: "break" }, 1.1);
const python = await page.evaluate(() => window.lab.python());
if (pictures) {
  await page.setViewportSize({ width: 420, height: 900 });
  await picture("lab-narrow", { language: "ko" }, 1.0);
}
const agent = `Chromium ${browser.version()}`;
await browser.close();
if (faults.length) {
  console.error(faults.join("\n"));
  process.exit(1);
}
console.log(JSON.stringify({ played, python, agent }));
