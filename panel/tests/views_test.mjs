// Every view in every size, theme and language: nothing is cut off, hold and stop are where they
// belong, what is pressed is large enough, text can be read, axe-core finds nothing. And the states
// in which there is nothing to show: connecting, empty, lost, not permitted, signed out.
//
// Not every combination of them is looked at, unless STANOK_FULL=1 asks for it (ctest panel.views_long).
// With STANOK_WRITE_DOCS=1 it takes the pictures of docs/operator/panel-views.md, too.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { findings, measure } from './looks.mjs';
import { full, password, root, setStage, until } from './stage.mjs';

const views = [
  'machine',
  'path',
  'programs',
  'tools',
  'drives',
  'scope',
  'process',
  'history',
  'help',
];
// The smallest page with the longer words, and the one that most see; all of them in both languages when it is full.
const sizes = full
  ? [
      [360, 640],
      [800, 1280],
      [1280, 800],
      [3840, 2160],
    ].flatMap((size) => ['en-US', 'ru-RU'].map((locale) => [...size, locale]))
  : [
      [360, 640, 'ru-RU'],
      [1280, 800, 'en-US'],
    ];
const example = join(root, 'programs/examples/square_and_circle.nc');

let stage;
before(async () => {
  stage = await setStage({ programs: [example, join(root, 'programs/examples/helix.nc')] });
  // Positions with as many digits as they have on this machine.
  await stage.client.call('offset.set', { offset: 'G54', axis: 'X', value: 587.655 });
});
after(async () => {
  await stage?.close();
  assert.deepEqual(stage.faults, []);
});

async function show(page, view) {
  await page.evaluate((name) => (location.hash = `#/${name}`), view);
  await page.locator(`nav a[href="#/${view}"][aria-current=page]`).waitFor();
  await page.locator('main > :not(h1)').first().waitFor();
  await until('the view is there', async () => !/being loaded/.test(await page.innerText('main')));
}

/** To be looked at, in the folder $STANOK_PICTURES. */
async function picturesOf(page, name) {
  const folder = process.env.STANOK_PICTURES;
  if (folder) await page.screenshot({ path: join(folder, `${name}.png`) });
}

/** Both stand at the upper right, STOP ALL outermost, with room between them. */
async function stopsAreInTheirCorner(page, width) {
  const hold = await page.locator('button.hold').boundingBox();
  const stop = await page.locator('button.stop').boundingBox();
  assert.ok(
    stop.x + stop.width <= width && width - stop.x - stop.width < 40,
    'stop is at the edge',
  );
  assert.ok(stop.y < 80 && hold.y < 80, 'both are at the top');
  assert.ok(stop.x - (hold.x + hold.width) >= 15, 'there is room between hold and stop');
  assert.ok(stop.height >= 44 && hold.height >= 44);
}

describe('sizes', () => {
  for (const [width, height, locale] of sizes) {
    test(`${width} x ${height}, ${locale}`, async () => {
      const page = await stage.openMachine({ width, height, locale });
      await page.locator('[data-help=jog] button').first().click();
      for (const view of views) {
        await show(page, view);
        assert.deepEqual(await page.evaluate(measure), [], view);
        await stopsAreInTheirCorner(page, width);
      }
      await show(page, 'machine');
      await page.locator('[data-help=positions] button').click();
      assert.deepEqual(await page.evaluate(measure), [], 'big digits');
      await page.locator('[data-help=positions] button').click();
      if (width === 1280) {
        const digits = page.locator('.work').first();
        const size = await digits.evaluate((one) => parseFloat(getComputedStyle(one).fontSize));
        assert.ok(size >= 32, `positions are written with ${size} px`);
      }
      await page.context().close();
    });
  }
});

describe('axe-core finds nothing', () => {
  const looks = [
    { colorScheme: 'dark', width: 1280, height: 800 },
    { colorScheme: 'light', width: 1280, height: 800 },
    { colorScheme: 'light', contrast: 'more', width: 360, height: 640 },
  ];
  for (const look of full ? looks : looks.slice(0, 1)) {
    test(`${look.colorScheme} ${look.contrast ?? ''} ${look.width}`, async () => {
      const page = await stage.openMachine(look);
      for (const view of views) {
        await show(page, view);
        assert.deepEqual(await findings(page), [], view);
      }
      await page.getByRole('button', { name: /integrator|operator/ }).click();
      await page.getByLabel('Contrast').selectOption('high');
      await show(page, 'machine');
      assert.deepEqual(await findings(page), [], 'high contrast');
      await page.locator('body').press('?');
      assert.deepEqual(await findings(page), [], 'list of keys');
      await page.context().close();
    });
  }
});

