// The picture of the ground, kept as a bitmap of the size of a pane. An edit draws anew only the cells that it changed.
import type { CellRect, Polygon, World } from 'localgridseg'
import { linesIn } from 'localgridseg/draw'
import { kindOf } from './blocks.js'
import type { Camera } from './camera.js'
import { rimOf } from './crystals.js'
import { css, darkened, drawSky, pixels, soilTile } from './look.js'
import { patternOf, theme } from './theme.js'

const cheap = 8000 // cells: a view of so many is drawn anew in every frame in which the camera moves
const rest = 120 // milliseconds after which a larger view is drawn anew
const small = 5 // pixels of a cell: below that soil is a colour
const high = 24 // cells of the sky, from the bottom of a pane to its top

export class GroundLayer {
  readonly canvas = document.createElement('canvas')
  readonly #context = this.canvas.getContext('2d')!
  #drawn = { x: 0, y: 0, scale: 0 }
  #ratio = 1
  #whole = true
  #dirty: CellRect[] = []
  #moved = 0
  #soil: HTMLCanvasElement | null = null // in the light of the theme

  /** Everything has to be drawn anew, in the colours of now. */
  reset(): void {
    this.#whole = true
    this.#soil = null
  }

  /** Whether the bitmap shows something else than it should. */
  isStale(camera: Camera): boolean {
    return this.#whole || this.#dirty.length > 0 || this.#isElsewhere(camera)
  }

  touch(cells: CellRect): void {
    this.#dirty.push(cells)
  }

