// Segments of a track as pairs of indices of its points, rising.

export class Pairs {
  indices: Uint32Array = new Uint32Array(2048);
  count = 0;
  /** Another one with every change, so that who draws them knows that they are others. */
  version = 0;

  clear(): void {
    this.count = 0;
    this.version += 1;
  }

  add(from: number, to: number): void {
    this.#reserve(this.count + 1);
    this.indices[2 * this.count] = from;
    this.indices[2 * this.count + 1] = to;
    this.count += 1;
    this.version += 1;
  }

  /** More of them, which lie behind those that are here. */
  append(pairs: Uint32Array): void {
    this.#reserve(this.count + pairs.length / 2);
    this.indices.set(pairs, 2 * this.count);
    this.count += pairs.length / 2;
    this.version += 1;
  }

  /** How many pairs end at or before a point. */
  upTo(point: number): number {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((this.indices[2 * middle + 1] ?? 0) <= point) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  #reserve(count: number): void {
    if (2 * count <= this.indices.length) return;
    const larger = new Uint32Array(Math.max(2 * count, 2 * this.indices.length));
    larger.set(this.indices.subarray(0, 2 * this.count));
    this.indices = larger;
  }
}
