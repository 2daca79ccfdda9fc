// Builds dist/: the modules by esbuild, their types by tsc, and the code of WebAssembly as CMake built it
// (cmake --build --preset web).
import { build } from 'esbuild'
import { execFileSync } from 'node:child_process'
import { copyFile, mkdir, readFile, rm, writeFile } from 'node:fs/promises'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('..', import.meta.url))
const built = (preset, name) => `${root}/../../build/${preset}/web/wasm/${name}`
process.chdir(root)
await rm('dist', { recursive: true, force: true })
await mkdir('dist')
for (const name of ['lgs.wasm', 'lgs-full.wasm', 'lgs-islands.wasm']) await copyFile(built('web', name), `dist/${name}`)
await copyFile(built('web-small', 'lgs.wasm'), 'dist/lgs-small.wasm')
await copyFile(built('web-small', 'lgs-oracle.wasm'), 'dist/lgs-oracle.wasm')

/** The code of WebAssembly as text, in the place of src/wasm.ts and src/wasm-islands.ts. */
const inlined = {
  name: 'inlined',
  setup({ onLoad }) {
    onLoad({ filter: /\/wasm(-islands)?\.ts$/ }, async ({ path }) => ({
      contents: `export const wasm = '${(await readFile(built('web', path.endsWith('islands.ts') ? 'lgs-islands.wasm' : 'lgs.wasm'))).toString('base64')}'`,
    }))
  },
}

/** What a module has besides init(), the code that its init() loads, and what starts that. */
const loading = {
  index: ['lgs', "export * from './src/api.js'"],
  small: ['lgs-small', "export * from './src/api.js'"],
  full: ['lgs-full', "export * from './src/api.js'; export { importMap } from './src/maps.js'"],
  islands: ['lgs-islands', "export * from './src/islands-api.js'"],
  pieces: ['lgs-islands', "export * from './src/api.js'; export { Pieces } from './src/piece-view.js'"],
  oracle: ['lgs-oracle', "export { answer, check, outline, page } from './src/oracle-api.js'", 'oracle-api'],
}
/** Their init() elsewhere, by the conditions of package.json. Browsers see no word of Node; and Cloudflare's workers
 *  compile nothing, but import the code as a module. */
const elsewhere = {
  node: (code) => `import { readFile } from 'node:fs/promises'
    import { compile } from './src/load.js'
    export const init = (options = {}) => start(() => compile(options, () => new URL('./${code}.wasm', import.meta.url), readFile))`,
  workerd: (code) => `import code from './${code}.wasm'
    export const init = () => start(async () => code)`,
}
const conditions = {
  name: 'conditions',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^(node|workerd)\/\w+$/ }, ({ path }) => ({ path, namespace: 'conditions' }))
    onResolve({ filter: /^node:|\.wasm$/ }, ({ path }) => ({ path, external: true }))
    onLoad({ filter: /./, namespace: 'conditions' }, ({ path }) => {
      const [condition, name] = path.split('/'), [code, exports, starter = 'engine'] = loading[name]
      return { resolveDir: root, contents: `import { start } from './src/${starter}.js'\n${exports}\n${elsewhere[condition](code)}` }
    })
  },
}
const entries = ['index', 'inline', 'inline-islands', 'small', 'full', 'islands', 'pieces', 'oracle', 'trace', 'draw', 'planck', 'box2d3']
await build({
  entryPoints: [...entries.map((name) => ({ in: `src/${name}.ts`, out: name })),
    ...Object.keys(elsewhere).flatMap((condition) =>
      Object.keys(loading).map((name) => ({ in: `${condition}/${name}`, out: `${name}.${condition}` })))],
  outdir: 'dist',
  format: 'esm',
  target: 'es2022',
  bundle: true,
  splitting: true,
  minify: true,
  keepNames: true,  // a console shows them
  sourcemap: true,  // with the sources in them: who steps into the package reads TypeScript
  external: ['planck'],
  plugins: [inlined, conditions],
})
// The code of WebAssembly is no source that one steps into, and would be there twice.
for (const name of ['inline', 'inline-islands']) {
  const file = `dist/${name}.js.map`, map = JSON.parse(await readFile(file, 'utf8'))
  map.sourcesContent = map.sources.map((source, k) => (/\/wasm(-islands)?\.ts$/.test(source) ? null : map.sourcesContent[k]))
  await writeFile(file, JSON.stringify(map))
}
execFileSync(process.execPath, [fileURLToPath(import.meta.resolve('typescript/bin/tsc')), '-p', '.'], { stdio: 'inherit' })