/** Lays hands on the messages of the daemon: `change` gives back what the page is to see, or null. */
const through = (change) => async (page) => {
  await page.routeWebSocket(/\/ws$/, (socket) => {
    const server = socket.connectToServer();
    socket.onMessage((text) => {
      const message = JSON.parse(text);
      const answer = change(message, 'asked');
      if (answer === undefined) server.send(text);
      else if (answer !== null)
        socket.send(JSON.stringify({ jsonrpc: '2.0', id: message.id, ...answer }));
    });
    server.onMessage((text) => {
      const message = JSON.parse(text);
      const changed = change(message, 'told');
      if (changed === undefined) socket.send(text);
      else if (changed !== null) socket.send(JSON.stringify(changed));
    });
  });
};

describe('states', () => {
  test('connecting: the daemon has not greeted', async () => {
    const page = await stage.openPage({ before: through(() => null) });
    await page.getByText('Is stanokd running?').waitFor();
    assert.deepEqual(await findings(page), []);
    await page.locator('button.stop').click();
    await page.getByRole('alert').getByText('Nothing was sent').waitFor();
    await page.context().close();
  });

  test('observer: what is not permitted says so where it was pressed, and is not sent', async () => {
    const sent = [];
    const observer = (message, way) => {
      if (way === 'asked') sent.push(message.method);
      if (message.method !== 'hello') return undefined;
      return { ...message, params: { ...message.params, role: 'observer' } };
    };
    const page = await stage.openMachine({ before: through(observer) });
    // Without the waiting of click() for a button that can be pressed, the page may move under it.
    const refused = page.getByRole('alert').getByText('Not permitted');
    await until('it is refused', async () => {
      await page.getByRole('button', { name: 'On', exact: true }).click({ force: true });
      return refused.isVisible();
    });
    assert.ok(!sent.includes('machine.on'));
    await page.getByText('Your role does not permit jogging. Sign in as an operator.').waitFor();
    for (const view of views) {
      await show(page, view);
      assert.deepEqual(await findings(page), [], view);
    }
    await page.context().close();
  });

  test('a question is put anew when what it asks for has changed', async () => {
    await stage.client.call('program.load', { program: 'helix.nc' });
    const page = await stage.openMachine();
    const region = page.getByRole('region', { name: 'Program', exact: true });
    await page.getByText('helix.nc').first().waitFor();
    await region.getByRole('button', { name: 'Run' }).click();
    await region.getByText(/Run helix.nc/).waitFor();
    await stage.client.call('program.load', { program: 'square_and_circle.nc' });
    await region.getByRole('button', { name: 'Yes' }).waitFor({ state: 'detached' });
    await region.getByRole('button', { name: 'Run' }).click();
    await region.getByText(/Run square_and_circle.nc/).waitFor();
    await page.context().close();
  });

  test('Start does not begin at the top while a place is written that was not searched', async () => {
    await stage.client.call('program.load', { program: 'square_and_circle.nc' });
    const sent = [];
    const note = (message, way) => {
      if (way === 'asked') sent.push(message.method);
    };
    const page = await stage.openMachine({ before: through(note) });
    const card = page.getByRole('article', { name: '1 work' });
    const says = card.locator('[data-start]');
    await says.getByText('Start runs square_and_circle.nc from the beginning.').waitFor();
    await page.getByText('Start from line, single block').click();
    const field = page.getByLabel(/Start from line,/);
    await field.fill('15');
    await says.getByText('Start is not possible: “15” has not been searched for.').waitFor();
    await card.getByRole('button', { name: 'Start', exact: true }).click();
    await page.getByRole('alert').getByText('has not been searched').waitFor();
    assert.ok(!sent.includes('program.start'));
    assert.deepEqual(await findings(page), []);
    // A place written for one channel is none of the other.
    await page.getByRole('button', { name: '2 master' }).click();
    assert.equal(await field.inputValue(), '');
    await page.getByRole('button', { name: '1 work' }).click();
    await field.press('Enter');
    await says.getByText('Start runs from square_and_circle.nc:15.').waitFor();
    assert.equal((await stage.status()).begins_at, 'square_and_circle.nc:15');
    // Forgotten by the daemon, it is a place that was not searched.
    await stage.client.call('program.load', { program: 'square_and_circle.nc' });
    await says.getByText('has not been searched').waitFor();
    await field.fill('no such line');
    await field.press('Enter');
    await page.getByRole('alert').locator('.refusal').waitFor();
    await says.getByText('“no such line” has not been searched').waitFor();
    await field.fill('');
    await says.getByText('from the beginning').waitFor();
    await page.context().close();
  });

  test('Start in the middle asks with its approach, and begins there', async () => {
    await stage.client.call('machine.on');
    await stage.client.call('program.load', { program: 'square_and_circle.nc' });
    const page = await stage.openMachine();
    const card = page.getByRole('article', { name: '1 work' });
    await page.getByText('Start from line, single block').click();
    const field = page.getByLabel(/Start from line,/);
    await field.fill('15');
    await field.press('Enter');
    await page.getByText('Approach', { exact: true }).waitFor();
    assert.deepEqual(await findings(page), []);
    await card.getByRole('button', { name: 'Start', exact: true }).click();
    await card.getByText(/Start at square_and_circle.nc:15\? Approach: .* mm/).waitFor();
    assert.equal((await stage.status()).program_status, 'Stopped');
    await card.getByRole('button', { name: 'Yes' }).click();
    await until('it has begun', async () => (await stage.status()).begins_at === null);
    await stage.client.call('program.reset');
    await page.context().close();
  });

  test('a view that fails leaves hold and stop where they are', async () => {
    const failing = async (page) => {
      await page.route('**/HistoryView-*.js', (route) =>
        route.fulfill({
          contentType: 'text/javascript',
          body: "export default function Fails() { throw new Error('as it was meant'); }",
        }),
      );
    };
    const page = await stage.openMachine({ before: failing });
    await page.evaluate(() => (location.hash = '#/history'));
    await page.getByText('This view has failed').waitFor();
    assert.deepEqual(await findings(page), []);
    await page.locator('button.hold').click();
    await page.evaluate(() => (location.hash = '#/machine'));
    await page.locator('[data-state]').first().waitFor();
    await page.context().close();
  });

  test('empty: no programs, tools, drives, runs', async () => {
    const nothing = {
      'program.list': { programs: [], root: '/programs', complete: true },
      'tool.list': { tools: [] },
      'program.history': { runs: [] },
    };
    const empty = (message, way) => {
      if (way === 'asked' && nothing[message.method]) return { result: nothing[message.method] };
      const { state } = message.params ?? {};
      if (message.method === 'status' && state.drives) state.drives.axes = [];
      return way === 'told' ? message : undefined;
    };
    const page = await stage.openMachine({ before: through(empty) });
    const said = {
      programs: 'No programs',
      tools: 'No tool found',
      drives: 'has no drives',
    };
    for (const [view, words] of Object.entries({ ...said, history: 'No program has run yet' })) {
      await show(page, view);
      await page.getByText(words).first().waitFor();
      assert.deepEqual(await findings(page), [], view);
    }
    await page.context().close();
  });

  test('history: what programs have measured', async () => {
    const bore = {
      channel: 1,
      number: 1,
      cycle: 65000,
      feature: 'bore',
      values: { error_size: 0.05, size: 24.05 },
      text: 'measured bore size=24.05 error_size=0.05',
    };
    const measured = (message, way) => {
      if (way === 'told') return message;
      if (message.method !== 'measurement.history') return undefined;
      return { result: { measurements: [bore] } };
    };
    const page = await stage.openMachine({ before: through(measured) });
    await show(page, 'history');
    const row = page.locator('tr', { hasText: 'bore' });
    await row.waitFor();
    assert.deepEqual(await row.locator('td').allTextContents(), [
      '1:05',
      '1',
      'bore',
      'error_size 0.0500, size 24.0500',
    ]);
    assert.deepEqual(await findings(page), []);
    await page.context().close();
  });

  test('lost: all values grey, and it says since when; then it is live again', async () => {
    const page = await stage.openMachine();
    stage.silence(true);
    try {
      await page.getByText(/No connection since \d\d:\d\d:\d\d/).waitFor();
      assert.ok(await page.locator('main > .machine.old').isVisible());
      assert.deepEqual(await findings(page), []);
    } finally {
      stage.silence(false);
    }
    await page.locator('main > .machine:not(.old)').waitFor();
    await page.getByText(/No connection since/).waitFor({ state: 'detached' });
    await page.context().close();
  });

  /** Lays hands on what the daemon says of its state: `act` gets each message and may take it away. */
  const statusThrough = (act) => (page) =>
    page.routeWebSocket(/\/ws$/, (socket) => {
      const server = socket.connectToServer();
      socket.onMessage((text) => server.send(text));
      server.onMessage((text) => {
        const message = typeof text === 'string' ? JSON.parse(text) : {};
        const passed = message.method === 'status' ? act(message) : text;
        socket.send(typeof passed === 'string' ? passed : JSON.stringify(passed));
      });
    });

  const delayed = ({ params, ...message }) => {
    const { machine, channels = {} } = params.state;
    const later = (one) => ({ ...one, age_ms: 400 });
    const ids = Object.entries(channels).map(([id, one]) => [id, later(one)]);
    const state = { ...params.state, channels: Object.fromEntries(ids) };
    return {
      ...message,
      params: { ...params, state: machine ? { ...state, machine: later(machine) } : state },
    };
  };
  const withheld = () => ({ jsonrpc: '2.0', method: 'nothing', params: {} });

  for (const [how, late] of [
    ['say that they are older than 0.3 s', delayed],
    ['do not come, while others do', withheld],
  ]) {
    test(`old: values are grey, and it says so, where statuses ${how}; then they are as ever`, async () => {
      let isLate = false;
      const before = statusThrough((message) => (isLate ? late(message) : message));
      const page = await stage.openMachine({ before });
      await page.locator('main > .machine:not(.old)').waitFor();
      isLate = true;
      await page.locator('main > .machine.old').waitFor();
      await page.locator('header').getByText('values older than 0.3 s').waitFor();
      assert.equal(await page.getByText(/No connection since/).count(), 0);
      assert.deepEqual(await findings(page), []);
      await show(page, 'path');
      await page.locator('main > .path.old').waitFor();
      isLate = false;
      await page.locator('main > .path:not(.old)').waitFor();
      await page.locator('header').getByText('live').waitFor();
      await page.context().close();
    });
  }

  test('a server that comes back knows its pages', async () => {
    const page = await stage.openMachine();
    await page.locator('main > .machine:not(.old)').waitFor();
    const again = page.waitForEvent('websocket');
    await stage.restartServer();
    await again;
    await page.locator('main > .machine:not(.old)').waitFor();
    assert.equal(await page.getByText('You are not signed in.').count(), 0);
    await page.context().close();
  });

  test('signed out: by a server that has lost its sessions', async () => {
    const page = await stage.openMachine();
    await stage.restartServer({ forgets: true });
    await page.getByText('You are not signed in.').waitFor();
    assert.deepEqual(await findings(page), []);
    assert.equal(await page.locator('button.stop').count(), 0);
    await page.goto(stage.newLink());
    await page.locator('[data-state]').first().waitFor();
    assert.ok(!page.url().includes('#'), page.url());
    await page.context().close();
  });
});

