// The first seconds of who has not been here: one rock is dug free, and falls; and a place is shown where the next one
// hangs. Whatever a visitor does ends it.
import type { Game } from './game.js'
import { noteWelcome } from './keep.js'
import { neckOf, rocks } from './scenes/landscape.js'
import { settings } from './settings.js'
import { wantsCalm } from './theme.js'
import { Brush } from './tools/brush.js'
import type { Viewer } from './viewer.js'

const before = 900 // milliseconds until it digs
const takes = 500
const next = 1400 // after it has dug
const longest = 30_000

export class Welcome {
  readonly #game: Game
  readonly #viewer: Viewer
  readonly #onEnd: () => void
  readonly #brush = new Brush(true)
  readonly #begun = performance.now()
  #step: 'waits' | 'digs' | 'asks' | 'over' = 'waits'

  constructor(game: Game, viewer: Viewer, onEnd: () => void) {
    this.#game = game
    this.#viewer = viewer
    this.#onEnd = onEnd
    viewer.invitation = neckOf(rocks[0])
    for (const event of ['pointerdown', 'keydown', 'wheel', 'hashchange']) addEventListener(event, () => this.end(), { once: true, capture: true })
    if (wantsCalm()) this.#step = 'asks'
    else this.#frame()
  }

  end(): void {
    if (this.#step === 'over') return
    if (this.#step === 'digs') this.#brush.up(this.#game)
    this.#step = 'over'
    this.#viewer.invitation = null
    noteWelcome()
    this.#onEnd()
  }

  #frame(): void {
    if (this.#step === 'over') return
    const time = performance.now() - this.#begun - before, [x, y] = neckOf(rocks[0])
    const at = x + settings.radius * (Math.min(1, time / takes) - 0.5)
    if (this.#step === 'waits' && time >= 0) {
      this.#brush.down(this.#game, at, y)
      this.#step = 'digs'
    } else if (this.#step === 'digs') {
      this.#brush.move(this.#game, at, y)
      this.#viewer.invitation = [at, y]
      if (time >= takes) {
        this.#brush.up(this.#game)
        this.#viewer.invitation = null
        this.#step = 'asks'
      }
    } else if (this.#step === 'asks' && time >= takes + next) {
      this.#viewer.invitation = neckOf(rocks[1])
    }
    if (time < longest) requestAnimationFrame(() => this.#frame())
    else this.end()
  }
}
