// Writes src/generated/codes.json from docs/reference/alarms.md, which is made from the catalogue of
// the project: [code, what, reaction, remedy, how to go on], for the help of the page.
import { readFileSync } from 'node:fs';
import { write } from './written.mjs';

const folder = new URL('..', import.meta.url);
const document = readFileSync(new URL('../docs/reference/alarms.md', folder), 'utf8');

const rows = document
  .split('\n')
  .filter((line) => /^\| [AEW]\d+ \|/.test(line))
  .map((line) =>
    line
      .slice(2, -2)
      .split(' | ')
      .map((cell) => cell.replaceAll('\\|', '|').trim()),
  )
  .map(([code, what, reaction, remedy, goOn]) => [
    code,
    what,
    Number(reaction),
    remedy,
    goOn ?? '',
  ]);

if (rows.length === 0) throw new Error('docs/reference/alarms.md has no row with a code');
write(
  new URL('src/generated/codes.json', folder),
  `[\n${rows.map((row) => `  ${JSON.stringify(row)}`).join(',\n')}\n]\n`,
);
