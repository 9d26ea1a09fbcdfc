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
import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { root, setStage } from '../panel/tests/stage.mjs';

const [table, seconds = '5'] = process.argv.slice(2);
if (table === undefined) {
  console.error('usage: panel_path_figures.mjs PATH [SECONDS]');
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
  }).observe({ type: 'longtask', buffered: true });
}

// In the page: asks for the view, and says after how many milliseconds which picture was there.
function show(points) {
  return new Promise((resolve) => {
    const began = performance.now();
    let first = null;
    location.hash = '#/path';
    const look = () => {
      const canvas = document.querySelector('canvas');
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
    const canvas = document.querySelector('canvas');
    const box = canvas.getBoundingClientRect();
    const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
    const event = (type, dx, dy, buttons) =>
      canvas.dispatchEvent(
        new PointerEvent(type, {
          bubbles: true,
          pointerId: 1,
          pointerType: 'mouse',
          button: type === 'pointermove' ? -1 : 0,
          buttons,
          clientX: x + dx,
          clientY: y + dy,
        }),
      );
    canvas.setPointerCapture = canvas.releasePointerCapture = () => undefined;
    const pictures = () => Number(canvas.dataset.pictures);
    const [began, from] = [performance.now(), pictures()];
    event('pointerdown', 0, 0, 1);
    let step = 0;
    const go = () => {
      step += 1;
      event('pointermove', 2 * step, 20 * Math.sin(step / 20), 1);
      const gone = performance.now() - began;
      if (gone < duration) return requestAnimationFrame(go);
      event('pointerup', 2 * step, 0, 0);
      resolve({ began, rate: (pictures() - from) / (gone / 1000) });
    };
    requestAnimationFrame(go);
  });
}

async function longest(page, since) {
  const tasks = await page.evaluate(() => window.longTasks);
  return Math.max(0, ...tasks.filter(([start]) => start >= since).map(([, length]) => length));
}

const ms = (time) => `${Math.round(time)} ms`;
const rate = (one) => `${one.toFixed(1)} / s`;

const pointsOfPage = 4096;

// The pages of the path as the page gets them: header, points, numbers of lines.
function pagesOf(file) {
  const [names = '', ...rows] = readFileSync(file, 'utf8').trim().split('\n');
  const columns = ['x', 'y', 'z'].map((axis) => names.split(',').indexOf(axis));
  const points = rows.map((row) => row.split(',').map(Number));
  const pages = [];
  for (let first = 0; first < points.length; first += pointsOfPage) {
    const part = points.slice(first, first + pointsOfPage);
    const bytes = Buffer.alloc(16 + 16 * part.length);
    [1, 7, pages.length, part.length].forEach((value, i) => bytes.writeUInt32LE(value, 4 * i));
    part.forEach((point, i) => {
      columns.forEach((column, axis) => bytes.writeFloatLE(point[column], 16 + 12 * i + 4 * axis));
      bytes.writeUInt32LE(first + i + 1, 16 + 12 * part.length + 4 * i);
    });
    pages.push(bytes);
  }
  return { pages, points: points.length };
}

const path = pagesOf(table);

/** Answers the page in the place of the daemon when it asks for the planned path. */
async function planned(page) {
  await page.addInitScript(watch);
  await page.routeWebSocket(/\/ws$/, (socket) => {
    const server = socket.connectToServer();
    socket.onMessage((text) => {
      const { id, method, params } = JSON.parse(text);
      if (method !== 'program.path') return server.send(text);
      const frame = path.pages[params.page];
      const geometry = frame && { id: 7, page: params.page, rapid: [], begins: [] };
      if (frame !== undefined) socket.send(frame);
      const result = { id: 7, pages: path.pages.length, points: path.points, complete: true };
      const answer = { jsonrpc: '2.0', id, result: { ...result, geometry: geometry ?? null } };
      socket.send(JSON.stringify(answer));
    });
    server.onMessage((text) => socket.send(text));
  });
}

const stage = await setStage({ programs: [join(root, 'programs/examples/helix.nc')] });
try {
  await stage.client.call('program.load', { program: 'helix.nc' });
  console.log(`${basename(table)}: ${path.points} points\n`);
  console.log(
    '| page | first picture | all of it | page does not answer, loading | turned from far | from near | page does not answer, turning |',
  );
  console.log('|---|---|---|---|---|---|---|');
  for (const [width, height] of sizes) {
    const page = await stage.openMachine({ width, height, before: planned });
    const shown = await page.evaluate(show, path.points);
    const loading = await longest(page, shown.began);
    const far = await page.evaluate(turn, duration_ms);
    const canvas = page.locator('canvas');
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
if (stage.faults.length > 0) throw new Error(stage.faults.join('\n'));
