// What the panes show: owns the camera's moves, the cursor, and what is lit up.
import type { Camera } from './camera.js'
import { element } from './dom.js'
import type { Game } from './game.js'
import { Glow } from './glow.js'
import { GroundLayer } from './layer.js'
import { describe, segmentAt } from './overlay.js'
import { Pane } from './pane.js'
import { Pointer } from './pointer.js'
import { height, width } from './scenes/landscape.js'
import { settings } from './settings.js'
import { currentTool } from './tools/all.js'

const readable = 7 // pixels per cell that the first view has at least

export class Viewer {
  readonly layer = new GroundLayer()
  readonly glow = new Glow()
  overlay = false
  labels: readonly (readonly [number, number])[] = []
  differences: Float64Array = new Float64Array()
  readonly #game: Game
  readonly camera: Camera
  readonly #panes = [new Pane(element('pane-0')), new Pane(element('pane-1'))]
  readonly #pointer: Pointer
  #shown = ''
  #size = { width: 0, height: 0 }
  readonly #inspector = element('inspector')

  constructor(game: Game, camera: Camera) {
    this.#game = game
    this.camera = camera
    this.#pointer = new Pointer(game, camera)
    this.#panes.forEach((pane, k) => this.#pointer.listen(pane.canvas, k))
    new ResizeObserver(([{ contentRect }]) => {
      this.#size = { width: Math.round(contentRect.width), height: Math.round(contentRect.height) }
    }).observe(this.#panes[0].canvas)
    this.showSides()
  }

  /** After the number of sides, or their ghosts, have changed. */
  showSides(): void {
    this.#panes.forEach((pane, k) => {
      const side = this.#game.sides[k]
      pane.show(side === undefined ? null : side.ghosts ? 'With ghost vertices' : 'Without ghost vertices')
    })
  }

  fit(): void {
    const cells = this.#game.ground.world.bounds() ?? { i0: 0, j0: 0, i1: width - 1, j1: height - 1 }
    this.showCells(cells.i0, cells.j0, cells.i1 + 1, cells.j1 + 2)
  }

  /** Some cells: left, bottom, right, top. */
  showCells(x0: number, y0: number, x1: number, y1: number): void {
    const box = this.#panes[0].canvas.getBoundingClientRect()
    this.camera.fit(x0, y0, x1, y1, box.width, box.height, readable)
  }

  lookAt(x: number, y: number, scale: number): void {
    Object.assign(this.camera, { x, y, scale })
  }

  zoom(factor: number): void {
    this.camera.zoom(factor, this.camera.x, this.camera.y)
  }

  /** By parts of the view. */
  moveView(dx: number, dy: number): void {
    this.camera.pan((-dx * this.#size.width) / 10, (dy * this.#size.height) / 10)
  }

  /** The cursor of the keyboard begins in the middle of the view. */
  moveCursor(dx: number, dy: number): void {
    const [x, y] = this.#pointer.cursor.at ?? [this.camera.x, this.camera.y]
    this.#pointer.cursor.at = [x + dx / 2, y + dy / 2]
  }

  useTool(): void {
    const { at } = this.#pointer.cursor
    const tool = currentTool()
    if (at === null) return
    tool.down(this.#game, ...at, 0)
    tool.up(this.#game)
  }

  draw(): void {
    const { width: paneWidth, height: paneHeight } = this.#size
    if (paneWidth === 0 || paneHeight === 0) return
    const ratio = Math.min(2, devicePixelRatio)
    const { world } = this.#game.ground
    this.#game.ground.commit()
    if (!this.#isNew(paneWidth, paneHeight, ratio)) return
    this.layer.update(world, this.camera, paneWidth, paneHeight, ratio)
    const { at } = this.#pointer.cursor
    const selected = this.overlay && at !== null ? segmentAt(world, ...at, 0.6) : null
    this.#inspector.hidden = selected === null
    if (selected !== null) this.#inspector.textContent = describe(selected)
    const scenery = {
      game: this.#game,
      camera: this.camera,
      layer: this.layer,
      glow: this.glow,
      overlay: this.overlay,
      selected,
      labels: this.labels,
      cursor: at,
      differences: this.differences,
    }
    this.#game.sides.forEach((side, k) => this.#panes[k].draw(side, scenery, paneWidth, paneHeight, ratio))
  }

  // While nothing moves nothing is drawn.
  #isNew(paneWidth: number, paneHeight: number, ratio: number): boolean {
    const sides = this.#game.sides.map((side) => [side.kicks.step, side.riders.length, side.ghosts])
    const shown = JSON.stringify([
      sides,
      this.#pointer.cursor,
      settings,
      this.overlay,
      this.differences.length,
      paneWidth,
      paneHeight,
      ratio,
    ])
    const isNew = shown !== this.#shown || this.glow.isLit || this.layer.isStale(this.camera)
    this.#shown = shown
    return isNew
  }

  /** Where a point of the world is on the page, in the first pane. */
  toPage(x: number, y: number): { x: number; y: number } {
    const box = this.#panes[0].canvas.getBoundingClientRect()
    const [px, py] = this.camera.toPixel(x, y, box.width, box.height)
    return { x: box.left + px, y: box.top + py }
  }
}
