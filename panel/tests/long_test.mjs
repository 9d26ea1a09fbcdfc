// Memory over a shift of messages.
//
// Eight hours of status messages go through the page as fast as it takes them ($STANOK_HOURS: how many
// hours): what the page makes of a message does not depend on the clock. What stays on its heap behind the
// last hour is what stayed behind the first one.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { root, setStage } from './stage.mjs';

const hours = Number(process.env.STANOK_HOURS ?? 8);
const messagesOfAnHour = 20 * 3600;
const growthMax_bytes = 2_000_000;

let stage;
before(async () => {
  stage = await setStage({ programs: [join(root, 'programs/examples/helix.nc')] });
});
after(async () => {
  await stage?.close();
  assert.deepEqual(stage.faults, []);
});

// In the page: keeps its WebSocket in view, and lets messages of a daemon that runs a program go through it.
function takeSocket() {
  const Original = window.WebSocket;
  window.WebSocket = class extends Original {
    constructor(...words) {
      super(...words);
      window.socketOfThePage = this;
    }
  };
  window.feed = async (from, count) => {
    for (let i = from; i < from + count; ++i) {
      const angle = i / 50;
      const position = { X: 40 * Math.cos(angle), Y: 40 * Math.sin(angle), Z: -i / 1e5 };
      const state = {
        channels: { 1: { position, line: 1 + (i % 5000), block: i, speed_mm_s: i % 60 } },
      };
      const data = JSON.stringify({
        jsonrpc: '2.0',
        method: 'status',
        params: { full: false, state },
      });
      window.socketOfThePage.onmessage(new MessageEvent('message', { data }));
      // As many for a picture as keep the page answering.
      if (i % 50 === 0) await new Promise((resolve) => setTimeout(resolve));
    }
  };
}

async function heap(page) {
  const session = await page.context().newCDPSession(page);
  for (let k = 0; k < 3; ++k) await session.send('HeapProfiler.collectGarbage');
  const { usedSize } = await session.send('Runtime.getHeapUsage');
  await session.detach();
  return usedSize;
}

for (const view of ['machine', 'path']) {
  test(`${view}: memory is flat over ${hours} hours of messages`, async (context) => {
    const page = await stage.openMachine({ before: (it) => it.addInitScript(takeSocket) });
    await page.evaluate((name) => (location.hash = `#/${name}`), view);
    if (view === 'path') await page.locator('canvas').waitFor();
    let told = 0;
    const sizes = [];
    for (let hour = 0; hour < hours; ++hour) {
      await page.evaluate(([from, count]) => window.feed(from, count), [told, messagesOfAnHour]);
      told += messagesOfAnHour;
      sizes.push(await heap(page));
    }
    context.diagnostic(
      `${told} messages; heap in MB: ${sizes.map((size) => (size / 1e6).toFixed(1))}`,
    );
    await page.locator('header').getByText('live').waitFor();
    // The trace is full in the third hour: 200,000 points.
    const settled = sizes[Math.min(2, sizes.length - 1)];
    assert.ok(sizes.at(-1) - settled < growthMax_bytes, sizes.join());
    await page.context().close();
  });
}
