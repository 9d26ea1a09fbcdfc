// The path that is drawn is the one that the machine follows: lines in the graphics memory of the browser beside the
// programmed point of every cycle that `stanok simulate --tip-trace` writes. In five situations.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, describe, test } from 'node:test';
import { listenToGraphics } from './drawn_lines.mjs';
import { bin, root, setStage, until } from './stage.mjs';

// What the planned path may leave out (docs/reference/protocol.md#programs), and Float32 of some hundred millimetres.
const tolerance_mm = 0.01 + 1e-4;
const machines = join(root, 'config/machines');

const head = 'G21 G90 G17 G40 G49 G69 G80 G94\nT2 M6\nG54\nG64 P0.01\nG43 H2\nG53 G0 Z0\n';
const figure = `G0 X-20 Y-6 Z40
G1 Z0 F3000
X20
G3 X30 Y4 I0 J10
G1 X10 Y15
G2 X-10 Y15 R10
G1 X-20 Y-6
G0 Z20
`;
const end = 'G53 G0 Z0\nM30\n';
const flat = head + figure + end;
const tilted = `${head}G68.2 X0 Y-30 Z0 I0 J25 K0\nG53.1\n${figure}G69\n${end}`;
const fiveAxes = `G21 G90 G17 G40 G49 G69 G80 G94
T2 M6
G54
G64 P0.01
G53 G0 Z0
G43.4 H2
G0 X-40 Y-30 Z30 A0 C0
G1 X-30 Y-20 Z5 A-10 C0 F3000
X30 Y-20 A-25 C60
X20 Y20 Z2 A-5 C120
X0 Y0 Z30 A0 C0
G49
${end}`;
const turned = `G21 G90 G18 G7 G40 G54
T0101
G97 S1200 M3
G95 G0 X70 Z5
G1 X40 F0.3
Z0
G3 X60 Z-10 R10
G1 X64 Z-30
G2 X70 Z-33 R3
G1 Z-40
G0 X80 Z10
M5
M30
`;

function between(a, b, share) {
  return a.map((value, k) => value + share * (b[k] - value));
}
const far = (a, b) => Math.max(...a.map((value, k) => Math.abs(value - b[k])));
const apart = (a, b) => Math.hypot(...a.map((value, k) => value - b[k]));

function toLine(point, [a, b]) {
  const way = b.map((value, k) => value - a[k]);
  const length2 = way.reduce((sum, one) => sum + one * one, 0);
  const along = way.reduce((sum, one, k) => sum + one * (point[k] - a[k]), 0);
  return apart(point, between(a, b, length2 > 0 ? Math.min(1, Math.max(0, along / length2)) : 0));
}

/** How far the points are from the nearest of the lines at most. */
const farthest = (points, lines) =>
  Math.max(...points.map((point) => Math.min(...lines.map((line) => toLine(point, line)))));

const pairs = (points) => points.slice(1).map((point, k) => [points[k], point]);

/** The programmed point of every cycle in which it moves, as lines from the cycle before. */
function tracedBy(folder, machine, text) {
  const [program, file] = [join(folder, 'part.nc'), join(folder, 'tip.csv')];
  writeFileSync(program, text);
  const words = ['simulate', program, '--machine', machine, '--tip-trace', `1=${file}`];
  execFileSync(join(bin, 'stanok'), words, { stdio: ['ignore', 'ignore', 'inherit'] });
  const [first, ...rows] = readFileSync(file, 'ascii').trim().split('\n');
  const columns = ['x', 'y', 'z'].map((word) => first.split(',').indexOf(word));
  const points = rows.map((row) => {
    const values = row.split(',').map(Number);
    return columns.map((column) => values[column] ?? 0);
  });
  return pairs(points).filter(([a, b]) => apart(a, b) > 0);
}

/** Where the first line of the daemon's path begins, and how many lines it has. */
async function planned(client) {
  const path = await until('the whole path', async () => {
    const answer = await client.call('program.path', { channel: 1, page: 0 });
    return answer.complete && answer;
  });
  assert.equal(path.pages, 1);
  const { begins, base64 } = path.geometry;
  const bytes = Buffer.from(base64, 'base64');
  const isBegin = (k) => begins.some(([from, to]) => from <= k && k < to);
  let first = 0;
  while (isBegin(first + 1)) ++first;
  return {
    begin: [0, 4, 8].map((at) => bytes.readFloatLE(12 * first + at)),
    count: path.points - begins.reduce((sum, [from, to]) => sum + to - from, 0),
  };
}