describe('users', () => {
  async function signIn(page, name, word) {
    await page.getByLabel('Name').fill(name);
    await page.getByLabel('Password').fill(word);
    await page.getByRole('button', { name: 'Sign in' }).click();
  }

  test('an observer looks; the password of an operator lets operate', async () => {
    const page = await stage.openPage({ link: stage.address() });
    await signIn(page, 'observer', 'another password');
    await page.getByText('Name or password is wrong.').waitFor();
    await signIn(page, 'observer', password);
    await page.getByRole('button', { name: 'observer' }).first().click();
    await page.getByText('You can watch.').waitFor();
    await page.locator('#session-menu').getByText('e7106mf4').waitFor();
    assert.deepEqual(await findings(page), []);
    await signIn(page, 'operator', password);
    await page.getByRole('button', { name: 'operator · operator' }).waitFor();
    await page.getByRole('button', { name: 'Take control' }).first().click();
    await page.getByRole('button', { name: 'Yes' }).click();
    await page.getByRole('button', { name: 'Release control' }).waitFor();
    const other = await stage.openMachine();
    await other.getByText('controlled by operator', { exact: true }).waitFor();
    await other.getByRole('button', { name: 'Start', exact: true }).first().click();
    await other.getByRole('alert').getByText('E6').waitFor();
    await other.getByRole('alert').getByText('controlled by operator').waitFor();
    assert.doesNotMatch(await other.innerText('main'), /session \d|uid \d|pid \d/);
    assert.doesNotMatch(await other.getByRole('alert').innerText(), /session \d|uid \d|pid \d/);
    await other.context().close();
    await page.context().close();
  });
});

