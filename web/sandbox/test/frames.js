// Measures frames: 500 bodies on a world of 300 x 100 cells that is dug at every frame. Prints what a frame takes of the
// main thread (edit, commit, fixtures, step, drawing), and the time from frame to frame. Times by the clock mean little on
// a machine that does other work meanwhile; the CPU time of the main thread does not depend on that.
//   node test/frames.js [with|without|both]
import { openBrowser } from './browser.js'

const view = process.argv[2] ?? 'with'
const frames = 600

const browser = await openBrowser()
try {
  await browser.onPage(
    async (page) => {
      await page.locator(`input[name=view][value=${view}]`).check()
      const session = await page.context().newCDPSession(page)
      await session.send('Performance.enable', { timeDomain: 'threadTicks' })
      const cpu = async () => (await session.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration').value
      await page.evaluate(() => window.sandbox.measure(30)) // compiled by now
      const before = await cpu()
      const result = await page.evaluate((frames) => window.sandbox.measure(frames), frames)
      const spent = (1000 * ((await cpu()) - before)) / frames
      const show = (name, times) => {
        const sorted = times.toSorted((a, b) => a - b)
        const at = (part) => sorted[Math.floor(part * (sorted.length - 1))].toFixed(1)
        console.log(`${name.padEnd(26)} p50 ${at(0.5).padStart(6)} ms   p99 ${at(0.99).padStart(6)} ms   most ${at(1).padStart(6)} ms`)
      }
      console.log(`${result.bodies} bodies, ${result.cells} cells, ${result.segments} segments, view: ${view}, ${frames} frames; headless Chromium, drawn by software`)
      console.log(`${'CPU of the main thread'.padEnd(26)} mean ${spent.toFixed(1)} ms a frame`)
      for (const [name, times] of Object.entries(result.times)) show(name, times)
    },
    { context: { viewport: { width: 1280, height: 800 } } },
  )
} finally {
  await browser.close()
}
