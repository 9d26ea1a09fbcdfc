// three.js without what the page never draws with. Its renderer refers to every material, shader, shadow and
// headset that it knows, so that none of them falls away by itself; left out here are the bodies of those
// that the path view has no use for: textures, environments, shadows, headsets, and every method of a class
// whose name nothing says. A shader that is used without its text does not compile, which the tests of the
// views see.
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

/** Materials of the page: MeshBasicMaterial and LineBasicMaterial, and MeshLambertMaterial. */
const shadersKept = /\/ShaderLib\/(meshbasic|meshlambert)\.glsl\.js$/;

/** Pieces of shaders that stand between #ifdef and #endif of features that the page never switches on. */
const piecesLeftOut = new RegExp(
  String.raw`\/ShaderChunk\/(` +
    'alphahash|alphamap|aomap|batching|bumpmap|clearcoat|displacementmap|emissivemap|envmap|fog|' +
    'gradientmap|iridescence|lightmap|lightprobes|lights_phong|lights_physical|lights_toon|' +
    'lights_fragment_maps|logdepthbuf|map_|metalnessmap|morph|normal_fragment_maps|normalmap|' +
    'roughnessmap|shadowmap|shadowmask|skin|transmission)',
);

/** Modules in whose place stands as much as the renderer asks of them. */
const stands: [RegExp, string][] = [
  [
    /\/webxr\/WebXRManager\.js$/,
    `export class WebXRManager {
  enabled = false;
  isPresenting = false;
  addEventListener() {}
  removeEventListener() {}
  setAnimationLoop() {}
  getEnvironmentBlendMode() {}
  dispose() {}
}`,
  ],
  [
    /\/webgl\/WebGLShadowMap\.js$/,
    `export class WebGLShadowMap {
  enabled = false;
  render() {}
}`,
  ],
  [
    /\/webgl\/WebGLMorphtargets\.js$/,
    'export function WebGLMorphtargets() { return { update() {} }; }',
  ],
  [
    /\/webgl\/WebGLUniformsGroups\.js$/,
    'export function WebGLUniformsGroups() { return { bind() {}, update() {}, dispose() {} }; }',
  ],
  // Of textures, the renderer asks for the number of a unit, and what is bound to none.
  [
    /\/webgl\/WebGLTextures\.js$/,
    `export class WebGLTextures {
  units = 0;
  getTextureUnits() { return this.units; }
  setTextureUnits(units) { this.units = units; }
  resetTextureUnits() { this.units = 0; }
  dispose() {}
}`,
  ],
  [/\/webgl\/WebGLUtils\.js$/, 'export class WebGLUtils {}'],
  [
    /\/webgl\/WebGLEnvironments\.js$/,
    'export class WebGLEnvironments { get() { return null; } dispose() {} }',
  ],
  [/\/shaders\/DFGLUTData\.js$/, 'export function getDFGLUT() { return null; }'],
  [/\/lights\/DirectionalLightShadow\.js$/, 'export class DirectionalLightShadow { dispose() {} }'],
  // Effects behind the picture and deep colours, which need the option outputBufferType.
  [/\/webgl\/WebGLOutput\.js$/, 'export class WebGLOutput {}'],
  [/\/extras\/PMREMGenerator\.js$/, 'export class PMREMGenerator {}'],
];

const lean = (shader: string): string =>
  shader
    .replace(/\/\*[^]*?\*\//g, '')
    .replace(/\/\/.*$/gm, '')
    .replace(/[ \t]+/g, ' ')
    .replace(/\s*\n\s*/g, '\n');

const emptied = (code: string): string => code.replace(/`[^`]*`/g, '``');

function leanModule(code: string, id: string): string | null {
  const [, text] = stands.find(([name]) => name.test(id)) ?? [];
  if (text !== undefined) return text;
  if (!id.endsWith('.glsl.js')) return null;
  const isLeftOut = id.includes('/ShaderLib/') ? !shadersKept.test(id) : piecesLeftOut.test(id);
  return isLeftOut ? emptied(code) : code.replace(/`([^`]*)`/g, lean);
}

const withoutComments = (code: string): string =>
  code.replace(/\/\*[^]*?\*\//g, '').replace(/(^|\s)\/\/.*$/gm, '');

/** As three.js is written: methods of a class, and functions that a constructor gives its object. */
const methods = [
  /^\t(?:(?:static|async|get|set) )*([A-Za-z_]\w*)\([^\n]*\) \{\n(?:[^]*?\n)??\t\}\n/gm,
  /^\t\tthis\.(\w+) = (?:async )?function \([^\n]*\) \{\n(?:[^]*?\n)??\t\t\};?\n/gm,
];

function numbersOf(words: Iterable<RegExpMatchArray>, group: number): Map<string, number> {
  const numbers = new Map<string, number>();
  for (const match of words) {
    const word = match[group] ?? '';
    numbers.set(word, (numbers.get(word) ?? 0) + 1);
  }
  return numbers;
}

/** Methods whose name stands nowhere but where they are defined; a program never becomes JSON. */
function withoutUnusedMethods(chunk: string, others: string): string {
  let code = chunk;
  for (;;) {
    const before = code;
    const said = numbersOf(`${code}\n${others}`.matchAll(/\w+/g), 0);
    for (const form of methods) {
      const defined = numbersOf(before.matchAll(form), 1);
      code = code.replace(form, (text, name: string) => {
        const isUsed = (said.get(name) ?? 0) > (defined.get(name) ?? 0);
        return name === 'toJSON' || (name !== 'constructor' && !isUsed) ? '' : text;
      });
    }
    if (code === before) return code;
  }
}

export function leanThree(): Plugin {
  return {
    name: 'lean-three',
    config: () => ({
      resolve: {
        alias: [
          {
            // Its sources: what is built of them has no parts that could be left out.
            find: /^three$/,
            replacement: fileURLToPath(
              new URL('../node_modules/three/src/Three.js', import.meta.url),
            ),
          },
        ],
      },
    }),
    transform(code, id) {
      if (!id.includes('/node_modules/three/src/')) return null;
      const text = leanModule(code, id);
      return text === null ? null : { code: text, map: null };
    },
    renderChunk: {
      order: 'pre',
      handler(code, chunk, _, { chunks }) {
        if (!Object.keys(chunk.modules).some((id) => id.includes('/node_modules/three/src/')))
          return null;
        const others = Object.values(chunks)
          .filter((one) => one.fileName !== chunk.fileName)
          .flatMap((one) => Object.values(one.modules).map((module) => module.code ?? ''));
        const lean = withoutUnusedMethods(
          withoutComments(code),
          withoutComments(others.join('\n')),
        );
        return { code: lean, map: null };
      },
    },
  };
}
