// The path that is drawn is the one that the machine follows: lines in the graphics memory of the browser beside the
// programmed point of every cycle that `stanok simulate --tip-trace` writes, put on the part by hand. In six situations.
// With STANOK_WRITE_DOCS=1 it takes the picture of docs/programmer/five-axes.md, too.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, describe, test } from 'node:test';
import { listenToGraphics } from './drawn_lines.mjs';
import { bin, full, root, setStage, until } from './stage.mjs';

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
const length_of_tool_mm = 130;
const flat = head + figure + end;
const twoOffsets = `${head}${figure}G10 L2 P2 X25 Y-15 Z70\nG55\n${figure}${end}`;
// Behind G69 no formula as short as this one says where the tilted table has the part: nothing moves there.
const tilted = `${head}G68.2 X0 Y-30 Z0 I0 J25 K0\nG53.1\n${figure}G69\nM30\n`;
function turnedAboutX([x, y, z], angle_deg) {
  const angle = (angle_deg * Math.PI) / 180;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [x, c * y - s * z, s * y + c * z];
}
/** J tilts about X: the plane as its matrix says it, zero at Y-30. */
function onTilted(point) {
  const [x, y, z] = turnedAboutX(point, 25);
  return [x, y - 30, z];
}
/** While the table turns about A, 35 mm behind the zero of the part and 100 mm below it, the tip goes round it there. */
function whileATurns(point, a) {
  const [x, y, z] = turnedAboutX([point[0], point[1] - 35, point[2] + 100], -a);
  return [x, y + 35, z - 100];
}
/** The lines of a text from the one that contains `from` to the one before the next that is `to`, counted from 1. */
function linesOf(text, from, to) {
  const lines = text.split('\n');
  const first = lines.findIndex((line) => line.includes(from));
  const last = lines.findIndex((line, k) => k > first && line === to);
  return { first: first + 1, last };
}
const within = ({ first, last }, line) => line >= first && line <= last;
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

/** The programmed point of every cycle in which it moves, put on the part, as lines from the cycle before. */
function tracedBy(folder, machine, text, onPart) {
  const [program, file] = [join(folder, 'part.nc'), join(folder, 'tip.csv')];
  writeFileSync(program, text);
  const words = ['simulate', program, '--machine', machine, '--tip-trace', `1=${file}`];
  execFileSync(join(bin, 'stanok'), words, { stdio: ['ignore', 'ignore', 'inherit'] });
  const [first, ...rows] = readFileSync(file, 'ascii').trim().split('\n');
  const columns = ['x', 'y', 'z'].map((word) => first.split(',').indexOf(word));
  const points = rows.map((row) => {
    const values = row.split(',').map(Number);
    const line = values[first.split(',').indexOf('line')] ?? 0;
    const a = values[first.split(',').indexOf('a')] ?? 0;
    return onPart(
      columns.map((column) => values[column] ?? 0),
      line,
      a,
    );
  });
  return pairs(points).filter(([a, b]) => apart(a, b) > 0);
}

