// A Ground on a canvas.
import { bad, object, reals } from './check.js'
import type { GroundDrawing, Rock } from './ground-types.js'
import type { Block } from './types.js'

interface Drawn {
  readonly outline: Path2D
  readonly fills: readonly (readonly [Block, Path2D])[]
}

function pathOf(lines: Iterable<ArrayLike<number>>, isClosed: boolean): Path2D {
  const path = new Path2D()
  for (const line of lines) {
    for (let k = 0; k < line.length; k += 2) k === 0 ? path.moveTo(line[0]!, line[1]!) : path.lineTo(line[k]!, line[k + 1]!)
    if (isClosed) path.closePath()
  }
  return path
}

const byBlock = (fills: readonly { block: Block; vertices: ArrayLike<number> }[]) =>
  [...new Set(fills.map(({ block }) => block))].map((block) =>
    [block, pathOf(fills.filter((fill) => fill.block === block).map(({ vertices }) => vertices), true)] as const)

/** What a Ground looks like, and its rocks, each block in its colour. Only what changed is made anew; all is drawn. */
export class GroundPicture {
  readonly #ground: { draw(): GroundDrawing[]; rocks(): readonly Rock<unknown>[] }
  readonly #colours: Readonly<Record<number, string>>
  readonly #line: string
  readonly #squares = new Map<string, Drawn>()
  readonly #rocks = new WeakMap<object, Drawn>()

  /** It is told what changed by ground.draw(), which nobody else must ask then. `line` is the colour of the outline. */
  constructor(ground: { draw(): GroundDrawing[]; rocks(): readonly Rock<unknown>[] }, colours: Readonly<Record<number, string>>, line: string = '#2b2320') {
    if (typeof ground?.draw !== 'function' || typeof ground.rocks !== 'function') throw bad('ground', 'a Ground', ground)
    if (typeof line !== 'string') throw bad('line', 'a colour', line)
    this.#ground = ground
    this.#colours = object('colours', 'a colour for each block', colours)
    this.#line = line
  }

  /** The transform is that of a context, from cells to pixels: [scale, 0, 0, -scale, 0, height] for y up. */
  draw(context: CanvasRenderingContext2D, transform: readonly [number, number, number, number, number, number]): void {
    const numbers = reals('transform', transform)
    for (const { key, fills, lines } of this.#ground.draw()) {
      if (fills.length === 0 && lines.length === 0) this.#squares.delete(key)
      else this.#squares.set(key, { outline: pathOf(lines, false), fills: byBlock(fills) })
    }
    context.save()
    context.setTransform(...(numbers as [number, number, number, number, number, number]))
    context.lineJoin = context.lineCap = 'round'
    for (const { fills } of this.#squares.values()) this.#fill(context, fills)
    for (const { outline } of this.#squares.values()) this.#stroke(context, outline, 0.07)
    for (const { ground, x, y, angle } of this.#ground.rocks()) {
      const { outline, fills } = this.#drawnOf(ground)
      context.save()
      context.translate(x, y)
      context.rotate(angle)
      this.#stroke(context, outline, 0.07) // half of it is seen, around the whole
      this.#fill(context, fills)
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

  #fill(context: CanvasRenderingContext2D, fills: Drawn['fills']): void {
    for (const [block, path] of fills) {
      context.fillStyle = this.#colours[block] ?? '#888'
      context.fill(path)
      context.strokeStyle = context.fillStyle
      context.lineWidth = 0.02 // no gaps between polygons
      context.stroke(path)
    }
  }

  #stroke(context: CanvasRenderingContext2D, path: Path2D, width: number): void {
    context.strokeStyle = this.#line
    context.lineWidth = width
    context.stroke(path)
  }
}
