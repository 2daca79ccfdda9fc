// What `npm pack` makes: what is in it, and whether a project made by Vite builds and runs with it.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { browse, skip, visit } from './browser.js'

const here = (path) => fileURLToPath(new URL(path, import.meta.url))
const run = (program, ...args) => execFileSync(program, args, { encoding: 'utf8', cwd: here('..'), stdio: ['ignore', 'pipe', 'pipe'] })
let folder, packed

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'lgs-pack-'))
  packed = JSON.parse(run('npm', 'pack', '--json', '--pack-destination', folder))[0]
  run('tar', '-xf', join(folder, packed.filename), '-C', folder)
})
after(() => rmSync(folder, { recursive: true }))

test('the package holds what it should, and nothing else', () => {
  const names = packed.files.map(({ path }) => path)
  const modules = ['index', 'inline', 'inline-islands', 'small', 'full', 'islands', 'pieces', 'oracle', 'trace', 'draw', 'planck', 'box2d3']
  const wanted = ['LICENSE', 'NOTICES.md', 'README.md', 'package.json', 'dist/lgs.wasm', 'dist/lgs-small.wasm',
    'dist/lgs-full.wasm', 'dist/lgs-islands.wasm', 'dist/lgs-oracle.wasm',
    ...modules.flatMap((name) => [`dist/${name}.js`, `dist/${name}.js.map`, `dist/${name}.d.ts`]),
    ...['index', 'small', 'full', 'islands', 'pieces', 'oracle'].flatMap((name) => ['node', 'workerd'].flatMap((where) =>
      [`dist/${name}.${where}.js`, `dist/${name}.${where}.js.map`]))]
  for (const name of wanted) assert.ok(names.includes(name), name)
  const others = names.filter((name) => !wanted.includes(name))
  assert.deepEqual(others.filter((name) => !/^dist\/(chunk-\w+\.js(\.map)?|[\w-]+\.d\.ts)$/.test(name)), [])
  const bytes = (pattern) => packed.files.filter(({ path }) => pattern.test(path)).reduce((sum, { size }) => sum + size, 0)
  assert.ok(bytes(/\.map$/) < 0.15 * bytes(/./), `${bytes(/\.map$/)} bytes of ${bytes(/./)} are maps of sources`)
})

test('what a module does not need is no error: subpaths where `exports` is not known, require() where Node can', () => {
  const project = join(folder, 'plain'), put = (name, text) => writeFileSync(join(project, name), text)
  mkdirSync(join(project, 'node_modules/localgridseg'), { recursive: true })
  run('tar', '-xf', join(folder, packed.filename), '-C', join(project, 'node_modules/localgridseg'), '--strip-components=1')
  put('package.json', '{ "type": "commonjs" }')
  put('old.ts', `import { createWorld, type World } from 'localgridseg'
    import { Islands } from 'localgridseg/islands'
    import { init } from 'localgridseg/inline-islands'
    import { outline } from 'localgridseg/oracle'
    import { parseTrace } from 'localgridseg/trace'
    export const all = [init, Islands, outline, parseTrace, (): World => createWorld()]`)
  const tsc = fileURLToPath(import.meta.resolve('typescript/bin/tsc'))
  execFileSync(process.execPath, [tsc, '--noEmit', '--strict', '--module', 'es2022', '--moduleResolution', 'node10', '--target', 'es2022',
    '--lib', 'es2022,dom,esnext.disposable', '--ignoreDeprecations', '5.0', 'old.ts'], { cwd: project, encoding: 'utf8', stdio: ['ignore', 'inherit', 'inherit'] })
  put('game.js', `const { init, createWorld, unitSquare } = require('localgridseg')
    init().then(() => { const world = createWorld(); world.add(0, 0, world.shape(unitSquare), 1); console.log(world.commit().added.length) })`)
  if (process.features.require_module) assert.equal(execFileSync(process.execPath, ['--no-warnings', 'game.js'], { cwd: project, encoding: 'utf8' }), '4\n')
})

