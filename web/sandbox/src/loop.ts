// Time: calls step() sixty times a second of simulated time, and draw() in each frame. Where steps take too long for that
// time goes slower: to catch up would make the next frame late, too.
import { stepTime } from './side.js'

const enough = 8 // milliseconds of steps in a frame

export class Loop {
  playing = true
  /** Without it nothing happens, and nothing is drawn anew. */
  running = true
  slow = false
  readonly #step: () => void
  readonly #draw: () => boolean
  #isSeen = false
  #last = 0
  #owed = 0

  /** `draw` says whether there is something to see now. */
  constructor(step: () => void, draw: () => boolean) {
    this.#step = step
    this.#draw = draw
  }

  start(): void {
    requestAnimationFrame((now) => this.#frame(now))
  }

  #frame(now: number): void {
    if (this.playing && this.running) {
      this.#owed += Math.min(0.05, (now - this.#last) / 1000) * (this.slow ? 0.2 : 1)
      const latest = performance.now() + enough
      while (this.#owed >= stepTime) {
        this.#step()
        this.#owed = performance.now() < latest ? this.#owed - stepTime : this.#owed % stepTime
      }
    }
    this.#last = now
    if (this.running || !this.#isSeen) this.#isSeen = this.#draw()  // once in any case: behind a dialogue, too
    this.start()
  }
}
