// A page of geometry as it comes in a binary frame: a header of four uint32 (kind, id, page, count),
// `count` points of three Float32 in mm, and `count` numbers as Uint32 (of lines in a path, of tools on a
// surface, of times in ms in a log); all little endian.

export const pathKind = 1;
export const surfaceKind = 2;
export const loggedKind = 3;

export interface GeometryPage {
  kind: number;
  id: number;
  page: number;
  /** x, y, z of each point. */
  points: Float32Array;
  /** The line of the program that leads to each point, or the tool that made the surface there. */
  lines: Uint32Array;
}

const headerBytes = 16;
const pointBytes = 12;
const lineBytes = 4;

/** null when the frame is not one of ours. */
export function readPage(frame: ArrayBuffer): GeometryPage | null {
  if (frame.byteLength < headerBytes) return null;
  const [kind = 0, id = 0, page = 0, count = 0] = new Uint32Array(frame, 0, 4);
  const linesAt = headerBytes + count * pointBytes;
  if (frame.byteLength !== linesAt + count * lineBytes) return null;
  return {
    kind,
    id,
    page,
    points: new Float32Array(frame, headerBytes, count * 3),
    lines: new Uint32Array(frame, linesAt, count),
  };
}
