// Moving by hand: lines, jogging by button, key and step, and everything that must end a jog: letting
// go, Escape, lost focus, a killed tab, a server that hangs.
//
// With STANOK_WRITE_DOCS=1 it takes pictures of docs/operator/at-the-machine.md, too.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { root, setStage, storyOf, until } from './stage.mjs';

const test = storyOf();
let stage;
let page;
before(async () => {
  stage = await setStage();
  await stage.switchOn();
  page = await stage.openMachine();
});
after(async () => {
  await stage?.close();
  assert.deepEqual(stage.faults, []);
});

const at = async (axis = 'X') => (await stage.status()).axes[axis].position;
/** At rest: the machine says so, and the position stays what it is from one look to the next. */
async function rests() {
  let last = NaN;
  await until('the axis stands', async () => {
    const { idle } = await stage.client.call('machine.status');
    const now = await at();
    const stands = idle && now === last;
    last = now;
    return stands;
  });
  return last;
}

async function hold(of = page) {
  const button = of.getByRole('button', { name: 'move X +' });
  await button.scrollIntoViewIfNeeded();
  const box = await button.boundingBox();
  await of.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await of.mouse.down();
}

// Pressed until the axis moves, and farther on. A busy computer may bring a press or its renewals so late that they
// are refused, which the page reports: a person presses again.
async function pressUntilItMoves(down, up, axis = 'X') {
  for (let tries = 0; tries < 20; ++tries) {
    await rests();
    const from = await at(axis);
    await down();
    const end = Date.now() + 3000;
    while (Date.now() < end) if (Math.abs((await at(axis)) - from) > 0.5) return from;
    await up();
  }
  throw new Error('the axis does not move');
}

const holdUntilItMoves = (of = page) =>
  pressUntilItMoves(
    () => hold(of),
    () => of.mouse.up(),
  );

const keyUntilItMoves = (key, axis) =>
  pressUntilItMoves(
    () => page.keyboard.down(key),
    () => page.keyboard.up(key),
    axis,
  );

/** Clicked until it has had its effect; again only when the page says that it was refused. */
async function clickUntil(what, button, condition) {
  const refused = button.page().getByRole('alert').locator('.refusal');
  await button.click();
  await until(what, async () => {
    if (await condition()) return true;
    if (await refused.isVisible()) {
      await refused.getByRole('button', { name: 'Close' }).click();
      await button.click();
    }
    return false;
  });
}

