// Positions and touching off on a lathe: diameters, inches, what is asked about, what is taken back; the
// file of a line. What the page shows is compared with what the daemon says beside it.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { findings } from './looks.mjs';
import { setStage, storyOf, until } from './stage.mjs';

const test = storyOf();
let stage;
let page;
let form;
const mdi = (text) => stage.client.call('mdi', { text, channel: 1, wait: 'done' });
const show = (view) => page.evaluate((name) => (location.hash = `#/${name}`), view);
const button = (name) => form.getByRole('button', { name, exact: true });
const written = () => form.getByRole('textbox');
const shows = (what, text) =>
  until(what, async () => text.test(await form.locator('[data-stands]').innerText()));
const stands = (word, value) =>
  until(`${word} at ${value}`, async () => {
    const { position } = await stage.status();
    return Math.abs(position[word] - value) < 1e-9;
  });

before(async () => {
  stage = await setStage({ machine: 'lathe.toml' });
  await stage.switchOn();
  await mdi('G21 G90 G0 X60 Z120');
  page = await stage.openMachine();
});
after(async () => {
  await stage?.close();
  assert.deepEqual(stage.faults, []);
});

test('a diameter is marked as one beside its word', async () => {
  const row = (word) => page.locator(`[data-axis=${word}]`);
  await row('X').getByText('60.000', { exact: true }).waitFor();
  await row('X').getByText('30.000', { exact: true }).waitFor();
  assert.match(await row('X').innerText(), /Ø\s*diameter\s*mm/);
  assert.doesNotMatch(await row('Z').innerText(), /diameter/);
  assert.equal((await stage.status()).point_W.X, 30);
});

test('along X the value is a diameter; it is taken back', async () => {
  await show('tools');
  form = page.locator('fieldset', { hasText: 'Touch off' });
  await form.getByLabel('Axis').selectOption('X');
  await shows('the diameter', /X\s*Ø.*60\.000 mm/s);
  await written().fill('50');
  await button('Touch off').click();
  await stands('X', 50);
  await form.getByText('G54 X 0.000 → 5.000 mm').waitFor();
  assert.deepEqual(await findings(page), []);
  await button('Undo touch-off').click();
  await stands('X', 60);
  await button('Undo touch-off').waitFor({ state: 'detached' });
});

test('in inches; a large change is done when it is confirmed', async () => {
  await mdi('G20 G91');
  await form.getByLabel('Axis').selectOption('Z');
  await shows('inches', /Z\s*4\.7244 in/);
  await written().fill('10');
  await button('Touch off').click();
  const question = form.getByRole('alert');
  await question.getByText(/-134\.000.*100\.000/).waitFor();
  assert.deepEqual(await findings(page), []);
  await button('No').click();
  await question.waitFor({ state: 'detached' });
  assert.equal((await stage.client.call('offset.list')).offsets.G54.Z, 250);
  await button('Touch off').click();
  await button('Yes, touch off').click();
  await stands('Z', 254);
  await form.getByText(/G54 Z 250\.000 → 116\.000 mm/).waitFor();
});

test('a value that was written in another situation is not taken', async () => {
  await written().fill('9');
  await mdi('G21 G90');
  await shows('millimetres', /254\.000 mm/);
  await button('Touch off').click();
  await form.getByText(/Not touched off/).waitFor();
  await stands('Z', 254);
  await written().fill('250');
  await button('Touch off').click();
  await stands('Z', 250);
});

test('each number of the display tells where it comes from', async () => {
  await show('machine');
  await page.getByText('How are these numbers made up?').click();
  const origin = page.locator('[data-origin=X]');
  await origin.getByText('Machine position X', { exact: true }).waitFor();
  await origin.getByText('Diameter G7 *', { exact: true }).waitFor();
  const z = page.locator('[data-origin=Z]');
  await z.getByText('Work offset G54', { exact: true }).waitFor();
  const told = await stage.client.call('channel.position', { channel: 1, why: 1 });
  for (const { word, shown, terms } of told.axes.filter(({ word }) => word !== 'C')) {
    const sum = terms.reduce((all, { amount }) => all + amount, 0);
    assert.ok(Math.abs(sum - shown) < 1e-9, word);
    const rows = page.locator(`[data-origin=${word}] tbody tr`);
    assert.equal(await rows.count(), terms.length, word);
    assert.match(await rows.last().innerText(), new RegExp(`${shown.toFixed(3)}\\s*$`));
  }
  assert.deepEqual(await findings(page), []);
  await page.getByText('How are these numbers made up?').click();
});

