// Makes the picture of the README: node test/picture.js FILE.png
import { drag, openBrowser } from './browser.js'

const browser = await openBrowser()
try {
  await browser.onPage(
    async (page) => {
      // Digs and undoes so often that the engine's code is compiled by now. Else the times would be those of a start.
      await page.evaluate(() => {
        const { ground } = window.sandbox.game
        for (let k = 0; k < 400; ++k) {
          const x = 5 + (k % 30)
          ground.begin()
          ground.edit({ kind: 'carve', region: { rings: [[x, 1, x + 1, 1.1, x + 0.6, 2.2]] } })
          ground.end()
          ground.undo()
        }
      })
      await page.locator('#scene').selectOption('hills')
      await page.evaluate(() => window.sandbox.step(235))
      await page.waitForTimeout(1200) // until nothing glows any more
      await drag(
        page,
        Array.from({ length: 7 }, (_, k) => [9.5 + k / 2, 2.5]),
      )
      await page.evaluate(() => window.sandbox.step(12))
      await page.waitForTimeout(200)
      await page.screenshot({ path: process.argv[2] })
    },
    { context: { viewport: { width: 1200, height: 700 } } },
  )
} finally {
  await browser.close()
}