test('a line by hand moves the axes; the one before comes back with arrow up', async () => {
  const line = page.getByLabel(/MDI \(/);
  await line.fill('G53 G0 X5');
  await line.press('Enter');
  await until('X is at 5', async () => (await at()) === 5);
  await rests();
  assert.equal(await line.inputValue(), '');
  await line.press('ArrowUp');
  assert.equal(await line.inputValue(), 'G53 G0 X5');
  await line.fill('');
});

test('a line runs once, however often Enter is pressed before its answer', async () => {
  const sent = [];
  const note = ({ payload }) => {
    if (String(payload).includes('"mdi"')) sent.push(payload);
  };
  const before = (other) => other.on('websocket', (socket) => socket.on('framesent', note));
  const other = await stage.openMachine({ before });
  const line = other.getByLabel(/MDI \(/);
  await line.fill('G53 G0 X6');
  await line.evaluate((field) => {
    const press = { key: 'Enter', code: 'Enter', bubbles: true };
    for (let i = 0; i < 3; ++i) field.dispatchEvent(new KeyboardEvent('keydown', press));
  });
  await until('it is answered', async () => (await line.inputValue()) === '');
  assert.equal(sent.length, 1);
  await other.context().close();
  await rests();
});

test('a line that is wrong is refused where it was entered, with code and remedy', async () => {
  const line = page.getByLabel(/MDI \(/);
  await line.fill('G1 X Q');
  await line.press('Enter');
  const refusal = page.getByRole('alert').locator('.refusal');
  await refusal.waitFor();
  assert.match(await refusal.innerText(), /E\d{4}[\s\S]*What to do/);
  const [card, field] = [await refusal.boundingBox(), await line.boundingBox()];
  assert.ok(Math.abs(card.y - field.y) < 200, 'it stands beside the field');
  await page.keyboard.press('Escape');
  await refusal.waitFor({ state: 'detached' });
  await line.fill('');
});

test('before it is armed nothing jogs', async () => {
  const from = await at();
  await page.locator('body').press('ArrowRight');
  assert.equal(await page.getByRole('button', { name: 'move X +' }).count(), 0);
  assert.equal(await rests(), from);
});

test('an axis moves while its button is down and stops when it is let go', async () => {
  await page.getByRole('button', { name: 'Arm' }).click();
  const from = await holdUntilItMoves();
  await page.mouse.up();
  const end = await rests();
  assert.ok(end > from);
});

test('an axis moves while its key is down, the other way, too', async () => {
  await page.locator('main').click({ position: { x: 3, y: 3 } });
  const from = await keyUntilItMoves('ArrowLeft');
  await page.keyboard.up('ArrowLeft');
  assert.ok((await rests()) < from);
});

test('a key stops when it is let go, also where it writes something else by then', async () => {
  await keyUntilItMoves('ArrowRight');
  // As Num Lock, switched on meanwhile, makes of an arrow of the number keys.
  await page.evaluate(() => {
    const keys = { key: '6', code: 'ArrowRight', bubbles: true };
    document.body.dispatchEvent(new KeyboardEvent('keyup', keys));
  });
  const end = await rests();
  assert.equal(await rests(), end);
  await page.keyboard.up('ArrowRight');
});

test('arrows on a slider move the slider, not an axis', async () => {
  const slider = page.getByRole('slider', { name: 'Rapid' });
  const from = await rests();
  await slider.focus();
  await page.keyboard.press('ArrowLeft');
  await until('95 %', async () => (await stage.status()).override.rapid === 95);
  assert.equal(await rests(), from);
  await slider.fill('100');
  await page.locator('main').click({ position: { x: 3, y: 3 } });
});

test('a button that vanishes under the finger stops when the finger goes', async () => {
  await holdUntilItMoves();
  await page.evaluate(() => {
    const button = document.querySelector('[data-jog="X1"]');
    button.parentElement.append(button.cloneNode(true));
    button.remove();
  });
  await page.mouse.up();
  const end = await rests();
  assert.equal(await rests(), end);
  await page.reload();
  await page.getByRole('button', { name: 'Arm' }).click();
  await page.locator('main').click({ position: { x: 3, y: 3 } });
});

test('with the keyboard alone every axis can be reached: Enter on its button', async () => {
  const button = page.getByRole('button', { name: 'move Y +' });
  await button.focus();
  const from = await keyUntilItMoves('Enter', 'Y');
  await page.keyboard.press('Tab');
  await rests();
  const end = await at('Y');
  await page.keyboard.up('Enter');
  assert.ok(end > from);
  await page.locator('main').click({ position: { x: 3, y: 3 } });
});

test('a pendant moves an axis while its two keys are down', async () => {
  const press = (...pressed) =>
    page.evaluate((keys) => {
      const buttons = Array.from({ length: 17 }, (_, i) => ({ pressed: keys.includes(i) }));
      navigator.getGamepads = () => [{ buttons }];
    }, pressed);
  const from = await pressUntilItMoves(
    () => press(0, 14),
    () => press(),
  );
  assert.ok((await at()) < from);
  await press(14);
  const end = await rests();
  assert.equal(await rests(), end);
  await press();
});

test('a step is a step', async () => {
  await page
    .getByRole('group', { name: 'Distance' })
    .getByRole('button', { name: '0.1', exact: true })
    .click();
  const from = await rests();
  const button = page.getByRole('button', { name: 'move X +' });
  await clickUntil('a tenth', button, async () => Math.abs((await at()) - from - 0.1) < 1e-6);
  await rests();
  await page.getByRole('button', { name: 'continuous' }).click();
});

test('the mouse wheel over the button of an axis is a handwheel', async () => {
  const distance = page.getByRole('group', { name: 'Distance' });
  await distance.getByRole('button', { name: '0.1', exact: true }).click();
  const from = await rests();
  await page.getByRole('button', { name: 'move X +' }).hover();
  for (let notch = 0; notch < 7; ++notch) await page.mouse.wheel(0, -100);
  for (let notch = 0; notch < 2; ++notch) await page.mouse.wheel(0, 100);
  await until('five tenths', async () => Math.abs((await at()) - from - 0.5) < 1e-6);
  assert.ok(Math.abs((await rests()) - from - 0.5) < 1e-6);
  await distance.getByRole('button', { name: 'continuous' }).click();
});

test('in the directions of the workpiece the axes go as its rotation has them', async () => {
  const choose = (group, name) =>
    page.getByRole('group', { name: group }).getByRole('button', { name, exact: true }).click();
  await stage.client.call('mdi', { text: 'G68 X0 Y0 R90', channel: 1, wait: 'done' });
  await choose('Distance', '1');
  await choose('Directions', 'workpiece');
  const [x, y] = [await rests(), await at('Y')];
  const button = page.getByRole('button', { name: 'move X +' });
  await clickUntil('1 mm of Y', button, async () => Math.abs((await at('Y')) - y - 1) < 1e-6);
  assert.ok(Math.abs((await rests()) - x) < 1e-6);
  await stage.client.call('mdi', { text: 'G69', channel: 1, wait: 'done' });
  await choose('Directions', 'machine axes');
  await choose('Distance', 'continuous');
});

test('Escape stops a long step, too', async () => {
  const choose = (group, name) =>
    page.getByRole('group', { name: group }).getByRole('button', { name, exact: true }).click();
  await choose('Distance', '10');
  await choose('Speed', '1');
  const from = await rests();
  const button = page.locator('[data-jog="X-1"]');
  await clickUntil('it moves', button, async () => Math.abs((await at()) - from) > 0.5);
  await page.keyboard.press('Escape');
  const end = await rests();
  assert.ok(Math.abs(end - from) < 9, `it went ${Math.abs(end - from)} mm of 10`);
  await page.getByRole('button', { name: 'Arm' }).click();
  await choose('Distance', 'continuous');
  await choose('Speed', '10');
});

test('Escape stops a jog and disarms', async () => {
  await keyUntilItMoves('ArrowRight');
  await page.keyboard.press('Escape');
  const end = await rests();
  await page.keyboard.up('ArrowRight');
  await page.locator('body').press('ArrowRight');
  assert.equal(await rests(), end);
  await page.getByRole('button', { name: 'Arm' }).click();
});

test('a page that loses the focus stops', async () => {
  await holdUntilItMoves();
  await page.evaluate(() => window.dispatchEvent(new Event('blur')));
  const end = await rests();
  assert.equal(await rests(), end);
  await page.mouse.up();
});

test('a server that hangs: the axis stops, and does not go on when it comes back', async () => {
  await holdUntilItMoves();
  stage.silence(true);
  const end = await rests();
  await page.getByText(/No connection since/).waitFor();
  stage.silence(false);
  await page.getByText(/No connection since/).waitFor({ state: 'detached' });
  assert.ok(Math.abs((await rests()) - end) < 10 * 0.2 + 1, 'at most one lease that was under way');
  await page.mouse.up();
});

/** Every message of the page and to it takes so long. */
const behind = (time_ms) => async (of) => {
  await of.routeWebSocket(/\/ws$/, (socket) => {
    const server = socket.connectToServer();
    socket.onMessage((text) => setTimeout(() => server.send(text), time_ms));
    server.onMessage((text) => setTimeout(() => socket.send(text), time_ms));
  });
};

test('behind 85 ms each way an axis moves for as long as its button is down', async () => {
  const other = await stage.openMachine({ before: behind(85) });
  await other.getByRole('button', { name: 'Arm' }).click();
  const told = other.getByRole('alert').getByText('The jog has ended');
  let from = await rests();
  let pressed = Date.now();
  await hold(other);
  // Three times as far as a single lease leads. A busy computer may end it for a while, and says so, or
  // may take the press before the button can be pressed: a person presses again.
  await until('X goes on', async () => {
    const isIdle = Date.now() - pressed > 5000 && (await at()) === from;
    if (isIdle || (await told.isVisible())) {
      await other.mouse.up();
      await other.keyboard.press('Escape');
      await other.getByRole('button', { name: 'Arm' }).click();
      from = await rests();
      pressed = Date.now();
      await hold(other);
    }
    return (await at()) - from > 3 * 10 * 0.2;
  });
  await other.mouse.up();
  const end = await rests();
  assert.equal(await rests(), end);
  // On a busy computer the last lease may have run out on its own, as above: nothing else may be told.
  const refusals = other.getByRole('alert').locator('.refusal');
  const others = refusals.filter({ hasNotText: 'The jog has ended' });
  assert.deepEqual(await others.allTextContents(), []);
  await other.context().close();
});

test('behind a connection that is too slow it ends, and says so', async () => {
  const other = await stage.openMachine({ before: behind(300) });
  await other.getByRole('button', { name: 'Arm' }).click();
  await hold(other);
  await other.getByRole('alert').getByText('The jog has ended').waitFor();
  const end = await rests();
  assert.equal(await rests(), end);
  await other.mouse.up();
  await other.context().close();
});

test('one hand on a touch screen: an axis moves while a finger is down, and on nothing else', async () => {
  const other = await stage.openMachine({
    width: 360,
    height: 640,
    hasTouch: true,
    isMobile: true,
  });
  await other.getByRole('button', { name: 'Arm' }).tap();
  const button = other.getByRole('button', { name: 'move X +' });
  await button.scrollIntoViewIfNeeded();
  const box = await button.boundingBox();
  assert.ok(box.width >= 44 && box.height >= 44, `${box.width} x ${box.height} px`);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const cdp = await other.context().newCDPSession(other);
  const touch = (type, ...touchPoints) =>
    cdp.send('Input.dispatchTouchEvent', { type, touchPoints });
  for (const [what, end] of [
    ['the finger goes', () => touch('touchEnd')],
    ['the system takes the finger', () => touch('touchCancel')],
    // A thumb that rolls does not end it: it has gone when it is lifted.
    [
      'the finger slides off and goes',
      async () => {
        await touch('touchMove', { x, y: y - 200 });
        await touch('touchEnd');
      },
    ],
  ]) {
    await pressUntilItMoves(
      () => touch('touchStart', { x, y }),
      () => touch('touchEnd'),
    );
    await end();
    const stands = await rests();
    assert.equal(await rests(), stands, what);
  }
  // Nothing was scrolled under the thumb.
  assert.equal((await button.boundingBox()).y, box.y);
  await other.context().close();
});

// What a machinist does with a broken insert.
test('in a held program the axes are moved away and come back', async () => {
  writeFileSync(join(stage.programs, 'cut.nc'), 'M3 S1000\nG91 G1 X200 F600\nM30\n');
  await stage.client.call('program.run', { program: 'cut.nc', channel: 1 });
  await until('it cuts', async () => (await stage.status()).speed_mm_s > 5);
  const other = await stage.openMachine();
  const card = other.getByRole('article', { name: '1 work' });
  await card.getByRole('button', { name: 'Hold', exact: true }).click();
  await until('it is held', async () => {
    const { held_by: by, speed_mm_s: speed } = await stage.status();
    return by !== null && speed === 0;
  });
  const turning = async () => (await stage.status()).spindles[0].commanded_rev_min;
  await card.getByRole('button', { name: 'Stop spindle' }).click();
  await until('the spindle stands', async () => (await turning()) === 0);
  const [x, z] = [await at('X'), await at('Z')];
  await other.getByRole('button', { name: 'Arm' }).click();
  const steps = other.getByRole('group', { name: 'Distance' });
  await steps.getByRole('button', { name: '1', exact: true }).click();
  const up = other.getByRole('button', { name: 'move Z +' });
  await clickUntil('it is away', up, async () => (await at('Z')) === z + 1);
  await card.getByText('The axes are not where').waitFor();
  assert.equal(await card.getByRole('button', { name: 'Resume' }).count(), 0);
  const resume = card.getByRole('button', { name: 'Resume' });
  await clickUntil('it is back', card.getByRole('button', { name: 'Return to path' }), () =>
    resume.isVisible(),
  );
  assert.deepEqual([await at('X'), await at('Z')], [x, z]);
  assert.equal(await turning(), 1000);
  const back = card.getByRole('button', { name: 'Back along the path' });
  const box = await back.boundingBox();
  await other.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await until('it goes back', async () => {
    await other.mouse.down();
    await card.getByText('The axes are in line 2').waitFor();
    const goes = (await at()) < x - 0.1;
    await other.mouse.up();
    return goes;
  });
  await until('it stands', async () => (await stage.status()).speed_mm_s === 0);
  if (process.env.STANOK_WRITE_DOCS)
    await card.screenshot({ path: join(root, 'docs/operator/pictures/panel-retrace.png') });
  await clickUntil('it is back again', card.getByRole('button', { name: 'Return to path' }), () =>
    resume.isVisible(),
  );
  assert.deepEqual([await at('X'), await at('Z')], [x, z]);
  await clickUntil('it cuts on', resume, async () => (await at()) > x);
  await card.getByRole('button', { name: 'Stop', exact: true }).click();
  await until('it is over', async () => (await stage.client.call('machine.status')).idle);
  await other.context().close();
});

// A stop in a tap leaves it in its hole; the spindle brings it out with the axis.
test('a tap that was stopped in its hole is taken out', async () => {
  const depth = 'G91 G94 G17\nS200 M3\nG33.1 Z-30 K1\nM30\n';
  writeFileSync(join(stage.programs, 'tap.nc'), depth);
  const z = await at('Z');
  await stage.client.call('program.run', { program: 'tap.nc', channel: 1 });
  await until('it is in', async () => (await at('Z')) < z - 5);
  const other = await stage.openMachine();
  const card = other.getByRole('article', { name: '1 work' });
  await card.getByRole('button', { name: 'Stop', exact: true }).click();
  await card.getByText('A tap is in its hole').waitFor();
  assert.ok((await at('Z')) < z - 5);
  await until('it stands', async () => (await stage.status()).state === 'Reset');
  if (process.env.STANOK_WRITE_DOCS)
    await card.screenshot({ path: join(root, 'docs/operator/pictures/panel-tap.png') });
  await other.getByRole('button', { name: 'Take the tap out' }).click();
  await other.getByRole('button', { name: 'Yes' }).click();
  await until('it is out', async () => !(await stage.status()).tap_in_hole);
  assert.ok(Math.abs((await at('Z')) - z) < 1e-6);
  await card.getByText('A tap is in its hole').waitFor({ state: 'detached' });
  await until('it is over', async () => (await stage.client.call('machine.status')).idle);
  assert.equal((await stage.status()).spindles[0].commanded_rev_min, 0);
  await other.context().close();
});

test('in a hold a new length counts at once, and the axes are led to it', async () => {
  await stage.client.call('tool.set', { number: 1, key: 'length', value: 50 });
  writeFileSync(join(stage.programs, 'cut.nc'), 'G43 H1\nG91 G1 X200 F600\nM30\n');
  await stage.client.call('program.run', { program: 'cut.nc', channel: 1 });
  await until('it cuts', async () => (await stage.status()).speed_mm_s > 5);
  const other = await stage.openMachine();
  const card = other.getByRole('article', { name: '1 work' });
  await card.getByRole('button', { name: 'Hold', exact: true }).click();
  await until('it is held', async () => {
    const { held_by: by, speed_mm_s: speed } = await stage.status();
    return by !== null && speed === 0;
  });
  const [x, z] = [await at('X'), await at('Z')];
  const home = await other.evaluate(() => location.hash);
  await other.evaluate(() => (location.hash = '#/tools'));
  const cell = other.getByLabel('T1.1 length', { exact: true });
  await cell.fill('52.5');
  await cell.press('Enter');
  await until('the length counts', async () => (await stage.status()).aside);
  await other.evaluate((hash) => (location.hash = hash), home);
  await card.getByText('The axes are not where').waitFor();
  assert.deepEqual([await at('X'), await at('Z')], [x, z]);
  const resume = card.getByRole('button', { name: 'Resume' });
  await clickUntil('it is back', card.getByRole('button', { name: 'Return to path' }), () =>
    resume.isVisible(),
  );
  assert.ok(Math.abs((await at('Z')) - (z + 2.5)) < 1e-6);
  assert.equal(await at('X'), x);
  await clickUntil('it cuts on', resume, async () => (await at()) > x);
  assert.ok(Math.abs((await at('Z')) - (z + 2.5)) < 1e-6);
  await card.getByRole('button', { name: 'Stop', exact: true }).click();
  await until('it is over', async () => (await stage.client.call('machine.status')).idle);
  await other.context().close();
});

test('a killed tab stops', async (context) => {
  const other = await stage.openMachine();
  await other.getByRole('button', { name: 'Arm' }).click();
  await holdUntilItMoves(other);
  const cdp = await other.context().newCDPSession(other);
  const killed = await at();
  cdp.send('Page.crash').catch(() => undefined);
  const end = await rests();
  context.diagnostic(`it went on for ${(end - killed).toFixed(3)} mm at 10 mm/s`);
  assert.equal(await rests(), end);
  await other.context().close();
});