/** Lines of the picture, from so near that it has all of them: farther away those finer than a pixel are left out. */
async function drawnOn(page, { begin, count }) {
  const canvas = page.locator('canvas');
  await until('the picture of this path', async () => {
    const [first] = await page.evaluate(() => window.drawnLines());
    return first !== undefined && far(first, begin) < 1e-3;
  });
  await page.getByRole('button', { name: 'Slanted' }).click();
  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const standing = async () => {
    const how = await canvas.evaluate(({ dataset }) => ({ ...dataset }));
    return how.how === 'standing' && Number(how.drawn) > 0 && Number(how.segments);
  };
  let segments = 0;
  for (let nearer = 0; segments !== count && nearer < 40; ++nearer) {
    await page.mouse.wheel(0, -400);
    segments = await until('a picture that stands', standing);
  }
  assert.equal(segments, count, 'all lines of the path');
  // While things move finer lines are left out: a picture may have come in between.
  const points = await until('all lines in a picture that stands', async () => {
    const [how, drawn] = await page.evaluate(() => [
      document.querySelector('canvas').dataset.how,
      window.drawnLines(),
    ]);
    return how === 'standing' && drawn.length === 2 * segments && drawn;
  });
  return points.flatMap((point, k) => (k % 2 === 0 ? [[point, points[k + 1]]] : []));
}

function compare(context, drawn, traced) {
  assert.ok(Math.max(...drawn.map(([a, b]) => apart(a, b))) > 1, 'chords, not every cycle');
  const added = farthest(drawn.flat(), traced);
  const middles = drawn.map(([a, b]) => between(a, b, 0.5));
  const between_points = farthest(middles, traced);
  const cycles = traced.map(([, to]) => to).filter((_, k) => k % 5 === 0);
  const left_out = farthest(cycles, drawn);
  const digits = (value) => value.toFixed(5);
  context.diagnostic(
    `${drawn.length} lines, ${traced.length} cycles: points ${digits(added)} mm from the tip, ` +
      `middles of lines ${digits(between_points)} mm, the tip ${digits(left_out)} mm from the lines`,
  );
  assert.ok(Math.max(added, between_points, left_out) <= tolerance_mm);
}

function situations(name, machine, act) {
  describe(name, () => {
    const folder = mkdtempSync(join(tmpdir(), 'panel-drawn-'));
    let stage;
    after(async () => {
      await stage?.close();
      rmSync(folder, { recursive: true });
      assert.deepEqual(stage?.faults ?? [], []);
    });
    const here = { folder, machine: join(machines, machine) };
    /** Shows a program in the path view. */
    here.load = async (text) => {
      if (stage === undefined) {
        stage = here.stage = await setStage({ machine });
        const before = (page) => page.addInitScript(listenToGraphics);
        here.page = await stage.openMachine({ before });
        await here.page.evaluate(() => (location.hash = '#/path'));
      }
      writeFileSync(join(stage.programs, 'part.nc'), text);
      await stage.client.call('program.load', { program: 'part.nc' });
    };
    here.compare = async (context, text) => {
      const drawn = await drawnOn(here.page, await planned(stage.client));
      compare(context, drawn, tracedBy(folder, here.machine, text));
    };
    here.check = async (context, text) => {
      await here.load(text);
      await here.compare(context, text);
    };
    act(here);
  });
}

