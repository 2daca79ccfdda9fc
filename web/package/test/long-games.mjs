// Long games for law 13: five seeds of 20,000 steps with 50 bodies each, unless it is said otherwise.
//
//     node web/package/test/long-games.mjs planck 50 20000 1 2 3 4 5
import { box2dCrowd, planckCrowd } from './crowds.js'
import { Turmoil, randomMove, randomNumbers } from './turmoil.js'

const [engine = 'planck', bodies = '50', steps = '20000', ...seeds] = process.argv.slice(2)
const { b2 } = await import('./box2d3.js')
const makeCrowd = engine === 'planck' ? planckCrowd : box2dCrowd(b2)
for (const seed of seeds.length > 0 ? seeds : ['1', '2', '3', '4', '5']) {
  const arena = { width: 24, height: 14, chunkCells: 8 }, game = new Turmoil(makeCrowd, arena), random = randomNumbers(Number(seed))
  for (let tries = 0; game.bodyCount < Number(bodies) && tries < 10_000; ++tries) game.play(randomMove(random, arena, 'body'))
  let wrong = null
  for (let k = 0; k < Number(steps) / 4; ++k) {
    const now = game.play(randomMove(random, arena))
    if (now !== null) wrong ??= `move ${k}: ${now}`
  }
  console.log(`${engine}, seed ${seed}, ${game.bodyCount} bodies, ${steps} steps: ${game.lost} lost, ${game.pushes} pushed, ` +
    `${game.holds} held, ${game.disabledCount} of them at the end, ${game.putBacks} put back; ${wrong ?? 'the law held'}`)
  game.end()
}
