// Builds the page into dist/: static files, for any server, in any folder.
import { copyFile, mkdir, readFile, rm, writeFile } from 'node:fs/promises'
import { createRequire } from 'node:module'
import { build } from 'esbuild'
import { copyPage } from '../links.js'

const require = createRequire(import.meta.url)
const here = (path) => new URL(path, import.meta.url).pathname

await rm(here('dist'), { recursive: true, force: true })
await mkdir(here('dist'))
const { metafile } = await build({
  absWorkingDir: here('.'),
  entryPoints: ['src/main.ts', 'src/import-worker.ts', 'src/reference-worker.ts'],
  outdir: 'dist',
  bundle: true,
  format: 'esm',
  splitting: true,
  target: 'es2022',
  minify: true,
  sourcemap: false,
  metafile: true,
  legalComments: 'eof',
  logOverride: { 'ignored-bare-import': 'silent' }, // of the package's own files, which have no side effects
})
await copyPage(here('index.html'), here('dist/index.html'))
// All that the page begins with is asked for at once: the modules, and the code of WebAssembly.
const first = new Set(['dist/main.js'])
for (const file of first)
  for (const { path, kind } of metafile.outputs[file].imports)
    if (kind === 'import-statement' || file === 'dist/main.js') first.add(path)
const links = [...first].map((file) => `<link rel="modulepreload" href="${file.slice('dist/'.length)}">`)
links.push('<link rel="preload" href="lgs-islands.wasm" as="fetch" type="application/wasm" crossorigin>')
const page = await readFile(here('dist/index.html'), 'utf8')
await writeFile(here('dist/index.html'), page.replace('</head>', `${links.join('\n')}\n</head>`))
await copyFile(here('style.css'), here('dist/style.css'))
await copyFile(here('../examples/digger.js'), here('dist/digger.js')) // to be read: main.js has it within
await mkdir(here('dist/scenes'))
for (const file of ['cave.tmx', 'crate.tx', 'quarry.ldtk', 'landscape.tmx', 'landscape.tsx'])
  await copyFile(here(`../../examples/maps/${file}`), here(`dist/scenes/${file}`))
for (const file of ['lgs-islands.wasm', 'lgs-full.wasm', 'lgs-oracle.wasm'])
  await copyFile(require.resolve(`localgridseg/${file}`), here(`dist/${file}`))
