// Time: calls step() sixty times a second of simulated time, and draw() in each frame.
import { stepTime } from './side.js'

export class Loop {
  playing = true
  /** Without it nothing happens, and nothing is drawn. */
  running = true
  slow = false
  readonly #step: () => void
  readonly #draw: () => void
  #last = 0
  #owed = 0

  constructor(step: () => void, draw: () => void) {
    this.#step = step
    this.#draw = draw
  }

  start(): void {
    requestAnimationFrame((now) => this.#frame(now))
  }

  #frame(now: number): void {
    if (this.playing && this.running) {
      this.#owed += Math.min(0.05, (now - this.#last) / 1000) * (this.slow ? 0.2 : 1)
      for (; this.#owed >= stepTime; this.#owed -= stepTime) this.#step()
    }
    this.#last = now
    if (this.running) this.#draw()
    this.start()
  }
}
