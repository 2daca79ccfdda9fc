// The ground, and the physics worlds over it: both, or one. Steps them all alike.
import type { CellRect, World } from 'localgridseg'
import { type Riding, setMotions, type Start } from './bodies.js'
import type { Document } from './documents.js'
import { Rocks } from './falling.js'
import { Ground, type GroundChange } from './ground.js'
import { Mirror } from './mirror.js'
import { cell } from './scale.js'
import { landscapeGate, landscapeRiders, makeLandscape } from './scenes/landscape.js'
import { type Gate, Side } from './side.js'

/** Who rolls on a ground, and where those who left it begin again. */
export interface Cast {
  readonly starts: Start[]
  readonly gate: Gate
}

export type View = 'both' | 'with' | 'without'

const cruise = 14 // radians a second, of the wheels of a car that nobody drives
const most = 22

export class Game {
  readonly ground: Ground
  readonly mirror = new Mirror()
  /** Ground that was cut off. */
  readonly rocks: Rocks
  /** With ghosts first. */
  sides: Side[] = []
  onChange: (change: GroundChange) => void = () => {}
  #view: View = 'both'
  #gate: Gate = landscapeGate
  #starts: Start[] = []
  #drive: number | null = null // -1, 0 or 1; null while nobody has driven

  constructor() {
    this.ground = new Ground(makeLandscape())
    this.ground.onChange = (change) => {
      this.onChange(change) // first: it can still see what was removed
      this.mirror.update(change.changes)
      for (const side of this.sides) side.sync(change.changes)
      this.#freeRiders(change.cells)
      if (change.mark === null) this.rocks.update(change.changes)
      else this.rocks.rollBack(change.changes, change.mark)
    }
    this.ground.onMark = (mark) => this.rocks.note(mark)
    this.rocks = new Rocks(this.ground)
    this.rocks.reset()
    this.#begin(landscapeRiders())
  }

  get view(): View {
    return this.#view
  }

  /** A side that was not there begins as a copy of the one that was. */
  set view(view: View) {
    if (view === this.#view) return
    const [first] = this.sides
    if (view === 'both') {
      const other = this.#makeSide(!first.ghosts)
      other.copyFrom(first)
      this.sides = first.ghosts ? [first, other] : [other, first]
    } else if (this.#view === 'both') {
      this.sides = [view === 'with' ? this.sides[0] : this.sides[1]]
    } else {
      first.setGhosts(view === 'with')
    }
    this.#view = view
    this.rocks.sides = this.sides
  }

  /** Another world, and who rolls on it. Without a cast marbles and a car start above it. */
  open(document: Document, cast?: Cast): void {
    this.ground.open(document)
    this.rocks.reset()
    const cells = document.world.bounds() ?? { i0: 0, j0: 0, i1: 20, j1: 0 }
    const { starts, gate } = cast ?? castIn(document.world, cells)
    this.#gate = gate
    this.#begin(starts)
  }

  /** Bodies that move already. They are the same in all sides. */
  cast(riders: readonly Riding[]): void {
    this.removeRiders()
    for (const { start, motions } of riders) {
      this.drop(start)
      for (const side of this.sides) setMotions(side.riders[side.riders.length - 1], motions)
    }
  }

  /** Puts the riders back to where they were at the start. */
  restart(): void {
    this.#begin(this.#starts)
  }

  drop(start: Start): void {
    for (const side of this.sides) side.add(start)
  }

  removeRiders(): void {
    for (const side of this.sides) side.removeAll()
  }

  drive(direction: number): void {
    this.#drive = direction
  }

  step(): void {
    this.ground.commit()
    const speed = this.#drive === null ? cruise : this.#drive * most
    for (const side of this.sides) side.step(speed, this.#gate)
    this.rocks.afterStep(this.#gate.bottom)
  }

  #begin(starts: Start[]): void {
    this.mirror.reset(this.ground.world)
    this.#starts = starts
    this.#drive = null
    const ghosts = { both: [true, false], with: [true], without: [false] }[this.#view]
    this.sides = ghosts.map((on) => this.#makeSide(on))
    this.rocks.sides = this.sides
    for (const start of starts) this.drop(start)
  }

  #makeSide(ghosts: boolean): Side {
    return new Side(this.ground.world, this.mirror, ghosts)
  }

  // Edges are two-sided. Who is inside new ground would stay there, so it is lifted out.
  #freeRiders(cells: CellRect): void {
    const { world } = this.ground
    for (const side of this.sides) {
      for (const rider of side.riders) {
        for (const body of rider.bodies) {
          const { x, y } = side.terrain.point(body.getPosition())
          if (x < cells.i0 || x > cells.i1 + 1 || y < cells.j0 || y > cells.j1 + 1) continue
          let up = 0
          while (up < 100 && world.at(x, y + up).where === 'inside') up += 0.25
          if (up === 0) continue
          for (const each of rider.bodies) {
            const at = each.getPosition()
            each.setTransform({ x: at.x, y: at.y + (up + rider.start.size) * cell }, each.getAngle())
            each.setAwake(true)
          }
        }
      }
    }
  }
}

function castIn(world: World, cells: CellRect): Cast {
  const starts = ridersIn(world, cells)
  const { x, y } = starts[starts.length >> 1]
  return { starts, gate: { x, y, speed: 2, bottom: cells.j0 - 5 } }
}

// In caves, where there are any, otherwise on top.
function ridersIn(world: World, cells: CellRect): Start[] {
  const columns = cells.i1 - cells.i0 + 1
  const count = Math.max(1, Math.min(16, Math.floor(columns / 2)))
  const places = Array.from({ length: count }, (_, k) => {
    const x = cells.i0 + ((k + 0.5) * columns) / count, isCar = k === count >> 1, size = isCar ? 0.7 : 0.3 + 0.05 * (k % 3)
    const y = underRoof(world, cells, x, isCar ? 1.2 : size)
    return { kind: isCar ? 'car' : 'marble', x, y: y ?? cells.j1 + 3, speed: 1, size, colour: k % 5, isInCave: y !== null } as const
  })
  const inCaves = places.filter(({ isInCave }) => isInCave)
  return (inCaves.length > 0 ? inCaves : places).map(({ isInCave: _, ...start }) => start)
}

/** A place in this column with ground above and below it, and room around it; the highest one. Null if there is none. */
function underRoof(world: World, cells: CellRect, x: number, room: number): number | null {
  const isFree = (x: number, y: number) => world.at(x, y).where === 'outside'
  let hasRoof = false
  for (let y = cells.j1 + 1; y > cells.j0; y -= 0.25) {
    const isRoomy = hasRoof && [-room, 0, room].every((dx) => [-room, 0, room].every((dy) => isFree(x + dx, y + dy)))
    if (isRoomy && world.rayCast(x, y, x, cells.j0) !== null) return y
    hasRoof ||= !isFree(x, y)
  }
  return null
}
