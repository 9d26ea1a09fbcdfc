// At most once in a while: asked for often, done once, and the last asking is never left out.

export function seldom(period_ms: number, act: () => void): () => void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  return () => {
    timer ??= setTimeout(() => {
      timer = null;
      act();
    }, period_ms);
  };
}
