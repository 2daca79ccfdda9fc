// The site is one folder of static files, which any server can have in any folder: sandbox, article and the pages of the
// API. It must be built: npm run build.
import assert from 'node:assert/strict'
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { after, before, test } from 'node:test'
import { blockAt, openBrowser } from './browser.js'

const dist = new URL('../dist/', import.meta.url)
const pages = readdirSync(dist, { recursive: true }).filter((name) => name.endsWith('.html'))

test('every link of every page leads to a file of the site, or to a page of somebody else', () => {
  assert.ok(pages.length > 50 && pages.includes('index.html') && pages.includes('article/index.html') && pages.includes('api/index.html'))
  const wrong = []
  for (const page of pages) {
    const text = readFileSync(new URL(page, dist), 'utf8')
    if (text.includes('.invalid')) wrong.push(`${page}: .invalid`)
    for (const [, link] of text.matchAll(/\s(?:href|src)="([^"#?]*)[^"]*"/g)) {
      if (link === '' || /^(https:|data:)/.test(link)) continue
      const to = new URL(link, new URL(page, dist)), file = to.pathname.endsWith('/') ? new URL('index.html', to) : to
      if (!file.pathname.startsWith(dist.pathname) || link.startsWith('/') || !existsSync(file)) wrong.push(`${page}: ${link}`)
    }
  }
  assert.deepEqual(wrong, [])
})

let browser
before(async () => (browser = await openBrowser()))
after(() => browser.close())

test('a trace in an address, as it is', () =>
  browser.onPage(async (page) => {
    assert.equal(await blockAt(page, 3.5, 2.5), 7)
    assert.equal(await page.evaluate(() => window.sandbox.game.ground.world.stats().polygons), 1)
  }, { hash: `#plain=${encodeURIComponent('lgs-trace 1\nadd a 3 2 7 0 0 1 0 1 1 0 1\ncommit\n')}` }))