test("Cloudflare's workers import the code, and compile nothing", async () => {
  const { build } = await import('esbuild')
  const asModule = { name: 'wasm', setup({ onLoad }) {
    onLoad({ filter: /\.wasm$/ }, ({ path }) => ({ contents: `export default globalThis.compiled[${JSON.stringify(path)}] ?? '${path}'` }))
  } }
  for (const name of ['localgridseg', 'localgridseg/small', 'localgridseg/full', 'localgridseg/islands', 'localgridseg/pieces']) {
    const { outputFiles: [{ text }] } = await build({ stdin: { resolveDir: here('.'), contents: `export { init, createWorld } from '${name}'` },
      bundle: true, write: false, format: 'esm', conditions: ['workerd'], plugins: [asModule], logLevel: 'error' })
    const [, path] = /"(\/[^"]*\.wasm)"/.exec(text)
    globalThis.compiled = { [path]: await WebAssembly.compile(readFileSync(path)) }
    const { compile } = WebAssembly
    WebAssembly.compile = WebAssembly.compileStreaming = () => { throw new Error('blocked by the embedder') }
    try {
      const { init, createWorld } = await import(`data:text/javascript,${encodeURIComponent(text)}`)
      await init()
      createWorld().free()
    } finally {
      Object.assign(WebAssembly, { compile })
    }
  }
})

test('a project made by Vite builds, finds the code of WebAssembly, and runs, in a worker too', { skip }, async () => {
  const project = join(folder, 'project')
  cpSync(here('consumer'), project, { recursive: true })
  mkdirSync(join(project, 'node_modules'))
  renameSync(join(folder, 'package'), join(project, 'node_modules/localgridseg'))
  const { build } = await import('vite')
  await build({ root: project, logLevel: 'error', build: { target: 'es2022' }, worker: { format: 'es' } })
  const assets = readdirSync(join(project, 'dist/assets'))
  assert.ok(assets.some((name) => /^lgs-.*\.wasm$/.test(name)), assets.join())
  const said = await browse(pathToFileURL(`${project}/dist/`), 'index.html', async (page) => {
    await page.waitForSelector('body[data-worker]', { state: 'attached' })
    assert.deepEqual(await page.evaluate('[document.body.dataset.page, document.body.dataset.worker]'), ['4', '4'])
  })
  assert.deepEqual(said, [])
})

test("Vite's development server serves it, as the README says", async () => {
  const project = join(folder, 'develop')
  cpSync(here('consumer'), project, { recursive: true })
  mkdirSync(join(project, 'node_modules/localgridseg'), { recursive: true })
  run('tar', '-xf', join(folder, packed.filename), '-C', join(project, 'node_modules/localgridseg'), '--strip-components=1')
  const [, text] = /```js\nexport default (\{.*\})  \/\/ vite.config.js/.exec(readFileSync(here('../README.md'), 'utf8'))
  const { createServer } = await import('vite')
  const { optimizeDeps } = Function(`return ${text}`)()
  const server = await createServer({ root: project, configFile: false, logLevel: 'error', optimizeDeps, server: { port: 0 } })
  try {
    await server.listen()
    const get = (path) => fetch(new URL(path, `http://localhost:${server.httpServer.address().port}`))
    const [, module] = /from "([^"]*localgridseg[^"]*)"/.exec(await (await get('/main.js')).text())
    const [, wasm] = /new URL\("([^"]*lgs\.wasm)"/.exec(await (await get(module)).text())
    assert.equal((await get(new URL(wasm, `http://localhost${module}`).pathname)).headers.get('content-type'), 'application/wasm')
  } finally {
    await server.close()
  }
})

test("and with nothing said, where it moves modules and finds a page in the place of the code", { skip }, async () => {
  const project = join(folder, 'moved')
  cpSync(here('consumer'), project, { recursive: true })
  mkdirSync(join(project, 'node_modules/localgridseg'), { recursive: true })
  run('tar', '-xf', join(folder, packed.filename), '-C', join(project, 'node_modules/localgridseg'), '--strip-components=1')
  const { createLogger, createServer } = await import('vite'), warnings = []
  const server = await createServer({ root: project, configFile: false, server: { port: 0 }, optimizeDeps: { include: ['localgridseg', 'localgridseg/full'] }, customLogger: { ...createLogger('silent'), warn: (text) => warnings.push(text) } })
  try {
    await server.listen()
    const address = `http://localhost:${server.httpServer.address().port}/`
    assert.match(await (await fetch(`${address}main.js`)).text(), /\.vite\/deps\/localgridseg/)
    const said = await visit(address, async (page) => {
      await page.waitForSelector('body[data-worker]', { state: 'attached' })
      assert.deepEqual(await page.evaluate('[document.body.dataset.page, document.body.dataset.worker]'), ['4', '4'])
    })
    assert.deepEqual([...said.filter((line) => !line.startsWith('[vite]')), ...warnings], [])
  } finally {
    await server.close()
  }
})