describe('programs', () => {
  const folder = mkdtempSync(join(tmpdir(), 'panel-upload-'));
  const wrong = join(folder, 'wrong.nc');
  after(() => rmSync(folder, { recursive: true }));

  async function open(name) {
    const page = await stage.openMachine();
    await show(page, 'programs');
    await page.getByRole('link', { name: new RegExp(name) }).click();
    await page.getByLabel('Text of the program').getByText('G').first().waitFor();
    return page;
  }

  test('a program is uploaded, its error marked in its line, mended and saved', async () => {
    writeFileSync(wrong, 'G90\r\nG1 X20 Q5 F100\r\nM30\r\n');
    const page = await stage.openMachine();
    await show(page, 'programs');
    await page.getByLabel('File to upload').setInputFiles(wrong);
    await page.getByRole('button', { name: 'Upload', exact: true }).click();
    const text = page.getByLabel('Text of the program');
    await text.getByText('X20').waitFor();
    await page.getByRole('button', { name: 'Check' }).click();
    await page.getByRole('button', { name: /E4003 wrong.nc:2/ }).click();
    assert.equal(await page.locator('.cm-lintRange-error').first().innerText(), 'Q5');
    assert.deepEqual(await findings(page), []);
    await page.keyboard.press('End');
    for (let i = 0; i < ' Q5 F100'.length; ++i) await page.keyboard.press('Backspace');
    await page.keyboard.type(' F100');
    await page.getByRole('button', { name: 'Check' }).click();
    await page.getByText('no errors').waitFor();
    await page.getByRole('button', { name: 'Save' }).click();
    const saved = async () =>
      (await stage.client.call('program.read', { program: 'wrong.nc' })).text;
    await until('it is saved', async () => (await saved()) === 'G90\r\nG1 X20 F100\r\nM30\r\n');
    await page.context().close();
  });

  test('a word is explained on hover and offered while it is written', async () => {
    const page = await open('square_and_circle.nc');
    const text = page.getByLabel('Text of the program');
    const explained = page.locator('.cm-tooltip-hover').getByText('millimetre');
    await until('it is explained', async () => {
      await page.mouse.move(0, 0); // where the page moved under the mouse
      await text.getByText('G21').first().hover();
      return explained.waitFor({ timeout: 5000 }).then(
        () => true,
        () => false,
      );
    });
    assert.deepEqual(await findings(page), []);
    await text.click();
    await page.keyboard.press('Control+End');
    await page.keyboard.type('G43.');
    const offered = page.locator('.cm-tooltip-autocomplete');
    await offered.getByText('G43.4').waitFor();
    assert.deepEqual(await findings(page), []);
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: 'Revert' }).click();
    await page.getByRole('button', { name: 'Yes' }).click();
    await page.context().close();
  });

  test('the time that a program takes is told before it runs', async () => {
    const page = await open('square_and_circle.nc');
    await page.getByRole('button', { name: 'Estimate time' }).click();
    await page.getByText(/takes \d+:\d\d, path \d+ mm/).waitFor();
    assert.deepEqual(await findings(page), []);
    assert.equal((await stage.status()).state, 'Reset');
    await page.context().close();
  });

  test('what somebody else has changed meanwhile is not overwritten', async () => {
    const page = await open('helix.nc');
    const theirs = 'G90\nM30\n';
    await stage.client.call('program.write', { program: 'helix.nc', text: theirs, version: 'any' });
    await page.getByLabel('Text of the program').click();
    await page.keyboard.type('G4 ');
    await page.getByRole('button', { name: 'Save' }).click();
    await page.getByRole('alert').getByText('Refused').waitFor();
    const { text } = await stage.client.call('program.read', { program: 'helix.nc' });
    assert.equal(text, theirs);
    await page.context().close();
  });
});

