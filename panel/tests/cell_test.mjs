// Two machines and their history behind one page: their tiles, the page of the other one, what was kept.
//
// With STANOK_WRITE_DOCS=1 it takes the picture of docs/operator/panel-views.md, too.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { findings, measure } from './looks.mjs';
import { root, setStage, storyOf, until } from './stage.mjs';

const test = storyOf();
let stage;
let page;
before(async () => {
  stage = await setStage({ neighbour: 'lathe.toml' });
  writeFileSync(join(stage.programs, 'part.nc'), 'G53 G1 X1 F6000\nG53 G1 X0\nM30\n');
  await stage.switchOn();
  page = await stage.openMachine();
});
after(async () => {
  await stage?.close();
  assert.deepEqual(stage.faults, []);
});

const tile = (name) => page.getByRole('article', { name, exact: true });

test('all machines have a tile', async () => {
  await page.getByRole('link', { name: 'Cell' }).click();
  for (const name of ['stanok', 'neighbour']) await tile(name).waitFor();
  await tile('stanok').getByText('on', { exact: true }).waitFor();
  await tile('neighbour').getByText('off', { exact: true }).first().waitFor();
});

test('what ran is in the history, of this machine and not of the other one', async () => {
  await stage.client.call('program.run', { program: 'part.nc', channel: 1, wait: 'done' });
  const history = page.getByRole('region', { name: 'History' });
  await until('the run is there', async () => {
    await history.getByRole('button', { name: 'Refresh' }).click();
    return (await history.getByRole('cell', { name: 'part.nc' }).count()) === 1;
  });
  await history.getByRole('button', { name: 'Utilization' }).click();
  await history.getByRole('columnheader', { name: 'OEE, %' }).waitFor();
  const cells = history.getByRole('row').nth(1).getByRole('cell');
  assert.deepEqual(
    [await cells.nth(0).innerText(), await cells.nth(5).innerText()],
    ['stanok', '100.0'],
  );
  if (process.env.STANOK_WRITE_DOCS === '1')
    await page.screenshot({ path: join(root, 'docs/operator/pictures/panel-cell.png') });
  await history.getByRole('button', { name: 'Alarms' }).click();
  await history.getByText('Nothing in this period').waitFor();
});

test('a run that an override of 0 % holds stands, and says why', async () => {
  writeFileSync(join(stage.programs, 'long.nc'), 'G53 G1 X20 F600\nG53 G1 X0\nM30\n');
  await stage.client.call('program.run', { program: 'long.nc', channel: 1 });
  await tile('stanok').locator('[data-state=running]').waitFor();
  await stage.client.call('override.feed', { channel: 1, percent: 0 });
  await tile('stanok').locator('[data-state=standing]').waitFor();
  await tile('stanok').getByText('nothing moves: feed override 0 %').waitFor();
  await stage.client.call('override.feed', { channel: 1, percent: 100 });
  await tile('stanok').locator('[data-state=running]').waitFor();
  await stage.client.call('program.reset', { channel: 1 });
});

test('it fits on small screens and large ones, in both languages, and axe-core finds nothing', async () => {
  for (const [width, height, locale] of [
    [360, 640, 'ru-RU'],
    [360, 640, 'en-US'],
    [3840, 2160, 'ru-RU'],
  ]) {
    const other = await stage.openMachine({ width, height, locale });
    await other.evaluate(() => (location.hash = '#/cell'));
    await other.locator('section table').first().waitFor();
    assert.deepEqual(await other.evaluate(measure), [], `${width} ${locale}`);
    assert.deepEqual(await findings(other), [], `${width} ${locale}`);
    await other.context().close();
  }
});

test('the name of a machine leads to its page, which works that machine alone', async () => {
  await tile('neighbour').getByRole('link').click();
  await page.locator('[data-state]').first().waitFor();
  const header = page.locator('header').first();
  const name = (await stage.neighbour.client.call('machine.status')).name;
  await header.getByText(name, { exact: true }).waitFor();
  await stage.neighbour.client.call('machine.on').catch(() => 0);
  await until('the neighbour is on', async () => {
    await stage.neighbour.client.call('machine.on').catch(() => 0);
    return (await stage.neighbour.client.call('machine.status')).on;
  });
  await page.getByRole('button', { name: /STOP ALL/ }).click();
  await until(
    'the neighbour is off',
    async () => !(await stage.neighbour.client.call('machine.status')).on,
  );
  assert.equal((await stage.client.call('machine.status')).on, true);
});

test('a machine that has gone is told, and the others are seen', async () => {
  await page.goto(`${stage.address()}#/cell`);
  await tile('neighbour').waitFor();
  stage.neighbour.daemon.kill('SIGKILL');
  await tile('neighbour').getByText('does not answer').waitFor();
  await tile('stanok').getByText('on', { exact: true }).waitFor();
});
