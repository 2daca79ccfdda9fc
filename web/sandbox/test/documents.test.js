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
    await page.locator('#landscape').click()
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
      await message(page, /is that of the full recompute/)
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
    await page.locator('#landscape').click()
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

test('share puts the ground into the address, and the address opens it', async () => {
  let hash
  let shared
  await browser.onPage(async (page) => {
    await drag(page, [
      [14, 5],
      [16, 4.2],
    ])
    shared = await outline(page)
    await page.locator('#share').click()
    await message(page, /address/)
    hash = new URL(page.url()).hash
    assert.ok(hash.length < 8000, `${hash.length} characters`)
    await page.locator('#empty').click()
    await page.evaluate(() => history.replaceState(null, '', '#'))
    await page.evaluate((hash) => (location.hash = hash), hash)
    await page.waitForFunction(() => window.sandbox.game.ground.world.bounds() !== null)
    assert.equal(await outline(page), shared)
  })
  await browser.onPage(async (page) => assert.equal(await outline(page), shared), { hash })
  await browser.onPage((page) => message(page, /./), { hash: '#trace=damaged' })
})

test('check finds a difference if there is one', () =>
  browser.onPage(async (page) => {
    await page.locator('#check').click()
    await message(page, /is that of the full recompute/)
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
    await message(page, /differs in \d+ places/)
  }))
