// Measures frames. When the digger is seen first; the time from frame to frame while 434 bodies fall over the hills, in
// one world or in both; and what a frame takes of the main thread (edit, commit, fixtures, step, drawing) with 500 bodies
// on a world of 300 x 100 cells that is dug at every frame. Chromium is headless and draws by software. Beside other work
// times by the clock are too long; see the CPU time then.
//   node test/frames.js [with|without|both]
import { openBrowser } from './browser.js'

const view = process.argv[2] ?? 'with'
const frames = 600
const crowd = 434
const openings = 7

function show(name, times) {
  const sorted = [...times].sort((a, b) => a - b)
  const at = (part) => sorted[Math.floor(part * (sorted.length - 1))].toFixed(1).padStart(6)
  console.log(`${name.padEnd(22)} p50 ${at(0.5)} ms   p95 ${at(0.95)} ms   p99 ${at(0.99)} ms   most ${at(1)} ms`)
}

/** In the page: says when the frame begins after that in which the digger is drawn for the first time. */
const noteFirst = () => {
  const { fill } = CanvasRenderingContext2D.prototype
  let isDrawn = false
  CanvasRenderingContext2D.prototype.fill = function (...all) {
    if (this.canvas.id === 'dig' && !isDrawn) requestAnimationFrame((now) => window.seen(now))
    isDrawn ||= this.canvas.id === 'dig'
    return fill.apply(this, all)
  }
}

/** Of the main thread, in milliseconds, since the page began. */
async function clock(page) {
  const session = await page.context().newCDPSession(page)
  await session.send('Performance.enable', { timeDomain: 'threadTicks' })
  return async () => 1000 * (await session.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration').value
}

/** In the page: lets them fall, and how long each of the next frames takes. */
const fall = async ([crowd, frames]) => {
  const { game } = window.sandbox, next = () => new Promise(requestAnimationFrame), times = []
  for (let k = game.sides[0].riders.length; k < crowd; ++k)
    game.drop({ kind: k % 3 === 0 ? 'box' : 'marble', x: 4 + ((k * 0.37) % 60), y: 22 + 1.2 * Math.floor(k / 60), speed: 1, size: 0.35, colour: k })
  document.getElementById('play').click() // a test's clock stands still
  for (let last = await next(), k = -60; k < frames; ++k) {
    const now = await next()
    if (k >= 0) times.push(now - last)
    last = now
  }
  return times
}

const browser = await openBrowser()
const context = { viewport: { width: 1280, height: 800 } }
try {
  const seen = [], spent = []
  for (let k = 0; k < openings; ++k)
    await browser.onPath((page) => page.waitForTimeout(200), '', { context, before: async (page) => {
      const cpu = await clock(page)
      await page.exposeBinding('seen', async (_, now) => {
        seen.push(now)
        spent.push(await cpu())
      })
      await page.addInitScript(noteFirst)
    } })
  show('the digger is seen', seen)
  show('CPU until then', spent)
  await browser.onPage(async (page) => {
    await page.locator(`input[name=view][value=${view}]`).evaluate((radio) => radio.click())
    show(`${crowd} bodies, ${view}`, await page.evaluate(fall, [crowd, frames]))
  }, { context })
  await browser.onPage(
    async (page) => {
      await page.locator(`input[name=view][value=${view}]`).evaluate((radio) => radio.click())
      const cpu = await clock(page)
      await page.evaluate(() => window.sandbox.measure('everywhere', 60)) // compiled by now
      for (const place of ['along', 'everywhere']) {
        await page.evaluate(() => window.sandbox.prepare())
        const before = await cpu()
        const result = await page.evaluate(([place, frames]) => window.sandbox.measure(place, frames), [place, frames])
        const spent = ((await cpu()) - before) / frames
        const { bodies, awake, cells, segments } = result
        console.log(`\ndug ${place} the surface, view: ${view}, ${frames} frames`)
        console.log(`${bodies} bodies, ${Math.round(awake)} of them awake; ${cells} cells, ${segments} segments`)
        for (const [name, times] of Object.entries(result.times)) show(name, times)
        console.log(`${'CPU of the main thread'.padEnd(22)} mean ${spent.toFixed(1)} ms`)
      }
    },
    { context },
  )
} finally {
  await browser.close()
}
