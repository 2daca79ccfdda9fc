// Builds the page into dist/: static files, for any server, in any folder.
import { copyFile, mkdir, rm } from 'node:fs/promises'
import { createRequire } from 'node:module'
import { build } from 'esbuild'
import { copyPage } from '../links.js'

const require = createRequire(import.meta.url)
const here = (path) => new URL(path, import.meta.url).pathname

await rm(here('dist'), { recursive: true, force: true })
await mkdir(here('dist'))
await build({
  absWorkingDir: here('.'),
  entryPoints: ['src/main.ts', 'src/worker.ts', 'src/import-worker.ts'],
  outdir: 'dist',
  bundle: true,
  format: 'esm',
  splitting: true,
  target: 'es2022',
  minify: true,
  sourcemap: false,
  legalComments: 'eof',
  logOverride: { 'ignored-bare-import': 'silent' }, // of the package's own files, which have no side effects
})
await copyPage(here('index.html'), here('dist/index.html'))
await copyFile(here('style.css'), here('dist/style.css'))
await mkdir(here('dist/scenes'))
for (const file of ['cave.tmx', 'crate.tx', 'quarry.ldtk', 'landscape.tmx', 'landscape.tsx'])
  await copyFile(here(`../../examples/maps/${file}`), here(`dist/scenes/${file}`))
for (const file of ['lgs-islands.wasm', 'lgs-full.wasm'])
  await copyFile(require.resolve(`localgridseg/${file}`), here(`dist/${file}`))
