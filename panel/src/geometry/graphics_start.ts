// A context for drawing is asked for where nobody waits: the thread of the page has hold and stop to send.

const patience_ms = 5000;

/** Gives `create` a browser that has started to draw, so that its context comes at once. */
export async function whenGraphicsStarted<T>(create: () => T): Promise<T> {
  const worker = startWorker();
  try {
    await new Promise<void>((resolve) => {
      setTimeout(resolve, worker === null ? 0 : patience_ms);
      if (worker !== null) worker.onmessage = worker.onerror = () => resolve();
    });
    return create();
  } finally {
    worker?.terminate();
  }
}

// Where there is none the page draws all the same.
function startWorker(): Worker | null {
  try {
    return new Worker(new URL('./graphics_start.worker.ts', import.meta.url), { type: 'module' });
  } catch {
    return null;
  }
}
