// The cutting process as the page shows it: a lathe controls the force of a cut whose depth and hardness
// change, the feed is interrupted, a grinding cycle is designed; lobes, figures from a log and planned feeds.
//
// With STANOK_WRITE_DOCS=1 it takes the pictures of docs/operator/panel-views.md, too.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { bin, root, setStage, storyOf, until } from './stage.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const test = storyOf();
let stage;
let page;
before(async () => {
  const examples = ['adaptive_steps.nc', 'plunge_grinding.toml', 'plunge_grinding.txt'];
  const programs = examples.map((name) => join(root, 'programs/examples', name));
  stage = await setStage({ machine: 'lathe.toml', programs });
  await stage.switchOn();
  page = await stage.openMachine({ width: 1120, height: 900 });
});
after(async () => {
  await stage?.close();
  assert.deepEqual(stage.faults, []);
});

const show = (view) => page.evaluate((name) => (location.hash = `#/${name}`), view);
const process = () => stage.client.call('process.status');

async function findings() {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run(document));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' | ')}`);
}

async function picture(name) {
  if (globalThis.process.env.STANOK_WRITE_DOCS) {
    await page.screenshot({ path: join(root, `docs/operator/pictures/panel-${name}.png`) });
  }
}

test('a turned part lies as turners expect, and its path is drawn', async () => {
  await stage.client.call('program.load', { program: 'adaptive_steps.nc' });
  await show('path');
  await page.locator('canvas[data-lie=turned]').waitFor();
  const points = () => page.locator('canvas').getAttribute('data-points').then(Number);
  await until('points', async () => (await points()) > 0);
  await picture('turned');
});

test('the force is controlled, and seen', async () => {
  await show('process');
  const force = page.getByRole('region', { name: 'Cutting force control' });
  await force.getByText('off', { exact: true }).waitFor();
  await stage.client.call('program.run', { program: 'adaptive_steps.nc' });
  await force.getByText('controlling').waitFor({ timeout: 120_000 });
  const samples = () =>
    page.locator('[aria-label="Last minute"] canvas').getAttribute('data-samples');
  await until('readings', async () => Number(await samples()) > 20);
  assert.deepEqual(await findings(), []);
  await picture('process');
});

test('its force is set from the page', async () => {
  const force = page.getByRole('region', { name: 'Cutting force control' });
  const now = (await process()).adaptive.force_set_n;
  await force.getByLabel('Value').fill(String(Math.round(now * 0.8)));
  await force.getByRole('button', { name: 'Set' }).click();
  const set = async () => (await process()).adaptive.force_set_n;
  await until('the new force', async () => Math.abs((await set()) - Math.round(now * 0.8)) < 1);
});

test('the feed is interrupted, and no more', async () => {
  const feed = page.getByRole('region', { name: 'Feed' });
  await feed.getByLabel('cut L_B, mm').fill('5');
  await feed.getByRole('button', { name: 'Interrupt', exact: true }).click();
  await feed.getByText(/pauses for 2.00 mm after each 5.00 mm/).waitFor();
  assert.deepEqual(await findings(), []);
  await feed.getByRole('button', { name: 'Stop interrupting' }).click();
  await until('the end of it', async () => (await process()).interruption === null);
});

test('a feed law from a sensor says what it does', async () => {
  const feed = page.getByRole('region', { name: 'Feed' });
  const law = feed.getByRole('button', { name: 'Linear, by power' });
  await feed.getByText(/law: /).waitFor({ state: 'detached' });
  await law.click();
  await feed.getByText(/^linear law: (on, F as programmed|\d+ % of F)/).waitFor();
  await law.click();
  await feed.getByText(/law: /).waitFor({ state: 'detached' });
});

// Times are those of docs/programmer/grinding.md.
test('a grinding cycle is designed, another one verified, with their plots', async () => {
  const grinding = page.getByRole('region', { name: 'Plunge grinding cycle' });
  await grinding.getByLabel('Process file').selectOption('plunge_grinding.toml');
  await grinding.getByRole('button', { name: 'Calculate' }).click();
  await grinding.getByText('within its limits').waitFor();
  await grinding.getByRole('row', { name: /this cycle 15\.44/ }).waitFor();
  await grinding.getByRole('row', { name: /lower bound 13\.59/ }).waitFor();
  const samples = await grinding.locator('canvas').first().getAttribute('data-samples');
  assert.ok(Number(samples) > 300, samples);
  assert.deepEqual(await findings(), []);
  await grinding.scrollIntoViewIfNeeded();
  await picture('grinding');
  await grinding.getByLabel('Process file').selectOption('plunge_grinding.txt');
  await grinding.getByRole('button', { name: 'Calculate' }).click();
  await grinding.getByRole('row', { name: /this cycle 18\.06/ }).waitFor();
  await grinding.getByRole('link', { name: 'W910' }).first().waitFor();
});

const calculations = () => page.getByRole('group', { name: 'Calculations' });

// 2 k zeta (1 + zeta) / K (docs/programmer/chatter.md).
const always_mm = (2 * 12_000 * 0.035 * 1.035) / 2000;

test('stability lobes are drawn, and a planned cut is judged', async () => {
  const file = join(stage.programs, 'bar.toml');
  const mode = '[[mode_x]]\nfrequency = 150.0\ndamping = 0.035\nstiffness = 12.0\n';
  writeFileSync(file, `kind = "turning"\nforce = 2000.0\n${mode}`);
  await show('machine');
  await show('process');
  await calculations().getByRole('button', { name: 'Stability of a cut' }).click();
  const lobes = page.getByRole('region', { name: 'Stability of a cut' });
  await lobes.getByLabel('Cut and vibration data').selectOption('bar.toml');
  await lobes.getByLabel('from, rev/min').fill('2000');
  await lobes.getByLabel('to, rev/min', { exact: true }).fill('12000');
  await lobes.getByLabel('planned, rev/min').fill('5300');
  await lobes.getByLabel('planned, mm').fill(String(2 * always_mm));
  await lobes.getByRole('button', { name: 'Calculate' }).click();
  const text = await lobes.getByText(/Stable up to .* at every speed/).innerText();
  const told = Number(/up to ([\d.]+) mm/.exec(text)?.[1]);
  assert.ok(Math.abs(told / always_mm - 1) < 1e-3, text);
  await lobes.getByText(/5300 rev\/min, .* chatters/).waitFor();
  await lobes.getByText(/Stable at \d+ rev\/min\./).waitFor();
  assert.equal(await lobes.locator('canvas').getAttribute('data-samples'), '400');
  assert.deepEqual(await findings(), []);
  await lobes.scrollIntoViewIfNeeded();
  await picture('stability');
});

test('what is wrong with its file is told beside the button', async () => {
  const lobes = page.getByRole('region', { name: 'Stability of a cut' });
  writeFileSync(join(stage.programs, 'bar.toml'), 'kind = "turning"\nforce = -2.0\n');
  await lobes.getByRole('button', { name: 'Calculate' }).click();
  await page.getByText('E9102').waitFor();
  await page.getByText('bar.toml:2').waitFor();
  await page.keyboard.press('Escape');
});

test('a calculation that takes long is ended', async () => {
  const lobes = page.getByRole('region', { name: 'Stability of a cut' });
  const modes = ['x', 'y'].map(
    (axis) => `[[mode_${axis}]]\nfrequency = 600.0\ndamping = 0.04\nstiffness = 5.6\n`,
  );
  const head = 'kind = "milling"\nforce = 800.0\nradial_ratio = 0.2\nteeth = 3\n';
  writeFileSync(join(stage.programs, 'bar.toml'), head + modes.join(''));
  await lobes.getByLabel('Method').selectOption('each tooth, for small widths of cut');
  await lobes.getByLabel('from, rev/min').fill('50');
  await lobes.getByRole('button', { name: 'Calculate' }).click();
  await lobes.getByRole('button', { name: 'Cancel' }).click();
  await lobes.getByText('calculating').waitFor({ state: 'detached' });
  assert.equal(await lobes.locator('canvas').count(), 0);
});

// Of [simulation.cutting] of lathe.toml: C = 1600 N, efficiency 0.85, y = 0.75.
test('figures of a cut are found in its log', async () => {
  const cut = join(stage.programs, 'cut.nc');
  writeFileSync(
    cut,
    'G21 G90 G18 G7 G40 G54\nT0101\nG97 S300 M3\nG4 F1.5\nS600\nG4 F1.5\nG95\nG0 X60 Z2\n' +
      'G1 Z-10 F0.1\nZ-20 F0.3\nZ-30 F0.15\nZ-40 F0.4\nG0 X72\nZ5 M5\nM30\n',
  );
  const machine = join(root, 'config/machines/lathe.toml');
  const log = join(stage.programs, '../log/cut.lcm');
  const words = ['simulate', cut, '--machine', machine, '--drives', '--log', log];
  execFileSync(join(bin, 'stanok'), words, { stdio: ['ignore', 'ignore', 'inherit'] });
  await show('machine');
  await show('process');
  await calculations().getByRole('button', { name: 'Identify from a log' }).click();
  const figures = page.getByRole('region', { name: 'Identify from a log' });
  await figures.getByLabel('Log', { exact: true }).selectOption('cut.lcm');
  await figures.getByLabel('Bar before the cut').fill('0:32,-20:33,-40:32');
  await figures.getByLabel('C of the material').fill('1600');
  await figures.getByRole('button', { name: 'Calculate' }).click();
  await figures.getByText(/readings; noise/).waitFor({ timeout: 120_000 });
  const value = async (name) => {
    const row = figures.getByRole('row', { name });
    return Number(await row.getByRole('cell').first().innerText());
  };
  assert.ok(Math.abs((await value(/^exponent y/)) - 0.75) < 0.01);
  assert.ok(Math.abs((await value(/^efficiency/)) - 0.85) < 0.01);
  assert.ok(Math.abs((await value(/^C \/ efficiency/)) / (1600 / 0.85) - 1) < 0.01);
  assert.deepEqual(await findings(), []);
  await figures.scrollIntoViewIfNeeded();
  await picture('figures');
});

// On the bar of lathe.toml the greatest depth is 3 mm: C t h^y = 1600 * 3 * 0.25^0.75 N.
test('feeds are planned that keep a force, and put among the programs', async () => {
  await calculations().getByRole('button', { name: 'Forces along a program' }).click();
  const forces = page.getByRole('region', { name: 'Forces along a program' });
  await forces.getByLabel('Program', { exact: true }).selectOption('adaptive_steps.nc');
  await forces.getByLabel('set force, N').fill('1200');
  await forces.getByLabel('minimum feed').fill('0.05');
  await forces.getByLabel('maximum feed').fill('0.6');
  await forces.getByRole('button', { name: 'Calculate' }).click();
  const row = forces.getByRole('row', { name: /maximum force, N/ });
  await row.waitFor({ timeout: 120_000 });
  const [before, after] = (await row.getByRole('cell').allInnerTexts()).map(Number);
  assert.ok(Math.abs(before - 1600 * 3 * 0.25 ** 0.75) < 0.1, before);
  assert.ok(after <= 1200 && after > 0.98 * 1200, after);
  assert.deepEqual(await findings(), []);
  await forces.scrollIntoViewIfNeeded();
  await picture('forces');
  await forces.getByRole('button', { name: 'Save to programs' }).click();
  await forces.getByRole('link', { name: 'adaptive_steps_planned.nc' }).waitFor();
  const text = readFileSync(join(stage.programs, 'adaptive_steps_planned.nc'), 'utf8');
  assert.match(text, /^\/\/ #adaptive/m);
  assert.match(text, /F0\.157/);
  assert.ok(existsSync(join(stage.programs, 'adaptive_steps.nc')));
});
