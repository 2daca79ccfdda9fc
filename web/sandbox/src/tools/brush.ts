// The round brush: digs, or paints.
import { circle, type Region, thickLine } from 'localgridseg'
import type { Edit } from '../edit.js'
import type { Game } from '../game.js'
import { settings } from '../settings.js'
import type { Tool } from './tool.js'

// A small brush needs few corners, and each of them costs.
function corners(): number {
  return 8 * Math.ceil(1 + settings.radius)
}

export class Brush implements Tool {
  readonly #digs: boolean
  #last: readonly [number, number] | null = null

  constructor(digs: boolean) {
    this.#digs = digs
  }

  down(game: Game, x: number, y: number): void {
    game.ground.begin()
    this.#last = [x, y]
    game.ground.edit(this.#edit(circle(x, y, settings.radius, corners())))
  }

  move(game: Game, x: number, y: number): void {
    if (this.#last === null || Math.hypot(x - this.#last[0], y - this.#last[1]) < settings.radius / 8) return
    game.ground.edit(this.#edit(thickLine([this.#last, [x, y]], settings.radius, corners())))
    this.#last = [x, y]
  }

  up(game: Game): void {
    this.#last = null
    game.ground.end()
  }

  preview(c: CanvasRenderingContext2D, x: number, y: number): void {
    c.arc(x, y, settings.radius, 0, 2 * Math.PI)
    c.stroke()
  }

  #edit(region: Region): Edit {
    return this.#digs ? { kind: 'carve', region } : { kind: 'paint', region, block: settings.block }
  }
}
