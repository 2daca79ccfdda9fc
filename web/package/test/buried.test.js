// Law 13, nobody is buried: after each sync and each afterStep() a dynamic body whose middle was free is free, or is held
// where it was. For planck and box2d3-wasm. Long games: node test/long-games.mjs.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import fc from 'fast-check'
import { circle, createWorld, loadWorld, rectangle, unitSquare } from 'localgridseg'
import { cutOut } from 'localgridseg/planck'
import { b2 } from './box2d3.js'
import { box2dCrowd, planckCrowd } from './crowds.js'
import { Turmoil, kinds, randomMove, randomNumbers } from './turmoil.js'

const scale = Number(process.env.LGS_TEST_SCALE ?? 1)
const engines = [['planck', planckCrowd], ['box2d3-wasm', box2dCrowd(b2)]]

const moves = fc.array(fc.record({
  kind: fc.oneof({ weight: 3, arbitrary: fc.constantFrom(...kinds.slice(0, 6)) }, { weight: 1, arbitrary: fc.constantFrom(...kinds) }),
  x: fc.nat(191), y: fc.nat(111), size: fc.nat(15), which: fc.nat(255),
}), { maxLength: 60 })
const arenas = fc.record({
  width: fc.constantFrom(12, 3, 6), height: fc.constantFrom(7, 3), cellSize: fc.constantFrom(1, 0.5, 2),
  chunkCells: fc.constantFrom(16, 1, 3), steps: fc.constantFrom(1, 4, 8), announces: fc.boolean(),
})

