// Writes src/generated/words.json from docs/reference/language.md, which is made from the tables of the
// language: [word, meaning, what may stand beside it], for hover, completion and help of the page.
import { readFileSync } from 'node:fs';
import { write } from './written.mjs';

const folder = new URL('..', import.meta.url);
const document = readFileSync(new URL('../docs/reference/language.md', folder), 'utf8');

function rowsOf(table) {
  const found = new RegExp(`<!-- ${table}: [^]*?<!-- end of ${table} -->`).exec(document);
  if (found === null) throw new Error(`docs/reference/language.md has no table ${table}`);
  return found[0]
    .split('\n')
    .filter((line) => line.startsWith('| ') && !/^\| (code|function|variable) \|/.test(line))
    .map((line) => line.slice(2, -1).split('|'))
    .map((cells) => cells.map((cell) => cell.trim().replaceAll('`', '')));
}

// Codes in italics are known and refused: nobody wants to be offered them.
const codes = rowsOf('codes')
  .filter(([code]) => /^[GM]/.test(code))
  .map(([code, meaning, , words]) => [code, meaning, words]);
const functions = rowsOf('functions').map(([call, result]) => {
  const [, name, rest] = /^(\w+)\s*(.*)$/.exec(call);
  return [name, result === '' ? '' : `→ ${result}`, rest];
});
const variables = rowsOf('system variables').map(([name, type, known]) => [name, type, known]);

const rows = [...codes, ...functions, ...variables];
write(
  new URL('src/generated/words.json', folder),
  `[\n${rows.map((row) => `  ${JSON.stringify(row)}`).join(',\n')}\n]\n`,
);
