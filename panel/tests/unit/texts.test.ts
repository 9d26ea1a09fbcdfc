// Both languages have the same keys, the same values to fill in, and a text for every key.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { english } from '../../src/text/english';
import { russian } from '../../src/text/russian';

const values = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).sort();

function sources(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return ['generated', 'text'].includes(entry.name) ? [] : sources(path);
    return /\.(svelte|ts)$/.test(entry.name) ? [readFileSync(path, 'utf8')] : [];
  });
}

test('the catalogues have the same keys in the same order', () => {
  expect(Object.keys(russian)).toEqual(Object.keys(english));
});

test.each(Object.keys(english) as (keyof typeof english)[])('%s', (key) => {
  expect(english[key]).not.toBe('');
  expect(russian[key]).not.toBe('');
  expect(values(russian[key])).toEqual(values(english[key]));
});

test('every key is used', () => {
  const code = sources('src').join('\n');
  const made = [...code.matchAll(/t\(`([\w.]+)\.\$\{/g)].map((match) => `${match[1]}.`);
  const topics = [...code.matchAll(/data-help="(\w+)"/g)].map((match) => `topic.${match[1]}`);
  const views = readFileSync('src/stores/route.svelte.ts', 'utf8');
  const unused = Object.keys(english).filter((key) => {
    if (code.includes(`'${key}'`) || made.some((start) => key.startsWith(start))) return false;
    return (
      !topics.includes(key) && !(key.startsWith('topic.') && views.includes(`'${key.slice(6)}'`))
    );
  });
  expect(unused).toEqual([]);
});

test('no text stands in a component instead of the catalogue', () => {
  const strays = sources('src').flatMap((code) => {
    const markup = code.replace(
      /<script[\s\S]*?<\/script>|<style[\s\S]*?<\/style>|<!--[\s\S]*?-->/g,
      '',
    );
    if (markup === code) return [];
    return [...markup.matchAll(/>\s*([A-Z][a-z]{3,}[^<>{}]*)</g)].map((match) => match[1]);
  });
  expect(strays).toEqual([]);
});

test('units are in the catalogues, too', () => {
  const written = /\} (?:s|ms|mm|µm|kB|MB|B|N|W|Hz|min)(?=[<`'"]|\{)/;
  const found = sources('src').flatMap((code) =>
    code.split('\n').filter((line) => written.test(line)),
  );
  expect(found).toEqual([]);
});
