// How long a press of HOLD ALL takes from the finger to the socket while the page draws a large path.
//
// The page draws SEGMENTS of a path and turns the picture all the time, in Debian's Chromium without a graphics
// processor (SwiftShader). HOLD ALL is pressed PRESSES times; a figure is the time from the event's own time stamp,
// which the browser gives it outside of the page's thread, to the call that sends program.hold. The same in the help
// view, which has no picture; and in the machine view for a controller whose direction is let go (to the end of the
// jog). Behind the socket are stanok-web and the cycle of the daemon: see stop_latency_figures.py.
//
// usage: STANOK_BIN=build/release/bin node benchmarks/panel_press_figures.mjs [SEGMENTS [PRESSES]]
// (default 200000 segments, 100 presses). Needs `npm ci` in panel/.
import { join } from "node:path";
import { root, setStage, until } from "../panel/tests/stage.mjs";
import { inPlaceOfDaemon, pagesOf } from "./planned_path.mjs";

const [segments = 200000, presses = 100] = process.argv.slice(2).map(Number);
const sizes = [
  [360, 640],
  [1280, 800],
];

/** A finishing pass: rows along X over a surface of waves. */
function surface(count) {
  const perRow = 500;
  return Array.from({ length: count + 1 }, (_, i) => {
    const row = Math.floor(i / perRow);
    const along = i % perRow;
    const x = (row % 2 === 0 ? along : perRow - 1 - along) * 0.4;
    const y = row * 0.5;
    return [x, y, 4 * Math.sin(x / 13) * Math.cos(y / 17)];
  });
}

// In the page: when which request was given to the socket.
function noteWhatIsSent() {
  window.sent = [];
  const send = WebSocket.prototype.send;
  WebSocket.prototype.send = function (text) {
    if (typeof text === "string")
      window.sent.push([JSON.parse(text), performance.now()]);
    send.call(this, text);
  };
}

// In the page: turns the picture for as long as it is shown.
function turnForEver() {
  const canvas = document.querySelector("canvas");
  const box = canvas.getBoundingClientRect();
  const event = (type, step, buttons) =>
    canvas.dispatchEvent(
      new PointerEvent(type, {
        bubbles: true,
        pointerId: 1,
        pointerType: "mouse",
        button: type === "pointermove" ? -1 : 0,
        buttons,
        clientX: box.left + box.width / 2 + step,
        clientY: box.top + box.height / 2 + 20 * Math.sin(step / 40),
      }),
    );
  canvas.setPointerCapture = canvas.releasePointerCapture = () => undefined;
  event("pointerdown", 0, 1);
  let step = 0;
  const go = () => {
    event("pointermove", (step += 2), 1);
    if (canvas.isConnected) requestAnimationFrame(go);
  };
  requestAnimationFrame(go);
}

/** Milliseconds from each press of HOLD ALL to program.hold in the socket. */
async function pressed(page) {
  await page.evaluate(() => {
    window.presses = [];
    const button = document.querySelector("button.hold");
    button.addEventListener(
      "pointerdown",
      (event) => window.presses.push(event.timeStamp),
      true,
    );
  });
  const box = await page.locator("button.hold").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const delays = [];
  for (let i = 0; i < presses; ++i) {
    await page.evaluate(() => (window.sent.length = window.presses.length = 0));
    await page.mouse.down();
    delays.push(
      await until("the hold is sent", () =>
        page.evaluate(() => {
          const hold = window.sent.find(
            ([request]) => request.method === "program.hold",
          );
          return hold && { delay: hold[1] - window.presses[0] };
        }),
      ),
    );
    await page.mouse.up();
  }
  return delays.map(({ delay }) => delay).sort((a, b) => a - b);
}

/** Milliseconds from a direction that is let go on a controller to the hold in the socket. */
async function letGo(page) {
  await page.getByRole("button", { name: "Arm" }).click();
  const delays = [];
  for (let tries = 0; delays.length < presses / 5 && tries < presses; ++tries) {
    await page.evaluate(
      (direction) => {
        window.sent.length = 0;
        const [from, to] = [
          performance.now() + 100,
          performance.now() + 400 + 100 * Math.random(),
        ];
        window.released = to;
        navigator.getGamepads = () => {
          const down = performance.now() >= from && performance.now() < to;
          const keys = down ? [0, direction] : [];
          return [
            {
              buttons: Array.from({ length: 17 }, (_, k) => ({
                pressed: keys.includes(k),
              })),
            },
          ];
        };
      },
      [14, 15][tries % 2],
    );
    await page.waitForFunction(
      () => performance.now() > window.released + 1000,
    );
    // None where the daemon ended the jog before, as on a computer too busy to renew it.
    const delay = await page.evaluate(() => {
      const hold = window.sent.find(
        ([{ method }, at]) =>
          method === "program.hold" && at >= window.released,
      );
      return hold === undefined ? null : hold[1] - window.released;
    });
    if (delay !== null) delays.push(delay);
  }
  return delays.sort((a, b) => a - b);
}

const shown = (delays) =>
  [delays[Math.floor(delays.length / 2)], delays.at(-1)]
    .map((one) => `${one.toFixed(1)} ms`)
    .join(", ");

const path = pagesOf(surface(segments));
const stage = await setStage({
  programs: [join(root, "programs/examples/helix.nc")],
});
try {
  await stage.client.call("program.load", { program: "helix.nc" });
  await stage.client.call("machine.on");
  console.log(
    `${segments} segments; median and longest of ${presses} presses\n`,
  );
  console.log(
    "| page | path view, turning | help view | controller, machine view |",
  );
  console.log("|---|---|---|---|");
  for (const [width, height] of sizes) {
    const page = await stage.openMachine({
      width,
      height,
      before: (one) => inPlaceOfDaemon(one, path),
    });
    await page.evaluate(noteWhatIsSent);
    const controller = await letGo(page);
    await page.evaluate(() => (location.hash = "#/path"));
    await page.waitForFunction(
      (points) =>
        Number(document.querySelector("canvas")?.dataset.drawn ?? 0) >= points,
      path.points,
    );
    await page.evaluate(turnForEver);
    const drawing = await pressed(page);
    await page.evaluate(() => (location.hash = "#/help"));
    await page.locator("canvas").waitFor({ state: "detached" });
    const help = await pressed(page);
    console.log(
      `| ${width} × ${height} | ${shown(drawing)} | ${shown(help)} | ${shown(controller)} |`,
    );
    await page.context().close();
  }
} finally {
  await stage.close();
}
if (stage.faults.length > 0) throw new Error(stage.faults.join("\n"));
