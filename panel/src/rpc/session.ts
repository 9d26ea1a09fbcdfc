// The session with stanok-web: a one-time link, or a name and a password, for a cookie.

export interface Session {
  name: string;
  role: string;
  machine: string;
}

export type Entry = 'entered' | 'wrong' | 'busy' | 'no_server';

async function post(body: object): Promise<Entry> {
  try {
    return await ask(body);
  } catch {
    return 'no_server';
  }
}

// While another login from the same place is under way the server says so with 429.
async function ask(body: object): Promise<Entry> {
  const answer = await fetch('/api/session', {
    method: 'POST',
    headers: { 'content-type': 'application/json' },
    body: JSON.stringify(body),
  });
  if (answer.status === 429) return 'busy';
  return answer.ok ? 'entered' : 'wrong';
}

/** The token of a one-time link stands behind # and is taken out of the address at once. */
export function takeToken(place: Location, history: History): string | null {
  const hash = place.hash.slice(1);
  if (hash === '' || hash.startsWith('/')) return null;
  history.replaceState(null, '', place.pathname + place.search);
  return hash;
}

export const signInByToken = (token: string): Promise<Entry> => post({ token });
export const signIn = (name: string, password: string): Promise<Entry> => post({ name, password });

export async function signOut(): Promise<void> {
  await fetch('/api/session', { method: 'DELETE' });
}

export type SessionAnswer = Session | 'signed_out' | 'no_server';

// A network that swallows the question would keep the page from connecting again.
const patience_ms = 4000;

export async function currentSession(): Promise<SessionAnswer> {
  try {
    const answer = await fetch('/api/session', { signal: AbortSignal.timeout(patience_ms) });
    if (answer.status === 401 || answer.status === 403) return 'signed_out';
    return answer.ok ? ((await answer.json()) as Session) : 'no_server';
  } catch {
    return 'no_server';
  }
}
