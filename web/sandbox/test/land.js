// What tests do in the digger's land, and ask of it.

export const calm = { reducedMotion: 'reduce' } // no hand digs
export const rocks = (page) => page.evaluate(() => window.sandbox.digger.ground.rocks().length)
/** Of the ground of a cavern, and all rocks. */
export const area = (page, cavern = 0) => page.evaluate((cavern) => {
  const { ground } = window.sandbox.digger, cells = { i0: 64 * cavern, j0: 0, i1: 64 * cavern + 63, j1: 31 }
  const of = (polygons) => polygons.reduce((sum, { vertices: v }) => v.reduce((s, _, k) => (k % 2 ? s : s + (v[k] * v[(k + 3) % v.length] - v[k + 1] * v[(k + 2) % v.length]) / 2), sum), 0)
  return of(ground.world.polygons(cells)) + ground.rocks().reduce((sum, { ground: { mass } }) => sum + mass.area, 0)
}, cavern)
/** Where a point of the land is on the page. */
export const spot = (page, x, y) => page.evaluate(([x, y]) => {
  const { picture, size } = window.sandbox.digger, { left, bottom } = document.getElementById('dig').getBoundingClientRect()
  return [left + (x - picture.x) * size, bottom - (y - picture.y) * size]
}, [x, y])
/** A drag across a stem. */
export async function cutAt(page, cx, cy, half = 1.5) {
  await page.mouse.move(...(await spot(page, cx - half, cy)))
  await page.mouse.down()
  for (let k = 1; k <= 8; ++k) await page.mouse.move(...(await spot(page, cx - half + (2 * half * k) / 8, cy)))
  await page.mouse.up()
}
/** The first stem, of a mushroom. */
export const cutStem = (page) => cutAt(page, 15, 7)
export const tapBack = (page) => page.evaluate(() => { for (const type of ['pointerdown', 'pointerup']) document.getElementById('dig-back').dispatchEvent(new PointerEvent(type)) })
/** Until this is told. */
export const lead = (page, word) => page.waitForFunction((word) => document.getElementById('dig-lead').textContent.includes(word), word)
