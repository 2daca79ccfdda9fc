// Measures frames: 500 bodies on a world of 300 x 100 cells that is dug at every frame. Prints what a frame takes of
// the main thread (edit, commit, fixtures, step, drawing), and the time from frame to frame. Chromium is headless and
// draws by software. Beside other work times by the clock are too long; see the CPU time then.
//   node test/frames.js [with|without|both]
import { openBrowser } from './browser.js'

const view = process.argv[2] ?? 'with'
const frames = 600

function show(name, times) {
  const sorted = [...times].sort((a, b) => a - b)
  const at = (part) => sorted[Math.floor(part * (sorted.length - 1))].toFixed(1).padStart(6)
  console.log(`${name.padEnd(22)} p50 ${at(0.5)} ms   p99 ${at(0.99)} ms   most ${at(1)} ms`)
}

const browser = await openBrowser()
try {
  await browser.onPage(
    async (page) => {
      await page.locator(`input[name=view][value=${view}]`).check()
      const session = await page.context().newCDPSession(page)
      await session.send('Performance.enable', { timeDomain: 'threadTicks' })
      const cpu = async () =>
        1000 * (await session.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration').value
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
    { context: { viewport: { width: 1280, height: 800 } } },
  )
} finally {
  await browser.close()
}
