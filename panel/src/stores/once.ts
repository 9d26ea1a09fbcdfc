// One at a time: what is asked for again while it is under way is the same, not another one.

export function once<T>(act: () => Promise<T>): () => Promise<T> {
  let underWay: Promise<T> | null = null;
  return () => {
    underWay ??= act().finally(() => (underWay = null));
    return underWay;
  };
}
