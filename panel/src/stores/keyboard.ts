// The keyboard of the page. Space holds everywhere but where text is written; buttons are pressed
// with Enter.
import { holdAll } from './acts';
import { jogging } from './jog.svelte';
import { attempt, refusals } from './refusal.svelte';
import { route } from './route.svelte';

function writesText(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement) return true;
  if (target instanceof HTMLSelectElement) return true;
  const pressed = ['button', 'checkbox', 'radio', 'range', 'submit', 'file'];
  return target instanceof HTMLInputElement && !pressed.includes(target.type);
}

// A slider has the arrow keys for itself: who moves an override must not move an axis.
function movesByArrows(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement && ['radio', 'range'].includes(target.type);
}

// The element that has the focus, inside of components with a tree of their own, too.
function focused(event: Event): EventTarget | null {
  return event.composedPath()[0] ?? event.target;
}

function help(event: KeyboardEvent): void {
  event.preventDefault();
  const place = document.activeElement?.closest('[data-help]');
  route.go('help', place instanceof HTMLElement ? (place.dataset['help'] ?? '') : route.view);
}

function onKeyDown(event: KeyboardEvent, toggleShortcuts: () => void): void {
  const writing = writesText(focused(event));
  if (event.key === 'F1') return help(event);
  if (event.key === 'Escape') {
    jogging.disarm();
    refusals.clear();
    return;
  }
  if (writing || event.ctrlKey || event.altKey || event.metaKey) return;
  if (event.key === ' ') {
    event.preventDefault();
    if (!event.repeat) void attempt(document.querySelector('.hold'), holdAll);
  } else if (event.key === '?') {
    toggleShortcuts();
  } else if (!movesByArrows(focused(event)) && jogging.keyDown(event)) {
    event.preventDefault();
  }
}

function onKeyUp(event: KeyboardEvent): void {
  if (event.key === ' ' && !writesText(focused(event))) event.preventDefault();
  jogging.keyUp(event);
}

/** Listens until the function that it gives back is called. */
export function listen(toggleShortcuts: () => void): () => void {
  const down = (event: KeyboardEvent): void => onKeyDown(event, toggleShortcuts);
  const away = (): void => jogging.release();
  window.addEventListener('keydown', down);
  window.addEventListener('keyup', onKeyUp);
  window.addEventListener('blur', away);
  window.addEventListener('pagehide', away);
  document.addEventListener('visibilitychange', away);
  return () => {
    window.removeEventListener('keydown', down);
    window.removeEventListener('keyup', onKeyUp);
    window.removeEventListener('blur', away);
    window.removeEventListener('pagehide', away);
    document.removeEventListener('visibilitychange', away);
  };
}
