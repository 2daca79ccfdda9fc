// A random game in a closed world: bodies, and ground that changes under them. Law 13 is looked at after each sync and
// each step. It is the game of addons/box2d/tests/turmoil.h. A crowd is the bodies of one physics engine: crowds.js.
import { circle, createWorld, loadWorld, thickLine, unitSquare } from 'localgridseg'

const mostUndo = 12
export const figures = ['circle', 'box', 'capsule', 'triangle', 'octagon', 'stick', 'cross', 'flag']
export const kinds = ['body', 'paint', 'line', 'carve', 'tile', 'dig', 'shot', 'portal', 'undo', 'redo', 'save', 'load', 'origin', 'kick']

const common = ['paint', 'paint', 'paint', 'line', 'carve', 'carve', 'carve', 'carve', 'carve', 'tile', 'tile', 'dig', 'dig',
  'kick', 'kick', 'kick', 'shot', 'shot', 'portal']
const rare = ['undo', 'undo', 'redo', 'save', 'load', 'origin']

/** std::minstd_rand */
export function randomNumbers(seed) {
  let state = (seed * 2654435761) % 2147483647 || 1
  return (below) => (state = (state * 48271) % 2147483647) % below
}

export function randomMove(random, { width, height }, kind) {
  const from = random(100) < 6 ? rare : common
  return { kind: kind ?? from[random(from.length)], x: random(width * 16), y: random(height * 16), size: random(16), which: random(256) }
}

const clamp = (v, least, most) => Math.max(Math.min(v, Math.max(least, most)), least)

export class Turmoil {
  pushes = 0
  holds = 0
  putBacks = 0
  #arena
  #world = createWorld()
  #square
  #crowd
  #terrain
  #watched = []
  #marks = [] // at the begin, and after each edit
  #now = 0 // at which of them the world is
  #file = null

