// The crystals of the digger's land, and its gold: where they are, and what was won. A crystal is won when it was cut free
// and breaks, or when something heavy falls on it; gold when it is dug out, too. An undo that brings them back takes them
// from the count.
import type { CellRect, GroundBody } from 'localgridseg/islands'
import type { Ground } from 'localgridseg/planck'

/** Of the blocks that count. */
export const shine: Readonly<Record<number, string>> = { 3: '#6df0e0', 5: '#ffd166' }
export const large = 3 // this block's hang from stems, and glow
export const gold = 5
const nugget = 0.5 // square cells of gold that are dug for each that is counted
const least = 0.15 // square cells: less is only a crumb
const share = 0.3 // of a rock's area: a boulder with a gem in it stays one
const across = 3 // cells: two pieces that are nearer are of one crystal
const reach = 2.4 // cells that a crystal is away from what falls on it
const heavy = 4, hard = 3 // square cells, and cells a second: what hits so breaks the crystals there
/** Cells that a cavern is wide, as in digger.js. */
export const cavern = 64
export const cavernAt = (x: number): number => Math.floor(x / cavern)

interface Known {
  readonly stroke: number // after which it was a rock
  readonly crystal: number // its block, or 0
  age: number
  still: number // seconds
  vx: number
  vy: number
}
/** A rock hit something, or a crystal broke. Positions are in cells, speeds in cells a second. */
export interface Hit {
  readonly at: readonly [number, number]
  readonly area: number
  readonly block: number
  readonly speed: number
  readonly isBroken: boolean
}

const areaOf = (v: ArrayLike<number>): number => {
  let sum = 0
  for (let k = 0, l = v.length - 2; k < v.length; l = k, k += 2) sum += v[l] * v[k + 1] - v[k] * v[l + 1]
  return sum / 2
}

export class Crystals {
  readonly #ground: Ground
  /** Of each square: the edges that face up, and the middles of the pieces of crystals. */
  readonly #squares = new Map<string, { readonly rim: Path2D; readonly middles: readonly [number, number][] }>()
  readonly #known = new WeakMap<GroundBody, Known>()
  #won: { readonly block: number; readonly stroke: number; readonly cavern: number }[] = [] // after which stroke it came loose
  #dug: { readonly area: number; readonly stroke: number }[] = [] // of gold
  #middles: [number, number][] = []

  /** What the picture draws is seen by this, too. */
  constructor(ground: Ground) {
    this.#ground = ground
    const draw = ground.draw.bind(ground)
    ground.draw = () => {
      const squares = draw()
      for (const { key, fills, lines } of squares) {
        if (lines.length === 0 && fills.length === 0) this.#squares.delete(key)
        else this.#squares.set(key, { rim: rimOf(lines), middles: fills.filter(({ block }) => block === large).map(({ vertices }) => middleOf(vertices)) })
      }
      if (squares.length > 0) this.#cluster()
      return squares
    }
  }

  /** How many crystals of a cavern are won. */
  count(cavern: number): number {
    return this.#won.filter((each) => each.block === large && each.cavern === cavern).length
  }
  get gold(): number {
    const dug = this.#dug.reduce((sum, { area }) => sum + area, 0)
    return this.#won.filter(({ block }) => block === gold).length + Math.floor(dug / nugget)
  }

