// Builds the article into the folder of the sandbox, which must be built before: sandbox/dist/article/. Together they
// are one site of static files.
import { copyFile, mkdir, rm } from 'node:fs/promises'
import { createRequire } from 'node:module'
import { build } from 'esbuild'
import { copyPage } from '../links.js'

const require = createRequire(import.meta.url)
const here = (path) => new URL(path, import.meta.url).pathname
const out = here('../sandbox/dist/article')

await rm(out, { recursive: true, force: true })
await mkdir(out, { recursive: true })
await build({
  absWorkingDir: here('.'),
  entryPoints: ['src/main.ts', 'src/engine-worker.ts'],
  outdir: out,
  bundle: true,
  format: 'esm',
  splitting: true,
  target: 'es2022',
  minify: true,
  sourcemap: false,
  legalComments: 'eof',
  logOverride: { 'ignored-bare-import': 'silent' }, // of the package's own files, which have no side effects
})
await copyPage(here('index.html'), `${out}/index.html`)
await copyFile(here('style.css'), `${out}/style.css`)
await copyFile(require.resolve('localgridseg/lgs.wasm'), `${out}/lgs.wasm`)
for (const file of ['reference.wasm', 'planted.wasm'])
  await copyFile(here(`../../build/web/web/wasm/${file}`), `${out}/${file}`)
