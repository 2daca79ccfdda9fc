// Drops marbles, boxes and cars.
import type { RiderKind } from '../bodies.js'
import type { Game } from '../game.js'
import type { Tool } from './tool.js'

const sizes = [0.4, 0.3, 0.45, 0.35]

export class DropTool implements Tool {
  readonly #kind: RiderKind
  #dropped = 0
  #last: readonly [number, number] | null = null

  constructor(kind: RiderKind) {
    this.#kind = kind
  }

  down(game: Game, x: number, y: number): void {
    this.#last = [x, y]
    game.drop({ kind: this.#kind, x, y, speed: 0, size: this.#size, colour: this.#dropped, stays: true })
    ++this.#dropped
  }

  move(game: Game, x: number, y: number): void {
    if (this.#last === null || Math.hypot(x - this.#last[0], y - this.#last[1]) < (this.#kind === 'car' ? 3 : 1)) return
    this.down(game, x, y)
  }

  up(): void {
    this.#last = null
  }

  preview(c: CanvasRenderingContext2D, x: number, y: number): void {
    if (this.#kind === 'marble') c.arc(x, y, this.#size, 0, 2 * Math.PI)
    else if (this.#kind === 'box') c.rect(x - this.#size, y - this.#size, 2 * this.#size, 2 * this.#size)
    else c.rect(x - 1, y - 0.65, 2, 1.1)
    c.stroke()
  }

  get #size(): number {
    return this.#kind === 'car' ? 0.7 : sizes[this.#dropped % sizes.length]
  }
}
