// A job as an operator sees it: the seed's master program is run, held, resumed, overridden; the page
// is loaded again in the middle, a second page looks on; a drive fails and the machine recovers.
import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { root, seedPrograms, setStage, storyOf, until } from './stage.mjs';

const test = storyOf();
let stage;
let page;
let seed;
before(async () => {
  seed = seedPrograms();
  const master = join(root, 'programs/examples/master.nc');
  stage = await setStage({ programs: [master, ...seed.files] });
  page = await stage.openMachine();
});
after(async () => {
  await stage?.close();
  rmSync(seed.folder, { recursive: true });
  assert.deepEqual(stage.faults, []);
});

const card = (of, name) => of.getByRole('article', { name });
const mark = (of, name, state) => card(of, name).locator(`[data-state=${state}]`);

/** Both programs are held, and go on: each is held by a request of its own, so that one may be held before the other. */
async function resumeBoth() {
  for (const name of ['2 master', '1 work']) {
    await mark(page, name, 'held').waitFor();
    await card(page, name).getByRole('button', { name: 'Resume' }).click();
    await mark(page, name, 'held').waitFor({ state: 'detached' });
  }
}

test('the token of the link is taken out of the address', async () => {
  assert.ok(!page.url().includes('#') || page.url().endsWith('#/machine'), page.url());
});

test('the machine is switched on', async () => {
  await page.getByRole('button', { name: 'On', exact: true }).click();
  await until('it is on', async () => (await stage.client.call('machine.status')).on);
  await stage.switchOn();
  await page.locator('header').getByText('on', { exact: true }).waitFor();
});

test('the master program is run from the page, after a question', async () => {
  await page.getByRole('button', { name: '2 master' }).click();
  await page.getByRole('combobox', { name: 'Program' }).selectOption('master.nc');
  await page.getByRole('region', { name: 'Program' }).getByRole('button', { name: 'Run' }).click();
  assert.equal((await stage.status(2)).state, 'Reset');
  await page.getByRole('button', { name: 'Yes' }).click();
  await mark(page, '2 master', 'waiting').waitFor();
  await mark(page, '1 work', 'running').waitFor();
  await card(page, '2 master').getByText('waits for the end of the program on').waitFor();
  await card(page, '2 master').getByText('→ 1 work').waitFor();
});

test('single block, optional stop and block skip show what the daemon has', async () => {
  await page.getByText('Start from line, single block').click();
  for (const [name, member] of [
    ['Single block', 'single_block'],
    ['Optional stop (M1)', 'optional_stop'],
  ]) {
    const button = page.getByRole('button', { name });
    await button.click();
    await page.getByRole('button', { name, pressed: true }).waitFor();
    assert.equal((await stage.status(2))[member], true);
    await button.click();
    await page.getByRole('button', { name, pressed: false }).waitFor();
  }
});

test('HOLD ALL holds, Resume goes on', async () => {
  await page.getByRole('button', { name: 'HOLD ALL' }).click();
  await mark(page, '1 work', 'held').waitFor();
  await until('the axes stand', async () => (await stage.status(1)).speed_mm_s === 0);
  await resumeBoth();
  await mark(page, '1 work', 'running').waitFor();
});

test('Space holds, and Enter presses the button that has the focus', async () => {
  await page.locator('body').press('Space');
  await mark(page, '1 work', 'held').waitFor();
  await mark(page, '2 master', 'held').waitFor();
  for (const name of ['1 work', '2 master']) {
    const resume = card(page, name).getByRole('button', { name: 'Resume' });
    await resume.focus();
    await page.keyboard.press('Enter');
    await mark(page, name, 'held').waitFor({ state: 'detached' });
  }
});

test('the feed override is the daemon\u2019s', async () => {
  await page.getByRole('button', { name: '1 work' }).click();
  const slider = page.getByRole('slider', { name: 'Feed' });
  await slider.fill('150');
  await until('150 %', async () => (await stage.status(1)).override.feed === 150);
  await page.getByRole('button', { name: 'Feed: more' }).click();
  await until('160 %', async () => (await stage.status(1)).override.feed === 160);
  await slider.fill('0');
  await mark(page, '1 work', 'standing').waitFor();
  const work = card(page, '1 work');
  await work.getByText('nothing moves: feed override 0 %').waitFor();
  assert.equal(await work.getByText(/\d left/).count(), 0);
  assert.ok(await work.getByRole('button', { name: 'Start', exact: true }).isDisabled());
  await slider.fill('160');
  await mark(page, '1 work', 'running').waitFor();
});

