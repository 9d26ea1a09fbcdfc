// How fast the path view of the page shows and turns a large program.
//
// PATH is the table of points that generate_programs writes beside a program (PROGRAM.nc.path.csv).
// Its points come to the page in pages of 4,096, as the daemon sends a planned path, but from here:
// planning a large program is not what is measured. Starts stanokd with simulated drives, stanok-web
// and Debian's Chromium without a screen, which draws in software (SwiftShader): there is no graphics
// processor in these figures. Measured in the browser, from the moment in which the path view is asked
// for: the first picture with some of the path, the picture with all of it; pictures a second while it
// is turned, from far and from near; and the longest time for which the page does not answer.
//
// usage: STANOK_BIN=build/release/bin node benchmarks/panel_path_figures.mjs PATH [SECONDS]
// (default 5 s of turning). Needs `npm ci` in panel/.
import { basename, join } from "node:path";
import { root, setStage } from "../panel/tests/stage.mjs";
import { inPlaceOfDaemon, pagesOf, pointsOfTable } from "./planned_path.mjs";

const [table, seconds = "5"] = process.argv.slice(2);
if (table === undefined) {
  console.error("usage: panel_path_figures.mjs PATH [SECONDS]");
  process.exit(2);
}
const sizes = [
  [360, 640],
  [1280, 800],
  [3840, 2160],
];
const duration_ms = 1000 * Number(seconds);

// In the page, before anything else of it: what keeps it from answering, and when pictures came.
function watch() {
  window.longTasks = [];
  new PerformanceObserver((list) => {
    for (const { startTime, duration } of list.getEntries())
      window.longTasks.push([startTime, duration]);
  }).observe({ type: "longtask", buffered: true });
}

// In the page: asks for the view, and says after how many milliseconds which picture was there.
function show(points) {
  return new Promise((resolve) => {
    const began = performance.now();
    let first = null;
    location.hash = "#/path";
    const look = () => {
      const canvas = document.querySelector("canvas");
      const drawn = Number(canvas?.dataset.drawn ?? 0);
      if (drawn > 0) first ??= performance.now() - began;
      if (drawn < points) return requestAnimationFrame(look);
      resolve({ began, first, all: performance.now() - began });
    };
    look();
  });
}

// In the page: turns the picture as a hand does, a step for each picture that the browser shows.
function turn(duration) {
  return new Promise((resolve) => {
    const canvas = document.querySelector("canvas");
    const box = canvas.getBoundingClientRect();
    const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
    const event = (type, dx, dy, buttons) =>
      canvas.dispatchEvent(
        new PointerEvent(type, {
          bubbles: true,
          pointerId: 1,
          pointerType: "mouse",
          button: type === "pointermove" ? -1 : 0,
          buttons,
          clientX: x + dx,
          clientY: y + dy,
        }),
      );
    canvas.setPointerCapture = canvas.releasePointerCapture = () => undefined;
    const pictures = () => Number(canvas.dataset.pictures);
    const [began, from] = [performance.now(), pictures()];
    event("pointerdown", 0, 0, 1);
    let step = 0;
    const go = () => {
      step += 1;
      event("pointermove", 2 * step, 20 * Math.sin(step / 20), 1);
      const gone = performance.now() - began;
      if (gone < duration) return requestAnimationFrame(go);
      event("pointerup", 2 * step, 0, 0);
      resolve({ began, rate: (pictures() - from) / (gone / 1000) });
    };
    requestAnimationFrame(go);
  });
}

async function longest(page, since) {
  const tasks = await page.evaluate(() => window.longTasks);
  return Math.max(
    0,
    ...tasks.filter(([start]) => start >= since).map(([, length]) => length),
  );
}

const ms = (time) => `${Math.round(time)} ms`;
const rate = (one) => `${one.toFixed(1)} / s`;

const path = pagesOf(pointsOfTable(table));
const planned = (page) =>
  page.addInitScript(watch).then(() => inPlaceOfDaemon(page, path));

const stage = await setStage({
  programs: [join(root, "programs/examples/helix.nc")],
});
try {
  await stage.client.call("program.load", { program: "helix.nc" });
  console.log(`${basename(table)}: ${path.points} points\n`);
  console.log(
    "| page | first picture | all of it | page does not answer, loading | turned from far | from near | page does not answer, turning |",
  );
  console.log("|---|---|---|---|---|---|---|");
  for (const [width, height] of sizes) {
    const page = await stage.openMachine({ width, height, before: planned });
    const shown = await page.evaluate(show, path.points);
    const loading = await longest(page, shown.began);
    const far = await page.evaluate(turn, duration_ms);
    const canvas = page.locator("canvas");
    const box = await canvas.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    for (let i = 0; i < 20; ++i) await page.mouse.wheel(0, -100);
    const near = await page.evaluate(turn, duration_ms);
    const turning = await longest(page, far.began);
    console.log(
      `| ${width} × ${height} | ${ms(shown.first)} | ${ms(shown.all)} | ${ms(loading)} | ${rate(far.rate)} | ${rate(near.rate)} | ${ms(turning)} |`,
    );
    if (process.env.STANOK_PICTURES)
      await page.screenshot({
        path: `${process.env.STANOK_PICTURES}/path-${width}.png`,
      });
    await page.context().close();
  }
} finally {
  await stage.close();
}
if (stage.faults.length > 0) throw new Error(stage.faults.join("\n"));
