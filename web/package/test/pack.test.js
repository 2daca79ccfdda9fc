// What is published: the tarball holds what it should, and a project made by Vite builds with it. The page of that project
// runs in Chromium, in a worker too, and the same package runs under Node, where there is no window.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { existsSync, readFileSync } from 'node:fs'
import { cp, mkdtemp, mkdir, readdir, rm } from 'node:fs/promises'
import { createServer } from 'node:http'
import { tmpdir } from 'node:os'
import { extname, join } from 'node:path'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'

const path = (relative) => fileURLToPath(new URL(relative, import.meta.url))
const consumer = path('../../consumer')
const run = (folder, command, ...args) => execFileSync(command, args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] })

let folder, files
before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'lgs-pack-'))
  const [packed] = JSON.parse(run(path('..'), 'npm', 'pack', '--json', '--pack-destination', folder))
  files = packed.files.map((file) => file.path)
  // As `npm install` would unpack it. It needs no registry, since the package depends on nothing.
  const modules = join(folder, 'node_modules', 'localgridseg')
  await mkdir(modules, { recursive: true })
  run(folder, 'tar', '-xzf', packed.filename, '-C', modules, '--strip-components=1')
})
after(() => rm(folder, { recursive: true }))

test('the tarball has what is built, and no source', () => {
  const rest = files.filter((file) => !/^dist\/[\w-]+\.(js|d\.ts|wasm)$/.test(file))
  assert.deepEqual(rest.sort(), ['LICENSE', 'README.md', 'package.json'].filter((file) => file === 'package.json' || existsSync(path(`../${file}`))))
  const { exports } = JSON.parse(readFileSync(path('../package.json'), 'utf8'))
  for (const entry of Object.values(exports).flatMap((e) => (typeof e === 'string' ? e : Object.values(e))))
    assert.ok(files.includes(entry.slice(2)), `${entry} is exported, and missing`)
})

test('under Node, as a server renders pages: importing needs no window and starts nothing', () => {
  const text = `
    import * as lgs from 'localgridseg'
    import * as inline from 'localgridseg/inline'
    if (typeof window !== 'undefined') throw new Error('a window')
    for (const { init, createWorld, unitSquare } of [lgs, inline]) {
      await init()
      const world = createWorld()
      world.addPolygon(0, 0, unitSquare, 1)
      console.log(world.commit().added.length)
    }`
  assert.equal(run(folder, process.execPath, '--input-type=module', '-e', text), '4\n4\n')
})

const vite = join(consumer, 'node_modules', 'vite', 'bin', 'vite.js')
const chromium = process.env.CHROMIUM ?? '/usr/bin/chromium'
const skip = !existsSync(vite) ? 'npm ci in web/consumer installs Vite' : !existsSync(chromium) && 'there is no chromium'

test('a project made by Vite builds, and finds lgs.wasm; its page and its worker run in Chromium', { skip }, async () => {
  for (const name of ['index.html', 'main.js', 'worker.js']) await cp(join(consumer, name), join(folder, name))
  run(folder, process.execPath, vite, 'build')
  const assets = await readdir(join(folder, 'dist', 'assets'))
  assert.ok(assets.some((name) => /^lgs-.*\.wasm$/.test(name)), `no lgs.wasm in ${assets}`)

  const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' }
  const server = createServer((request, response) => {
    const file = join(folder, 'dist', request.url === '/' ? 'index.html' : request.url)
    if (!existsSync(file)) return response.writeHead(404).end()
    response.setHeader('content-type', types[extname(file)] ?? 'application/octet-stream').end(readFileSync(file))
  }).listen(0)
  await new Promise((done) => server.once('listening', done))
  const { chromium: browserType } = await import('playwright-core')
  const browser = await browserType.launch({ executablePath: chromium, args: ['--no-sandbox'] })
  try {
    const page = await browser.newPage()
    const said = []
    page.on('console', (message) => said.push(message.text()))
    page.on('pageerror', (error) => said.push(String(error)))
    await page.goto(`http://localhost:${server.address().port}/`)
    await page.waitForFunction(() => document.title.startsWith('done'), undefined, { timeout: 10_000 })
    assert.equal(await page.title(), 'done: page 4, inline 4, worker 4')
    assert.deepEqual(said, [])
  } finally {
    await browser.close()
    server.close()
  }
})