for (const [name, makeCrowd] of engines) {
  test(`${name}: nobody is buried in small games`, () => {
    fc.assert(fc.property(arenas, moves, (arena, played) => {
      const game = new Turmoil(makeCrowd, arena)
      try {
        for (const move of played) assert.equal(game.play(move), null)
      } finally {
        game.end()
      }
    }), { numRuns: Math.ceil(60 * scale), seed: 13 })
  })

  test(`${name}: nobody is lost of 50 in longer games`, (t) => {
    for (const seed of [1, 2]) {
      const arena = { width: 24, height: 14, chunkCells: 8 }, game = new Turmoil(makeCrowd, arena), random = randomNumbers(seed)
      for (let tries = 0; game.bodyCount < 50 && tries < 10_000; ++tries) game.play(randomMove(random, arena, 'body'))
      for (let k = 0; k < 60 * scale; ++k) assert.equal(game.play(randomMove(random, arena)), null, `move ${k} of seed ${seed}`)
      assert.equal(game.lost, 0)
      assert.ok(game.pushes > 0 || scale < 1, 'somebody overlapped')
      t.diagnostic(`${game.bodyCount} bodies: ${game.pushes} pushed, ${game.holds} held, ${game.disabledCount} at the end, ${game.putBacks} put back`)
      game.end()
    }
  })

  /** A floor of cells 0 to 9, and a body above it that has come to rest. */
  const resting = (figure = 'box', options = {}) => {
    const world = createWorld(), square = world.shape(unitSquare)
    world.fill({ i0: 0, j0: -2, i1: 9, j1: 0 }, square, 1)
    world.commit()
    const crowd = makeCrowd(), terrain = crowd.makeTerrain(world, options)
    const body = crowd.add(figure, 0.8, { x: 5.5, y: 1.405 })
    const run = (steps) => { for (let k = 0; k < steps; ++k) crowd.step(), terrain.afterStep() }
    run(10)
    return { world, square, crowd, terrain, body, run, at: () => crowd.positionOf(body), isFree: () => crowd.middlesOf(body).every(({ x, y }) => world.at(x, y).where === 'outside') }
  }

  // The middle is 0.6 lattice units above the floor, and so it is free. Then a float is 32 units.
  if (name !== 'planck') test(`${name}: rounding puts nobody into the ground when the origin moves`, () => {
    const { world, crowd, terrain, body, at, run } = resting('circle')
    const isFree = () => crowd.middlesOf(body).every((middle) => world.at(terrain.point(middle).x, terrain.point(middle).y).where === 'outside')
    crowd.put(body, { x: 5.5, y: 1 + 0.6 / 65536 })
    terrain.resync()
    assert.ok(isFree(), 'before')
    crowd.moveOrigin(terrain, { i: 0, j: 4096 })
    assert.ok(isFree(), 'at once')
    crowd.put(body, { x: 5.5, y: 0.7 - 4096 })
    crowd.kick(body, 0, -1)
    run(1)
    assert.ok(isFree(), 'after it was put back')
    assert.ok(Math.abs(at().y + 4095) < 0.01)
    world.free()
  })

  test(`${name}: who is built over is pushed out, the shortest way, and stands`, () => {
    const { world, square, crowd, terrain, body, run, at, isFree } = resting()
    world.add(5, 1, square, 1)
    const changes = world.commit()
    const [overlap, ...others] = terrain.overlapsWith(changes)
    assert.equal(others.length, 0)
    assert.deepEqual(crowd.namesOf([overlap.body]), crowd.namesOf([body]))
    assert.ok(overlap.isFree && overlap.depth > 0.2, JSON.stringify(overlap.depth))
    assert.equal(terrain.fits(body), false)
    assert.equal(terrain.fits(body, { x: 5.5, y: 2.45, angle: 0 }), true)
    const before = at()
    terrain.sync(changes)
    assert.deepEqual(terrain.overlaps.map(({ displacement }) => displacement), [overlap.displacement])
    assert.ok(Math.hypot(at().x - before.x - overlap.displacement.x, at().y - before.y - overlap.displacement.y) < 1e-5)
    assert.ok(isFree() && terrain.fits(body))
    run(120)
    assert.ok(isFree())
    world.free()
  })

  test(`${name}: who is pushed has no velocity against the way any more, and keeps the rest`, () => {
    const { world, square, terrain, crowd, body } = resting()
    world.add(5, 1, square, 1)
    const changes = world.commit(), [{ displacement: way }] = terrain.overlapsWith(changes)
    const length = Math.hypot(way.x, way.y), [ux, uy] = [way.x / length, way.y / length]
    crowd.kick(body, -5 * ux - 2 * uy, -5 * uy + 2 * ux)
    terrain.sync(changes)
    const { x, y } = crowd.velocityOf(body)
    assert.ok(Math.abs(x * ux + y * uy) < 1e-4 && Math.abs(y * ux - x * uy - 2) < 1e-4, JSON.stringify({ way, x, y }))
    world.free()
  })

  test(`${name}: who is pressed into the ground, or came through it, in a step is put back`, () => {
    for (const to of [{ x: 5.5, y: 0.4 }, { x: 5.5, y: -4 }]) {
      const { world, terrain, crowd, body, at } = resting('circle')
      const before = at()
      crowd.put(body, to)
      crowd.step()
      assert.deepEqual(crowd.namesOf(terrain.afterStep()), crowd.namesOf([body]))
      assert.ok(Math.hypot(at().x - before.x, at().y - before.y) < 1e-5)
      assert.ok(Math.hypot(crowd.velocityOf(body).x, crowd.velocityOf(body).y) < 1e-9)
      crowd.put(body, { x: 3.5, y: before.y }) // beside, over free ground
      crowd.step()
      assert.deepEqual(crowd.namesOf(terrain.afterStep()), [])
      world.free()
    }
  })

  test(`${name}: who has no way out is held where it is, and comes free when there is room`, () => {
    const { world, crowd, terrain, body, run, at, isFree } = resting('circle')
    world.fill({ i0: -30, j0: 1, i1: 40, j1: 40 }, world.shape(unitSquare), 1)
    const before = at()
    terrain.sync(world.commit())
    assert.deepEqual(crowd.namesOf(terrain.disabled), crowd.namesOf([body]))
    run(60)
    assert.deepEqual(at(), before)
    assert.equal(crowd.isEnabled(body), false)
    world.clear(30, 30) // far away
    terrain.sync(world.commit())
    assert.equal(terrain.disabled.length, 1)
    world.clear({ i0: 4, j0: 1, i1: 6, j1: 3 })
    terrain.sync(world.commit())
    assert.equal(terrain.disabled.length, 0)
    assert.ok(crowd.isEnabled(body) && isFree())
    run(60)
    assert.ok(isFree())
    world.free()
  })

  test(`${name}: hold, leave, and a block that is passable`, () => {
    for (const [onOverlap, material, disabled, overlaps] of [
      ['disable', undefined, 1, 1], ['leave', undefined, 0, 0], ['push', (block) => ({ isPassable: block === 7 }), 0, 0],
    ]) {
      const { world, square, terrain, at } = resting('circle', { onOverlap, ...(material && { material }) })
      const before = at()
      world.add(5, 1, square, 7)
      const changes = world.commit()
      assert.equal(terrain.overlapsWith(changes).length, material ? 0 : 1)
      terrain.sync(changes)
      assert.deepEqual([terrain.disabled.length, terrain.overlaps.length], [disabled, overlaps], onOverlap)
      assert.deepEqual(at(), before)
      world.free()
    }
  })

  test(`${name}: an undo and a load catch, too`, () => {
    for (const how of ['undo', 'load', 'another world']) {
      const { world, square, terrain, crowd, body } = resting()
      const mark = world.mark()
      world.clear(5, 0)
      terrain.sync(world.commit())
      for (let k = 0; k < 40; ++k) crowd.step(), terrain.afterStep()
      assert.ok(crowd.positionOf(body).y < 0.6, 'it is in the hole')
      let now = world
      if (how === 'undo') terrain.sync(world.rollBack(mark))
      else if (how === 'load') {
        world.rollBack(mark)
        terrain.resync()
      } else {
        now = createWorld()
        now.fill({ i0: 0, j0: -2, i1: 9, j1: 0 }, now.shape(unitSquare), 1)
        now.commit()
        terrain.resync(now)
        world.free()
      }
      assert.equal(terrain.overlaps.length, 1, how)
      const { x, y } = crowd.middlesOf(body)[0]
      assert.equal(now.at(x, y).where, 'outside', how)
      now.clear(0, 0)
      terrain.sync(now.commit())
      now.free()
      void square
    }
  })

  test(`${name}: a load holds who was held, releases who is free, and believes where bodies are`, () => {
    const { world, square, terrain, crowd, body: held, run, at } = resting('circle')
    const other = crowd.add('circle', 0.8, { x: 8.5, y: 1.405 })
    world.fill({ i0: -30, j0: 1, i1: 6, j1: 40 }, square, 1)
    terrain.sync(world.commit(), 'disable')
    assert.deepEqual(crowd.namesOf(terrain.disabled), crowd.namesOf([held]))
    const saved = world.save(), heldAt = at(), otherAt = crowd.positionOf(other)
    world.clear({ i0: -30, j0: 1, i1: 6, j1: 40 })
    terrain.sync(world.commit())
    assert.ok(crowd.isEnabled(held))
    crowd.put(held, { x: 2.5, y: 3 })
    crowd.put(other, heldAt)
    world.fill({ i0: 4, j0: 1, i1: 9, j1: 40 }, square, 1)
    terrain.sync(world.commit(), 'disable')
    assert.deepEqual(crowd.namesOf(terrain.disabled), crowd.namesOf([other]))
    const loaded = loadWorld(saved)
    crowd.put(held, heldAt)
    crowd.put(other, otherAt)
    terrain.resync(loaded)
    world.free()
    assert.ok(crowd.isEnabled(other))
    assert.ok(crowd.isEnabled(held) ? terrain.fits(held) : terrain.disabled.length === 1, 'pushed or held, though its ground is as before')
    run(2)
    assert.ok(Math.abs(crowd.positionOf(other).x - otherAt.x) < 0.01, 'it did not come through the ground: it was put there')
    loaded.free()
  })

  test(`${name}: after a load who was below the ground is there again`, () => {
    const { world, terrain, crowd, body, run, at } = resting('circle')
    const loaded = loadWorld(world.save())
    crowd.put(body, { x: 5.5, y: -4 })
    terrain.resync(loaded)
    world.free()
    run(1)
    assert.ok(Math.abs(at().y + 4) < 0.02)
    loaded.free()
  })

  test(`${name}: each that is held is held, and comes free`, () => {
    const { world, crowd, terrain, body } = resting('circle')
    const others = [3.5, 7.5].map((x) => crowd.add('circle', 0.8, { x, y: 1.405 }))
    for (const [j, count] of [[1, 3], [1, 0]]) {
      count ? world.fill({ i0: -30, j0: j, i1: 40, j1: 40 }, world.shape(unitSquare), 1) : world.clear({ i0: -30, j0: j, i1: 40, j1: 40 })
      terrain.sync(world.commit())
      assert.equal(terrain.disabled.length, count)
    }
    for (const one of [body, ...others]) assert.ok(crowd.isEnabled(one))
    world.free()
  })

  test(`${name}: a shape is where its body has turned it`, () => {
    const { world, crowd, terrain } = resting('circle')
    const flag = crowd.add('flag', 1, { x: 3.5, y: 2 }) // the shape is within (3.75, 1.75) and (4.25, 2.25)
    const box = () => terrain.outlinesOf(flag).rings[0].reduce(([x0, y0, x1, y1], v, k) =>
      k % 2 ? [x0, Math.min(y0, v), x1, Math.max(y1, v)] : [Math.min(x0, v), y0, Math.max(x1, v), y1], [1e9, 1e9, -1e9, -1e9])
    const near = (numbers) => box().forEach((v, k) => assert.ok(Math.abs(v - numbers[k]) < 0.01, `${box()} is not ${numbers}`))
    near([3.75, 1.75, 4.25, 2.25])
    crowd.turn(flag)
    near([3.25, 2.25, 3.75, 2.75])
    world.add(3, 2, world.shape(unitSquare), 1)
    const [overlap] = terrain.overlapsWith(world.commit())
    assert.deepEqual(crowd.namesOf([overlap.body]), crowd.namesOf([flag]))
    assert.ok(Math.abs(overlap.depth - 0.25) < 0.01, 'all of it, to its middle')
    world.free()
  })

  test(`${name}: who goes through a portal stays there, if it is said`, () => {
    for (const isSaid of [true, false]) {
      const { world, terrain, crowd, body, at } = resting('circle')
      const before = at()
      crowd.put(body, { x: 5.5, y: -4 })
      if (isSaid) terrain.moved(body)
      crowd.step()
      assert.equal(terrain.afterStep().length, isSaid ? 0 : 1)
      assert.ok(Math.abs(at().y - (isSaid ? -4 : before.y)) < 0.02)
      world.free()
    }
  })

  test(`${name}: a way out leads through no wall that was there`, () => {
    const world = createWorld(), square = world.shape(unitSquare)
    world.fill({ i0: 0, j0: 0, i1: 9, j1: 0 }, square, 1)
    world.paint(rectangle(5.9, 4, 0, 1, 3, 0.05), 1) // a thin wall
    world.commit()
    const crowd = makeCrowd(), terrain = crowd.makeTerrain(world, {})
    const body = crowd.add('circle', 0.6, { x: 5.5, y: 1.31 })
    world.paint({ rings: [[5, 1, 6, 1, 6, 2, 5, 2]] }, 1)
    terrain.sync(world.commit())
    assert.equal(terrain.overlaps.length, 1)
    assert.ok(crowd.positionOf(body).x < 5.85)
    world.free()
  })

  test(`${name}: cutOut() moves nobody and refuses nothing`, () => {
    const { world, terrain, body, at } = resting('triangle')
    const before = at(), outline = terrain.outlinesOf(body)
    assert.equal(outline.rings.length, 1)
    world.paint(circle(5.5, 1.5, 2), 4)
    cutOut(terrain, world, world.commit())
    assert.deepEqual(at(), before)
    assert.deepEqual([terrain.overlaps.length, terrain.disabled.length], [0, 0])
    assert.ok(terrain.fits(body))
    assert.equal(world.at(5.5, 2.8).block, 4)
    world.free()
  })

  test(`${name}: bodiesIn() names who is there, each once, and not the terrain`, () => {
    const { world, crowd, terrain, body } = resting('cross')
    assert.equal(terrain.outlinesOf(body).rings.length, 2)
    const names = (i0, j0, i1, j1) => crowd.namesOf(terrain.bodiesIn({ i0, j0, i1, j1 }))
    assert.deepEqual(names(5, 1, 5, 1), crowd.namesOf([body]))
    assert.deepEqual(names(7, 0, 8, 2), [])
    assert.deepEqual(names(5, 1, 4, 1), [])
    world.free()
  })
}