  /** All edges of the ground that face up. */
  *rims(): Iterable<Path2D> {
    for (const { rim } of this.#squares.values()) yield rim
  }

  /** The middles of those that glow. */
  get glowing(): readonly (readonly [number, number])[] {
    const falling = this.#ground.rocks().filter(({ ground }) => this.#known.get(ground)?.crystal === large)
    return [...this.#middles, ...falling.map(({ ground: { mass }, x, y, angle }) => placed(mass.x, mass.y, x, y, angle))]
  }

  /** How much gold there is in these cells, and in rocks. */
  goldIn(cells: CellRect): number {
    const all = [...this.#ground.world.polygons(cells), ...this.#ground.rocks().flatMap(({ ground }) => ground.polygons)]
    return all.reduce((sum, { block, vertices }) => (block === gold ? sum + areaOf(vertices) : sum), 0)
  }

  /** So much gold was dug out by the last of so many strokes. */
  noteDug(area: number, strokes: number): void {
    if (area > 1e-9) this.#dug.push({ area, stroke: strokes })
  }

  /** After each step of the ground. `strokes` there are now; while one goes back in time nothing is broken by others. */
  step(time: number, strokes: number, gravity: number, goesBack: boolean): Hit[] {
    this.#won = this.#won.filter(({ stroke }) => stroke <= strokes)
    this.#dug = this.#dug.filter(({ stroke }) => stroke <= strokes)
    const hits: Hit[] = []
    for (const rock of this.#ground.rocks()) {
      const { ground, body, x, y, angle, vx, vy } = rock
      let known = this.#known.get(ground)
      if (known === undefined) this.#known.set(ground, (known = { stroke: strokes, crystal: this.#crystalOf(ground), age: 0, still: 0, vx, vy }))
      const speed = Math.hypot(vx - known.vx, vy - known.vy + gravity * time)
      known.age += time
      known.still = Math.hypot(vx, vy) < 0.5 ? known.still + time : 0
      Object.assign(known, { vx, vy })
      const isBroken = known.crystal !== 0 && body !== null && ((speed > 4 && known.age > 0.1) || known.still > 0.3)
      const { x: cx, y: cy, area } = ground.mass, at = placed(cx, cy, x, y, angle)
      if (known.crystal === 0 && area > heavy && speed > hard && !goesBack) hits.push(...this.#smash(at, Math.sqrt(area / Math.PI) + reach, strokes + 1))
      if (!isBroken && speed < 4) continue
      hits.push({ at, area, block: known.crystal || ground.polygons[0].block, speed, isBroken })
      if (!isBroken) continue
      this.#won.push({ block: known.crystal, stroke: known.stroke, cavern: cavernAt(at[0]) })
      this.#ground.forget(body)
      body.getWorld().destroyBody(body)
    }
    return hits
  }

  /** The crystals that are near, and below. It is a stroke of its own. */
  #smash([x, y]: readonly [number, number], far: number, stroke: number): Hit[] {
    const broken = this.#middles.filter(([mx, my]) => my < y && Math.hypot(mx - x, my - y) < far)
    if (broken.length === 0) return []
    const isOf = (v: ArrayLike<number>, i: number, j: number) => {
      const [px, py] = middleOf(v)
      return broken.some(([mx, my]) => Math.hypot(px + i - mx, py + j - my) < across)
    }
    const cells = { i0: Math.floor(x - far - across), j0: Math.floor(y - far - across), i1: Math.ceil(x + far + across), j1: Math.ceil(y) }
    this.#ground.edit((world) => {
      const all = world.polygons(cells).filter(({ block, vertices, i, j }) => block === large && isOf(vertices, i, j))
      world.removeMany(all.map(({ id }) => id))
    })
    this.#middles = this.#middles.filter((each) => !broken.includes(each))
    for (const [mx] of broken) this.#won.push({ block: large, stroke, cavern: cavernAt(mx) })
    return broken.map((at) => ({ at, area: 6, block: large, speed: 6, isBroken: true }))
  }

  #crystalOf({ polygons, mass }: GroundBody): number {
    const all = new Map<number, number>()
    for (const { block, vertices } of polygons) if (block in shine) all.set(block, (all.get(block) ?? 0) + areaOf(vertices))
    for (const [block, area] of all) if (area > least && area > share * mass.area) return block
    return 0
  }

  // A crystal has pieces in several cells.
  #cluster(): void {
    const sums: [number, number, number][] = []
    for (const { middles } of this.#squares.values())
      for (const [x, y] of middles) {
        const near = sums.find(([sx, sy, n]) => Math.hypot(sx / n - x, sy / n - y) < across)
        if (near === undefined) sums.push([x, y, 1])
        else [near[0], near[1], near[2]] = [near[0] + x, near[1] + y, near[2] + 1]
      }
    this.#middles = sums.map(([x, y, n]) => [x / n, y / n])
  }
}

const middleOf = (v: ArrayLike<number>): [number, number] => [(v[0] + v[4]) / 2, (v[1] + v[5]) / 2] // roughly

// The solid is on the left of a line, so what faces up runs to the left.
function rimOf(lines: readonly ArrayLike<number>[]): Path2D {
  const path = new Path2D()
  for (const line of lines)
    for (let k = 2, isOpen = false; k < line.length; k += 2) {
      const dx = line[k] - line[k - 2], dy = line[k + 1] - line[k - 1], isUp = dx < -0.7 * Math.abs(dy)
      if (isUp && !isOpen) path.moveTo(line[k - 2], line[k - 1])
      if (isUp) path.lineTo(line[k], line[k + 1])
      isOpen = isUp
    }
  return path
}

function placed(px: number, py: number, x: number, y: number, angle: number): [number, number] {
  const c = Math.cos(angle), s = Math.sin(angle)
  return [x + c * px - s * py, y + s * px + c * py]
}
