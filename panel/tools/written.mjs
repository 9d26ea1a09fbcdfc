// Writes a generated file; with --check it only says whether the file is what it should be.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';

export function write(url, text) {
  const path = fileURLToPath(url);
  if (!process.argv.includes('--check')) {
    writeFileSync(path, text);
  } else if (!existsSync(path) || readFileSync(path, 'utf8') !== text) {
    console.error(
      `${basename(path)} is not what it should be: cd panel && npm run generate && npm run build`,
    );
    process.exitCode = 1;
  }
}