  /** Brings the bitmap up to date. */
  update(world: World, camera: Camera, width: number, height: number, ratio: number): void {
    if (this.canvas.width !== width * ratio || this.canvas.height !== height * ratio) {
      this.canvas.width = width * ratio
      this.canvas.height = height * ratio
      this.#ratio = ratio
      this.#whole = true
    }
    if (this.#isElsewhere(camera)) {
      this.#moved ||= performance.now()
      if (this.#cellsAt(camera.scale) < cheap || performance.now() - this.#moved > rest) this.#whole = true
    }
    if (this.#whole) {
      this.#drawn = { x: camera.x, y: camera.y, scale: camera.scale }
      this.#whole = false
      this.#moved = 0
      this.#draw(world, 0, 0, this.canvas.width, this.canvas.height)
    } else {
      for (const cells of this.#dirty) this.#drawCells(world, cells)
    }
    this.#dirty = []
  }

  /** Draws the bitmap into a pane: moved and scaled if the camera has moved on since. */
  paintOn(context: CanvasRenderingContext2D, camera: Camera): void {
    const { width, height } = this.canvas
    const zoom = camera.scale / this.#drawn.scale
    const unit = camera.scale * this.#ratio
    const left = width / 2 + (this.#drawn.x - camera.x) * unit - (width / 2) * zoom
    const top = height / 2 - (this.#drawn.y - camera.y) * unit - (height / 2) * zoom
    context.drawImage(this.canvas, left, top, width * zoom, height * zoom)
  }

  #isElsewhere(camera: Camera): boolean {
    return camera.x !== this.#drawn.x || camera.y !== this.#drawn.y || camera.scale !== this.#drawn.scale
  }

  #cellsAt(scale: number): number {
    const unit = scale * this.#ratio
    return (this.canvas.width / unit) * (this.canvas.height / unit)
  }

  // Pixels of the bitmap.
  #px(x: number): number {
    return this.canvas.width / 2 + (x - this.#drawn.x) * this.#drawn.scale * this.#ratio
  }

  #py(y: number): number {
    return this.canvas.height / 2 - (y - this.#drawn.y) * this.#drawn.scale * this.#ratio
  }

  #drawCells(world: World, cells: CellRect): void {
    const margin = 2
    const left = Math.max(0, Math.floor(this.#px(cells.i0)) - margin)
    const right = Math.min(this.canvas.width, Math.ceil(this.#px(cells.i1 + 1)) + margin)
    const top = Math.max(0, Math.floor(this.#py(cells.j1 + 1)) - margin)
    const bottom = Math.min(this.canvas.height, Math.ceil(this.#py(cells.j0)) + margin)
    if (left < right && top < bottom) this.#draw(world, left, top, right, bottom)
  }

  #draw(world: World, left: number, top: number, right: number, bottom: number): void {
    const c = this.#context
    const unit = this.#drawn.scale * this.#ratio
    const cells = {
      i0: Math.floor((left - this.canvas.width / 2) / unit + this.#drawn.x),
      i1: Math.floor((right - this.canvas.width / 2) / unit + this.#drawn.x),
      j0: Math.floor((this.canvas.height / 2 - bottom) / unit + this.#drawn.y),
      j1: Math.floor((this.canvas.height / 2 - top) / unit + this.#drawn.y),
    }
    c.save()
    c.beginPath()
    c.rect(left, top, right - left, bottom - top)
    c.clip()
    const sky = this.canvas.height / high
    c.setTransform(sky, 0, 0, -sky, 0, this.canvas.height)
    drawSky(c, theme().mood, 0, this.canvas.width / sky, 0)
    c.resetTransform()
    this.#drawPolygons(world.polygons(cells))
    this.#drawGrid(cells, unit)
    this.#drawOutline(world, { i0: cells.i0 - 1, j0: cells.j0 - 1, i1: cells.i1 + 1, j1: cells.j1 + 1 }, unit)
    c.restore()
  }

  #drawGrid(cells: CellRect, unit: number): void {
    if (unit < 10) return
    const c = this.#context
    c.beginPath()
    for (let i = cells.i0; i <= cells.i1 + 1; ++i) {
      c.moveTo(Math.round(this.#px(i)) + 0.5, this.#py(cells.j0))
      c.lineTo(Math.round(this.#px(i)) + 0.5, this.#py(cells.j1 + 1))
    }
    for (let j = cells.j0; j <= cells.j1 + 1; ++j) {
      c.moveTo(this.#px(cells.i0), Math.round(this.#py(j)) + 0.5)
      c.lineTo(this.#px(cells.i1 + 1), Math.round(this.#py(j)) + 0.5)
    }
    c.strokeStyle = theme().grid
    c.lineWidth = 1
    c.stroke()
  }

  #drawPolygons(polygons: readonly Polygon[]): void {
    const byKind = new Map<number, Polygon[]>()
    for (const polygon of polygons) {
      const kind = kindOf(polygon.block).block
      const same = byKind.get(kind)
      if (same === undefined) byKind.set(kind, [polygon])
      else same.push(polygon)
    }
    const c = this.#context
    for (const [kind, same] of byKind) {
      c.fillStyle = c.strokeStyle = theme().special[kind] ?? this.#soilOf(c)
      this.#fill(same)
      const pattern = patternOf(c, kind)
      if (pattern === null) continue
      c.fillStyle = pattern
      c.strokeStyle = 'transparent'
      this.#fill(same)
    }
  }

  #soilOf(c: CanvasRenderingContext2D): string | CanvasPattern {
    const unit = this.#drawn.scale * this.#ratio
    if (unit < small) return theme().ground
    const pattern = c.createPattern((this.#soil ??= darkened(soilTile(), theme().mood)), 'repeat')!
    pattern.setTransform(new DOMMatrix([unit / pixels, 0, 0, unit / pixels, this.#px(0), this.#py(0)]))
    return pattern
  }

  // Full cells are rectangles of whole pixels, which is fast and leaves no hairlines. A browser takes long for one path
  // of many polygons, so the others are filled a few at a time.
  #fill(polygons: readonly Polygon[]): void {
    const c = this.#context
    const others: Polygon[] = []
    for (const polygon of polygons) {
      if (isFull(polygon.vertices)) {
        const [left, top] = [Math.round(this.#px(polygon.i)), Math.round(this.#py(polygon.j + 1))]
        c.fillRect(left, top, Math.round(this.#px(polygon.i + 1)) - left, Math.round(this.#py(polygon.j)) - top)
      } else {
        others.push(polygon)
      }
    }
    c.lineWidth = 0.7
    for (let k = 0; k < others.length; k += 100) {
      c.beginPath()
      for (const { i, j, vertices } of others.slice(k, k + 100)) {
        c.moveTo(this.#px(i + vertices[0]), this.#py(j + vertices[1]))
        for (let n = 2; n < vertices.length; n += 2) c.lineTo(this.#px(i + vertices[n]), this.#py(j + vertices[n + 1]))
        c.closePath()
      }
      c.fill()
      c.stroke()
    }
  }

  #drawOutline(world: World, cells: CellRect, unit: number): void {
    const c = this.#context
    const lines = linesIn(world, cells)
    c.beginPath()
    for (const line of lines) {
      c.moveTo(this.#px(line[0]), this.#py(line[1]))
      for (let k = 2; k < line.length; k += 2) c.lineTo(this.#px(line[k]), this.#py(line[k + 1]))
    }
    c.strokeStyle = theme().line
    c.lineCap = c.lineJoin = 'round'
    c.lineWidth = Math.min(2, Math.max(0.75, unit / 14)) * (unit > 10 ? 1 : 0.7)
    c.stroke()
    c.strokeStyle = css(theme().mood.rim, 0.85)
    c.setTransform(unit, 0, 0, -unit, this.#px(0), this.#py(0))
    c.lineWidth /= unit
    c.stroke(rimOf(lines))
    c.resetTransform()
  }
}

function isFull(vertices: Float64Array): boolean {
  return vertices.length === 8 && vertices.every((coordinate) => coordinate === 0 || coordinate === 1)
}
