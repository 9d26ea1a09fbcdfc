// The build: one page, hashed file names, three.js and the editor in chunks of their own that load
// when a view wants them. Nothing in the output depends on where or when it was built.
import { readFileSync, readdirSync } from 'node:fs';
import { svelte } from '@sveltejs/vite-plugin-svelte';
import type { Plugin } from 'vite';
import { defineConfig } from 'vitest/config';
import { leanThree } from './tools/lean_three';

const packageOf = (module: string): string | undefined =>
  /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(module)?.[1];

function licenceText(name: string): string {
  const home = `node_modules/${name}`;
  const { version, license } = JSON.parse(readFileSync(`${home}/package.json`, 'utf8')) as {
    version: string;
    license: string;
  };
  const file = readdirSync(home).find((entry) => /^licen[cs]e/i.test(entry));
  if (file === undefined) throw new Error(`${name} has no licence file`);
  const text = readFileSync(`${home}/${file}`, 'utf8').trim();
  return `${name} ${version} (${license})\n\n${text}\n`;
}

/** Writes licences.txt: every package whose code is in the page, with its licence. */
function licences(): Plugin {
  return {
    name: 'licences',
    generateBundle(_, bundle) {
      const modules = Object.values(bundle).flatMap((part) =>
        part.type === 'chunk' ? Object.keys(part.modules) : [],
      );
      const names = modules.map(packageOf).filter((name) => name !== undefined);
      const rule = `\n${'-'.repeat(78)}\n\n`;
      const texts = [...new Set(names)].sort().map(licenceText);
      const head = 'Packages whose code is part of this page, with their licences.\n';
      this.emitFile({
        type: 'asset',
        fileName: 'licences.txt',
        source: [head, ...texts].join(rule),
      });
    },
  };
}

const bridge = process.env['STANOK_WEB'] ?? 'http://127.0.0.1:8080';

export default defineConfig({
  plugins: [svelte(), leanThree(), licences()],
  base: './',
  build: {
    target: 'es2022',
    minify: 'terser',
    outDir: 'dist',
    emptyOutDir: true,
    // One style sheet: compressed, the small ones of the views take more.
    cssCodeSplit: false,
    sourcemap: false,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    reportCompressedSize: false,
    chunkSizeWarningLimit: 800,
    rollupOptions: {
      output: {
        // Pieces that several views share go into one of them where they are small.
        experimentalMinChunkSize: 4000,
        entryFileNames: 'assets/[name]-[hash].js',
        chunkFileNames: 'assets/[name]-[hash].js',
        assetFileNames: 'assets/[name]-[hash][extname]',
      },
    },
  },
  server: { proxy: { '/api': bridge, '/ws': { target: bridge, ws: true } } },
  test: { include: ['tests/unit/**/*.test.ts'], environment: 'node' },
});
