// The cutting process as the page shows it: a lathe controls the force of a cut whose depth and hardness
// change, the feed is interrupted, a grinding cycle is designed.
//
// With STANOK_WRITE_DOCS=1 it takes the pictures of docs/operator/panel-views.md, too.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { root, setStage, storyOf, until } from './stage.mjs';

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
  const force = page.getByRole('region', { name: 'Control of the cutting force' });
  await force.getByText('off', { exact: true }).waitFor();
  await stage.client.call('program.run', { program: 'adaptive_steps.nc' });
  await force.getByText('controls the force').waitFor({ timeout: 120_000 });
  const samples = () =>
    page.locator('[aria-label="The last minute"] canvas').getAttribute('data-samples');
  await until('readings', async () => Number(await samples()) > 20);
  assert.deepEqual(await findings(), []);
  await picture('process');
});

test('its force is set from the page', async () => {
  const force = page.getByRole('region', { name: 'Control of the cutting force' });
  const now = (await process()).adaptive.force_set_n;
  await force.getByLabel('Value').fill(String(Math.round(now * 0.8)));
  await force.getByRole('button', { name: 'Set' }).click();
  const set = async () => (await process()).adaptive.force_set_n;
  await until('the new force', async () => Math.abs((await set()) - Math.round(now * 0.8)) < 1);
});

test('the feed is interrupted, and no more', async () => {
  const feed = page.getByRole('region', { name: 'Feed' });
  await feed.getByLabel('cut L_B, mm').fill('5');
  await feed.getByRole('button', { name: 'Interrupt' }).click();
  await feed.getByText(/rests for 2.00 mm after each 5.00 mm/).waitFor();
  assert.deepEqual(await findings(), []);
  await feed.getByRole('button', { name: 'No more' }).click();
  await until('the end of it', async () => (await process()).interruption === null);
});

// Times are those of docs/programmer/grinding.md.
test('a grinding cycle is designed, another one verified, with their plots', async () => {
  const grinding = page.getByRole('region', { name: 'Plunge grinding cycle' });
  await grinding.getByLabel('Process file').selectOption('plunge_grinding.toml');
  await grinding.getByRole('button', { name: 'Calculate' }).click();
  await grinding.getByText('keeps its limits').waitFor();
  await grinding.getByRole('row', { name: /this one 15\.44/ }).waitFor();
  await grinding.getByRole('row', { name: /lower bound 13\.59/ }).waitFor();
  const samples = await grinding.locator('canvas').first().getAttribute('data-samples');
  assert.ok(Number(samples) > 300, samples);
  assert.deepEqual(await findings(), []);
  await grinding.scrollIntoViewIfNeeded();
  await picture('grinding');
  await grinding.getByLabel('Process file').selectOption('plunge_grinding.txt');
  await grinding.getByRole('button', { name: 'Calculate' }).click();
  await grinding.getByRole('row', { name: /this one 18\.06/ }).waitFor();
  await grinding.getByRole('link', { name: 'W910' }).first().waitFor();
});
