// The picture of the path stays while other views are shown: a context for drawing, its shaders and its memory
// are waited for by the thread of the page, which has hold and stop to send, and so are made once.
import { whenGraphicsStarted } from './graphics_start';
import type { Lie, PathScene, Standpoint } from './path_scene';
import type { Track } from './track';

let kept: { scene: PathScene; planned: Track; lie: Lie } | null = null;

/** Of this path: the one that was left, or another one, which is seen from `standpoint`. */
export async function pictureOf(
  planned: Track,
  traced: Track,
  lie: Lie,
  standpoint?: Standpoint,
): Promise<PathScene> {
  const { PathScene } = await import('./path_scene');
  const isSame = () => kept?.planned === planned && kept.lie === lie && !kept.scene.isLost;
  if (!isSame())
    await whenGraphicsStarted(() => {
      if (isSame()) return;
      forgetPicture();
      kept = { scene: new PathScene(planned, traced, lie, standpoint), planned, lie };
    });
  if (kept === null) throw new Error('no picture');
  return kept.scene;
}

/** What is shown next is another picture, whatever it is of. */
export function forgetPicture(): void {
  kept?.scene.close();
  kept = null;
}
