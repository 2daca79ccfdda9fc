// The two worlds, what rolls in them, and what the ground does to it.
// In a real browser; the build must be there: npm run build -w sandbox
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { click, drag, openBrowser } from './browser.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

const kicks = (page) => page.evaluate(() => window.sandbox.kicks())
const step = (page, count) => page.evaluate((count) => window.sandbox.step(count), count)
const riders = (page) => page.evaluate(() => window.sandbox.game.sides.map((side) => side.riders.length))
const tool = (page, name) => page.locator(`input[name=tool][value=${name}]`).check()

test('the first second: two worlds, everything rolls, and only without ghosts there are kicks', () =>
  browser.onPage(async (page) => {
    assert.equal(await page.locator('.pane:visible').count(), 2)
    assert.match(await page.locator('#lead').textContent(), /seams/)
    const places = () =>
      page.evaluate(() =>
        window.sandbox.game.sides.map((side) => side.riders.map((rider) => rider.bodies[0].getPosition().x)),
      )
    const [start] = await places()
    await step(page, 30)
    const [half] = await places()
    assert.ok(
      half.every((x, k) => x > start[k]),
      'all riders move to the right',
    )
    await step(page, 570)
    const [smooth, rough] = await kicks(page)
    assert.equal(smooth, 0)
    assert.ok(rough > 50, `${rough} kicks`)
    await page.waitForFunction(
      (count) => document.querySelector('#pane-1 [data-count=kicks]').textContent === String(count),
      rough,
    )
  }))

test('the clock runs by itself, pauses, and steps', () =>
  browser.onPage(async (page) => {
    const now = () => page.evaluate(() => window.sandbox.game.sides[0].kicks.step)
    await page.locator('#step').click()
    const begin = await now()
    await page.locator('#step').click()
    assert.equal(await now(), begin + 1)
    await page.locator('#play').click()
    await page.waitForFunction((from) => window.sandbox.game.sides[0].kicks.step > from + 20, begin)
    await page.locator('#slow').check()
    await page.locator('#play').click()
    assert.equal(await page.locator('#play').textContent(), 'Play')
  }))

test('drop marbles, boxes and a car, and drive it', () =>
  browser.onPage(async (page) => {
    const [count] = await riders(page)
    for (const [k, kind] of ['marble', 'box', 'car'].entries()) {
      await tool(page, kind)
      await click(page, 14 + 4 * k, 7)
    }
    assert.deepEqual(await riders(page), [count + 3, count + 3])
    await page.locator('#scene').selectOption('empty')
    await tool(page, 'tile')
    await drag(
      page,
      Array.from({ length: 14 }, (_, k) => [k + 2.5, 0.5]),
    )
    await tool(page, 'car')
    await click(page, 12, 2)
    const car = () => page.evaluate(() => window.sandbox.game.sides[0].riders.at(-1).bodies[0].getPosition().x)
    await page.locator('#pane-0 canvas').focus()
    await page.keyboard.down('ArrowLeft')
    const from = await car()
    await step(page, 240)
    assert.ok((await car()) < from)
    await page.keyboard.up('ArrowLeft')
    await page.locator('#scene').selectOption('hills')
    assert.deepEqual(await riders(page), [count, count])
  }))

// An empty world with tiles, and one rider. Returns where it is after some steps, in cells.
async function tryOut(page, tiles, rider, steps) {
  await page.locator('#scene').selectOption('empty')
  await page.waitForFunction(() => window.sandbox.game.sides[0].riders.length === 0)
  return page.evaluate(
    ([tiles, rider, steps]) => {
      const { game } = window.sandbox
      game.ground.begin()
      for (const [i, j, block] of tiles)
        game.ground.edit({
          kind: 'tile',
          i,
          j,
          vertices: [
            [0, 0],
            [1, 0],
            [1, 1],
            [0, 1],
          ],
          block,
        })
      game.ground.end()
      game.drop({ kind: 'box', speed: 0, size: 0.3, colour: 0, stays: true, ...rider })
      if (rider.up) game.sides[0].riders[0].bodies[0].setLinearVelocity({ x: 0, y: rider.up })
      window.sandbox.step(steps)
      const { x, y } = game.sides[0].riders[0].bodies[0].getPosition()
      return { x: x * 4, y: y * 4 }
    },
    [tiles, rider, steps],
  )
}

test('ice, sticky and one-way ground', () =>
  browser.onPage(async (page) => {
    const floor = (block) => Array.from({ length: 40 }, (_, i) => [i, 0, block])
    const slide = { kind: 'marble', x: 2, y: 1.3, speed: 4 }
    const [plain, ice, sticky] = [
      await tryOut(page, floor(1), slide, 180),
      await tryOut(page, floor(101), slide, 180),
      await tryOut(page, floor(102), slide, 180),
    ]
    assert.ok(ice.x > 12 && plain.x > 5, 'both go on')
    assert.ok(sticky.x < 4, `${sticky.x}: it is held back`)
    const platform = [
      [4, 4, 103],
      [5, 4, 103],
      [6, 4, 103],
    ]
    const fallen = await tryOut(page, platform, { x: 5.5, y: 7 }, 180)
    assert.ok(Math.abs(fallen.y - 5.3) < 0.1, `${fallen.y}: it lies on top`)
    const risen = await tryOut(page, platform, { x: 5.5, y: 3, up: 2.2 }, 240)
    assert.ok(Math.abs(risen.y - 5.3) < 0.1, `${risen.y}: it went through from below, and lies on top`)
  }))

test('an undo that refills a hole lifts who is in it', () =>
  browser.onPage(async (page) => {
    await page.locator('#scene').selectOption('empty')
    await page.evaluate(() => {
      const { ground } = window.sandbox.game
      const edit = (edit) => (ground.begin(), ground.edit(edit), ground.end())
      edit({ kind: 'paint', region: { rings: [[0, 0, 12, 0, 12, 6, 0, 6]] }, block: 1 })
      edit({ kind: 'carve', region: { rings: [[4, 2, 7, 2, 7, 7, 4, 7]] } })
      window.sandbox.game.drop({ kind: 'marble', x: 5.5, y: 4, speed: 0, size: 0.4, colour: 0 })
    })
    await step(page, 120)
    const height = () =>
      page.evaluate(() => window.sandbox.game.sides.map((side) => side.riders[0].bodies[0].getPosition().y * 4))
    assert.ok((await height())[0] < 3)
    await page.locator('#undo').click()
    await step(page, 120)
    for (const y of await height()) assert.ok(Math.abs(y - 6.4) < 0.1, `${y}: it lies on the ground`)
  }))

test('ghosts switched off in one world: kicks are counted', () =>
  browser.onPage(async (page) => {
    await page.locator('input[name=view][value=with]').check()
    assert.equal(await page.locator('.pane:visible').count(), 1)
    await step(page, 200)
    assert.deepEqual(await kicks(page), [0])
    await page.locator('input[name=view][value=without]').check()
    await step(page, 300)
    const [rough] = await kicks(page)
    assert.ok(rough > 10, `${rough} kicks`)
    await page.locator('input[name=view][value=both]').check()
    assert.equal(await page.locator('.pane:visible').count(), 2)
    const places = await page.evaluate(() =>
      window.sandbox.game.sides.map((side) => side.riders.map((rider) => rider.bodies[0].getPosition().x)),
    )
    assert.deepEqual(places[0], places[1])
  }))
