// Colours of the tokens as a picture needs them: resolved for the theme that is shown.

export function resolvedColours<Name extends string>(
  place: HTMLElement,
  tokens: Record<Name, string>,
): Record<Name, string> {
  const probe = document.createElement('span');
  place.append(probe);
  const resolved = Object.entries<string>(tokens).map(([name, token]) => {
    probe.style.color = `var(${token})`;
    return [name, getComputedStyle(probe).color] as const;
  });
  probe.remove();
  return Object.fromEntries(resolved) as Record<Name, string>;
}

/** By how much everything is larger than on a usual screen: pictures are drawn in pixels of that one. */
export const magnification = (): number =>
  parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;
