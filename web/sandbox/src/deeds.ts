// What a visitor did in the digger, as it is counted and taken back: strokes, digs, and the fewest digs of each cavern. A
// dig has a stroke for each move of the pointer; who drags on and on through soil begins another one.
import type { GroundPicture } from 'localgridseg/draw'
import type { Ground } from 'localgridseg/planck'
import { cavernAt } from './crystals.js'
import { wantsCalm } from './theme.js'

const bedrock = 2 // its block
const brush = 0.6 // cells, as in digger.js
const long = 8 // cells through soil, of one dig
const quick = 9 // how fast one goes back: such a part of the way in a second, at first
const margin = 0.2 // of the width: what is taken back is nearer to the middle

/** What is kept of a visit: of caverns. */
export interface Counts {
  readonly digs: readonly (readonly [number, number])[]
  readonly best: readonly (readonly [number, number])[]
}

export class Deeds {
  /** Where the next stroke is made, as x. */
  at = 0
  readonly best = new Map<number, number>()
  readonly #ground: Ground
  readonly #picture: GroundPicture
  readonly #canvas: HTMLCanvasElement
  #places: number[] = [] // of all strokes that can be taken back
  #begun: { readonly strokes: number; isDig: boolean }[] = [] // how many strokes there were when each began
  #before = new Map<number, number>() // digs that no undo takes back
  #last: readonly [number, number] | null = null
  #length = 0 // of this dig
  #to: number | null = null // so many strokes stay: it goes back
  #wentBack = -Infinity // when

  // One goes back where it is seen: until then the picture moves.
  constructor(ground: Ground, picture: GroundPicture, canvas: HTMLCanvasElement) {
    this.#ground = ground
    this.#picture = picture
    this.#canvas = canvas
    const edit = ground.edit.bind(ground), undo = ground.undo.bind(ground)
    ground.edit = (edits) => {
      const result = edit(edits)
      this.#places.push(this.at)
      return result
    }
    ground.undo = () => {
      if (!ground.canUndo) return false
      const isSeen = this.#isSeen(this.#places.at(-1)!)
      this.#wentBack = performance.now()
      if (!isSeen) return false
      this.#places.pop()
      return undo()
    }
  }

  /** That can be taken back. */
  get strokes(): number {
    return this.#places.length
  }

  /** How often something was begun. */
  get begun(): number {
    return this.#begun.length
  }

  get goesBack(): boolean {
    return this.#to !== null || performance.now() - this.#wentBack < 150
  }

  get counts(): Counts {
    const caverns = new Set([...this.#before.keys(), ...this.#places.map(cavernAt)])
    return { digs: [...caverns].map((cavern) => [cavern, this.digsIn(cavern)]), best: [...this.best] }
  }
  set counts({ digs, best }: Counts) {
    this.#before = new Map(digs)
    for (const [cavern, count] of best) this.best.set(cavern, count)
  }

  digsIn(cavern: number): number {
    const isThere = ({ strokes, isDig }: { strokes: number; isDig: boolean }) => isDig && strokes < this.#places.length && cavernAt(this.#places[strokes]) === cavern
    return (this.#before.get(cavern) ?? 0) + this.#begun.filter(isThere).length
  }

  /** What follows is taken back together. It is a dig once it meets soil. */
  begin(): void {
    this.#to = null
    this.#last = null
    this.#length = 0
    this.#begun.push({ strokes: this.#places.length, isDig: false })
  }

  /** Before the brush goes there. */
  strike([x, y]: readonly [number, number]): void {
    const [fx, fy] = this.#last ?? [x, y]
    this.#last = [x, y]
    const far = Math.hypot(x - fx, y - fy), steps = Math.max(1, Math.ceil(far / (brush / 2)))
    for (let k = 1; k <= steps; ++k) {
      if (!this.#isSoil(fx + ((x - fx) * k) / steps, fy + ((y - fy) * k) / steps)) continue
      this.#begun.at(-1)!.isDig = true
      this.#length += far / steps
    }
    if (this.#length < long) return
    this.begin()
    this.#last = [x, y]
  }

  /** Where the brush meets it. */
  #isSoil(x: number, y: number): boolean {
    return [[0, 0], [brush, 0], [-brush, 0], [0, brush], [0, -brush]].some(([dx, dy]) => {
      const spot = this.#ground.world.at(x + dx, y + dy)
      return spot.where !== 'outside' && spot.block !== bedrock
    })
  }

  /** To before what was begun last. */
  rewind(): void {
    while (this.#begun.length > 0) {
      const { strokes } = this.#begun.pop()!
      if (strokes >= this.#places.length) continue // it is taken back already
      this.#to = Math.min(strokes, this.#to ?? strokes)
      return
    }
  }

  /** A cavern begins anew, and nothing can be taken back any more. */
  renew(cavern: number): void {
    this.#ground.forgetUndo()
    this.#before = new Map(this.counts.digs)
    this.#before.delete(cavern)
    this.#places = []
    this.#begun = []
    this.#to = null
  }

  /** In each frame, after so many seconds. */
  step(time: number): void {
    if (this.#to === null) return
    let left = Math.ceil((this.#places.length - this.#to) * Math.min(1, quick * time))
    for (; left > 0; --left) if (!this.#ground.undo()) break
    if (this.#places.length <= this.#to || !this.#ground.canUndo) this.#to = null
  }

  /** A part of the way, if it is not. */
  #isSeen(at: number): boolean {
    const picture = this.#picture, wide = this.#canvas.clientWidth / picture.size
    const part = 1 - Math.exp((-quick * Math.min(50, performance.now() - this.#wentBack)) / 1000)
    const off = Math.max(0, picture.x + margin * wide - at) - Math.max(0, at - picture.x - (1 - margin) * wide)
    if (Math.abs(off) < 0.5) return true
    picture.x -= wantsCalm() ? off : Math.sign(off) * Math.min(Math.abs(off), part * (2 + Math.abs(off)))
    return false
  }
}
