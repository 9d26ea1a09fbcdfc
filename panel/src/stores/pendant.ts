// A game controller as a pendant: while jogging is armed, an axis moves while the enabling button and a
// direction are down together. Directions are keys, not sticks: a stick that is worn moves by itself.

/** Buttons of the standard layout of the Gamepad API. */
const enabling = 0;
const directions: [button: number, word: string, direction: 1 | -1][] = [
  [12, 'Y', 1],
  [13, 'Y', -1],
  [14, 'X', -1],
  [15, 'X', 1],
  [5, 'Z', 1],
  [4, 'Z', -1],
];

export interface Buttons {
  readonly buttons: readonly { readonly pressed: boolean }[];
}

/** The direction that is asked for; null with none, with several, or without the enabling button. */
export function askedFor(
  pads: readonly (Buttons | null)[],
): [word: string, direction: 1 | -1] | null {
  const asked = pads.flatMap((pad) => {
    if (pad?.buttons[enabling]?.pressed !== true) return [];
    return directions.filter(([button]) => pad.buttons[button]?.pressed === true);
  });
  const [only, ...others] = asked;
  return only === undefined || others.length > 0 ? null : [only[1], only[2]];
}

export interface Jogged {
  press(word: string, direction: 1 | -1): void;
  release(): void;
}

/** Looks at the controllers with every picture until the function that it gives back is called. What is
    down already when it begins moves nothing: it has to be let go first. */
export function watchPendants(jogged: Jogged): () => void {
  const read = (): ReturnType<typeof askedFor> => askedFor(navigator.getGamepads());
  let last = read()?.join(' ') ?? '';
  let frame = 0;
  const look = (): void => {
    const asked = read();
    const now = asked?.join(' ') ?? '';
    if (now !== last) {
      last = now;
      jogged.release();
      if (asked !== null) jogged.press(...asked);
    }
    frame = requestAnimationFrame(look);
  };
  frame = requestAnimationFrame(look);
  return () => {
    cancelAnimationFrame(frame);
    if (last !== '') jogged.release();
  };
}
