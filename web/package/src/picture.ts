// A Ground on a canvas.
import { bad, finite, object, options as known, within } from './check.js'
import type { GroundDrawing, Rock } from './ground-types.js'
import type { Block, CellRect } from './types.js'

interface Drawn {
  readonly outline: Path2D
  readonly fills: readonly (readonly [Block, Path2D])[]
}

type Ring = ArrayLike<number>

function pathOf(lines: Iterable<Ring>, isClosed: boolean): Path2D {
  const path = new Path2D()
  for (const line of lines) {
    for (let k = 0; k < line.length; k += 2) k === 0 ? path.moveTo(line[0]!, line[1]!) : path.lineTo(line[k]!, line[k + 1]!)
    if (isClosed) path.closePath()
  }
  return path
}

/** Twice the area, by its diagonals, is that of a cell. */
const isWhole = (v: Ring) => v.length === 8 && Math.abs((v[4]! - v[0]!) * (v[7]! - v[3]!) - (v[6]! - v[2]!) * (v[5]! - v[1]!)) === 2

/** Whole cells that lie beside each other as rectangles: there are far fewer lines to fill. */
function joined(rings: readonly Ring[]): Ring[] {
  const whole = rings.filter(isWhole).map((v) => [Math.min(v[0]!, v[4]!), Math.min(v[1]!, v[5]!)] as const).sort((a, b) => a[1] - b[1] || a[0] - b[0])
  const rows: [number, number, number, number][] = [], rectangles = new Map<string, [number, number, number, number]>()
  for (const [x, y] of whole) {
    const last = rows.at(-1)
    if (last !== undefined && last[1] === y && last[2] === x) ++last[2]
    else rows.push([x, y, x + 1, y + 1])
  }
  const all = rings.filter((v) => !isWhole(v))
  const close = ([x0, y0, x1, y1]: [number, number, number, number]) => all.push([x0, y0, x1, y0, x1, y1, x0, y1])
  for (const row of rows) {
    const key = `${row[0]} ${row[2]}`, below = rectangles.get(key)
    if (below !== undefined && below[3] === row[1]) {
      ++below[3]
      continue
    }
    if (below !== undefined) close(below)
    rectangles.set(key, row)
  }
  for (const rectangle of rectangles.values()) close(rectangle)
  return all
}

const byBlock = (fills: readonly { block: Block; vertices: Ring }[]) =>
  [...new Set(fills.map(({ block }) => block))].map((block) =>
    [block, pathOf(joined(fills.filter((fill) => fill.block === block).map(({ vertices }) => vertices)), true)] as const)

/** A colour; or a gradient or a pattern, in cells. */
export type Fill = string | CanvasGradient | CanvasPattern

export interface PictureOptions {
  /** What is in the lower left corner, in cells: 0, 0, if it is not given. */
  readonly x?: number
  readonly y?: number
  /** Of a cell, in pixels of the page: 24, if it is not given. */
  readonly size?: number
  /** The colour of the outline. */
  readonly line?: string
}

const leastSize = 0.1, mostSize = 10_000

/** What a Ground looks like, and its rocks, each block in its colour. Only what changed is rebuilt; all is drawn. */
export class GroundPicture {
  /** What is in the lower left corner, in cells, and the size of a cell in pixels of the page: yours to change. */
  x: number
  y: number
  size: number
  readonly #ground: { draw(): GroundDrawing[]; rocks(): readonly Rock<unknown>[] }
  readonly #canvas: HTMLCanvasElement
  readonly #colours: Readonly<Record<number, Fill>>
  readonly #line: string
  readonly #squares = new Map<string, Drawn>()
  readonly #rocks = new WeakMap<object, Drawn>()

