// Mouse, pen and touch on the panes: one pointer uses the tool or moves the view, two fingers move and zoom.
import type { Camera } from './camera.js'
import type { Game } from './game.js'
import { settings } from './settings.js'
import { currentTool } from './tools/all.js'
import type { Tool } from './tools/tool.js'

const slack = 5 // pixels that a finger may tremble

export interface Cursor {
  /** In cells; null while no pointer is over a pane. */
  at: readonly [number, number] | null
}

interface Spot {
  x: number
  y: number
}

export class Pointer {
  readonly cursor: Cursor = { at: null }
  readonly #game: Game
  readonly #camera: Camera
  readonly #touches = new Map<number, Spot>()
  #using: Tool | null = null
  #waiting: (() => void) | null = null // what a finger will do
  #panning = false

  constructor(game: Game, camera: Camera) {
    this.#game = game
    this.#camera = camera
  }

  /** A pane, which shows the side of this number. */
  listen(canvas: HTMLCanvasElement, side: number): void {
    canvas.addEventListener('pointerdown', (event) => this.#down(canvas, event, side))
    canvas.addEventListener('pointermove', (event) => this.#move(canvas, event))
    for (const end of ['pointerup', 'pointercancel'] as const) canvas.addEventListener(end, (event) => this.#up(event))
    canvas.addEventListener('pointerleave', (event) => {
      if (!this.#touches.has(event.pointerId)) this.cursor.at = null
    })
    canvas.addEventListener('contextmenu', (event) => event.preventDefault())
    canvas.addEventListener('wheel', (event) => this.#wheel(canvas, event), { passive: false })
  }

  #cellOf(canvas: HTMLCanvasElement, event: MouseEvent): [number, number] {
    const box = canvas.getBoundingClientRect()
    return this.#camera.toCell(event.clientX - box.left, event.clientY - box.top, box.width, box.height)
  }

  #down(canvas: HTMLCanvasElement, event: PointerEvent, side: number): void {
    canvas.setPointerCapture(event.pointerId)
    this.#touches.set(event.pointerId, { x: event.clientX, y: event.clientY })
    if (this.#touches.size > 1) {
      this.#waiting = null
      this.#stopUsing()
      return
    }
    const [x, y] = (this.cursor.at = this.#cellOf(canvas, event))
    const tool = currentTool()
    this.#panning = event.button !== 0 || tool.isIdleAt?.(this.#game, x, y, side) === true
    if (this.#panning) return
    this.#waiting = () => {
      this.#using = tool
      tool.down(this.#game, x, y, side)
    }
    if (event.pointerType !== 'touch') this.#begin()
  }

  // A finger uses the tool once it moves, or when it goes: until then a second one may come, to move the view.
  #begin(): void {
    this.#waiting?.()
    this.#waiting = null
  }

  #move(canvas: HTMLCanvasElement, event: PointerEvent): void {
    const touch = this.#touches.get(event.pointerId)
    const at = (this.cursor.at = this.#cellOf(canvas, event))
    if (touch === undefined) return
    if (this.#touches.size === 2) this.#pinch(canvas, touch, event)
    else if (Math.hypot(event.clientX - touch.x, event.clientY - touch.y) < slack && this.#waiting !== null) return
    else if (this.#panning) this.#camera.pan(event.clientX - touch.x, event.clientY - touch.y)
    else {
      this.#begin()
      this.#using?.move(this.#game, ...at)
    }
    touch.x = event.clientX
    touch.y = event.clientY
  }

  #pinch(canvas: HTMLCanvasElement, touch: Spot, event: PointerEvent): void {
    const other = [...this.#touches.values()].find((each) => each !== touch)!
    const before = Math.hypot(touch.x - other.x, touch.y - other.y)
    const after = Math.hypot(event.clientX - other.x, event.clientY - other.y)
    this.#camera.pan((event.clientX - touch.x) / 2, (event.clientY - touch.y) / 2)
    const box = canvas.getBoundingClientRect()
    const middle = this.#camera.toCell(
      (event.clientX + other.x) / 2 - box.left,
      (event.clientY + other.y) / 2 - box.top,
      box.width,
      box.height,
    )
    if (before > 0) this.#camera.zoom(after / before, ...middle)
  }

  #up(event: PointerEvent): void {
    this.#touches.delete(event.pointerId)
    if (event.type === 'pointerup') this.#begin()
    this.#waiting = null
    this.#stopUsing()
    this.#panning = false
    // A tap of the hand looks at a segment.
    if (event.pointerType === 'touch' && settings.tool !== 'hand') this.cursor.at = null
  }

  #stopUsing(): void {
    this.#using?.up(this.#game)
    this.#using = null
  }

  #wheel(canvas: HTMLCanvasElement, event: WheelEvent): void {
    event.preventDefault()
    this.#camera.zoom(Math.exp(-event.deltaY / (event.deltaMode === 0 ? 500 : 15)), ...this.#cellOf(canvas, event))
  }
}
