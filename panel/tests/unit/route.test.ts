// The address of a view, also where a person or another program wrote it.
import { expect, test } from 'vitest';
import { route } from '../../src/stores/route.svelte';

test('view and what stands behind it', () => {
  route.read('#/programs/sub%2Fa%20b.nc%3A12');
  expect([route.view, route.rest]).toEqual(['programs', 'sub/a b.nc:12']);
  route.read('#/nowhere');
  expect([route.view, route.rest]).toEqual(['machine', '']);
});

test('an address that is none shows the view all the same', () => {
  route.read('#/help/%E0%A4%A');
  expect([route.view, route.rest]).toEqual(['help', '%E0%A4%A']);
});
