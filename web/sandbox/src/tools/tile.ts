// Puts a shape of the palette into cells, or empties them.
import type { Game } from '../game.js'
import { settings } from '../settings.js'
import { tiles, turned } from '../tiles.js'
import type { Tool } from './tool.js'

export class TileTool implements Tool {
  #last = ''

  down(game: Game, x: number, y: number): void {
    game.ground.begin()
    this.#last = ''
    this.move(game, x, y)
  }

  move(game: Game, x: number, y: number): void {
    const [i, j] = [Math.floor(x), Math.floor(y)]
    if (this.#last === `${i} ${j}`) return
    this.#last = `${i} ${j}`
    if (settings.tile < 0) game.ground.edit({ kind: 'clear', i, j })
    else
      game.ground.edit({
        kind: 'tile',
        i,
        j,
        vertices: turned(tiles[settings.tile].vertices, settings.quarters),
        block: settings.block,
      })
  }

  up(game: Game): void {
    game.ground.end()
  }

  preview(c: CanvasRenderingContext2D, x: number, y: number): void {
    const [i, j] = [Math.floor(x), Math.floor(y)]
    const corners = settings.tile < 0 ? tiles[0].vertices : turned(tiles[settings.tile].vertices, settings.quarters)
    for (const [cx, cy] of corners) c.lineTo(i + cx, j + cy)
    c.closePath()
    c.stroke()
  }
}
