// After the build: refuses a page that is larger than its budget or that names a folder of the machine on which it was
// built. Counted is what a page may load while it works: of the languages one, the larger; not what reads the manual.
// usage: seal.mjs [FOLDER], dist by default
import { readdirSync, readFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { join, resolve, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const budgetBytes = 350 * 1000;
const folder = fileURLToPath(new URL('..', import.meta.url));
const dist = resolve(process.argv[2] ?? join(folder, 'dist'));

function files(at = dist) {
  return readdirSync(at, { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory() ? files(join(at, entry.name)) : [join(at, entry.name)],
  );
}

const languages = [];
let total = 0;
for (const file of files()) {
  const bytes = readFileSync(file);
  for (const place of [folder, homedir() + sep]) {
    if (place.length > 2 && bytes.includes(place)) throw new Error(`${file} names ${place}`);
  }
  if (file.endsWith('licences.txt')) continue;
  const packed = gzipSync(bytes, { level: 9 }).length;
  if (/assets.(english|russian)-/.test(file)) languages.push(packed);
  else if (!/assets.Manual-/.test(file)) total += packed;
  console.log(`${String(packed).padStart(8)}  ${file.slice(dist.length + 1)}`);
}
total += Math.max(...languages);
console.log(`${String(total).padStart(8)}  bytes gzipped of ${budgetBytes}`);
if (total > budgetBytes)
  throw new Error(`the page is larger than its budget of ${budgetBytes} bytes`);
