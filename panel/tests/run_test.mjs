// A run looked at closely: the part while it is cut, and signals at the full cycle rate.
//
// With STANOK_WRITE_DOCS=1 it takes the pictures of docs/operator/panel-views.md, too.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { root, setStage, storyOf, until } from './stage.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const test = storyOf();
const folder = mkdtempSync(join(tmpdir(), 'panel-run-'));
// A plate of 60 x 40 x 12 mm: two tools, a pocket of three passes and a slot.
const plate = `G21 G90 G17
#workpiece (0, 0.5, 0, 60, 40, 12, 0, 0, 12)
T1 M6
M3 S3000
G0 X-12 Y10 Z5
G1 Z-3 F4000
G1 X72 F2000
G1 Y20
G1 X-12
G1 Y30
G1 X72
G0 Z5
T2 M6
G0 X30 Y-8
G1 Z-8 F4000
G1 Y48 F1500
G0 Z5
M5
M30
`;
const tool = (number, radius) =>
  `[[tool]]
number = ${number}
kind = "flat"
radius = ${radius}
length = 0.0
overhang = 40.0
`;
const tables = tool(1, '5.0') + tool(2, '3.0');

let stage;
let page;
const asked = [];
const note = ({ payload }) => asked.push(/"method":"([^"]+)"/.exec(String(payload))?.[1]);
before(async () => {
  const program = join(folder, 'plate.nc');
  writeFileSync(program, plate);
  stage = await setStage({ machine: 'mill3.toml', programs: [program] });
  await stage.client.call('tool.load', { tables });
  await stage.switchOn();
  const listen = (it) => it.on('websocket', (socket) => socket.on('framesent', note));
  page = await stage.openMachine({ width: 1120, height: 700, before: listen });
});
after(async () => {
  await stage?.close();
  rmSync(folder, { recursive: true });
  assert.deepEqual(stage.faults, []);
});

const show = (view) => page.evaluate((name) => (location.hash = `#/${name}`), view);
const run = () => stage.client.call('program.run', { program: 'plate.nc', channel: 1 });
const isOver = async () => (await stage.status()).program_status === 'Stopped';

