// Where the page begins: signs in with the token of a one-time link, then shows the panel.
import { mount } from 'svelte';
import App from './App.svelte';
import { signInByToken, takeToken } from './rpc/session';
import { route } from './stores/route.svelte';
import { settings } from './stores/settings.svelte';
import { spoken } from './stores/spoken.svelte';
import { store } from './stores/machine.svelte';
import './style/tokens.css';
import './style/base.css';

// A link may be opened in a tab that shows the page already: then only the part behind # changes.
async function enter(): Promise<void> {
  const token = takeToken(location, history);
  route.read(location.hash);
  if (token === null) return;
  if ((await signInByToken(token)) === 'entered') store.reconnect();
}

async function begin(): Promise<void> {
  await enter();
  window.addEventListener('hashchange', () => void enter());
  store.start();
}

async function show(): Promise<void> {
  // Hold and stop are there even where no text has come.
  await spoken.speak(settings.language).catch(() => undefined);
  const place = document.getElementById('panel');
  if (place !== null) mount(App, { target: place });
}

void show();
void begin();
