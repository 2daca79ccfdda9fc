// The scenes of the menu, and their code. In a real browser; the build must be there: npm run build -w sandbox
import assert from 'node:assert/strict'
import { execFile } from 'node:child_process'
import { writeFile } from 'node:fs/promises'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'
import { build } from 'esbuild'
import { openBrowser } from './browser.js'

const here = (path) => fileURLToPath(new URL(path, import.meta.url))
let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

const names = ['hills', 'cave', 'quarry', 'tiled', 'platforms', 'materials', 'million']

test('all tools show where to dig, until somebody does', () =>
  browser.onPath(async (page) => {
    await page.locator('#dig-more').click()
    await page.waitForFunction(() => window.sandbox.game !== undefined)
    const asks = () => page.evaluate(() => window.sandbox.viewer.invitation)
    const [x, y] = await asks(), at = await page.evaluate(([x, y]) => window.sandbox.toPage(x, y), [x, y])
    await page.mouse.move(at.x - 12, at.y)
    await page.mouse.down()
    await page.mouse.move(at.x + 12, at.y, { steps: 4 })
    await page.mouse.up()
    await page.waitForFunction(() => window.sandbox.game.rocks.of(window.sandbox.game.sides[0]).length === 1)
    assert.equal(await asks(), null)
  }, ''))

test('the menu says which scene is open', () =>
  browser.onPage(async (page) => {
    const shown = () => page.evaluate(() => document.querySelector('#scene').selectedOptions[0].textContent)
    assert.equal(await shown(), 'Hills')
    await page.locator('#scene').selectOption('cave')
    await page.waitForFunction(() => window.sandbox.game.ground.world.bounds().i0 === 0)
    assert.match(await shown(), /^Cave/)
    // Who is in the cave has the cave's roof above.
    const below = await page.evaluate(() => {
      const { game } = window.sandbox, { world } = game.ground, top = world.bounds().j1 + 1
      const hasRoof = ({ start: { x, y } }) => world.rayCast(x, y, x, top) !== null
      return game.sides[0].riders.filter(hasRoof).length / game.sides[0].riders.length
    })
    assert.equal(below, 1)
  }))

test('each scene opens, rolls, and has its code beside it', () =>
  browser.onPage(async (page) => {
    for (const name of names) {
      const before = await page.evaluate(() => window.sandbox.game.ground.document === window.last)
      assert.equal(before, false)
      await page.evaluate(() => (window.last = window.sandbox.game.ground.document))
      await page.locator('#scene').selectOption(name === 'hills' ? 'anew' : name)
      await page.waitForFunction(() => window.sandbox.game.ground.document !== window.last)
      await page.evaluate(() => window.sandbox.step(60))
      const stats = await page.evaluate(() => window.sandbox.game.ground.world.stats())
      assert.ok(stats.segments > 10, name)
      if (name === 'million') assert.ok(stats.cells > 990_000)
      if (name === 'hills') await page.locator('#show-code').check()
      assert.match(await page.locator('#code pre').textContent(), /createWorld\(/)
      await page.locator('input[name=language][value=cpp]').check()
      assert.match(await page.locator('#code pre').textContent(), /#include <lgs\//)
      await page.locator('input[name=language][value=js]').check()
    }
  }))

test('a conveyor carries a box along, ice does not', () =>
  browser.onPage(async (page) => {
    await page.locator('#scene').selectOption('materials')
    await page.waitForFunction(() => window.sandbox.game.sides[0].riders.length === 7)
    const moved = await page.evaluate(() => {
      const { game, step } = window.sandbox
      game.removeRiders()
      for (const x of [9, 23]) game.drop({ kind: 'box', x, y: 2.5, speed: 0, size: 0.4, colour: 0, stays: true })
      step(90)
      return game.sides[0].riders.map(({ bodies }, k) => 4 * bodies[0].getPosition().x - [9, 23][k])
    })
    assert.ok(Math.abs(moved[0]) < 0.1 && moved[1] > 1, `${moved}`)
  }))

test('the JavaScript beside the scenes runs', async () => {
  const codes = await loadCodes()
  assert.deepEqual(Object.keys(codes), names)
  for (const name of names) {
    assert.ok(codes[name].js.split('\n').length <= 20 && codes[name].cpp.split('\n').length <= 22, `${name} is short`)
    const file = here(`../dist/code-${name}.mjs`)
    await writeFile(file, codes[name].js)
    const { stdout } = await promisify(execFile)(process.execPath, [file], { cwd: here('../../../examples/maps') })
    assert.match(stdout, /^\d+ removed, [1-9]\d* added/, name)
  }
})

// The compiler only looks at it; native tests link the same calls. It is left out where there is no compiler.
test('the C++ beside the scenes compiles', async (t) => {
  const run = promisify(execFile)
  try {
    await run('c++', ['--version'])
  } catch {
    return t.skip('there is no c++')
  }
  const includes = ['lib/include', 'lib/brush/include', 'addons/tiled/include'].map((folder) => `-I${here(`../../../${folder}`)}`)
  const codes = await loadCodes()
  const file = here('../dist/codes.cpp')
  // All in one file, so that the headers are read once.
  await writeFile(file, names.map((name) => codes[name].cpp.replace('int main()', `int ${name}()`)).join('\n'))
  await run('c++', ['-std=c++20', '-fsyntax-only', '-Wall', '-Wextra', '-Werror', ...includes, file])
})

async function loadCodes() {
  const { outputFiles } = await build({ entryPoints: [here('../src/scenes/code.ts')], write: false, format: 'esm' })
  return (await import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`)).codes
}
