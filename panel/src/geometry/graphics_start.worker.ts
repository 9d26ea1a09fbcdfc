// Starts what draws, in a thread of its own: the first context of a browser may take half a second where
// a processor has to draw, and a thread that asks for one waits for it.
try {
  new OffscreenCanvas(1, 1).getContext('webgl2')?.finish();
} finally {
  postMessage('started');
}