describe('what is not saved', () => {
  test('stays while other views are shown, and can be taken back', async () => {
    const name = 'square_and_circle.nc';
    const page = await stage.openMachine();
    await show(page, 'programs');
    await page.getByRole('link', { name: new RegExp(name) }).click();
    const text = page.getByLabel('Text of the program');
    await text.click();
    await page.keyboard.press('Control+Home');
    await page.keyboard.type('G4 P7 ');
    await show(page, 'machine');
    await page.evaluate((of) => (location.hash = `#/programs/${of}`), name);
    await text.getByText('G4 P7').waitFor();
    await page.getByRole('heading', { name: /changed/ }).waitFor();
    await page.getByRole('button', { name: 'Revert' }).click();
    await page.getByRole('button', { name: 'Yes' }).click();
    await text.getByText('G4 P7').waitFor({ state: 'detached' });
    await page.context().close();
  });

  test('a text of another encoding is shown and not saved', async () => {
    writeFileSync(
      join(stage.programs, 'cp1251.nc'),
      Buffer.from([0x28, 0xcf, 0x29, 0x0a, 0x4d, 0x32]),
    );
    const page = await stage.openMachine();
    await page.evaluate(() => (location.hash = '#/programs/cp1251.nc'));
    await page.getByText('This text is not UTF-8').waitFor();
    await page.getByLabel('Text of the program').click();
    await page.keyboard.type('G4 ');
    await page.getByRole('heading', { name: /changed/ }).waitFor();
    assert.ok(await page.getByRole('button', { name: 'Save' }).isDisabled());
    await page.context().close();
  });
});

