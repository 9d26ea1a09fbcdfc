// Several machines behind one server: which one an address means, and how their history is shown.
import { describe, expect, it } from 'vitest';
import { machineOf, pageOf } from '../../src/stores/cell.svelte';
import { columnUnit, shownValue } from '../../src/stores/history_values';
import { spoken } from '../../src/stores/spoken.svelte';
import { takeToken } from '../../src/rpc/session';

describe('the machine of a page', () => {
  it('stands in the address; without one it is the first', () => {
    expect(machineOf({ search: '' })).toBe('');
    expect(machineOf({ search: '?machine=lathe' })).toBe('lathe');
    expect(machineOf(new URL(`http://x${pageOf('mill.2')}`))).toBe('mill.2');
  });

  it('stays when the token of a link is taken out', () => {
    const seen: unknown[] = [];
    const history = { replaceState: (...all: unknown[]) => seen.push(all[2]) };
    const place = { hash: '#secret', pathname: '/', search: '?machine=lathe' };
    expect(takeToken(place as Location, history as unknown as History)).toBe('secret');
    expect(seen).toEqual(['/?machine=lathe']);
  });
});

describe('a value of the history', () => {
  const shown = (name: 'oee' | 'time_s' | 'blocks' | 'path_mm', value: number | null): string =>
    shownValue({ name, kind: 'number' }, value);

  it('has the unit of its column', async () => {
    await spoken.speak('en');
    expect([columnUnit('oee'), columnUnit('path_mm'), columnUnit('runs')]).toEqual([
      ', %',
      ', mm',
      '',
    ]);
    expect(shown('oee', 0.4567)).toBe('45.7');
    expect(shown('path_mm', 12.34)).toBe('12.3');
    expect(shown('blocks', 1200)).toBe('1200');
    expect(shown('time_s', null)).toBe('–');
  });

  it('is a moment where it is a time', () => {
    const value = shownValue(
      { name: 'ended', kind: 'time' },
      new Date(2026, 0, 2, 3, 4, 5).getTime() / 1000,
    );
    expect(value).toBe('2026-01-02 03:04:05');
  });
});
