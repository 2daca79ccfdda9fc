// Each program runs. Those of browsers show ground, and less of it after a click.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import { createRequire } from 'node:module'
import { before, test } from 'node:test'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { browse, skip, visit } from '../package/test/browser.js'

const here = fileURLToPath(new URL('.', import.meta.url))
const run = (name) => execFileSync(process.execPath, [`${here}${name}`], { encoding: 'utf8' })

test('Node: a world is saved, loaded and dug', () => {
  const [first, ...segments] = run('node.js').trimEnd().split('\n')
  assert.match(first, /^2 cells are empty, \d+ are cut$/)
  assert.ok(segments.length > 8 && segments.every((line) => line.startsWith('block 1: ')))
})
for (const name of ['planck.js', 'box2d3.js'])
  test(`${name}: ground goes and comes back, and nobody is lost`, () => {
    const [, caught, left] = run(name).trimEnd().split('\n')
    assert.ok(parseInt(caught) > 0, caught)
    assert.match(left, /^10 of 10 /)
  })

before(() => run('build.js'))
for (const name of ['canvas', 'worker', 'pixi', 'phaser'])
  test(`${name}: a click digs`, { skip }, async (t) => {
    if (!existsSync(`${here}dist/${name}.html`)) return t.skip('npm install has not been run here')
    await browse(pathToFileURL(`${here}dist/`), `${name}.html`, async (page) => {
      await page.waitForSelector('body[data-ready]', { timeout: 60_000 })
      const picture = async () => {
        await page.waitForTimeout(500)
        return page.locator('canvas').screenshot()
      }
      const full = await picture()
      await page.locator('canvas').click({ position: { x: 320, y: 160 } })
      const dug = await picture()
      if (process.env.LGS_PICTURES) await page.screenshot({ path: `${process.env.LGS_PICTURES}/${name}.png` })
      assert.ok(!full.equals(dug))
    })
  })

test('vite: a digger in strict TypeScript, built and served by Vite 8 with its defaults, without a warning', { skip }, async (t) => {
  const require = createRequire(import.meta.url), root = `${here}vite`
  const vite = await import('vite').catch(() => null)
  if (vite === null) return t.skip('npm install has not been run here')
  execFileSync(process.execPath, [require.resolve('typescript/bin/tsc'), '-p', root], { stdio: ['ignore', 'inherit', 'inherit'] })
  const warnings = [], warn = (text) => warnings.push(text)
  const options = { root, configFile: false, customLogger: { ...vite.createLogger('silent'), warn, warnOnce: warn } }
  await vite.build({ ...options, build: { outDir: `${here}dist/vite`, emptyOutDir: true } })
  const plays = async (page) => {
    await page.waitForSelector('body[data-rocks="0"]')
    await page.mouse.move(100, 600)
    await page.mouse.down()
    const { height } = await page.locator('canvas').boundingBox()
    for (let k = 0; k <= 8; ++k) await page.mouse.move(24 * (4.5 + 3 * k / 8), height - 24 * 12)
    await page.waitForSelector('body[data-rocks="1"]')
    await page.mouse.up()
    for (let k = 0; k < 12; ++k) await page.keyboard.press('z')
    await page.waitForSelector('body[data-rocks="0"]')
  }
  const said = []
  for (const start of [vite.createServer, vite.preview]) {
    const server = await start({ ...options, server: { port: 0 }, preview: { port: 0 }, build: { outDir: `${here}dist/vite` } })
    if (start === vite.createServer) await server.listen()
    try {
      said.push(...(await visit(server.resolvedUrls.local[0], plays)))
    } finally {
      await server.close()
    }
  }
  assert.deepEqual([...said.filter((line) => !line.startsWith('[vite]')), ...warnings], [])
})