test('a line that was written in another situation is not done', async () => {
  const line = page.getByPlaceholder('G0 Z50');
  const press = page
    .getByRole('region', { name: 'MDI', exact: true })
    .getByRole('button', { name: 'Run', exact: true });
  const { position } = await stage.status();
  await line.fill('G91 G0 Z1');
  await mdi('G18');
  const shown = (await stage.status()).situation;
  await page.getByText('G18', { exact: true }).first().waitFor();
  await press.click();
  await page
    .getByRole('alert')
    .getByText(/Not done: codes, tool or tables/)
    .waitFor();
  assert.deepEqual((await stage.status()).position, position);
  assert.equal((await stage.status()).situation, shown);
  await press.click();
  await stands('Z', position.Z + 1);
  await mdi('G90 G0 Z250');
});

test('a block search tells words, diameters with their mark', async () => {
  writeFileSync(join(stage.programs, 'words.nc'), 'G7 G0 X60 Z200\nN20 G0 X80\nN30 Z210\nM30\n');
  await stage.client.call('program.load', { program: 'words.nc', channel: 1 });
  await page.getByText('Start from line, single block, block skip').click();
  await page.getByLabel('Start from line, N number, or file:line').fill('N30');
  await page.getByRole('button', { name: 'Search', exact: true }).click();
  await page.getByText(/X Ø 80\.000 mm/).waitFor();
});

test('the line of another file has its name, and its text is shown', async () => {
  const main = '#include "called.nc"\nG0 Z200\nway();\nM30\n';
  writeFileSync(join(stage.programs, 'main.nc'), main);
  const called = 'void way()\n{\n  G94 G1 F300 Z150\n}\n';
  writeFileSync(join(stage.programs, 'called.nc'), called);
  await show('machine');
  await stage.client.call('program.run', { program: 'main.nc', channel: 1 });
  await page.getByText('called.nc:3', { exact: true }).waitFor();
  await page.getByText('G94 G1 F300 Z150').waitFor();
  await stage.client.call('program.stop', { channel: 1 });
});

// What the page must show of a status, and what it shows.
const wanted = (status) => ({
  place: `line ${status.line}`,
  codes: [...status.g_codes, ...status.m_codes],
  tool: status.tool.number,
  speed: Math.round(status.spindles[0].commanded_rev_min),
  X: status.position.X.toFixed(3),
  Z: status.position.Z.toFixed(3),
});
async function shown() {
  const card = page.locator('article').first();
  const value = async (name) =>
    parseInt(
      await card
        .locator('dl div', { hasText: new RegExp(`^${name}`) })
        .locator('dd')
        .innerText(),
    );
  const work = (word) => page.locator(`[data-axis=${word}] .work`).innerText();
  return {
    place: await card.locator('.line').innerText(),
    codes: await page.getByLabel('Active codes').locator('li').allInnerTexts(),
    tool: await value('T'),
    speed: await value('S'),
    X: await work('X'),
    Z: await work('Z'),
  };
}
async function sameAtStop(what, standing) {
  await until(`${what}: the channel stands`, async () => standing(await stage.status()));
  const status = await stage.status();
  let found;
  await until(`${what} on the page: ${JSON.stringify(wanted(status))}`, async () => {
    found = await shown();
    return JSON.stringify(found) === JSON.stringify(wanted(status));
  });
  return status;
}

test('at a stop of each kind the page shows what the status says', async () => {
  await mdi('G21 G90 G94');
  const lines = [
    'G21 G90 G18 G7 G54',
    'T0101',
    'G97 S400 M3',
    'M8',
    'G0 X60 Z200',
    'M0',
    'M9',
    'G55',
  ];
  lines.push('M1', 'G0 X70 M5', 'G91 G94 G1 Z-20 F600', 'M30');
  writeFileSync(join(stage.programs, 'stops.nc'), lines.join('\n') + '\n');
  const call = (method, parameters = {}) =>
    stage.client.call(method, { channel: 1, ...parameters });
  const held = (line, by) => (status) =>
    status.state === 'Interrupted' && status.line === line && status.held_by === by;
  await call('program.optional_stop', { on: 1 });
  await call('program.run', { program: 'stops.nc' });
  const stopped = await sameAtStop('M0', held(6, 'program stop'));
  assert.deepEqual(stopped.coolant, ['flood']);
  await call('program.start');
  await sameAtStop('M1', held(9, 'program stop'));
  await call('program.start');
  await until('the last way', async () => {
    const { line, to_go: toGo } = await stage.status();
    return line === 11 && toGo.Z > -18;
  });
  await call('program.hold');
  const by = 'feed hold by an operator';
  await sameAtStop('hold', (status) => held(11, by)(status) && status.speed_mm_s === 0);
  await call('program.step', { on: 1 });
  await call('program.resume');
  await sameAtStop('single block', held(11, 'single block'));
  await call('program.step', { on: 0 });
  await call('program.start');
  await sameAtStop('end', (status) => status.state === 'Reset');
});