test('loading the page again changes nothing of the job', async () => {
  const before = await stage.status(1);
  await page.reload();
  await page.locator('[data-state]').first().waitFor();
  const after = await stage.status(1);
  assert.equal(after.run, before.run);
  assert.equal(after.override.feed, 160);
  assert.ok(['Active', 'Reset'].includes(after.state), after.state);
});

test('a second page sees the same and may hold', async () => {
  // Slow enough to be still there when a loaded computer has opened the page.
  await stage.client.call('override.feed', { channel: 1, percent: 5 });
  const other = await stage.openMachine({ width: 360, height: 640 });
  await mark(other, '2 master', 'waiting').waitFor();
  await other.getByRole('button', { name: 'HOLD ALL' }).click();
  await mark(page, '1 work', 'held').waitFor();
  await mark(page, '2 master', 'held').waitFor();
  await other.context().close();
  await resumeBoth();
});

test('the master runs to its end, and its worker programs with it', async () => {
  await page.getByRole('slider', { name: 'Feed' }).fill('200');
  await until('200 %', async () => (await stage.status(1)).override.feed === 200);
  await until('the master has ended', async () => (await stage.status(2)).state === 'Reset', {
    shown: async () => [await stage.status(1), await stage.status(2)],
  });
  await mark(page, '2 master', 'ready').waitFor();
  const { runs } = await stage.client.call('program.history');
  const names = runs.map((run) => `${run.program} ${run.ok}`);
  for (const name of ['0003_MB_3D.nc', 'Impeller_surface.nc', 'master.nc']) {
    assert.ok(names.includes(`${name} true`), names.join());
  }
  await stage.client.call('program.run', { program: 'master.nc', channel: 2 });
  await mark(page, '1 work', 'running').waitFor();
});

test('a drive fails: the alarm tells code, text and remedy; reset and on recover', async () => {
  await stage.client.call('drive.fault', { drive: 'X', fault: 'trip' });
  await mark(page, '1 work', 'alarm').waitFor();
  const alarm = card(page, '1 work').getByText('What to do');
  await alarm.waitFor();
  const code = (await stage.status(1)).alarm.code;
  assert.match(code, /^A3/);
  await card(page, '1 work').getByRole('link', { name: code }).click();
  await page.getByRole('heading', { name: code }).waitFor();
  await page.getByRole('link', { name: 'Machine', exact: true }).click();
  await stage.client.call('drive.fault', { drive: 'X', fault: 'none' });
  await stage.client.call('drive.reset', { drive: 'X' });
  await card(page, '1 work').getByRole('button', { name: 'Reset' }).click();
  await card(page, '2 master').getByRole('button', { name: 'Reset' }).click();
  await until(
    'no alarm stands',
    async () => (await stage.client.call('alarm.list')).alarms.length === 0,
  );
  await stage.switchOn();
  await mark(page, '1 work', 'alarm').waitFor({ state: 'detached' });
});

test('the runs are in the history', async () => {
  await page.getByRole('link', { name: 'Alarms and runs' }).click();
  await page.getByRole('cell', { name: 'master.nc' }).first().waitFor();
});

test('STOP ALL takes the power, and says in words what it is not', async () => {
  const stop = page.getByRole('button', { name: 'STOP ALL' });
  assert.match(await stop.innerText(), /not the E-stop/);
  await stop.click();
  await until('it is off', async () => !(await stage.client.call('machine.status')).on);
});

test('its alarm has the words of the button, and one press resets all channels', async () => {
  await page
    .getByText('stopped by an operator (STOP ALL): a software stop, not the E-stop')
    .first()
    .waitFor();
  await page.getByRole('link', { name: 'Machine', exact: true }).click();
  for (const name of ['1 work', '2 master']) {
    await mark(page, name, 'alarm').waitFor();
    await card(page, name).getByText('stopped by an operator (STOP ALL)').waitFor();
  }
  await page.getByRole('button', { name: 'Reset all' }).click();
  await until(
    'no alarm stands',
    async () => (await stage.client.call('alarm.list')).alarms.length === 0,
  );
  await page.getByRole('button', { name: 'Reset all' }).waitFor({ state: 'detached' });
});
