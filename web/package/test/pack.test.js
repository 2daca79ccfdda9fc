// What `npm pack` makes: what is in it, and whether a project made by Vite builds and runs with it.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { browse, skip } from './browser.js'

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
  const modules = ['index', 'inline', 'full', 'islands', 'pieces', 'trace', 'draw', 'planck', 'box2d3'].map((name) => `dist/${name}`)
  const wanted = ['LICENSE', 'NOTICES.md', 'README.md', 'package.json', 'dist/lgs.wasm', 'dist/lgs-full.wasm',
    'dist/lgs-islands.wasm',
    ...modules.flatMap((name) => [`${name}.js`, `${name}.js.map`, `${name}.d.ts`])]
  for (const name of wanted) assert.ok(names.includes(name), name)
  const others = names.filter((name) => !wanted.includes(name))
  assert.deepEqual(others.filter((name) => !/^dist\/(chunk-\w+\.js(\.map)?|[\w-]+\.d\.ts)$/.test(name)), [])
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
