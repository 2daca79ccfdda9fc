// Files, addresses, and the check.
// In a real browser; the build must be there: npm run build -w sandbox
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { click, drag, message, openBrowser, outline } from './browser.js'

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

const trace = `lgs-trace 1
add a 0 0 1  0 0  1 0  1 1  0 1
add b 1 0 2  0 0  1 0  0 1
commit
`

test('a trace is opened, copied, and dropped', () =>
  browser.onPage(async (page) => {
    await page.locator('#file').setInputFiles({ name: 'two.trace', mimeType: 'text/plain', buffer: Buffer.from(trace) })
    await message(page, /two\.trace: 2 polygons/)
    const opened = await outline(page)
    assert.equal(opened.split('\n').length, 5)
    await page.locator('#copy').click()
    await message(page, /copied/)
    const copy = await page.evaluate(() => navigator.clipboard.readText())
    assert.match(copy, /^lgs-trace \d/)
    await page.locator('#scene').selectOption('hills')
    const data = await page.evaluateHandle((text) => {
      const transfer = new DataTransfer()
      transfer.items.add(new File([text], 'again.trace'))
      return transfer
    }, copy)
    await page.dispatchEvent('body', 'drop', { dataTransfer: data })
    await message(page, /again\.trace/)
    assert.equal(await outline(page), opened)
  }))

const maps = new URL('../../../examples/maps/', import.meta.url).pathname

test('maps of Tiled and LDtk are opened', () =>
  browser.onPage(async (page) => {
    for (const files of [['landscape.tmx', 'landscape.tsx'], ['cave.tmx', 'crate.tx'], ['quarry.ldtk']]) {
      await page.locator('#file').setInputFiles(files.map((name) => maps + name))
      await message(page, new RegExp(`${files[0]}: \\d\\d+ polygons`))
      await page.locator('#check').click()
      await message(page, /No mismatch: all \d\d+ segments/)
    }
    await page.locator('#file').setInputFiles([`${maps}landscape.tmx`])
    await message(page, /landscape\.tsx/)
  }))

test('a saved world is opened', () =>
  browser.onPage(async (page) => {
    await page.locator('#file').setInputFiles({ name: 'two.trace', mimeType: 'text/plain', buffer: Buffer.from(trace) })
    await message(page, /two\.trace/)
    const opened = await outline(page)
    const bytes = await page.evaluate(() => [...window.sandbox.game.ground.world.save()])
    await page.locator('#scene').selectOption('hills')
    await page
      .locator('#file')
      .setInputFiles({ name: 'two.lgs', mimeType: 'application/octet-stream', buffer: Buffer.from(bytes) })
    await message(page, /two\.lgs: 2 polygons/)
    assert.equal(await outline(page), opened)
  }))

test('a bad file is refused in words, and changes nothing', () =>
  browser.onPage(async (page) => {
    const before = await outline(page)
    await page
      .locator('#file')
      .setInputFiles({ name: 'bad.trace', mimeType: 'text/plain', buffer: Buffer.from('nonsense') })
    await message(page, /./)
    assert.equal(await outline(page), before)
  }))

test('a picture is no document, and the map among several files is the one that is named', () =>
  browser.onPage(async (page) => {
    await page.locator('#file').setInputFiles([`${maps}landscape.png`])
    await message(page, /landscape\.png: neither a trace/)
    await page.locator('#file').setInputFiles([`${maps}landscape.tsx`, `${maps}landscape.tmx`])
    await message(page, /^landscape\.tmx: \d+ polygons/)
  }))

