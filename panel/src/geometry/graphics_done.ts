// When the graphics have done what they were asked for. Whoever asks them something before that waits for it, and
// with it the thread of the page.

const pause = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 4));

export async function whenDone(gl: WebGL2RenderingContext): Promise<void> {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  if (fence === null) return;
  do await pause();
  while (!gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED);
  gl.deleteSync(fence);
}
