// The colours of the picture of a path.
import type { Colours } from '../../geometry/path_scene';
import { resolvedColours } from '../../style/resolved';

const tokens: Record<keyof Colours, string> = {
  ground: '--raised',
  line: '--line',
  feed: '--path-feed',
  arc: '--path-arc',
  rapid: '--path-rapid',
  done: '--path-done',
  tool: '--attention',
};

export const coloursOf = (place: HTMLElement): Colours => resolvedColours(place, tokens);
