// The game of the examples in a browser: it prints what those in C++, C and Python print.
import assert from 'node:assert/strict'
import { existsSync, readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { extname } from 'node:path'
import { test } from 'node:test'
import { chromium } from 'playwright-core'

const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium'
const skip = existsSync(executablePath) ? false : `there is no ${executablePath}`
const root = new URL('../../../', import.meta.url)
const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' }
const args = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync']

test('the game in a browser prints what the other doors print', { skip }, async () => {
  const server = createServer((request, response) => {
    if (request.url === '/favicon.ico') return response.writeHead(204).end()
    try {
      const body = readFileSync(new URL(`.${request.url}`, root))
      response.writeHead(200, { 'content-type': types[extname(request.url)] ?? 'text/plain' }).end(body)
    } catch {
      response.writeHead(404).end()
    }
  }).listen(0, 'localhost')
  await new Promise((done) => server.once('listening', done))
  const browser = await chromium.launch({ executablePath, args })
  try {
    const page = await browser.newPage()
    const said = []
    page.on('console', (message) => said.push(message.text()))
    page.on('pageerror', (error) => said.push(String(error)))
    await page.goto(`http://localhost:${server.address().port}/examples/browser_game.html`)
    await page.waitForSelector('body[data-state=done]')
    assert.equal(await page.textContent('#text'), readFileSync(new URL('examples/game.txt', root), 'utf8'))
    assert.deepEqual(said, [])
  } finally {
    await browser.close()
    server.close()
  }
})