describe('the manual', () => {
  const pages = [
    [360, 640, 'ru-RU'],
    [1280, 800, 'en-US'],
    [3840, 2160, 'en-US'],
  ];
  for (const [width, height, locale] of full ? pages : pages.slice(0, 1)) {
    test(`is read and found in, ${width} x ${height}, ${locale}`, async () => {
      const page = await stage.openMachine({ width, height, locale });
      await show(page, 'help');
      await page.locator('a[href="#/help/manual%2F"]').click();
      const document = page.locator('article');
      await document.getByRole('heading', { name: 'Documents' }).waitFor();
      await document.getByRole('link', { name: 'What the page shows' }).click();
      await document.getByRole('heading', { name: 'On every view' }).waitFor();
      const picture = document.locator('img').first();
      await picture.scrollIntoViewIfNeeded();
      await until('the picture', () => picture.evaluate(({ naturalWidth }) => naturalWidth > 0));
      assert.deepEqual(await findings(page), []);
      assert.deepEqual(await page.evaluate(measure), []);
      await stopsAreInTheirCorner(page, width);
      await picturesOf(page, `manual-${width}`);
      await page.locator('input[type=search]').fill('tunnel another computer');
      const found = page.getByRole('link', { name: 'The page › Opening it' });
      await found.waitFor();
      assert.deepEqual(await findings(page), []);
      assert.deepEqual(await page.evaluate(measure), []);
      await picturesOf(page, `found-${width}`);
      await found.focus();
      await page.keyboard.press('Enter');
      const heading = document.getByRole('heading', { name: 'Opening it' });
      await until('the heading has the focus', () =>
        heading.evaluate((one) => one.ownerDocument.activeElement === one),
      );
      await page.context().close();
    });
  }

  test('a page of it that is not there says so', async () => {
    const page = await stage.openMachine();
    await page.evaluate(() => (location.hash = '#/help/manual%2Fno%2Fsuch.md'));
    await page.getByText('This page of the manual is not available').waitFor();
    assert.deepEqual(await findings(page), []);
    // The browser writes it on the console, too.
    await until('it was told', () => stage.faults.length > 0);
    assert.match(stage.faults.pop(), /404/);
    await page.context().close();
  });
});