/** Where the first line of the daemon's path begins, and how many lines it has. */
async function planned(client) {
  const path = await until('the whole path', async () => {
    const answer = await client.call('program.path', { channel: 1, page: 0, system: 'part' });
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

/** From where the path is seen: of a picture that stands, and that no frame changes any more. */
async function seenFrom(page) {
  return until('a picture that stands', () =>
    page.evaluate(async () => {
      const before = window.drawnFrom();
      for (let frame = 0; frame < 5; ++frame) await new Promise(requestAnimationFrame);
      const stands = document.querySelector('canvas')?.dataset.how === 'standing';
      return stands && before.length > 0 && `${before}` === `${window.drawnFrom()}` && before;
    }),
  );
}

/** Turns the wheel by one notch, and waits for the picture that stands behind it: on a busy computer it comes late. */
async function goNearer(page) {
  const before = await seenFrom(page);
  await page.mouse.wheel(0, -400);
  await until(
    'a nearer picture',
    async () => far(await page.evaluate(() => window.drawnFrom()), before) > 0,
  );
  await seenFrom(page);
}

/** Lines of the picture, from so near that it has all of them: farther away those finer than a pixel are left out. */
async function drawnOn(page, { begin, count }) {
  const canvas = page.locator('canvas');
  await until('the picture of this path', async () => {
    const [first] = await page.evaluate(() => window.drawnLines());
    return first !== undefined && far(first, begin) < 1e-3;
  });
  await page.getByRole('button', { name: 'Isometric' }).click();
  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const segmentsSeen = () => canvas.evaluate(({ dataset }) => Number(dataset.segments));
  await seenFrom(page);
  for (let nearer = 0; nearer < 40 && (await segmentsSeen()) !== count; ++nearer)
    await goNearer(page);
  const segments = await segmentsSeen();
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
    here.compare = async (context, text, onPart = (point) => point) => {
      const drawn = await drawnOn(here.page, await planned(stage.client));
      compare(context, drawn, tracedBy(folder, here.machine, text, onPart));
    };
    here.check = async (context, text, onPart) => {
      await here.load(text);
      await here.compare(context, text, onPart);
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
  test('in another work offset', (context) => {
    const second = linesOf(twoOffsets, 'G55', 'M30');
    // G54 of this machine has Z60.
    return here.check(context, twoOffsets, ([x, y, z], line) =>
      within(second, line) ? [x + 25, y - 15, z + 10] : [x, y, z],
    );
  });
  test('on a tilted plane', (context) => {
    const plane = linesOf(tilted, 'G68.2', 'G69');
    const turning = linesOf(tilted, 'G53.1', 'G0 X-20 Y-6 Z40');
    return here.check(context, tilted, (point, line, a) => {
      if (!within(plane, line)) return point;
      return within(turning, line) ? whileATurns(onTilted(point), a) : onTilted(point);
    });
  });
  test('with five axes', (context) => {
    const led = linesOf(fiveAxes, 'G43.4', 'G49');
    return here.check(context, fiveAxes, ([x, y, z], line) =>
      within(led, line) ? [x, y, z] : [x, y, z - length_of_tool_mm],
    );
  });
  test('the table turns where the machine stands still', async () => {
    const { page, stage } = here;
    await here.load(flat);
    await stage.switchOn();
    const canvas = page.locator('canvas');
    const { x, y, width, height } = await canvas.boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 60, y + height / 2 + 20, { steps: 4 });
    await page.mouse.up();
    const from = () => seenFrom(page);
    const seen = await from();
    await stage.client.call('mdi', { text: 'G0 A-20', channel: 1, wait: 'done' });
    await until('the tool leans on the part', async () => {
      const { on_part: on } = await stage.status();
      return Math.abs(on.direction[2] - Math.cos((20 * Math.PI) / 180)) < 1e-5;
    });
    assert.ok(far(await from(), seen) < 1e-6, 'the part stands');
    const button = page.getByRole('button', { name: 'Show machine' });
    await button.click();
    await until('another picture', async () => far(await from(), seen) > 1e-3);
    const turned = await from();
    // Columns of both matrices are those of turns: what lies between them turns about X by 20 deg.
    const turn = (row, column) =>
      [0, 1, 2].reduce((sum, k) => sum + seen[4 * row + k] * turned[4 * column + k], 0);
    assert.ok(Math.abs(turn(0, 0) - 1) < 1e-4, 'about X');
    const cosine = Math.cos((20 * Math.PI) / 180);
    assert.ok(Math.abs(turn(1, 1) - cosine) < 1e-4 && Math.abs(turn(2, 2) - cosine) < 1e-4);
    await button.click();
    await until('the picture from before', async () => far(await from(), seen) < 1e-6);
    await stage.client.call('mdi', { text: 'G0 A0', channel: 1, wait: 'done' });
  });
  test('in colours by feed and by tool, which is remembered', async () => {
    const { page } = here;
    const colours = page.getByLabel('Colors of the path');
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
    const from = () => seenFrom(page);
    await page.getByRole('button', { name: 'Isometric' }).click();
    const usual = await from();
    const { x, y, width, height } = await canvas.boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 120, y + height / 2 + 40, { steps: 4 });
    await page.mouse.up();
    await page.mouse.wheel(0, -200);
    const turned = await from();
    assert.ok(far(turned, usual) > 1, 'turned');
    await page.evaluate(() => (location.hash = '#/machine'));
    await canvas.waitFor({ state: 'detached' });
    await page.evaluate(() => (location.hash = '#/path'));
    await canvas.waitFor();
    const again = await from();
    assert.ok(far(again, turned) < 1e-3, `${again} is not ${turned}`);
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

// A whole part, which takes long: when it is full (ctest panel.drawn_long).
situations('while a mill works on tilted planes', 'trunnion.toml', (here) => {
  test('the part is cut where its planes lie', { skip: !full }, async () => {
    await here.load(flat);
    const { page, stage } = here;
    const name = 'tilted_planes.nc';
    cpSync(join(root, 'programs/examples', name), join(stage.programs, name));
    await stage.client.call('program.load', { program: name });
    await stage.switchOn();
    await stage.client.call('program.run', { program: name, channel: 1 });
    // The second face, from three points: its system begins at X32 and Y runs along -X there.
    await until('the tool in the second plane', async () => {
      const { on_part: on, line } = await stage.status();
      return line >= 33 && on?.work !== null && Math.abs(on.work[3] - 32) < 1e-4;
    });
    const { on_part: on } = await stage.status();
    const slope = Math.hypot(4, 10);
    for (const [k, part] of [4 / slope, 0, 10 / slope].entries())
      assert.ok(Math.abs(on.direction[k] - part) < 1e-5, `${on.direction}`);
    await page.locator('canvas[data-triangles]:not([data-triangles="0"])').waitFor();
    if (process.env.STANOK_WRITE_DOCS === '1') {
      await stage.client.call('program.hold', { channel: 1 });
      const before = await page.evaluate(() => window.drawnFrom());
      await page.getByRole('button', { name: 'Show machine' }).click();
      await until(
        'the machine to stand',
        async () => far(await page.evaluate(() => window.drawnFrom()), before) > 0.1,
      );
      await page.getByRole('button', { name: 'Isometric' }).click();
      await until('a picture of it', async () =>
        page.locator('canvas').evaluate(({ dataset }) => dataset.how === 'standing'),
      );
      await page.screenshot({ path: join(root, 'docs/programmer/pictures/panel-planes.png') });
      await page.getByRole('button', { name: 'Show machine' }).click();
      await stage.client.call('program.resume', { channel: 1 });
    }
    await until('the end of the program', async () => !(await stage.status()).line);
  });
});
