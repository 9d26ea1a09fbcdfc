// The picture of the path stays while other views are shown: a context for drawing, its shaders and its memory
// are waited for by the thread of the page, which has hold and stop to send, and so are made once.
import { whenGraphicsStarted } from './graphics_start';
import type { Lie, PathScene, Standpoint } from './path_scene';
import type { Track } from './track';

/** Claims its place when it is asked for: browsers start to draw in any order. */
class Kept {
  #scene: PathScene | null = null;
  #isForgotten = false;
  readonly made: Promise<PathScene>;

  constructor(
    readonly planned: Track,
    readonly lie: Lie,
    create: (module: typeof import('./path_scene')) => PathScene,
  ) {
    this.made = this.#make(create);
  }

  async #make(create: (module: typeof import('./path_scene')) => PathScene): Promise<PathScene> {
    const module = await import('./path_scene');
    return whenGraphicsStarted(() => {
      if (this.#isForgotten) throw new Error('another picture is shown');
      return (this.#scene = create(module));
    });
  }

  get isLost(): boolean {
    return this.#scene?.isLost === true;
  }

  forget(): void {
    this.#isForgotten = true;
    this.#scene?.close();
  }
}

let kept: Kept | null = null;

/** Of this path: the one that was left, or another one, which is seen from `standpoint`. Throws where another one is
    asked for before it is made, and where the browser cannot draw. */
export async function pictureOf(
  planned: Track,
  traced: Track,
  lie: Lie,
  standpoint?: Standpoint,
): Promise<PathScene> {
  if (kept?.planned !== planned || kept.lie !== lie || kept.isLost) {
    forgetPicture();
    kept = new Kept(
      planned,
      lie,
      ({ PathScene }) => new PathScene(planned, traced, lie, standpoint),
    );
  }
  const mine = kept;
  try {
    return await mine.made;
  } catch (error) {
    // The next one who asks tries once more.
    if (kept === mine) kept = null;
    throw error;
  }
}

/** What is shown next is another picture, whatever it is of. */
export function forgetPicture(): void {
  kept?.forget();
  kept = null;
}