  /** It gets what changed from ground.draw(), which nothing else must call then. */
  constructor(ground: { draw(): GroundDrawing[]; rocks(): readonly Rock<unknown>[] }, canvas: HTMLCanvasElement, colours: Readonly<Record<number, Fill>>, options: PictureOptions = {}) {
    if (typeof ground?.draw !== 'function' || typeof ground.rocks !== 'function') throw bad('ground', 'a Ground', ground)
    if (typeof canvas?.getContext !== 'function') throw bad('canvas', 'a canvas', canvas)
    const { x = 0, y = 0, size = 24, line = '#2b2320' } = known('options', ['x', 'y', 'size', 'line'], options)
    if (typeof line !== 'string') throw bad('line', 'a colour', line)
    this.#ground = ground
    this.#canvas = canvas
    this.#colours = object('colours', 'a colour for each block', colours)
    this.#line = line
    this.x = finite('x', x)
    this.y = finite('y', y)
    this.size = within('size', size, leastSize, mostSize)
  }

  /** Where a pointer is, in cells. */
  at(pointer: { readonly offsetX: number; readonly offsetY: number }): [number, number] {
    const { offsetX, offsetY } = object('pointer', 'an event of a pointer', pointer)
    return [this.x + offsetX / this.size, this.y + (this.#canvas.clientHeight - offsetY) / this.size]
  }

  /** What is seen: for Ground.window(). */
  get cells(): CellRect {
    const { clientWidth, clientHeight } = this.#canvas, { x, y, size } = this
    return { i0: Math.floor(x), j0: Math.floor(y), i1: Math.floor(x + clientWidth / size), j1: Math.floor(y + clientHeight / size) }
  }

  /** All of the canvas, which gets as many pixels as the screen has there. */
  draw(): void {
    const canvas = this.#canvas, context = canvas.getContext('2d')!, ratio = globalThis.devicePixelRatio ?? 1
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio), scale = this.size * ratio
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height })
    for (const { key, fills, lines } of this.#ground.draw()) {
      if (fills.length === 0 && lines.length === 0) this.#squares.delete(key)
      else this.#squares.set(key, { outline: pathOf(lines, false), fills: byBlock(fills) })
    }
    context.clearRect(0, 0, width, height)
    context.save()
    context.setTransform(scale, 0, 0, -scale, -scale * this.x, height + scale * this.y)
    context.lineJoin = context.lineCap = 'round'
    for (const { fills } of this.#squares.values()) this.#fill(context, fills, 0.06)
    for (const { outline } of this.#squares.values()) this.#stroke(context, outline, 0.07)
    for (const { ground, x, y, angle } of this.#ground.rocks()) {
      const { outline, fills } = this.#drawnOf(ground)
      context.save()
      context.translate(x, y)
      context.rotate(angle)
      this.#stroke(context, outline, 0.07) // half of it is seen, around the whole
      this.#fill(context, fills, 0.02)
      context.restore()
    }
    context.restore()
  }

  #drawnOf(ground: Rock<unknown>['ground']): Drawn {
    let drawn = this.#rocks.get(ground)
    if (drawn === undefined) {
      const fills = ground.polygons.map(({ i, j, block, vertices }) =>
        ({ block, vertices: Array.from(vertices, (v, k) => v + (k % 2 === 0 ? i : j)) }))
      drawn = { outline: pathOf(fills.map(({ vertices }) => vertices), true), fills: byBlock(fills) }
      this.#rocks.set(ground, drawn)
    }
    return drawn
  }

  #fill(context: CanvasRenderingContext2D, fills: Drawn['fills'], width: number): void {
    for (const [block, path] of fills) {
      context.fillStyle = this.#colours[block] ?? '#888'
      context.fill(path)
      context.strokeStyle = context.fillStyle
      context.lineWidth = width // no gaps between polygons; the outline covers it
      context.stroke(path)
    }
  }

  #stroke(context: CanvasRenderingContext2D, path: Path2D, width: number): void {
    context.strokeStyle = this.#line
    context.lineWidth = width
    context.stroke(path)
  }
}
