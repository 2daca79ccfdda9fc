// Chromium, and the page in it. What goes wrong on the page fails the test.
import assert from 'node:assert/strict'
import { chromium } from 'playwright-core'
import { serve } from '../serve.js'

const options = {
  executablePath: '/usr/bin/chromium',
  args: [
    '--headless',
    '--no-sandbox',
    '--disable-gpu',
    '--disable-quic',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
  ],
}

const folder = '/any/folder/' // the page works in any
const permissions = ['clipboard-read', 'clipboard-write']

export async function openBrowser() {
  const server = await serve(0, folder)
  const browser = await chromium.launch(options)
  const address = `http://localhost:${server.address().port}${folder}`
  const wrong = []
  const newPage = async (context) => {
    const page = await (
      await browser.newContext({ viewport: { width: 1000, height: 700 }, permissions, ...context })
    ).newPage()
    await page.addInitScript(() => {
      if (location.protocol !== 'http:') return
      if (!location.search.includes('keep')) localStorage.clear()
    })
    page.on('console', (message) => wrong.push(message.text()))
    page.on('pageerror', (error) => wrong.push(error.stack))
    page.on('request', (request) => {
      if (!request.url().startsWith(address) && !/^(about|blob|data):/.test(request.url()))
        wrong.push(`asks for ${request.url()}`)
    })
    return page
  }
  const usual = await newPage({})
  return {
    /** Runs a test on the page, loaded anew, with all controls open. Its clock stands still: sandbox.step() steps it. */
    async onPage(test, { hash = '#tools', context, query = '' } = {}) {
      const page = context === undefined ? usual : await newPage(context)
      await page.goto('about:blank')
      await page.goto(address + query + hash)
      await page.waitForSelector('[data-ready]')
      await page.evaluate(() => window.sandbox.step?.(0))
      if (context === undefined) await page.evaluate(() => { document.getElementById('show-more').checked = true })
      await test(page)
      assert.deepEqual(wrong, [])
    },
    /** Runs a test on another page of the site, whose clock runs. `wrongs` are the complaints that the test expects. */
    async onPath(test, path, { context = {}, before = async () => {}, wrongs = [] } = {}) {
      const page = await newPage(context)
      await before(page)
      await page.goto(address + path)
      await page.waitForSelector('body[data-ready]')
      await test(page)
      await page.close()
      assert.deepEqual(
        wrong.splice(0).filter((each) => !wrongs.some((pattern) => pattern.test(each))),
        [],
      )
    },
    async close() {
      await browser.close()
      server.close()
    },
  }
}

/** Drags the mouse through points of the world. */
export async function drag(page, points) {
  for (const [k, [x, y]] of points.entries()) {
    const at = await page.evaluate(([x, y]) => window.sandbox.toPage(x, y), [x, y])
    await page.mouse.move(at.x, at.y)
    if (k === 0) await page.mouse.down()
  }
  await page.mouse.up()
}

export async function click(page, x, y) {
  await drag(page, [[x, y]])
}

/** All segments, as text: equal for equal outlines. */
export function outline(page) {
  return page.evaluate(() => {
    const { world } = window.sandbox.game.ground
    world.commit()
    const { geometry, block, length } = world.segments()
    return Array.from({ length }, (_, k) => `${[...geometry.slice(8 * k, 8 * k + 8)]} ${block[k]}`)
      .sort()
      .join('\n')
  })
}

/** What is at a point of the world: its block, or 0. */
export function blockAt(page, x, y) {
  return page.evaluate(
    ([x, y]) => {
      const spot = window.sandbox.game.ground.world.at(x, y)
      return spot.where === 'outside' ? 0 : spot.block
    },
    [x, y],
  )
}

/** Waits until the message of the page matches. */
export async function message(page, pattern) {
  await page.waitForFunction(
    (source) => new RegExp(source).test(document.getElementById('message').textContent),
    pattern.source,
  )
}
