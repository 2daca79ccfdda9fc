// Draws one physics world over the ground.
import type { CellRect, Segment } from 'localgridseg'
import { GROUND, kindOf } from './blocks.js'
import type { Camera } from './camera.js'
import type { Game } from './game.js'
import type { Glow } from './glow.js'
import type { GroundLayer } from './layer.js'
import { drawOverlay, drawSegment } from './overlay.js'
import { drawKicks, drawRiders, drawRocks } from './riders-view.js'
import { cell } from './scale.js'
import { settings } from './settings.js'
import type { Side } from './side.js'
import { theme, wantsCalm } from './theme.js'
import { currentTool } from './tools/all.js'

export interface Scenery {
  readonly game: Game
  readonly camera: Camera
  readonly layer: GroundLayer
  readonly glow: Glow
  readonly overlay: boolean
  readonly selected: Segment | null
  /** Places whose ground has its name written on it, if it is no ordinary one. */
  readonly labels: readonly (readonly [number, number])[]
  readonly cursor: readonly [number, number] | null
  /** Where somebody is asked to dig. */
  readonly invitation: readonly [number, number] | null
  /** Edges where a check found a difference: start x, y, end x, y of each. */
  readonly differences: Float64Array
}

export class Pane {
  readonly canvas: HTMLCanvasElement
  readonly #section: HTMLElement
  readonly #context: CanvasRenderingContext2D
  readonly #shown = { kicks: -1, hardest: -1 }

  constructor(section: HTMLElement) {
    this.#section = section
    this.canvas = section.querySelector('canvas')!
    this.#context = this.canvas.getContext('2d', { alpha: false })!
  }

  show(title: string | null): void {
    this.#section.hidden = title === null
    this.#section.style.display = title === null ? 'none' : ''
    if (title === null) return
    this.#section.querySelector('h2')!.textContent = title
    this.canvas.ariaLabel = title
  }

  draw(side: Side, scenery: Scenery, width: number, height: number, ratio: number): void {
    const { camera, game, layer } = scenery
    if (this.canvas.width !== width * ratio || this.canvas.height !== height * ratio) {
      this.canvas.width = width * ratio
      this.canvas.height = height * ratio
    }
    const c = this.#context
    c.setTransform(1, 0, 0, 1, 0, 0)
    c.fillStyle = theme().sky
    c.fillRect(0, 0, this.canvas.width, this.canvas.height)
    layer.paintOn(c, camera)

    const unit = camera.scale * ratio
    const pixel = 1 / camera.scale
    c.setTransform(unit, 0, 0, -unit, this.canvas.width / 2 - camera.x * unit, this.canvas.height / 2 + camera.y * unit)
    c.lineJoin = 'round'
    if (scenery.overlay) drawOverlay(c, game.ground.world, this.#cells(camera, width, height), pixel, side.ghosts)
    scenery.glow.draw(c, pixel)
    c.save()
    c.scale(1 / cell, 1 / cell) // bodies are in metres
    drawRocks(c, game.rocks.of(side), pixel * cell)
    drawRiders(c, side, pixel * cell)
    drawKicks(c, side, pixel * cell)
    c.restore()
    if (scenery.selected !== null) drawSegment(c, game.ground.world, scenery.selected, pixel)
    this.#drawLabels(scenery, ratio)
    this.#drawDifferences(scenery.differences, pixel)
    if (scenery.invitation !== null) this.#drawInvitation(scenery.invitation, pixel)
    if (scenery.cursor !== null) this.#drawPreview(scenery.cursor, pixel)
    this.#count('kicks', side.kicks.count)
    this.#count('hardest', side.kicks.hardest)
  }

  #cells(camera: Camera, width: number, height: number): CellRect {
    const [x0, y1] = camera.toCell(0, 0, width, height)
    const [x1, y0] = camera.toCell(width, height, width, height)
    return { i0: Math.floor(x0), j0: Math.floor(y0), i1: Math.floor(x1), j1: Math.floor(y1) }
  }

  // Rings that close in on the place, as often as a heart beats; and a word.
  #drawInvitation([x, y]: readonly [number, number], pixel: number): void {
    const c = this.#context, t = wantsCalm() ? 0.5 : (performance.now() / 1000) % 1
    c.strokeStyle = theme().kick
    c.lineWidth = 3 * pixel
    for (const [radius, alpha] of [[settings.radius, 1], [settings.radius * (2.4 - 1.4 * t), t]]) {
      c.globalAlpha = alpha
      c.beginPath()
      c.arc(x, y, radius, 0, 2 * Math.PI)
      c.stroke()
    }
    c.globalAlpha = 1
    c.save()
    c.scale(1, -1)
    c.font = `600 ${16 * pixel}px system-ui, sans-serif`
    c.textBaseline = 'middle'
    c.fillStyle = theme().ink
    c.fillText('Dig here', x + settings.radius + 10 * pixel, -y)
    c.restore()
  }

  #drawPreview([x, y]: readonly [number, number], pixel: number): void {
    const c = this.#context
    c.strokeStyle = c.fillStyle = theme().ink
    c.lineWidth = 1.5 * pixel
    c.globalAlpha = 0.65
    c.beginPath()
    currentTool().preview(c, x, y, pixel)
    c.globalAlpha = 1
  }

  #drawLabels({ labels, game, camera }: Scenery, ratio: number): void {
    if (camera.scale < 12) return
    const c = this.#context
    c.save()
    c.fillStyle = theme().ink
    c.textAlign = 'center'
    c.textBaseline = 'middle'
    c.font = '12px system-ui, sans-serif'
    c.setTransform(ratio, 0, 0, ratio, 0, 0)
    for (const [x, y] of labels) {
      const spot = game.ground.world.at(x, y)
      const kind = spot.where === 'outside' ? null : kindOf(spot.block)
      if (kind === null || kind.block === GROUND) continue
      c.fillText(kind.name, ...camera.toPixel(x, y, this.canvas.width / ratio, this.canvas.height / ratio))
    }
    c.restore()
  }

  #drawDifferences(ends: Float64Array, pixel: number): void {
    const c = this.#context
    c.strokeStyle = theme().kick
    c.lineWidth = 6 * pixel
    c.beginPath()
    for (let k = 0; k < ends.length; k += 4) {
      c.moveTo(ends[k], ends[k + 1])
      c.lineTo(ends[k + 2], ends[k + 3])
    }
    c.stroke()
  }

  #count(name: 'kicks' | 'hardest', value: number): void {
    if (this.#shown[name] === value) return
    this.#shown[name] = value
    const place = this.#section.querySelector(`[data-count=${name}]`)!
    place.textContent = name === 'kicks' ? String(value) : value.toFixed(2)
    if (name === 'kicks') place.nextElementSibling!.textContent = value === 1 ? 'kick' : 'kicks'
    place.parentElement!.classList.toggle('some', value > 0)
  }
}
