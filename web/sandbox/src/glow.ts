// The segments that the last edits removed, added and relinked glow for a moment.
import type { Changes } from 'localgridseg'
import type { Mirror } from './mirror.js'
import { theme, wantsCalm } from './theme.js'

const lasts = 900 // milliseconds

interface Flash {
  readonly ends: Float64Array
  readonly kind: 'removed' | 'added' | 'relinked'
  readonly since: number
}

export class Glow {
  #flashes: Flash[] = []

  get isLit(): boolean {
    return this.#flashes.length > 0
  }

  /** Before the mirror follows the changes. */
  note(changes: Changes, mirror: Mirror): void {
    const since = performance.now()
    const { added, relinked } = changes
    this.#flashes.push({ ends: mirror.ends(changes.removed), kind: 'removed', since })
    this.#flashes.push({ ends: endsOf(added.geometry, added.length), kind: 'added', since })
    this.#flashes.push({ ends: endsOf(relinked.geometry, relinked.length), kind: 'relinked', since })
  }

  /** The context's unit is a cell. */
  draw(c: CanvasRenderingContext2D, pixel: number): void {
    const now = performance.now()
    this.#flashes = this.#flashes.filter((flash) => now - flash.since < lasts)
    const colours = theme()
    for (const { ends, kind, since } of this.#flashes) {
      c.globalAlpha = wantsCalm() ? 0.8 : 1 - (now - since) / lasts
      c.strokeStyle = colours[kind]
      c.lineWidth = (kind === 'relinked' ? 3 : 4) * pixel
      c.setLineDash(kind === 'removed' ? [6 * pixel, 5 * pixel] : kind === 'relinked' ? [2 * pixel, 4 * pixel] : [])
      c.beginPath()
      for (let k = 0; k < ends.length; k += 4) {
        c.moveTo(ends[k], ends[k + 1])
        c.lineTo(ends[k + 2], ends[k + 3])
      }
      c.stroke()
    }
    c.globalAlpha = 1
    c.setLineDash([])
  }
}

function endsOf(geometry: ArrayLike<number>, length: number): Float64Array {
  const ends = new Float64Array(4 * length)
  for (let k = 0; k < length; ++k) {
    for (let n = 0; n < 4; ++n) ends[4 * k + n] = geometry[8 * k + n]
  }
  return ends
}
