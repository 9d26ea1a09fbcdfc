// A planned path that the page gets from here, not from the daemon: planning a large program is not what is measured.
import { readFileSync } from "node:fs";

const pointsOfPage = 4096;

/** X, Y, Z of each row of a table of points that generate_programs writes. */
export function pointsOfTable(file) {
  const [names = "", ...rows] = readFileSync(file, "utf8").trim().split("\n");
  const columns = ["x", "y", "z"].map((axis) => names.split(",").indexOf(axis));
  return rows
    .map((row) => row.split(","))
    .map((row) => columns.map((column) => Number(row[column])));
}

/** The pages of a path as the page gets them: header, points, numbers of lines. */
export function pagesOf(points) {
  const pages = [];
  for (let first = 0; first < points.length; first += pointsOfPage) {
    const part = points.slice(first, first + pointsOfPage);
    const bytes = Buffer.alloc(16 + 16 * part.length);
    [1, 0, pages.length, part.length].forEach((value, i) =>
      bytes.writeUInt32LE(value, 4 * i),
    );
    part.forEach((point, i) => {
      point.forEach((value, axis) =>
        bytes.writeFloatLE(value, 16 + 12 * i + 4 * axis),
      );
      bytes.writeUInt32LE(first + i + 1, 16 + 12 * part.length + 4 * i);
    });
    pages.push(bytes);
  }
  return { pages, points: points.length };
}

/** Answers the page in the place of the daemon when it asks for the planned path, under the number that the daemon
    gave to its own. */
export function inPlaceOfDaemon(page, path) {
  return page.routeWebSocket(/\/ws$/, (socket) => {
    const server = socket.connectToServer();
    let number = 0;
    socket.onMessage((text) => {
      const { id, method, params } = JSON.parse(text);
      if (method !== "program.path") return server.send(text);
      const frame = path.pages[params.page];
      frame?.writeUInt32LE(number, 4);
      const geometry = frame && {
        id: number,
        page: params.page,
        rapid: [],
        begins: [],
      };
      if (frame !== undefined) socket.send(frame);
      const size = {
        pages: path.pages.length,
        points: path.points,
        complete: true,
        given_up: null,
      };
      const result = {
        id: number,
        part: null,
        ...size,
        geometry: geometry ?? null,
      };
      socket.send(JSON.stringify({ jsonrpc: "2.0", id, result }));
    });
    server.onMessage((text) => {
      const named =
        typeof text === "string" && /"planned_path":(\d+)/.exec(text);
      if (named) number = Number(named[1]);
      socket.send(text);
    });
  });
}
