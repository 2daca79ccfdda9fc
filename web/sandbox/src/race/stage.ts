// The race in its dialog: starts it, steps it by the clock, and ends it.
import { element, onClick } from '../dom.js'
import { stepTime } from '../side.js'
import { onThemeChange, wantsCalm } from '../theme.js'
import { Race } from './race.js'
import { drawRace } from './view.js'

const address = '#race'
const wait = 400 // milliseconds before the start: until one has looked

export class RaceStage {
  race: Race | null = null
  readonly #dialog = element<HTMLDialogElement>('race-dialog')
  readonly #canvas = this.#dialog.querySelector('canvas')!
  #begun = 0
  #steps = 0

  /** `onOpen` and `onClose`: the sandbox behind it stands still meanwhile. */
  constructor(onOpen: () => void, onClose: () => void) {
    for (const id of ['race', 'dig-race']) onClick(id, () => this.open(onOpen))
    onClick('race-again', () => this.#begin())
    this.#dialog.addEventListener('close', () => {
      this.race?.free()
      this.race = null
      if (location.hash === address) history.replaceState(null, '', location.pathname)
      onClose()
    })
    onThemeChange(() => this.#draw(performance.now()))
    if (location.hash === address) this.open(onOpen)
    addEventListener('hashchange', () => {
      if (location.hash === address) this.open(onOpen)
    })
  }

  open(onOpen: () => void): void {
    if (this.#dialog.open) return
    onOpen()
    this.#dialog.showModal()
    this.#begin()
    requestAnimationFrame((now) => this.#frame(now))
  }

  /** For tests and pictures: steps without a clock, and draws. */
  step(count: number, now: number): void {
    this.#begun = Infinity
    for (let k = 0; k < count; ++k) this.race!.step()
    this.#draw(now)
  }

  #begin(): void {
    this.race?.free()
    this.race = new Race()
    this.#steps = 0
    this.#begun = performance.now() + wait
    element('race-result').textContent = ''
    // Who wants no motion sees how it ended.
    if (wantsCalm()) while (!this.race.isOver) this.race.step()
    this.#draw(performance.now())
  }

  #frame(now: number): void {
    if (this.race === null) return
    const due = Math.min(this.#steps + 4, Math.floor((now - this.#begun) / 1000 / stepTime))
    for (; this.#steps < due; ++this.#steps) this.race.step()
    this.#draw(now)
    requestAnimationFrame((next) => this.#frame(next))
  }

  #draw(now: number): void {
    if (this.race === null) return
    const ratio = Math.min(2, devicePixelRatio)
    const { clientWidth: width, clientHeight: height } = this.#canvas
    if (this.#canvas.width !== width * ratio || this.#canvas.height !== height * ratio) {
      this.#canvas.width = width * ratio
      this.#canvas.height = height * ratio
    }
    const c = this.#canvas.getContext('2d')!
    c.setTransform(ratio, 0, 0, ratio, 0, 0)
    drawRace(c, this.race, width, height, now)
    const { result } = this.race
    if (element('race-result').textContent !== result) element('race-result').textContent = result
  }
}
