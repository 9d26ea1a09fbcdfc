// Several machines behind one server: which one an address means, and how their history is shown.
import { describe, expect, it } from 'vitest';
import { machineOf, pageOf, withMotion, type Glance } from '../../src/stores/cell.svelte';
import { columnUnit, shownValue } from '../../src/stores/history_values';
import { stateOf, whyStands } from '../../src/stores/acts';
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

describe('what a channel of the cell is doing', () => {
  const seen = (cycle: number, X: number, more: object = {}): Glance => {
    const channel = { id: 1, state: 'Active', program_status: 'Running', cycle, position: { X } };
    return {
      id: 'mill',
      answers: true,
      on: true,
      channels: [{ ...channel, ...more }],
    } as Glance & {
      channels: object[];
    };
  };
  const stands = (...glances: Glance[]): boolean | undefined =>
    glances.reduce<Glance | undefined>((before, now) => withMotion(now, before), undefined)
      ?.channels[0]?.stands;

  it('is that of the motion: an override of 0 % lets nothing move', async () => {
    await spoken.speak('en');
    const held = { speed_mm_s: 0, g_codes: ['G1'], words: ['X'] };
    const [channel] = seen(1, 0, {
      ...held,
      override: { feed: 0, rapid: 100, spindle: 100 },
    }).channels;
    expect(channel && stateOf(channel, true)).toBe('standing');
    expect(channel && whyStands(channel)).toBe('nothing moves: feed override 0 %');
    const [other] = seen(1, 0, {
      ...held,
      override: { feed: 100, rapid: 0, spindle: 100 },
    }).channels;
    expect(other && stateOf(other, true)).toBe('running');
  });

  it('stands where the axes are as they were when it was seen before', () => {
    expect(stands(seen(1, 0))).toBe(false);
    expect(stands(seen(1, 0), seen(900, 0.1))).toBe(false);
    expect(stands(seen(1, 0), seen(900, 0))).toBe(true);
    expect(stands(seen(1, 0), seen(900, 0), seen(1800, 0.1))).toBe(false);
  });

  it('is not known from the same look twice', () => {
    expect(stands(seen(1, 0), seen(1, 0))).toBe(false);
    expect(stands(seen(1, 0), seen(900, 0), seen(900, 0))).toBe(true);
  });

  it('of a server that says no more it is as ever', () => {
    const old = { cycle: undefined, position: undefined };
    expect(stands(seen(1, 0, old), seen(2, 0, old))).toBe(false);
  });
});
