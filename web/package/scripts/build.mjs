// Builds dist/: the modules by esbuild, their types by tsc, and the code of WebAssembly as CMake built it
// (cmake --build --preset web).
import { build } from 'esbuild'
import { execFileSync } from 'node:child_process'
import { copyFile, mkdir, readFile, rm } from 'node:fs/promises'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('..', import.meta.url))
const built = `${root}/../../build/web/web/wasm`
process.chdir(root)
await rm('dist', { recursive: true, force: true })
await mkdir('dist')
for (const name of ['lgs.wasm', 'lgs-full.wasm', 'lgs-islands.wasm']) await copyFile(`${built}/${name}`, `dist/${name}`)

/** The code of WebAssembly as text, in the place of src/wasm.ts. */
const inlined = {
  name: 'inlined',
  setup({ onLoad }) {
    onLoad({ filter: /\/wasm\.ts$/ }, async () => ({
      contents: `export const wasm = '${(await readFile(`${built}/lgs.wasm`)).toString('base64')}'`,
    }))
  },
}
await build({
  entryPoints: ['index', 'inline', 'full', 'islands', 'pieces', 'trace', 'draw', 'planck', 'box2d3'].map((name) => `src/${name}.ts`),
  outdir: 'dist',
  format: 'esm',
  target: 'es2022',
  bundle: true,
  splitting: true,
  minify: true,
  sourcemap: true,  // with the sources in them: who steps into the package reads TypeScript
  external: ['planck'],
  plugins: [inlined],
})
execFileSync(process.execPath, [fileURLToPath(import.meta.resolve('typescript/bin/tsc')), '-p', '.'], { stdio: 'inherit' })
