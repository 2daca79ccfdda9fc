// The crystals of the digger's land, and its gold: where they are, and what was won. A crystal is won when it falls far
// enough to burst, or when something heavy falls on it; gold when it is dug out or comes loose. Gold can be spent. An undo
// that brings them back takes them from the count.
import type { CellRect, GroundBody } from 'localgridseg/islands'
import type { Ground } from 'localgridseg/planck'

/** Of the blocks that count. */
export const shine: Readonly<Record<number, string>> = { 3: '#6df0e0', 5: '#ffd166' }
export const large = 3 // this block's hang from stems, and glow
export const gold = 5
const mushroom = 4, stone = 6
const nugget = 0.5 // square cells of gold that are dug for each that is counted
const least = 0.15 // square cells: less is only a crumb
const share = 0.3 // of a rock's area: a boulder with a gem in it stays one
const across = 3 // cells: two pieces that are nearer are of one crystal
const reach = 2.4 // cells that a crystal is away from what falls on it
const heavy = 4, hard = 3 // square cells, and cells a second: what hits so breaks the crystals there
const bursts = 9 // cells a second: a crystal that is slower stays whole
const surely = 10.2 // is shown: between two frames it gets faster
const arm = 1.5 // cells from its middle, where one that topples is faster than there
const thrown = 3 // cells a second, upwards: so a mushroom throws up again what falls on it, and nothing breaks there
const open = 0.4 // cells of air: below that a crystal lies
const sides = [[-2.2, 2.3], [-1.2, 0.5], [1, 1.4], [1.6, 2.7]] // from its tip: a pit that is narrower does not do
const before = -1 // the stroke of what was won at another visit: no undo takes it back
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
  spin: number
}
type Point = readonly [number, number]
/** A rock hit something, or a crystal broke. Positions are in cells, speeds in cells a second. */
export interface Hit {
  readonly at: Point
  readonly area: number
  readonly block: number
  readonly speed: number
  readonly what: 'burst' | 'stays whole' | 'is thrown up' | 'lands'
}
/** Where a crystal would fall, and what then: it bursts only if that is far enough. */
export interface Fall {
  readonly from: Point
  readonly to: Point
  readonly what: 'bursts' | 'stays whole' | 'is thrown up'
}
/** What is kept of a visit. */
export interface Winnings {
  readonly won: readonly { readonly block: number; readonly cavern: number }[]
  readonly dug: number // square cells of gold, less what was spent
}
/** A crystal, a mushroom's cap or a boulder, in the ground; or a part of it in a square. */
export interface Piece {
  readonly block: number
  readonly middle: Point
  readonly low: Point
}

const areaOf = (v: ArrayLike<number>): number => {
  let sum = 0
  for (let k = 0, l = v.length - 2; k < v.length; l = k, k += 2) sum += v[l] * v[k + 1] - v[k] * v[l + 1]
  return sum / 2
}

export class Crystals {
  readonly #ground: Ground
  /** Of each square: the edges that face up, and the pieces of crystals. */
  readonly #squares = new Map<string, { readonly rim: Path2D; readonly pieces: readonly Piece[] }>()
  readonly #known = new WeakMap<GroundBody, Known>()
  #won: { readonly block: number; readonly stroke: number; readonly cavern: number }[] = [] // after which stroke it came loose
  #dug: { readonly area: number; readonly stroke: number }[] = [] // of gold
  #pieces: readonly Piece[] = []

