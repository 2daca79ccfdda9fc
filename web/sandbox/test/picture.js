// Makes the picture of the digger: node test/picture.js FILE.png
import { openBrowser } from './browser.js'

const browser = await openBrowser()
try {
  await browser.onPath(
    async (page) => {
      const spot = ([x, y]) => page.evaluate(([x, y]) => {
        const { picture, size } = window.sandbox.digger, { left, bottom } = document.getElementById('dig').getBoundingClientRect()
        return [left + (x - picture.x) * size, bottom - (y - picture.y) * size]
      }, [x, y])
      const drag = async (from, to) => {
        await page.mouse.move(...(await spot(from)))
        await page.mouse.down()
        await page.mouse.move(...(await spot(to)), { steps: 12 })
        await page.mouse.up()
      }
      const isFree = (count) => page.waitForFunction((count) => document.querySelectorAll('#dig-places .full').length === count, count)
      await drag([5.5, 16], [8.5, 16])
      await isFree(1)
      await drag([48.5, 17], [53, 17])
      await isFree(2)
      await page.waitForFunction(() => window.sandbox.digger.ground.rocks().length === 0)
      await page.waitForTimeout(1500)
      await drag([12.5, 17.4], [15.5, 17.4])
      await page.screenshot({ path: process.argv[2] })
    },
    '',
    { context: { viewport: { width: 1000, height: 620 }, reducedMotion: 'reduce' } },
  )
} finally {
  await browser.close()
}
