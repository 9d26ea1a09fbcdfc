// What a page really draws: the lines that stand in the graphics memory when it asks for a picture of them, whatever
// the program of the page believes. Looks at WebGL from outside; the page has nothing for it.

/**
 * Runs in the page, before its own scripts. `window.drawnLines()` are the points of the last picture's lines, two for
 * each, `window.drawnColours()` the colours of these points ("" where a line has one of its own); `window.drawnFrom()`
 * is the matrix from their places to those before the eye.
 */
export function listenToGraphics() {
  const kept = new WeakMap(); // buffer → its bytes
  const bound = new Map(); // target → buffer
  const arrays = new WeakMap(); // vertex array → { elements, places: by location }
  const none = { elements: null, places: new Map() };
  let [array, program, lines, colours, from] = [none, null, [], [], []];
  const gl = WebGL2RenderingContext.prototype;
  const { ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER, LINES, UNSIGNED_INT } = gl;

  function around(name, note) {
    const inner = gl[name];
    gl[name] = function (...given) {
      note.apply(this, given);
      return inner.apply(this, given);
    };
  }
  const bufferOf = (target) =>
    target === ELEMENT_ARRAY_BUFFER ? array.elements : bound.get(target);
  const bytesOf = (view, from = 0, count = view.length - from) =>
    new Uint8Array(view.buffer, view.byteOffset, view.byteLength).slice(
      from * view.BYTES_PER_ELEMENT,
      (from + count) * view.BYTES_PER_ELEMENT,
    );

  around('bindVertexArray', (one) => {
    if (one !== null && !arrays.has(one)) arrays.set(one, { elements: null, places: new Map() });
    array = one === null ? none : arrays.get(one);
  });
  around('bindBuffer', (target, buffer) => {
    if (target === ELEMENT_ARRAY_BUFFER) array.elements = buffer;
    else bound.set(target, buffer);
  });
  around('bufferData', (target, view) => kept.set(bufferOf(target), bytesOf(view)));
  around('bufferSubData', (target, at, view, from, count) =>
    kept.get(bufferOf(target)).set(bytesOf(view, from, count), at),
  );
  around('vertexAttribPointer', (place) => array.places.set(place, bound.get(ARRAY_BUFFER)));
  around('useProgram', (one) => (program = one));
  around('clear', () => ([lines, colours] = [[], []]));
  around('drawElements', function (mode, count, type, offset) {
    if (mode !== LINES || type !== UNSIGNED_INT) return;
    const place = this.getAttribLocation(program, 'position');
    from = [...this.getUniform(program, this.getUniformLocation(program, 'modelViewMatrix'))];
    const points = new Float32Array(kept.get(array.places.get(place)).buffer);
    const indices = new Uint32Array(kept.get(array.elements).buffer, offset, count);
    const coloured = kept.get(array.places.get(this.getAttribLocation(program, 'color'))) ?? [];
    for (const index of indices) {
      lines.push([...points.subarray(3 * index, 3 * index + 3)]);
      colours.push(coloured.slice(3 * index, 3 * index + 3).join());
    }
  });
  window.drawnLines = () => lines;
  window.drawnColours = () => colours;
  window.drawnFrom = () => from;
}
