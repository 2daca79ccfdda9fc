// A static server and headless Chromium, for the tests that need a browser.
import { existsSync, readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { extname } from 'node:path'
import { chromium } from 'playwright-core'

const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium'
export const skip = existsSync(executablePath) ? false : `there is no ${executablePath}`
const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' }
const args = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync']

/** Serves a folder, and opens a page of it. `use` gets the page; whatever the page prints is returned. */
export async function browse(root, path, use) {
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
  try {
    return await visit(`http://localhost:${server.address().port}/${path}`, use)
  } finally {
    server.close()
  }
}

/** Opens a page. */
export async function visit(address, use) {
  const browser = await chromium.launch({ executablePath, args })
  const said = []
  try {
    const page = await browser.newPage()
    page.on('console', (message) => said.push(message.text()))
    page.on('pageerror', (error) => said.push(String(error)))
    await page.goto(address)
    await use(page)
  } finally {
    await browser.close()
  }
  return said
}