describe('tables', () => {
  test('a value is changed, shown with what it was, and taken back', async () => {
    const page = await stage.openMachine();
    await show(page, 'tools');
    const cell = page.getByLabel('T1.1 length', { exact: true });
    const before = (await stage.client.call('tool.get', { number: 1 })).length;
    await cell.fill('81.25');
    await cell.press('Enter');
    const length = async () => (await stage.client.call('tool.get', { number: 1 })).length;
    await until('81.25', async () => (await length()) === 81.25);
    await page.getByText(/T1.1 length from/).waitFor();
    const changes = page.getByRole('region', { name: 'Changes' });
    const row = changes.getByRole('row', { name: /T1\.1 length/ });
    await row.first().waitFor();
    const cells = await row.first().getByRole('cell').allInnerTexts();
    assert.deepEqual(cells.slice(1, 4), ['T1.1 length', before.toFixed(3), '81.250']);
    assert.notEqual(cells[4], '', 'who it was');
    await page.getByRole('button', { name: 'Undo' }).click();
    await until('as before', async () => (await length()) === before);
    await page.context().close();
  });

  test('a value that the daemon wants to have confirmed is a question', async () => {
    const confirmed = [];
    const before = (page) =>
      page.routeWebSocket(/\/ws$/, (socket) => {
        const server = socket.connectToServer();
        server.onMessage((text) => socket.send(text));
        socket.onMessage((text) => {
          const message = JSON.parse(text);
          if (message.method === 'tool.set') confirmed.push(message.params.confirmed);
          server.send(text);
        });
      });
    const page = await stage.openMachine({ before });
    await show(page, 'tools');
    const length = async () => (await stage.client.call('tool.get', { number: 1 })).length;
    const asItWas = await length();
    const cell = page.getByLabel('T1.1 length', { exact: true });
    const question = page.getByRole('alert').filter({ hasText: 'tool_length_max' });
    const ask = async () => {
      await cell.fill('600');
      await cell.press('Enter');
      await question.getByText('Is this value intended?').waitFor();
    };
    await ask();
    assert.deepEqual(await findings(page), []);
    await question.getByRole('button', { name: 'No', exact: true }).click();
    await question.waitFor({ state: 'detached' });
    assert.equal(await length(), asItWas);
    await ask();
    await question.getByRole('button', { name: 'Yes', exact: true }).click();
    await until('600', async () => (await length()) === 600);
    assert.deepEqual(confirmed, [undefined, undefined, 1]);
    await stage.client.call('tool.set', {
      number: 1,
      edge: 1,
      key: 'length',
      value: asItWas,
      confirmed: 1,
    });
    await page.context().close();
  });
});

describe('path', () => {
  const points = 200_000;

  function pages(id) {
    const each = 50_000;
    return Array.from({ length: points / each }, (_, page) => {
      const bytes = Buffer.alloc(16 + each * 16);
      [1, id, page, each].forEach((value, i) => bytes.writeUInt32LE(value, 4 * i));
      for (let i = 0; i < each; ++i) {
        const turn = (page * each + i) / 500;
        bytes.writeFloatLE(40 * Math.cos(turn), 16 + 12 * i);
        bytes.writeFloatLE(40 * Math.sin(turn), 20 + 12 * i);
        bytes.writeFloatLE(turn / 10, 24 + 12 * i);
        bytes.writeUInt32LE(page * each + i + 1, 16 + 12 * each + 4 * i);
      }
      return bytes;
    });
  }

  /** How long HOLD ALL waits to be heard while the view is opened, and while that of help is: told, not asserted. */
  async function pressWhileItOpens(page, context) {
    await page.evaluate(() => {
      document.querySelector('canvas').dataset.first = 'yes';
      window.waited = [];
      window.waitedInHelp = [];
      const note = ({ timeStamp }) =>
        (location.hash === '#/path' ? window.waited : window.waitedInHelp).push(
          performance.now() - timeStamp,
        );
      window.addEventListener('pointerdown', note, true);
    });
    const box = await page.locator('button.hold').boundingBox();
    for (let moment_ms = 0; moment_ms < 800; moment_ms += 100) {
      for (const view of ['help', 'path']) {
        await page.evaluate((name) => (location.hash = `#/${name}`), view);
        await page.waitForTimeout(moment_ms);
        await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
        await show(page, view);
      }
    }
    for (const [view, of] of [
      ['path', 'waited'],
      ['help', 'waitedInHelp'],
    ]) {
      const most = Math.max(...(await page.evaluate((name) => window[name], of)));
      context.diagnostic(`hold is heard after ${most.toFixed(0)} ms at most in the view ${view}`);
    }
    // What draws was waited for once, when the view was opened first.
    assert.equal(await page.locator('canvas').getAttribute('data-first'), 'yes');
    await page.locator(`canvas[data-drawn="${points}"]`).waitFor();
  }

  test(`${points} planned points come by pages, a press tells the line`, async (context) => {
    await stage.client.call('program.load', { program: 'helix.nc' });
    // The page waits for the path whose number the status has.
    const path = await until('a path', async () => (await stage.status()).planned_path);
    const frames = pages(path);
    const planned = async (page) => {
      await page.routeWebSocket(/\/ws$/, (socket) => {
        const server = socket.connectToServer();
        socket.onMessage((text) => {
          const { id, method, params } = JSON.parse(text);
          if (method !== 'program.path') return server.send(text);
          const { page } = params;
          const geometry = page < 4 ? { id: path, page, rapid: [[0, 100]], begins: [] } : null;
          if (page < 4) socket.send(frames[page]);
          const result = {
            id: path,
            pages: 4,
            points,
            complete: true,
            given_up: null,
            part: null,
            geometry,
          };
          socket.send(JSON.stringify({ jsonrpc: '2.0', id, result }));
        });
        server.onMessage((text) => socket.send(text));
      });
    };
    const page = await stage.openMachine({ before: planned });
    await show(page, 'path');
    await page.locator(`canvas[data-points="${points}"]`).waitFor();
    const box = await page.locator('canvas').boundingBox();
    const picture = () => page.locator('canvas').getAttribute('data-pictures').then(Number);
    const [first, began] = [await picture(), Date.now()];
    await page.mouse.move(box.x + 500, box.y + 300);
    await page.mouse.down();
    for (let i = 0; i < 60; ++i) await page.mouse.move(box.x + 500 + 3 * i, box.y + 300 + i);
    await page.mouse.up();
    const rate = ((await picture()) - first) / ((Date.now() - began) / 1000);
    context.diagnostic(`turned with ${rate.toFixed(1)} pictures a second, drawn in software`);
    await pressWhileItOpens(page, context);
    await page.getByRole('button', { name: 'Front' }).click();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await page.getByText(/This part of the path comes from line \d+/).waitFor();
    await page.context().close();
  });
});

