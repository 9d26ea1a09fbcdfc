// The session with stanok-web: a one-time link, or a name and a password, for a cookie and a key.
//
// The browser sends the cookie to every port of the host; the key stays in the storage of this
// origin, is a field of each question and the first message of each WebSocket. A wrong one ends the
// session. Read anew each time: another tab may have signed in.

export interface Session {
  name: string;
  role: string;
  machine: string;
}

export type Entry = 'entered' | 'wrong' | 'busy' | 'no_server';

const keyName = 'stanok-session-key';

const sessionKey = (): string => localStorage.getItem(keyName) ?? '';

/** What a question to the server shows. */
export const sessionFields = (): Record<string, string> => ({ 'x-stanok-key': sessionKey() });

/** The first message of a WebSocket. */
export const keyMessage = (): string =>
  JSON.stringify({ jsonrpc: '2.0', method: 'session.key', params: { key: sessionKey() } });

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
  if (!answer.ok) return 'wrong';
  localStorage.setItem(keyName, ((await answer.json()) as { key: string }).key);
  return 'entered';
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
  await fetch('/api/session', { method: 'DELETE', headers: sessionFields() });
  localStorage.removeItem(keyName);
}

export type SessionAnswer = Session | 'signed_out' | 'no_server';

// A network that swallows the question would keep the page from connecting again.
const patience_ms = 4000;

export async function currentSession(): Promise<SessionAnswer> {
  try {
    const signal = AbortSignal.timeout(patience_ms);
    const answer = await fetch('/api/session', { headers: sessionFields(), signal });
    if (answer.status === 401 || answer.status === 403) return 'signed_out';
    return answer.ok ? ((await answer.json()) as Session) : 'no_server';
  } catch {
    return 'no_server';
  }
}
