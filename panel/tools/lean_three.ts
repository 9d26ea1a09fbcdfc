// three.js and CodeMirror without what the page never uses. The renderer of three.js refers to every material,
// shader, shadow and headset that it knows, so that none of them falls away by itself; left out here are the
// bodies of those that the path view has no use for: textures, environments, shadows, headsets. Of both are left out
// the methods that nothing in the page could call. A shader that is used without its text does not compile,
// which the tests of the views see.
import { fileURLToPath } from 'node:url';
import { parseAst, type Plugin } from 'vite';

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

/** Packages whose classes have more methods than the page calls. */
const trimmed = /\/node_modules\/(three\/src|@codemirror|@lezer)\//;

interface Node {
  type: string;
  start: number;
  end: number;
}
type Named = Node & { name?: string; value?: unknown };

/** What takes a name with it that only others say: a method, or a function that a constructor gives its object. */
interface Method {
  name: string;
  start: number;
  end: number;
  says: Set<string>;
}

/** Names of methods that a browser or the language calls, and of one that nobody does: nothing here becomes JSON. */
const saidElsewhere = ['constructor', 'toString', 'valueOf', 'handleEvent'];
const neverSaid = 'toJSON';

const isNode = (value: unknown): value is Node =>
  typeof value === 'object' && value !== null && 'type' in value;

const childrenOf = (node: Node): Node[] => Object.values(node).flat().filter(isNode);

const part = (node: Node, name: string): Named | undefined =>
  (node as unknown as Record<string, Named | undefined>)[name];

const isComputed = (node: Node): boolean => (node as { computed?: boolean }).computed === true;

function methodName(node: Node): string | undefined {
  if (node.type === 'MethodDefinition')
    return isComputed(node) ? undefined : part(node, 'key')?.name;
  if (node.type !== 'ExpressionStatement') return undefined;
  const [to, value] = ['left', 'right'].map((side) => {
    const expression = part(node, 'expression');
    return expression?.type === 'AssignmentExpression' ? part(expression, side) : undefined;
  });
  const isOwn = to !== undefined && part(to, 'object')?.type === 'ThisExpression';
  return isOwn && !isComputed(to) && value?.type === 'FunctionExpression'
    ? part(to, 'property')?.name
    : undefined;
}

/** The names that a node itself says of what others have: `.name`, `{ name } = `, and every text. */
function namesIn(node: Named): string[] {
  if (node.type === 'MemberExpression' && !isComputed(node))
    return [part(node, 'property')?.name ?? ''];
  if (node.type === 'ObjectPattern')
    return childrenOf(node).map((one) => part(one, 'key')?.name ?? '');
  return node.type === 'Literal' ? [String(node.value)] : [];
}

/** Takes in the names of a program: those of each method apart from what is said in any case. */
function gather(node: Node, says: Set<string>, methods: Method[]): void {
  const name = methodName(node);
  const isMethod = name !== undefined && !saidElsewhere.includes(name);
  const own = isMethod ? new Set<string>() : says;
  if (isMethod) methods.push({ name, start: node.start, end: node.end, says: own });
  for (const one of namesIn(node)) own.add(one);
  // The name under which a method is given to an object is no use of it.
  const inner = isMethod && node.type !== 'MethodDefinition' ? part(node, 'expression') : node;
  const value = inner === node || inner === undefined ? inner : part(inner, 'right');
  if (value !== undefined) childrenOf(value).forEach((child) => gather(child, own, methods));
}

/** Methods whose name nothing says that could be reached. */
export function withoutUnusedMethods(chunk: string, others: string[]): string {
  const said = new Set<string>();
  const methods: Method[] = [];
  const elsewhere: Method[] = [];
  gather(parseAst(chunk), said, methods);
  for (const code of others) gather(parseAst(code), said, elsewhere);
  said.delete(neverSaid);
  let waiting = [...methods, ...elsewhere];
  for (;;) {
    const reached = waiting.filter(({ name }) => said.has(name));
    if (reached.length === 0) break;
    waiting = waiting.filter(({ name }) => !said.has(name));
    for (const { says } of reached)
      says.forEach((name) => (name === neverSaid ? undefined : said.add(name)));
  }
  // What lies within another goes with it.
  const unused = methods.filter((one) => waiting.includes(one));
  let [lean, end] = ['', 0];
  for (const one of unused.sort((a, b) => a.start - b.start)) {
    if (one.start < end) continue;
    lean += chunk.slice(end, one.start);
    end = one.end;
  }
  return lean + chunk.slice(end);
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
        if (!Object.keys(chunk.modules).some((id) => trimmed.test(id))) return null;
        const others = Object.values(chunks)
          .filter((one) => one.fileName !== chunk.fileName)
          .flatMap((one) => Object.values(one.modules).map((module) => module.code ?? ''));
        return { code: withoutUnusedMethods(code, others), map: null };
      },
    },
  };
}