async function findings() {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run(document));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' | ')}`);
}

async function picture(name) {
  if (process.env.STANOK_WRITE_DOCS) {
    // While things move it has fewer pixels.
    const moving = page.locator('canvas[data-how=moving]');
    await until('a picture that stands', async () => (await moving.count()) === 0);
    await page.screenshot({ path: join(root, `docs/operator/pictures/panel-${name}.png`) });
  }
}

test('what does not change is not asked for with every status', async () => {
  await stage.client.call('mdi', { text: 'G53 G0 X-40', channel: 1, wait: 'done' });
  await stage.client.call('mdi', { text: 'G53 G0 X0', channel: 1, wait: 'done' });
  assert.ok(asked.filter((method) => method === 'kinematics.list').length <= 1, asked.join());
});

// Three passes of 10 mm across 60 mm, 3 deep; a slot of 6 mm, 8 deep, across 40 mm, of which 30 are 3 deep already.
const removed_cm3 = (60 * 30 * 3 + 6 * 40 * 8 - 6 * 30 * 3) / 1000;

test('the part that a program leaves is shown before it runs; the list says when it was checked', async () => {
  await show('programs/plate.nc');
  const files = page.getByRole('region', { name: 'Files' });
  assert.equal(await files.getByText(/checked|ran/).count(), 0);
  await page.getByRole('button', { name: 'Check', exact: true }).click();
  await files.getByText(/checked \d\d:\d\d/).waitFor();
  await page.getByRole('button', { name: 'Show the part' }).click();
  const text = await page.getByText(/cm³ removed/).innerText({ timeout: 90_000 });
  const [removed, blank] = (/: ([\d.]+) cm³ of ([\d.]+)/.exec(text) ?? []).slice(1).map(Number);
  assert.equal(blank, (60 * 40 * 12) / 1000);
  assert.ok(Math.abs(removed / removed_cm3 - 1) < 0.005, text);
  const part = page.getByLabel('The part that plate.nc makes');
  await until('the picture', async () => (await part.getAttribute('data-drawn')) === '640');
  // In its middle there is the part, in its corner there is none.
  const alpha = await part.evaluate((canvas) => {
    const at = (x, y) => canvas.getContext('2d').getImageData(x, y, 1, 1).data[3];
    return [at(320, 240), at(2, 2)];
  });
  assert.deepEqual(alpha, [255, 0]);
  assert.deepEqual(await findings(), []);
  await part.scrollIntoViewIfNeeded();
  await picture('result');
  writeFileSync(join(stage.programs, 'plate.nc'), `${plate}\n`);
  await show('machine');
  await show('programs');
  await files.getByText(/changed since the check/).waitFor();
});

test('the part is seen while it is cut, in the colours of its tools', async () => {
  await show('path');
  await run();
  const canvas = page.locator('canvas');
  await until('the blank', async () => Number(await canvas.getAttribute('data-triangles')) > 0);
  const tools = page.getByRole('list', { name: 'Surfaces by tool' });
  await tools.getByText('T1').waitFor({ timeout: 60_000 });
  await tools.getByText('T2').waitFor({ timeout: 60_000 });
  await tools.getByText('blank').waitFor();
  await until('the program is over', isOver);
  await show('programs');
  await page.getByText(/ran \d\d:\d\d$/).waitFor();
  await show('path');
});

test('it can be cut open and put away', async () => {
  const canvas = page.locator('canvas');
  await page.getByLabel('Section').selectOption('X');
  await page.getByLabel('Position of the section').fill('0.4');
  assert.deepEqual(await findings(), []);
  await picture('part');
  await page.getByRole('button', { name: 'Part' }).click();
  await until('nothing', async () => (await canvas.getAttribute('data-triangles')) === '0');
  await page.getByRole('button', { name: 'Part' }).click();
  await until('the part', async () => Number(await canvas.getAttribute('data-triangles')) > 0);
});

test('the part of another program does not stand under the path of this one', async () => {
  const canvas = page.locator('canvas');
  await page.getByText('The part that plate.nc left in its last run').waitFor();
  writeFileSync(join(stage.programs, 'other.nc'), 'G21 G90\nG1 X5 F600\nM30\n');
  await stage.client.call('program.load', { program: 'other.nc', channel: 1 });
  await page.getByText('Hidden: the part of plate.nc; another program is loaded.').waitFor();
  const button = page.getByRole('button', { name: 'Part' });
  assert.equal(await button.getAttribute('aria-pressed'), 'false');
  assert.deepEqual(await findings(), []);
  await button.click();
  await page.getByText('The part that plate.nc left in its last run').waitFor();
  await stage.client.call('program.load', { program: 'plate.nc', channel: 1 });
  await page.getByRole('button', { name: 'Part', pressed: true }).waitFor();
  await until('the part', async () => Number(await canvas.getAttribute('data-triangles')) > 0);
});

/** A box as a text STL file. */
function stlOf([x0, y0, z0], [x1, y1, z1]) {
  const at = (k) => [k & 1 ? x1 : x0, k & 2 ? y1 : y0, k & 4 ? z1 : z0];
  // Counter-clockwise from outside.
  const faces = ['0231', '4576', '0154', '2673', '0462', '1375'];
  const triangles = faces.flatMap(([a, b, c, d]) => [
    [a, b, c],
    [a, c, d],
  ]);
  const facet = (corners) => corners.map((k) => `vertex ${at(Number(k)).join(' ')}`).join('\n');
  const all = triangles.map(
    (one) => `facet normal 0 0 0\nouter loop\n${facet(one)}\nendloop\nendfacet`,
  );
  return `solid box\n${all.join('\n')}\nendsolid\n`;
}
const blank = { low: [0, 0, -12], high: [60, 40, 0] };

let trianglesOfPart = 0;
test('every corner of the part knows how far it is off the reference', async () => {
  writeFileSync(join(stage.programs, 'blank.stl'), stlOf(blank.low, blank.high));
  let [from, workpiece, corners, farthest, deepest] = [0, 0, 0, 0, 0];
  while (from !== null) {
    const asked = { from, workpiece, reference: 'blank.stl' };
    const page = await stage.client.call('workpiece.surface', asked);
    workpiece = page.workpiece;
    const bytes = Buffer.from(page.geometry.base64, 'base64');
    const { count } = page.geometry;
    for (let i = 0; i < count; ++i) {
      const place = [0, 4, 8].map((at) => bytes.readFloatLE(12 * i + at));
      const deviation = bytes.readInt32LE(12 * count + 4 * i) / 1e4;
      // All of it lies in the blank: the nearest face of it.
      const inside = place.map((x, k) => Math.max(blank.low[k] - x, x - blank.high[k]));
      const expected = Math.max(...inside);
      farthest = Math.max(farthest, Math.abs(deviation - expected));
      deepest = Math.min(deepest, deviation);
    }
    corners += count;
    from = page.next;
  }
  assert.ok(corners > 10_000, corners);
  trianglesOfPart = corners / 3;
  assert.ok(farthest < 2e-3, `${farthest} mm`);
  // The walls of the slot pass the middle of the blank, 6 mm from its top and from its bottom.
  assert.ok(deepest > -6 && deepest < -5.5, String(deepest));
});

test('its colours say so, with a scale in mm', async () => {
  await show('machine');
  await show('path');
  const canvas = page.locator('canvas');
  const triangles = async () => Number(await canvas.getAttribute('data-triangles'));
  await until('the part', async () => (await triangles()) === trianglesOfPart);
  await page.getByLabel('Colors of the part').selectOption('Deviation from blank.stl');
  await page.getByLabel('Scale of deviations').selectOption('± 2 mm');
  const scale = page.getByRole('list', { name: 'Deviation, mm' });
  await scale.getByText('below −1.429 mm: overcut').waitFor();
  await scale.getByText('−0.286 to 0.286').waitFor();
  await until('the whole part', async () => (await triangles()) === trianglesOfPart);
  assert.deepEqual(await findings(), []);
  await picture('deviation');
  writeFileSync(join(stage.programs, 'blank.stl'), 'M30\n');
  await page.getByLabel('Colors of the part').selectOption('By tool');
  await page.getByLabel('Colors of the part').selectOption('Deviation from blank.stl');
  await page.getByText(/blank.stl: .*no STL file/).waitFor();
  await page.getByLabel('Colors of the part').selectOption('By tool');
  await until('the part', async () => (await triangles()) > 0);
});

test('a log is verified and played, forward and backward', async () => {
  await stage.client.call('log.stop');
  await show('history');
  await page
    .getByRole('region', { name: 'Logs' })
    .getByRole('button', { name: 'Verify' })
    .first()
    .click();
  await page.getByText(/repeats bit for bit/).waitFor({ timeout: 90_000 });
  assert.deepEqual(await findings(), []);
  await picture('history');
  await page
    .getByRole('region', { name: 'Logs' })
    .getByRole('button', { name: 'Play' })
    .first()
    .click();
  const time = page.getByLabel('Time in the log');
  await time.waitFor();
  await until(
    'points',
    async () => Number(await page.locator('canvas').getAttribute('data-points')) > 100,
  );
  const at = async () => Number(await time.inputValue());
  await time.fill('8');
  await page.getByRole('button', { name: 'Forward' }).click();
  await until('it goes on', async () => (await at()) > 8.3);
  await page.getByRole('button', { name: 'Backward' }).click();
  const from = await at();
  await until('it goes back', async () => (await at()) < from - 0.2);
  await page.getByRole('button', { name: 'Pause' }).click();
  assert.deepEqual(await findings(), []);
  await picture('playback');
  await page.getByRole('button', { name: 'Back to live' }).click();
  await time.waitFor({ state: 'detached' });
});

test('the scope records every cycle from its start', async () => {
  await show('scope');
  await page.getByText('No recording', { exact: true }).waitFor();
  assert.deepEqual(await findings(), []);
  await page.getByLabel('Length').selectOption('0.5 s');
  await page.getByRole('button', { name: 'Record' }).click();
  await page.getByText('complete').waitFor();
  const samples = () => page.locator('canvas').getAttribute('data-samples');
  await until('500 cycles', async () => (await samples()) === '500');
});

test('a block is a trigger; what was before it is there, too', async () => {
  await page.getByLabel(/^Trigger/).selectOption('at a block');
  await page.getByLabel('Line, channel 1').fill('7');
  await page.getByLabel('Length').selectOption('2 s');
  await page.getByRole('button', { name: 'Record' }).click();
  await page.getByText('waiting for the trigger').waitFor();
  await run();
  await page.getByText('complete').waitFor({ timeout: 60_000 });
  const reading = await stage.client.call('scope.read', { from: 1_000_000 });
  assert.equal(reading.cycles, 2000);
  assert.equal(reading.trigger, 500);
});

test('cursors tell values and differences; the recording is a table', async () => {
  await page.getByLabel('Cursor A').fill('500');
  await page.getByLabel('Cursor B').fill('1500');
  await page.getByText(/B − A: 1\.0000 s/).waitFor();
  assert.deepEqual(await findings(), []);
  await picture('scope');
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'CSV' }).click(),
  ]);
  const [head, ...rows] = readFileSync(await download.path(), 'utf8')
    .trim()
    .split('\n');
  assert.equal(head, 'time (s),X.position (mm),X.velocity (mm/s),X.acceleration (mm/s2)');
  assert.equal(rows.length, 2000);
  assert.equal(rows[0].split(',')[0], '-0.500000');
  const row = page.getByRole('row', { name: /X.position/ });
  const shown = Number((await row.locator('td').first().innerText()).replace('\u2212', '-'));
  assert.ok(Math.abs(shown - Number(rows[500].split(',')[1])) < 1e-4);
  const [image] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'PNG' }).click(),
  ]);
  assert.equal(
    readFileSync(await image.path())
      .subarray(1, 4)
      .toString(),
    'PNG',
  );
  await until('the program is over', isOver);
});

test('programs of the queue begin one after the other, and none behind a reset', async () => {
  const move = 'G21 G90\nG53 G1 X-5 F6000\nG53 X0\n';
  writeFileSync(join(stage.programs, 'short.nc'), `${move}M30\n`);
  const endless = `for (num turn = 0; turn < 100000; turn++) {\n${move}}\nM30\n`;
  writeFileSync(join(stage.programs, 'long.nc'), endless);
  const queue = page.getByRole('region', { name: 'Queue of channel 1' });
  const waiting = async () => (await stage.status()).queue.programs;
  await stage.switchOn();
  for (const [k, name] of ['short.nc', 'short.nc', 'long.nc', 'short.nc'].entries()) {
    await page.evaluate((of) => (location.hash = `#/programs/${of}`), name);
    await page.getByRole('heading', { name }).waitFor();
    await page.getByRole('button', { name: 'Add to queue' }).click();
    await until('it is in the queue', async () => (await waiting()) === k + 1);
    // A button that waits for its answer does not hear.
    await page.locator('[aria-busy=true]').waitFor({ state: 'detached' });
  }
  assert.ok(!(await stage.status()).queue.started);
  await queue.getByRole('button', { name: 'Start the queue' }).click();
  await queue.getByRole('button', { name: 'Yes' }).click();
  await queue.getByText('running').waitFor();
  const status = () => stage.status();
  await until('the third one', async () => (await status()).program === 'long.nc');
  await until('two that wait', async () => (await waiting()) === 2);
  await queue.getByText('long.nc').waitFor();
  assert.deepEqual(await findings(), []);
  await picture('queue');
  await stage.client.call('program.reset', { channel: 1 });
  await queue.getByText('Stopped:').waitFor();
  await until('it is over', isOver);
  assert.equal(await waiting(), 2);
  await queue.getByRole('button', { name: 'long.nc: remove from the queue' }).click();
  await until('one that waits', async () => (await waiting()) === 1);
  assert.ok(!(await status()).queue.started);
});
