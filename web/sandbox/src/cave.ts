// What the digger's land looks like: sky and hills behind, soil with pebbles, light from above, and crystals that glow.
// GroundPicture fills blocks with what is in `colours`: these are patterns here, which cost hardly more than colours. Each
// cavern has colours of its own, and gets lighter with each of its crystals.
import type { Fill, GroundPicture } from 'localgridseg/draw'
import { cavern, cavernAt, type Crystals, shine } from './crystals.js'
import { cap, css, darkened, dawn, day, drawSky, keyOf, makeTiles, mixed, mixedMoods, type Mood, nights, pixels, rock, soil, stays, stone, type Tiles } from './look.js'
import { wantsCalm } from './theme.js'

const between = 6 // cells from one cavern's colours to those of the next
const motes = 22
const high = 24 // cells, of the land

export class Cave {
  readonly #lights = new Map<number, number>() // of caverns: 0 is night, 2 day
  readonly #canvas: HTMLCanvasElement
  readonly #behind: HTMLCanvasElement
  readonly #picture: GroundPicture
  readonly #crystals: Crystals
  readonly #colours: Record<number, Fill>
  readonly #gravity: number
  #tiles: Tiles | null = null
  #frames = 0
  #seen = '' // of the sky
  #coloured = '' // for which mood

  constructor(canvas: HTMLCanvasElement, behind: HTMLCanvasElement, picture: GroundPicture, crystals: Crystals, colours: Record<number, Fill>, gravity: number) {
    this.#canvas = canvas
    this.#behind = behind
    this.#picture = picture
    this.#crystals = crystals
    this.#colours = colours
    this.#gravity = gravity
    const { dark, shadow } = nights[0]
    Object.assign(colours, { 1: css(mixed(soil, shadow, dark)), 4: css(mixed(cap, shadow, 0.8 * dark)), ...shine })
    this.#paintRock(nights[0])
  }

  lightOf(cavern: number): number {
    return this.#lights.get(cavern) ?? 0
  }
  setLight(cavern: number, light: number): void {
    this.#lights.set(cavern, light)
  }

  /** Where the middle of the canvas is. */
  get #mood(): Mood {
    const x = this.#picture.x + this.#canvas.clientWidth / this.#picture.size / 2
    const here = cavernAt(x), part = x / cavern - here, edge = part < 0.5 ? -part : 1 - part // the nearest one, in caverns
    const near = Math.max(0, 1 - (Math.abs(edge) * cavern) / between), mood = this.#moodOf(here)
    return near === 0 ? mood : mixedMoods(mood, this.#moodOf(here + (edge < 0 ? -1 : 1)), near / 2)
  }