  /** A wall all around, ground below, and rocks above it. `makeCrowd` is of crowds.js. */
  constructor(makeCrowd, arena) {
    this.#arena = { width: 24, height: 14, cellSize: 0.5, chunkCells: 16, steps: 4, ...arena }
    const { width, height, cellSize, chunkCells } = this.#arena, world = this.#world
    this.#square = world.shape(unitSquare)
    const fill = (i0, j0, i1, j1, block) => world.fill({ i0, j0, i1, j1 }, this.#square, block)
    fill(-1, -1, width, -1, 1)
    fill(-1, height, width, height, 1)
    fill(-1, 0, -1, height - 1, 1)
    fill(width, 0, width, height - 1, 1)
    if (height > 3) fill(0, 0, width - 1, 1, 2)
    world.commit()
    this.#marks = [world.mark()]
    this.#crowd = makeCrowd()
    this.#terrain = this.#crowd.makeTerrain(world, { cellSize, chunkCells, ...arena.terrain })
  }

  get bodyCount() { return this.#crowd.bodies.length }
  get disabledCount() { return this.#terrain.disabled.length }
  end() {
    this.#terrain.destroy()
    this.#crowd.destroy?.()
    this.#world.free()
  }

  /** What is wrong after a move and the steps after it; null if nothing is. */
  play(move) {
    this.#act(move)
    let wrong = this.#look('after the move')
    for (let k = 0; k < this.#arena.steps; ++k) {
      if (!this.#arena.announces) this.#terrain.beforeStep()
      this.#crowd.step()
      const putBack = this.#crowd.namesOf(this.#terrain.afterStep())
      this.putBacks += putBack.length
      wrong ??= this.#lookAtPutBacks(putBack)
      const later = this.#look('after a step')
      wrong ??= later
    }
    return wrong
  }

  /** Bodies that are inside the ground or out of the world, but for those that are held. */
  get lost() {
    return this.#crowd.bodies.filter((body) => this.#crowd.isEnabled(body) &&
      this.#middlesOf(body).every(([x, y]) => !this.#isFree(x, y) || this.#isOut(x, y))).length
  }

  #pointOf({ x, y }) { return [(x % (this.#arena.width * 16)) / 16, (y % (this.#arena.height * 16)) / 16] }

  // It never reaches the walls.
  #regionOf(move) {
    const { width, height } = this.#arena
    const within = (at, reach, cells) => clamp(at, Math.min(reach, cells / 2), cells - reach)
    const most = Math.min(width, height) / 2 - 1 / 65536
    const radius = Math.min(most, 0.25 + move.size / 8), [x, y] = this.#pointOf(move)
    const a = [within(x, radius, width), within(y, radius, height)]
    if (move.kind !== 'line') return circle(...a, radius, 8 + (move.which % 24))
    const thin = Math.min(most, 1 / 16 + (move.which % 8) / 32), angle = move.which * 0.0245
    const b = [within(a[0] + 3 * Math.cos(angle), thin, width), within(a[1] + 3 * Math.sin(angle), thin, height)]
    return thickLine([a, b], thin, 8)
  }

  #isFree(x, y) { return this.#world.at(x, y).where === 'outside' }
  #isOut(x, y) { return x < 0 || y < 0 || x > this.#arena.width || y > this.#arena.height }
  #middlesOf(body) { return this.#crowd.middlesOf(body).map((p) => this.#terrain.point(p)).map(({ x, y }) => [x, y]) }

  #isFreeBody(body) { return this.#middlesOf(body).every(([x, y]) => this.#isFree(x, y) && !this.#isOut(x, y)) }

  // 0.2 to 2 cells long. A shot may begin with a corner in the ground.
  #addBody(move) {
    const size = 0.2 + 0.12 * move.size, [x, y] = this.#pointOf(move)
    if (!this.#isFree(x, y) || (move.kind === 'body' && this.#world.nearest(x, y, 0.75 * size))) return
    const body = this.#crowd.add(figures[move.which % figures.length], size * this.#arena.cellSize, this.#terrain.position(x, y))
    if (!this.#isFreeBody(body)) return this.#crowd.remove(this.#crowd.bodies.length - 1)
    this.#watched.push({ isFree: null, isHeld: false, at: null, free: null })
    this.#shove(body, move)
  }

  #shove(body, { kind, which }) {
    if (kind !== 'body') this.#crowd.kick(body, 60 * Math.cos(0.0245 * which), 60 * Math.sin(0.0245 * which))
    if (this.#arena.announces) this.#terrain.moved(body)
  }

  // A bullet is gone, and there is another one.
  #shoot(move) {
    const { bodies } = this.#crowd
    if (bodies.length > 0) {
      const gone = move.which % bodies.length
      this.#crowd.remove(gone)
      this.#watched.splice(gone, 1)
    }
    this.#addBody(move)
  }

  #portal(move) {
    const { bodies } = this.#crowd, body = bodies[move.which % bodies.length]
    if (body === undefined || !this.#crowd.isEnabled(body)) return
    const from = this.#crowd.positionOf(body)
    this.#crowd.put(body, this.#terrain.position(...this.#pointOf(move)))
    if (this.#isFreeBody(body)) this.#shove(body, move)
    else this.#crowd.put(body, from)
  }

  // Who was put back is where that very body was free last.
  #lookAtPutBacks(names) {
    for (const name of names) {
      const k = this.#crowd.namesOf(this.#crowd.bodies).indexOf(name), { free } = this.#watched[k]
      const at = this.#terrain.point(this.#crowd.positionOf(this.#crowd.bodies[k]))
      if (Math.hypot(at.x - free.x, at.y - free.y) > 1 / 8) return `body ${k} was put back to where it never was`
    }
    return null
  }

  #edit(move) {
    const world = this.#world, [x, y] = this.#pointOf(move), i = Math.floor(x), j = Math.floor(y)
    if (move.kind === 'paint' || move.kind === 'line') world.paint(this.#regionOf(move), 3)
    else if (move.kind === 'carve') world.carve(this.#regionOf(move))
    else if (move.kind === 'tile') world.replace(i, j, this.#square, 2)
    else world.clear(i, j)
  }

  #sync(changes) {
    this.#terrain.sync(changes)
    this.#count()
  }
  #count() { for (const { isFree } of this.#terrain.overlaps) isFree ? ++this.pushes : ++this.holds }

  #undo(steps) {
    if (this.#now === 0) return
    this.#now = Math.max(0, this.#now - 1 - (steps % 3))
    this.#sync(this.#world.rollBack(this.#marks[this.#now], 'keep'))
  }

  #redo(steps) {
    if (this.#now + 1 === this.#marks.length) return
    this.#now = Math.min(this.#marks.length - 1, this.#now + 1 + (steps % 2))
    this.#sync(this.#world.redo(this.#marks[this.#now]))
  }

  #load() {
    if (this.#file === null) return
    const old = this.#world
    this.#world = loadWorld(this.#file)
    this.#square = this.#world.shape(unitSquare)
    this.#marks = [this.#world.mark()]
    this.#now = 0
    this.#terrain.resync(this.#world)
    old.free()
    this.#count()
  }

  #doneNow(move) {
    this.#edit(move)
    this.#sync(this.#world.commit())
    this.#marks.length = this.#now + 1
    if (this.#now === mostUndo) this.#world.forget(this.#marks.shift())
    this.#now = this.#marks.push(this.#world.mark()) - 1
  }

  #act(move) {
    switch (move.kind) {
      case 'body':
        return this.#addBody(move)
      case 'shot':
        return this.#shoot(move)
      case 'portal':
        return this.#portal(move)
      case 'undo':
        return this.#undo(move.which)
      case 'redo':
        return this.#redo(move.which)
      case 'save':
        this.#file = this.#world.save()
        return
      case 'load':
        return this.#load()
      case 'origin':
        return this.#crowd.moveOrigin(this.#terrain, { i: move.x - 64, j: move.y - 64 })
      case 'kick': {
        const { bodies } = this.#crowd, body = bodies[move.which % bodies.length]
        if (body === undefined || !this.#crowd.isEnabled(body)) return
        return this.#crowd.kick(body, 4 * move.size * Math.cos(0.1 * move.x), 4 * move.size * Math.sin(0.1 * move.x))
      }
      default:
        return this.#doneNow(move)
    }
  }

  // The law: a middle that was free is free, unless the body is held, and then it does not move.
  #look(after) {
    let wrong = null
    this.#crowd.bodies.forEach((body, k) => {
      const watched = this.#watched[k], isHeld = !this.#crowd.isEnabled(body)
      const at = this.#terrain.point(this.#crowd.positionOf(body))
      if (isHeld && watched.isHeld && Math.hypot(at.x - watched.at.x, at.y - watched.at.y) > 0.01)
        wrong ??= `${after}, body ${k} moved while it was held`
      const isFree = this.#middlesOf(body).map(([x, y], m) => {
        const isFreeNow = this.#isFree(x, y)
        const wasFree = watched.isFree === null || watched.isHeld || watched.isFree[m]
        if (!isHeld && wasFree && (!isFreeNow || this.#isOut(x, y)))
          wrong ??= `${after}, body ${k} is in the ground, its middle ${m} at ${x} ${y}`
        return isFreeNow
      })
      Object.assign(watched, { isFree, isHeld, at }, isFree.every(Boolean) && { free: at })
    })
    return wrong
  }
}
