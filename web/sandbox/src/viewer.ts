// What the panes show: owns the camera's moves, the cursor, and what is lit up.
import type { Camera } from './camera.js'
import { element } from './dom.js'
import type { Game } from './game.js'
import { Glow } from './glow.js'
import { GroundLayer } from './layer.js'
import { describe, segmentAt } from './overlay.js'
import { Pane } from './pane.js'
import { Pointer } from './pointer.js'
import type { Scene } from './scenes/all.js'
import { settings } from './settings.js'
import { currentTool } from './tools/all.js'

export class Viewer {
  readonly layer = new GroundLayer()
  readonly glow = new Glow()
  overlay = false
  labels: readonly (readonly [number, number])[] = []
  differences: Float64Array = new Float64Array()
  home: Pick<Scene, 'view' | 'middle'> | null = null
  /** Where somebody is asked to dig: x, y; null if nowhere. */
  invitation: readonly [number, number] | null = null
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
    this.#panes.forEach(({ canvas }, k) => {
      this.#pointer.listen(canvas, k)
      canvas.addEventListener('focus', () => canvas.matches(':focus-visible') && this.moveCursor(0, 0)) // so that one sees it
    })
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

  /** What its scene says is to be seen at first; everything, if it says nothing. */
  showHome(): void {
    if (this.home?.view === undefined) this.fit()
    else this.showCells(this.home.view, this.home.middle)
  }

  fit(): void {
    const cells = this.#game.ground.world.bounds() ?? { i0: 0, j0: 0, i1: 47, j1: 9 }
    this.showCells([cells.i0, cells.j0, cells.i1 + 1, cells.j1 + 2])
  }

  /** Some cells: left, bottom, right, top. */
  showCells(cells: readonly [number, number, number, number], middle?: number): void {
    const box = this.#panes[0].canvas.getBoundingClientRect()
    this.camera.fit(cells, box.width, box.height, middle)
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

  /** The cursor of the keyboard begins where somebody is asked to dig, or in the middle of the view. */
  moveCursor(dx: number, dy: number): void {
    const [x, y] = this.#pointer.cursor.at ?? this.invitation ?? [this.camera.x, this.camera.y]
    this.#pointer.cursor.at = [x + dx / 2, y + dy / 2]
  }

  useTool(): void {
    if (this.#pointer.cursor.at === null) this.moveCursor(0, 0)
    const tool = currentTool()
    tool.down(this.#game, ...this.#pointer.cursor.at!, 0)
    tool.up(this.#game)
  }

  /** Whether there is something to see now. */
  draw(): boolean {
    const { width: paneWidth, height: paneHeight } = this.#size
    if (paneWidth === 0 || paneHeight === 0) return false
    const ratio = Math.min(2, devicePixelRatio)
    const { world } = this.#game.ground
    this.#game.ground.commit()
    if (!this.#isNew(paneWidth, paneHeight, ratio)) return true
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
      invitation: this.invitation,
      differences: this.differences,
    }
    this.#game.sides.forEach((side, k) => this.#panes[k].draw(side, scenery, paneWidth, paneHeight, ratio))
    return true
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
    const isNew = shown !== this.#shown || this.glow.isLit || this.layer.isStale(this.camera) || this.invitation !== null
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
