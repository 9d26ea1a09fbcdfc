// three.js without what the page never draws with. Its renderer refers to every material, shader, shadow and
// headset that it knows, so that none of them falls away by itself; left out here are the bodies of those
// that the path view has no use for. A shader that is used without its text does not compile, which the
// tests of the views see.
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
  };
}
