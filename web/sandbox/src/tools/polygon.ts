// A free polygon: each click is a corner. A click on the first corner, or once more on the last one, closes it.
import type { Game } from '../game.js'
import { settings } from '../settings.js'
import type { Tool } from './tool.js'

const closeTo = 0.35 // cells

export class PolygonTool implements Tool {
  #corners: [number, number][] = []

  down(game: Game, x: number, y: number): void {
    const ends = [this.#corners.at(0), this.#corners.at(-1)]
    if (ends.some((end) => end !== undefined && Math.hypot(x - end[0], y - end[1]) < closeTo)) this.#close(game)
    else this.#corners.push([x, y])
  }

  move(): void {}

  up(): void {}

  #close(game: Game): void {
    const ring = this.#corners
    this.#corners = []
    if (ring.length < 3) return
    game.ground.begin()
    game.ground.edit({ kind: 'paint', region: { rings: [ring] }, block: settings.block })
    game.ground.end()
  }

  cancel(): void {
    this.#corners = []
  }

  preview(c: CanvasRenderingContext2D, x: number, y: number, pixel: number): void {
    for (const [cx, cy] of this.#corners) c.lineTo(cx, cy)
    c.lineTo(x, y)
    c.stroke()
    c.beginPath()
    for (const [cx, cy] of [...this.#corners, [x, y]]) {
      c.moveTo(cx + 4 * pixel, cy)
      c.arc(cx, cy, 4 * pixel, 0, 2 * Math.PI)
    }
    c.fill()
  }
}
