// dist/: a page for each program of browsers. Those whose packages are not installed are left out, which is said.
import { build } from 'esbuild'
import { copyFile, mkdir, rm, writeFile } from 'node:fs/promises'
import { fileURLToPath } from 'node:url'

const here = fileURLToPath(new URL('.', import.meta.url)), dist = `${here}dist`
const isThere = (name) => {
  try {
    return Boolean(import.meta.resolve(name))
  } catch {
    return false
  }
}
const pages = ['canvas', 'worker', ...['pixi', 'phaser'].filter((name) => isThere(name === 'pixi' ? 'pixi.js' : name))]
await rm(dist, { recursive: true, force: true })
await mkdir(dist)
await build({
  entryPoints: [...pages, 'ground'].map((name) => `${here}${name}.js`),
  outdir: dist, bundle: true, format: 'esm', target: 'es2022', minify: true, logLevel: 'warning',
})
await copyFile(fileURLToPath(import.meta.resolve('localgridseg/lgs.wasm')), `${dist}/lgs.wasm`)
for (const name of pages)
  await writeFile(`${dist}/${name}.html`, `<!doctype html>\n<meta charset="utf-8">\n<title>${name}</title>\n<body><script type="module" src="${name}.js"></script></body>\n`)
console.log(`dist/: ${pages.join(', ')}`)
