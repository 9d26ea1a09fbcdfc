// The colours of the tokens, as the picture needs them: resolved for the theme that is shown.
import type { Colours } from '../../geometry/path_scene';

const tokens: Record<keyof Colours, string> = {
  ground: '--raised',
  line: '--line',
  feed: '--path-feed',
  rapid: '--path-rapid',
  done: '--path-done',
  tool: '--attention',
};

export function coloursOf(place: HTMLElement): Colours {
  const probe = document.createElement('span');
  place.append(probe);
  const resolved = Object.entries(tokens).map(([name, token]) => {
    probe.style.color = `var(${token})`;
    return [name, getComputedStyle(probe).color] as const;
  });
  probe.remove();
  return Object.fromEntries(resolved) as unknown as Colours;
}
