// Which view is shown: #/machine, #/help/E6070. The part behind the view is the view's own.
export const views = [
  'machine',
  'cell',
  'path',
  'programs',
  'tools',
  'drives',
  'scope',
  'process',
  'history',
  'help',
] as const;
export type View = (typeof views)[number];

// What no address can mean is taken as it stands.
function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

class Route {
  view = $state<View>('machine');
  rest = $state('');

  read(hash: string): void {
    const [first, ...rest] = hash.replace(/^#?\/?/, '').split('/');
    this.view = views.find((one) => one === first) ?? 'machine';
    this.rest = decoded(rest.join('/'));
  }

  go(view: View, rest = ''): void {
    location.hash = rest === '' ? `#/${view}` : `#/${view}/${encodeURIComponent(rest)}`;
  }
}

export const route = new Route();