situations('on a mill with a trunnion table', 'trunnion.toml', (here) => {
  test('flat', (context) => here.check(context, flat));
  test('arcs have a colour of their own', async () => {
    const [points, colours] = await here.page.evaluate(() => [
      window.drawnLines(),
      window.drawnColours(),
    ]);
    const circles = [
      [20, 4],
      [0, 15],
    ];
    const off = ([x, y], [across, up]) => Math.abs(Math.hypot(x - across, y - up) - 10);
    const of = { arcs: [], others: [] };
    for (let k = 0; k < points.length; k += 2) {
      const ends = [points[k], points[k + 1]];
      if (apart(...ends) < 0.3) continue;
      const far = Math.min(...circles.map((one) => Math.max(...ends.map((end) => off(end, one)))));
      // Where a corner is rounded within its tolerance a piece is near the circle, and no arc.
      if (far < 0.001) of.arcs.push(colours[k + 1]);
      else if (far > 0.02) of.others.push(colours[k + 1]);
    }
    assert.ok(of.arcs.length > 20, `${of.arcs.length} lines on arcs`);
    const [arc, ...more] = new Set(of.arcs);
    assert.deepEqual(more, []);
    assert.match(arc, /^\d+,\d+,\d+$/);
    assert.ok(!of.others.includes(arc), 'of arcs only');
    // Feed and rapid.
    assert.equal(new Set(of.others).size, 2);
  });
  test('on a tilted plane', (context) => here.check(context, tilted));
  test('with five axes', (context) => here.check(context, fiveAxes));
  test('in colours by feed and by tool, which is remembered', async () => {
    const { page } = here;
    const colours = page.getByLabel('Colours of the path');
    const legend = page.locator('.legend');
    await colours.selectOption('By feed');
    await legend.getByText('F 3000 mm/min').waitFor();
    await colours.selectOption('By tool');
    await legend.getByText('T2').waitFor();
    assert.equal(
      await page.evaluate(() => JSON.parse(localStorage['stanok.screen']).shading),
      'tool',
    );
    await colours.selectOption('By kind of move');
    await legend.getByText('feed', { exact: true }).waitFor();
    await legend.getByText('arc', { exact: true }).waitFor();
  });
  test('seen from where it was turned to, after another view', async () => {
    const { page } = here;
    const canvas = page.locator('canvas');
    const from = () => page.evaluate(() => window.drawnFrom());
    await page.getByRole('button', { name: 'Slanted' }).click();
    const usual = await from();
    const { x, y, width, height } = await canvas.boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 120, y + height / 2 + 40, { steps: 4 });
    await page.mouse.up();
    await page.mouse.wheel(0, -200);
    const stands = () => canvas.evaluate(({ dataset }) => dataset.how === 'standing');
    await until('a turned picture', async () => (await stands()) && far(await from(), usual) > 1);
    const turned = await from();
    await page.evaluate(() => (location.hash = '#/machine'));
    await canvas.waitFor({ state: 'detached' });
    await page.evaluate(() => (location.hash = '#/path'));
    await canvas.waitFor();
    await until('the path again', async () => (await stands()) && (await from()).length > 0);
    assert.ok(far(await from(), turned) < 1e-3, `${await from()} is not ${turned}`);
  });
  test('after another zero offset, without being loaded again', async (context) => {
    const { client } = here.stage;
    await here.load(flat);
    const { begin } = await planned(client);
    const shift = { X: 35.5, Y: -20.25, Z: 11.125 };
    const { offsets } = await client.call('offset.list');
    for (const [axis, by] of Object.entries(shift))
      await client.call('offset.set', { offset: 'G54', axis, value: offsets.G54[axis] + by });
    // It begins where the machine stands: in the new system that is elsewhere, and nothing is loaded again.
    const expected = Object.values(shift).map((by, k) => begin[k] - by);
    await until('another path', async () => far((await planned(client)).begin, expected) < 1e-3);
    // The same machine, with the tables as they are now.
    const { tables } = await client.call('tool.save');
    assert.match(tables, /71\.125/);
    mkdirSync(join(here.folder, 'trunnion'));
    here.machine = join(here.folder, 'trunnion.toml');
    cpSync(join(machines, 'trunnion.toml'), here.machine);
    writeFileSync(join(here.folder, 'trunnion/tables.toml'), tables);
    await here.compare(context, flat);
  });
  test('after a line by hand has set the zero offset', async () => {
    const { client } = here.stage;
    await here.stage.switchOn();
    const { begin } = await planned(client);
    const { offsets } = await client.call('offset.list');
    const by = 7.75;
    const z = offsets.G54.Z + by;
    await client.call('mdi', { text: `G10 L2 P1 Z${z}`, channel: 1, wait: 'done' });
    const expected = [begin[0], begin[1], begin[2] - by];
    await until('another path', async () => far((await planned(client)).begin, expected) < 1e-3);
    const { changes } = await client.call('tool.history');
    assert.deepEqual([changes[0].what, changes[0].to], ['G54 Z', z]);
  });
});

situations('on a lathe', 'lathe.toml', (here) => {
  test('a turned part', (context) => here.check(context, turned));
});
