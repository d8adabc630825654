// SPDX-License-Identifier: Apache-2.0
// Bundles page.html, style.css, the modules of this folder and three.js into one page.
import { readFileSync, renameSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const source = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];
const esbuild = createRequire(join(folder, 'package.json'))('esbuild');

const common = { bundle: true, minify: true, write: false, nodePaths: [join(folder, 'node_modules')] };
const text = (entry, more) =>
  esbuild.buildSync({ ...common, ...more, entryPoints: [join(source, entry)] }).outputFiles[0].text.trim();
const script = text('main.js', { format: 'iife', target: 'es2020', legalComments: 'inline' });
const style = text('style.css', {});

const page = readFileSync(join(source, 'page.html'), 'utf8')
  .replace('@STYLE@', () => style)
  .replace('@SCRIPT@', () => script);
const target = join(folder, 'preview.html');
writeFileSync(`${target}.new`, page);
renameSync(`${target}.new`, target);
