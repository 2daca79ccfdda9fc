// What a tool is: it hears where the pointer goes, in cells.
import type { Game } from '../game.js'

export interface Tool {
  down(game: Game, x: number, y: number): void
  move(game: Game, x: number, y: number): void
  up(game: Game): void
  /** What it would do at (x, y). The context's unit is a cell; `pixel` is that of the screen. */
  preview(c: CanvasRenderingContext2D, x: number, y: number, pixel: number): void
}