  #moodOf(cavern: number): Mood {
    const night = nights[((cavern % nights.length) + nights.length) % nights.length], light = this.lightOf(cavern)
    const morning = mixedMoods(dawn, night, stays)
    return light < 1 ? mixedMoods(night, { ...morning, dark: dawn.dark }, light) : mixedMoods({ ...morning, dark: dawn.dark }, day, light - 1)
  }

  /** Over what the picture has drawn. */
  draw(now: number): void {
    const mood = this.#mood, time = wantsCalm() ? 0 : now / 1000
    if (++this.#frames === 3) this.#tiles = makeTiles() // the first frame does not wait for them
    this.#colour(mood, time)
    this.#drawSky()
    const c = this.#canvas.getContext('2d')!, { width, height, clientWidth } = this.#canvas
    const { x, y, size } = this.#picture, scale = (size * width) / clientWidth, wide = clientWidth / size
    c.save()
    c.setTransform(scale, 0, 0, -scale, -scale * x, height + scale * y)
    c.strokeStyle = css(mood.rim, 0.85)
    c.lineWidth = 0.13
    c.lineCap = c.lineJoin = 'round'
    for (const rim of this.#crystals.rims()) c.stroke(rim)
    c.fillStyle = this.#colours[2] // behind the bars
    c.fillRect(x, -40, wide, 40.1)
    c.fillRect(x, high - 0.1, wide, 60)
    this.#drawFalls(c, time)
    c.fillStyle = css([255, 240, 190], 0.2 + 0.5 * mood.dark)
    c.beginPath()
    for (let k = 0; k < motes; ++k) {
      const far = 0.4 + 0.6 * ((k * 0.37) % 1), at = (((k * 7.3 - x * far + 0.5 * Math.sin(time * 0.6 + k)) % wide) + wide) % wide
      const my = 6 + ((k * 3.7) % 12) + 0.4 * Math.sin(time * 0.8 + 2 * k)
      c.moveTo(x + at, my)
      c.arc(x + at, my, (0.06 + 0.07 * far) * (0.8 + 0.3 * Math.sin(1.7 * time + 5 * k)), 0, 2 * Math.PI)
    }
    c.fill()
    const radius = 3.3 + 0.25 * Math.sin(2 * time)
    c.globalCompositeOperation = 'lighter'
    c.globalAlpha = 0.25 + 0.6 * mood.dark
    if (this.#tiles !== null) for (const [hx, hy] of this.#crystals.glowing)
      if (hx > x - radius && hx < x + wide + radius) c.drawImage(this.#tiles.halo, hx - radius, hy - radius, 2 * radius, 2 * radius)
    c.restore()
  }

  /** How far each crystal would fall: to a star, if that bursts it; to a bow, if it is thrown up; and else to a bar. */
  #drawFalls(c: CanvasRenderingContext2D, time: number): void {
    c.lineWidth = 0.12
    for (const { from: [x, y], to: [, below], what } of this.#crystals.falls(this.#gravity)) {
      c.strokeStyle = what === 'stays whole' ? 'rgba(255, 150, 130, 0.8)' : 'rgba(150, 255, 240, 0.75)'
      c.setLineDash([0.32, 0.36])
      c.lineDashOffset = what === 'stays whole' ? 0 : 2 * time
      c.beginPath()
      c.moveTo(x, y - 0.25)
      c.lineTo(x, below)
      c.stroke()
      c.setLineDash([])
      c.beginPath()
      if (what === 'bursts') for (let k = 0; k < 5; ++k) {
        const angle = (Math.PI * (k + 0.5)) / 5, cos = Math.cos(angle), sin = Math.sin(angle)
        c.moveTo(x + 0.3 * cos, below + 0.15 + 0.3 * sin)
        c.lineTo(x + 0.75 * cos, below + 0.15 + 0.75 * sin)
      } else if (what === 'is thrown up') {
        for (const side of [-1, 1]) {
          c.moveTo(x + 0.3 * side, below + 0.3)
          c.quadraticCurveTo(x + 0.7 * side, below + 2.2, x + 1.5 * side, below + 0.9)
          c.lineTo(x + 1.45 * side, below + 1.4)
          c.moveTo(x + 1.5 * side, below + 0.9)
          c.lineTo(x + 1.05 * side, below + 1.15)
        }
      } else {
        c.moveTo(x - 0.7, below + 0.12)
        c.lineTo(x + 0.7, below + 0.12)
      }
      c.stroke()
    }
  }

  // For the next picture.
  #colour(mood: Mood, time: number): void {
    const c = this.#canvas.getContext('2d')!, tiles = this.#tiles
    if (tiles === null) return
    const pattern = (tile: HTMLCanvasElement, scale: number, shift = 0) => {
      const made = c.createPattern(tile, 'repeat')!
      made.setTransform(new DOMMatrix([1 / scale, 0, 0, -1 / scale, shift, 0]))
      return made
    }
    for (const { block, tile } of tiles.gleams) this.#colours[block] = pattern(tile, 12, 3 * time)
    const coloured = keyOf(mood)
    if (this.#coloured === coloured) return
    this.#coloured = coloured
    this.#colours[1] = pattern(darkened(tiles.soil, mood), pixels)
    this.#colours[4] = pattern(darkened(tiles.caps, { ...mood, dark: 0.8 * mood.dark }), pixels)
    this.#paintRock(mood)
    this.#colours[2] = pattern(darkened(tiles.rock, mood), 2 * pixels)
  }

  #paintRock({ dark, shadow }: Mood): void {
    Object.assign(this.#colours, { 2: css(mixed(rock, shadow, dark)), 6: css(mixed(stone, shadow, 0.9 * dark)) })
  }

  // Only when one has walked, or the light has changed. It is not sharp: half the pixels do. The wall between two caverns
  // hides where their skies meet.
  #drawSky(): void {
    const behind = this.#behind, { x, y, size } = this.#picture, { clientWidth, clientHeight } = this.#canvas
    const wide = clientWidth / size, first = cavernAt(x), moods: Mood[] = []
    for (let k = first; k * cavern < x + wide; ++k) moods.push(this.#moodOf(k))
    const seen = [Math.round(x * size), size, ...moods.map(keyOf), clientWidth, clientHeight].join()
    if (seen === this.#seen) return
    this.#seen = seen
    Object.assign(behind, { width: Math.ceil(clientWidth / 2), height: Math.ceil(clientHeight / 2) })
    const c = behind.getContext('2d', { alpha: false })!
    c.setTransform(size / 2, 0, 0, -size / 2, (-x * size) / 2, behind.height + (y * size) / 2)
    for (const [k, mood] of moods.entries()) {
      const left = (first + k) * cavern
      c.save()
      c.beginPath()
      c.rect(left, 0, cavern, clientHeight / size + 1)
      c.clip()
      drawSky(c, mood, Math.max(left, Math.floor(x)), Math.min(left + cavern, x + wide + 1), x)
      c.restore()
    }
  }
}