  /** What the picture draws is seen by this, too. */
  constructor(ground: Ground) {
    this.#ground = ground
    const draw = ground.draw.bind(ground)
    ground.draw = () => {
      const squares = draw()
      for (const { key, fills, lines } of squares) {
        if (lines.length === 0 && fills.length === 0) this.#squares.delete(key)
        else this.#squares.set(key, { rim: rimOf(lines), pieces: fills.filter(({ block }) => block === large || block === mushroom || block === stone).map(({ block, vertices }) => ({ block, middle: middleOf(vertices), low: lowestOf(vertices) })) })
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
    return this.#won.filter(({ block }) => block === gold).length + Math.floor(this.#area / nugget + 1e-9)
  }
  get #area(): number {
    return this.#dug.reduce((sum, { area }) => sum + area, 0)
  }
  /** By the last of so many strokes. */
  spend(pieces: number, strokes: number): void {
    this.#dug.push({ area: -pieces * nugget, stroke: strokes })
  }

  /** What came after so many strokes. */
  takeBack(strokes: number): void {
    this.#won = this.#won.filter(({ stroke }) => stroke <= strokes)
    this.#dug = this.#dug.filter(({ stroke }) => stroke <= strokes)
  }

  get winnings(): Winnings {
    return { won: this.#won.map(({ block, cavern }) => ({ block, cavern })), dug: this.#area }
  }
  set winnings({ won, dug }: Winnings) {
    this.#won = won.map((each) => ({ ...each, stroke: before }))
    this.#dug = [{ area: dug, stroke: before }]
  }
  /** A cavern is as it was at first; the gold stays. */
  renew(cavern: number): void {
    const { won, dug } = this.winnings
    this.winnings = { won: won.filter((each) => each.block !== large || each.cavern !== cavern), dug }
  }

  /** Crystals in the ground. */
  get #whole(): readonly Piece[] {
    return this.#pieces.filter(({ block }) => block === large)
  }
  /** What can be cut loose so near. */
  near([x, y]: Point, far: number): readonly Piece[] {
    return this.#pieces.filter(({ middle: [mx, my] }) => Math.hypot(mx - x, my - y) < far)
  }

  /** All edges of the ground that face up. */
  *rims(): Iterable<Path2D> {
    for (const { rim } of this.#squares.values()) yield rim
  }

  /** The middles of those that glow. */
  get glowing(): readonly (readonly [number, number])[] {
    const falling = this.#ground.rocks().filter(({ ground }) => this.#known.get(ground)?.crystal === large)
    return [...this.#whole.map(({ middle }) => middle), ...falling.map(({ ground: { mass }, x, y, angle }) => placed(mass.x, mass.y, x, y, angle))]
  }

  /** Of all that hang free, down to what is below. `gravity` in cells a second, squared. */
  falls(gravity: number): Fall[] {
    const { world } = this.#ground
    return this.#whole.flatMap(({ middle: [middle], low: [x, y] }) => {
      const below = world.rayCast(x, y - 0.01, x, 0)
      if (below === null || y - below.y < open || world.at(middle, y - open / 2).where !== 'outside') return []
      const far = Math.min(y - below.y, ...sides.map(([dx, dy]) => y + dy - (world.rayCast(x + dx, y - 0.01, x + dx, 0)?.y ?? 0)))
      const what = world.hit(below.segment).block === mushroom ? 'is thrown up' : 2 * gravity * far > surely ** 2 ? 'bursts' : 'stays whole'
      return [{ from: [x, y], to: [x, below.y], what } as const]
    })
  }

  /** Whether it is on a mushroom. */
  #isSoft(x: number, y: number, angle: number, { mass }: GroundBody): boolean {
    const [cx, cy] = placed(mass.x, mass.y, x, y, angle), below = this.#ground.world.rayCast(cx, cy, cx, cy - 4)
    return below !== null && this.#ground.world.hit(below.segment).block === mushroom
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
    this.takeBack(strokes)
    const hits: Hit[] = []
    for (const rock of this.#ground.rocks()) {
      const { ground, body, x, y, angle, vx, vy, spin } = rock
      let known = this.#known.get(ground)
      if (known === undefined) this.#known.set(ground, (known = { stroke: strokes, crystal: this.#crystalOf(ground), age: 0, still: 0, vx, vy, spin }))
      const speed = Math.hypot(vx - known.vx, vy - known.vy + gravity * time), fast = Math.hypot(known.vx, known.vy) + arm * Math.abs(known.spin)
      known.age += time
      known.still = Math.hypot(vx, vy) < 0.5 ? known.still + time : 0
      Object.assign(known, { vx, vy, spin })
      const isHit = speed > 4 && known.age > 0.1, isThrown = vy > thrown || (isHit && this.#isSoft(x, y, angle, ground))
      const isBroken = body !== null && (known.crystal === gold ? isHit || known.still > 0.3 : known.crystal === large && isHit && fast > bursts && !isThrown)
      const { x: cx, y: cy, area } = ground.mass, at = placed(cx, cy, x, y, angle)
      if (known.crystal === 0 && area > heavy && speed > hard && !goesBack) hits.push(...this.#smash(at, Math.sqrt(area / Math.PI) + reach, strokes + 1))
      if (!isBroken && speed < 4) continue
      const what = isBroken ? 'burst' : isThrown ? 'is thrown up' : known.crystal === large && isHit ? 'stays whole' : 'lands'
      hits.push({ at, area, block: known.crystal || ground.polygons[0].block, speed, what })
      if (!isBroken) continue
      this.#won.push({ block: known.crystal, stroke: known.stroke, cavern: cavernAt(at[0]) })
      this.#ground.forget(body)
      body.getWorld().destroyBody(body)
    }
    return hits
  }

  /** The crystals that are near, and below. It is a stroke of its own. */
  #smash([x, y]: readonly [number, number], far: number, stroke: number): Hit[] {
    const near = this.#whole.filter(({ middle: [mx, my] }) => my < y && Math.hypot(mx - x, my - y) < far), broken = near.map(({ middle }) => middle)
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
    this.#pieces = this.#pieces.filter((each) => !near.includes(each))
    for (const [mx] of broken) this.#won.push({ block: large, stroke, cavern: cavernAt(mx) })
    return broken.map((at) => ({ at, area: 6, block: large, speed: 6, what: 'burst' }))
  }

  #crystalOf({ polygons, mass }: GroundBody): number {
    const all = new Map<number, number>()
    for (const { block, vertices } of polygons) if (block in shine) all.set(block, (all.get(block) ?? 0) + areaOf(vertices))
    for (const [block, area] of all) if (area > least && area > share * mass.area) return block
    return 0
  }