test('a link holds the edits, the view and the bodies', async () => {
  const state = (page) =>
    page.evaluate(() => {
      const { game, toPage } = window.sandbox
      const riders = game.sides[0].riders.map(({ bodies }) => [4 * bodies[0].getPosition().x, 4 * bodies[0].getPosition().y])
      return { at: toPage(20, 5), unit: toPage(21, 5).x - toPage(20, 5).x, riders, worlds: game.view }
    })
  let hash, shared, ground
  await browser.onPage(async (page) => {
    await page.locator('input[name=tool][value=dig]').check()
    await drag(page, [[20, 4.5], [22, 4.5]])
    await page.locator('input[name=view][value=without]').check()
    await page.keyboard.press('+')
    await page.keyboard.press('Control+ArrowRight')
    await page.evaluate(() => window.sandbox.step(90))
    ;[shared, ground] = [await state(page), await outline(page)]
    await page.locator('#share').click()
    await message(page, /has your terrain, view and bodies/)
    hash = new URL(page.url()).hash
  })
  await browser.onPage(
    async (page) => {
      const opened = await state(page)
      assert.equal(await outline(page), ground)
      assert.equal(opened.worlds, 'without')
      assert.ok(Math.abs(opened.at.x - shared.at.x) < 1 && Math.abs(opened.unit - shared.unit) < 0.01, 'the view')
      assert.equal(opened.riders.length, shared.riders.length)
      // Its clock runs until the test stops it.
      const far = opened.riders.filter(([x, y], k) => Math.hypot(x - shared.riders[k][0], y - shared.riders[k][1]) > 4)
      assert.ok(far.length <= 2, `${far.length} bodies are elsewhere`)
    },
    { hash },
  )
})

test('what was dug is there again after the page was closed', async () => {
  let ground
  await browser.onPage(async (page) => {
    await page.locator('input[name=tool][value=dig]').check()
    await drag(page, [[12, 4.5], [13, 4.5]])
    ground = await outline(page)
    await page.waitForFunction(() => localStorage.getItem('localgridseg-sandbox') !== null)
  })
  await browser.onPage(
    async (page) => {
      assert.equal(await outline(page), ground)
      await message(page, /terrain from last time/)
    },
    { query: '?keep' },
  )
})

test('share puts the ground into the address, and the address opens it', async () => {
  let hash
  let shared
  await browser.onPage(async (page) => {
    await page.locator('input[name=tool][value=dig]').check()
    await drag(page, [
      [14, 5],
      [16, 4.2],
    ])
    shared = await outline(page)
    await page.locator('#share').click()
    await message(page, /address/)
    hash = new URL(page.url()).hash
    assert.ok(hash.length < 8000, `${hash.length} characters`)
    await page.locator('#scene').selectOption('empty')
    await page.evaluate(() => history.replaceState(null, '', '#'))
    await page.evaluate((hash) => (location.hash = hash), hash)
    await page.waitForFunction(() => window.sandbox.game.ground.world.bounds() !== null)
    assert.equal(await outline(page), shared)
  })
  await browser.onPage(async (page) => assert.equal(await outline(page), shared), { hash })
  await browser.onPage((page) => message(page, /link is damaged/), { hash: '#trace=damaged' })
})

test('check finds a difference if there is one', () =>
  browser.onPage(async (page) => {
    await page.locator('#check').click()
    await message(page, /No mismatch/)
    await page.evaluate(() => {
      const { world } = window.sandbox.game.ground
      const segments = world.segments.bind(world)
      world.segments = (cells) => {
        const list = segments(cells).copy()
        list.geometry[0] += 0.5 // a wrong outline
        return list
      }
    })
    await page.locator('#check').click()
    await message(page, /MISMATCH with the reference: \d+ segments/)
  }))

test('a trace in the address is checked, and stepped through', () =>
  browser.onPage(
    async (page) => {
      await page.locator('#check').click()
      await message(page, /No mismatch: all \d segments/)
      const opened = page.waitForEvent('popup')
      await page.locator('#steps').click()
      const steps = await opened
      await steps.waitForFunction(() => document.title.includes('trace'))
      assert.match(await steps.content(), /add b 1 0 2/)
    },
    { hash: `#plain=${encodeURIComponent(trace)}` },
  ))
