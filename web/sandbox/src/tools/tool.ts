// What a tool is: it hears where the pointer goes, in cells.
import type { Game } from '../game.js'

export interface Tool {
  /** `side` is the number of the physics world that is shown there. */
  down(game: Game, x: number, y: number, side: number): void
  move(game: Game, x: number, y: number): void
  up(game: Game): void
  /** Whether it has nothing to do there: then the pointer moves the view. */
  isIdleAt?(game: Game, x: number, y: number, side: number): boolean
  /** What it would do at (x, y). The context's unit is a cell; `pixel` is that of the screen. */
  preview(c: CanvasRenderingContext2D, x: number, y: number, pixel: number): void
}