  // A crystal has pieces in several cells.
  #cluster(): void {
    const sums: { block: number; x: number; y: number; count: number; low: Point }[] = []
    for (const { pieces } of this.#squares.values())
      for (const { block, middle: [x, y], low } of pieces) {
        const near = sums.find((sum) => sum.block === block && Math.hypot(sum.x / sum.count - x, sum.y / sum.count - y) < across)
        if (near === undefined) sums.push({ block, x, y, count: 1, low })
        else Object.assign(near, { x: near.x + x, y: near.y + y, count: near.count + 1, low: lower(near.low, low) })
      }
    this.#pieces = sums.map(({ block, x, y, count, low }) => ({ block, middle: [x / count, y / count], low }))
  }
}

const middleOf = (v: ArrayLike<number>): [number, number] => [(v[0] + v[4]) / 2, (v[1] + v[5]) / 2] // roughly

/** Of two that are as low the left one: what stands on a stem has air there. */
const lower = (a: Point, b: Point): Point => (a[1] < b[1] - 0.05 || (a[1] < b[1] + 0.05 && a[0] < b[0]) ? a : b)
function lowestOf(v: ArrayLike<number>): Point {
  let low: Point = [v[0], v[1]]
  for (let k = 2; k < v.length; k += 2) low = lower(low, [v[k], v[k + 1]])
  return low
}

// The solid is on the left of a line, so what faces up runs to the left.
export function rimOf(lines: readonly ArrayLike<number>[]): Path2D {
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
