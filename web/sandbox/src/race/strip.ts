// Below the digger two wheels carry what was won there, one with ghost vertices and one without, again and again.
import { element } from '../dom.js'
import { stepTime } from '../side.js'
import { wantsCalm } from '../theme.js'
import { Race } from './race.js'
import { drawLanes } from './view.js'

const wait = 1500 // milliseconds between two races

export class Strip {
  readonly #canvas = element('dig-race').querySelector('canvas')!
  #race = new Race()
  #begun = 0
  #steps = 0
  #ended: number | null = null
  #load = -1

  constructor() {
    this.load = 0
    requestAnimationFrame((now) => {
      this.#begin(now)
      this.#frame(now)
    })
  }

  /** How many crystals they carry. With another one they begin anew. */
  set load(load: number) {
    if (load === this.#load) return
    if (load > this.#load && this.#load >= 0) this.#ended = -Infinity
    this.#load = load
    element('dig-carried').textContent = load === 0 ? '' : `${load === 1 ? 'Your crystal rolls' : `Your ${load} crystals roll`} home.`
  }

  #begin(now: number): void {
    this.#race.free()
    this.#race = new Race()
    this.#begun = now
    this.#steps = 0
    this.#ended = null
    if (wantsCalm()) while (!this.#race.isOver) this.#race.step()
  }

  #frame(now: number): void {
    const canvas = this.#canvas
    if (!canvas.isConnected) return this.#race.free()
    if (this.#ended !== null && now - this.#ended > wait && (!wantsCalm() || this.#ended === -Infinity)) this.#begin(now)
    for (const due = Math.min(this.#steps + 4, Math.floor((now - this.#begun) / 1000 / stepTime)); this.#steps < due; ++this.#steps) this.#race.step()
    if (this.#race.isOver) this.#ended ??= now
    const ratio = Math.min(2, devicePixelRatio), { clientWidth: width, clientHeight: height } = canvas
    if (canvas.width !== width * ratio || canvas.height !== height * ratio) Object.assign(canvas, { width: width * ratio, height: height * ratio })
    const c = canvas.getContext('2d')!
    c.setTransform(ratio, 0, 0, ratio, 0, 0)
    drawLanes(c, this.#race, width, height, this.#load)
    requestAnimationFrame((next) => this.#frame(next))
  }
}