test('the planned path of the daemon is drawn, and a line of it shown', async () => {
  await stage.client.call('program.load', { program: 'square_and_circle.nc' });
  const page = await stage.openMachine();
  await page.evaluate(() => (location.hash = '#/path/15'));
  const canvas = page.locator('canvas');
  await until('points', async () => Number(await canvas.getAttribute('data-points')) > 10);
  const { points } = await stage.client.call('program.path', { channel: 1, page: 0 });
  await page.locator(`canvas[data-points="${points}"]`).waitFor();
  await page.getByText('This part of the path comes from line 15').waitFor();
  await page.getByRole('button', { name: 'Limits' }).click();
  await page.getByRole('button', { name: 'Measure' }).click();
  await page.getByText('Press two points on the path.').waitFor();
  await page.getByRole('button', { name: 'Top', exact: true }).click();
  const box = await canvas.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  // The square lies around the middle of the picture: a press outwards from there meets a side of it.
  const meet = async (dx, dy, text) => {
    for (let way = 0; way < 0.5; way += 0.01) {
      await page.mouse.click(x + dx * way * box.width, y + dy * way * box.height);
      if (await page.getByText(text).isVisible()) return;
    }
    throw new Error('nothing of the path was met');
  };
  await page.mouse.click(x, y);
  await meet(1, 0, /Distance [\d.]+ mm/);
  await page.getByRole('button', { name: 'Measure' }).click();
  await page.getByRole('button', { name: 'Limits' }).click();
  await page.getByText('This part of the path comes from line 15').waitFor();
  await page.getByRole('link', { name: 'Show the line' }).click();
  await page.getByLabel('Text of the program').getByText('G').first().waitFor();
  await page.context().close();
});

if (process.env.STANOK_WRITE_DOCS) {
  test('pictures of the manual', async () => {
    await stage.switchOn();
    const page = await stage.openMachine({ width: 1120, height: 700 });
    await stage.client.call('program.run', { program: 'square_and_circle.nc', channel: 1 });
    await page.locator('[data-state=running]').first().waitFor();
    for (const view of ['path', 'machine', 'programs', 'tools', 'drives']) {
      await show(page, view);
      if (view === 'programs') {
        await page.getByRole('link', { name: /square_and_circle/ }).click();
      }
      await page.waitForTimeout(view === 'path' ? 4000 : 500);
      await page.screenshot({ path: join(root, `docs/operator/pictures/panel-${view}.png`) });
    }
    await page.context().close();
  });
}
