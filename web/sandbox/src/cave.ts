// What the digger's land looks like: sky and hills behind, soil with pebbles, light from above, and crystals that glow.
// GroundPicture fills blocks with what is in `colours`: these are patterns here, which cost hardly more than colours. Each
// cavern has colours of its own, and gets lighter with each of its crystals.
import type { Fill, GroundPicture } from 'localgridseg/draw'
import { cavern, cavernAt, type Crystals, shine } from './crystals.js'
import { wantsCalm } from './theme.js'

type Colour = readonly [number, number, number]
interface Tiles {
  readonly soil: HTMLCanvasElement
  readonly caps: HTMLCanvasElement
  readonly rock: HTMLCanvasElement
  readonly gleams: readonly { readonly block: number; readonly tile: HTMLCanvasElement }[]
  readonly halo: HTMLCanvasElement
}
interface Mood {
  readonly sky: Colour
  readonly low: Colour // of the sky
  readonly hills: Colour
  readonly rim: Colour // of what faces up
  readonly shadow: Colour
  readonly dark: number // 0 to 1
}
// By night; the first is that of the first cavern.
const nights: readonly Mood[] = [
  { sky: [22, 26, 58], low: [92, 66, 112], hills: [46, 42, 86], rim: [158, 150, 236], shadow: [26, 22, 62], dark: 0.5 },
  { sky: [8, 38, 52], low: [34, 104, 104], hills: [20, 70, 80], rim: [126, 232, 196], shadow: [6, 40, 58], dark: 0.52 },
  { sky: [44, 16, 34], low: [148, 58, 46], hills: [92, 34, 46], rim: [255, 164, 110], shadow: [56, 12, 36], dark: 0.5 },
]
const dawn: Mood = { sky: [92, 92, 164], low: [252, 178, 142], hills: [134, 104, 152], rim: [255, 204, 178], shadow: [40, 26, 62], dark: 0.22 }
const day: Mood = { sky: [126, 198, 234], low: [253, 240, 212], hills: [158, 200, 206], rim: [255, 240, 190], shadow: [40, 26, 62], dark: 0 }
const stays = 0.3 // of the night's colours, until it is day
const between = 6 // cells from one cavern's colours to those of the next
const rock: Colour = [87, 67, 74], stone: Colour = [150, 142, 152], cap: Colour = [217, 93, 74], soil: Colour = [181, 131, 90]
const motes = 22
const pixels = 16 // of a cell, in a pattern

const mix = (a: number, b: number, t: number): number => a + (b - a) * t
const mixed = (a: Colour, b: Colour, t: number): Colour => [0, 1, 2].map((n) => a[n] + (b[n] - a[n]) * t) as unknown as Colour
const css = ([r, g, b]: Colour, alpha = 1) => `rgba(${Math.round(r)}, ${Math.round(g)}, ${Math.round(b)}, ${alpha})`

export class Cave {
  readonly #lights = new Map<number, number>() // of caverns: 0 is night, 2 day
  readonly #canvas: HTMLCanvasElement
  readonly #behind: HTMLCanvasElement
  readonly #picture: GroundPicture
  readonly #crystals: Crystals
  readonly #colours: Record<number, Fill>
  #tiles: Tiles | null = null
  #frames = 0
  #seen = '' // of the sky
  #coloured = '' // for which mood

  constructor(canvas: HTMLCanvasElement, behind: HTMLCanvasElement, picture: GroundPicture, crystals: Crystals, colours: Record<number, Fill>) {
    this.#canvas = canvas
    this.#behind = behind
    this.#picture = picture
    this.#crystals = crystals
    this.#colours = colours
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
    const behind = this.#behind, { x, size } = this.#picture, { clientWidth, clientHeight } = this.#canvas
    const wide = clientWidth / size, first = cavernAt(x), moods: Mood[] = []
    for (let k = first; k * cavern < x + wide; ++k) moods.push(this.#moodOf(k))
    const seen = [Math.round(x * size), ...moods.map(keyOf), clientWidth, clientHeight].join()
    if (seen === this.#seen) return
    this.#seen = seen
    Object.assign(behind, { width: Math.ceil(clientWidth / 2), height: Math.ceil(clientHeight / 2) })
    const c = behind.getContext('2d', { alpha: false })!
    c.setTransform(size / 2, 0, 0, -size / 2, (-x * size) / 2, behind.height)
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

/** From one column to another; hills are nearer than the sky, and go along with who walks. */
function drawSky(c: CanvasRenderingContext2D, { sky, low, hills }: Mood, from: number, to: number, x: number): void {
  const gradient = c.createLinearGradient(0, 19, 0, 4)
  gradient.addColorStop(0, css(sky))
  gradient.addColorStop(1, css(low))
  c.fillStyle = gradient
  c.fillRect(from, 0, to - from, 100)
  for (const [far, base, high] of [[0.3, 9.5, 2.4], [0.55, 7, 1.6]]) {
    c.fillStyle = css(hills, far + 0.15)
    c.beginPath()
    c.moveTo(from, 0)
    for (let at = from; at <= to + 1; ++at) {
      const there = at - x * (1 - far)
      c.lineTo(at, base + high * Math.sin(there / 5.3 + base) * Math.sin(there / 9.1) + 0.5 * high * Math.sin(there / 2.3))
    }
    c.lineTo(to + 1, 0)
    c.fill()
  }
}

function tile(width: number, height: number, draw: (c: CanvasRenderingContext2D) => void): HTMLCanvasElement {
  const canvas = document.createElement('canvas')
  Object.assign(canvas, { width, height })
  draw(canvas.getContext('2d')!)
  return canvas
}

function makeTiles(): Tiles {
  const gleams = Object.entries(shine).map(([block, colour]) => ({ block: Number(block), tile: gleamTile(colour) }))
  return { soil: soilTile(), caps: capTile(), rock: rockTile(), halo: haloTile(), gleams }
}

const keyOf = ({ sky, low, shadow, dark }: Mood) => [...sky, ...low, ...shadow, 100 * dark].map(Math.round).join()

function mixedMoods(a: Mood, b: Mood, t: number): Mood {
  const of = (name: 'sky' | 'low' | 'hills' | 'rim' | 'shadow') => mixed(a[name], b[name], t)
  return { sky: of('sky'), low: of('low'), hills: of('hills'), rim: of('rim'), shadow: of('shadow'), dark: mix(a.dark, b.dark, t) }
}

function darkened(from: HTMLCanvasElement, { dark, shadow }: Mood): HTMLCanvasElement {
  return tile(from.width, from.height, (c) => {
    c.drawImage(from, 0, 0)
    c.fillStyle = css(shadow, dark)
    c.fillRect(0, 0, from.width, from.height)
  })
}

// Of 32 cells, as the land is high: darker far up, with layers and pebbles, the same at each visit.
const soilTile = () => tile(32 * pixels, 32 * pixels, (c) => {
  const all = 32 * pixels
  let seed = 7
  const random = () => ((seed = (seed * 16807) % 2147483647) / 2147483647)
  c.fillStyle = css(soil)
  c.fillRect(0, 0, all, all)
  for (const [at, thick, alpha] of [[2.2, 0.9, 0.1], [4.4, 1.3, 0.08], [7.4, 0.6, 0.12], [9.2, 0.5, 0.08], [28.8, 0.5, 0.1], [30.2, 0.4, 0.12]]) {
    c.strokeStyle = `rgba(70, 30, 20, ${alpha})`
    c.lineWidth = thick * pixels
    c.beginPath()
    for (let x = -8; x <= all + 8; x += 8) c.lineTo(x, at * pixels + 5 * Math.sin((x * 2 * Math.PI * 3) / all + at))
    c.stroke()
  }
  for (let k = 0; k < 380; ++k) {
    c.fillStyle = random() < 0.55 ? 'rgba(50, 20, 20, 0.16)' : 'rgba(255, 226, 180, 0.14)'
    c.beginPath()
    c.ellipse(8 + (all - 16) * random(), 6 + (all - 12) * random(), 2 + 5 * random(), 1.2 + 2.2 * random(), 0.4 * random() - 0.2, 0, 2 * Math.PI)
    c.fill()
  }
  const depth = c.createLinearGradient(0, 0, 0, 12 * pixels)
  depth.addColorStop(0, 'rgba(40, 18, 50, 0.62)')
  depth.addColorStop(1, 'rgba(40, 18, 50, 0)')
  c.fillStyle = depth
  c.fillRect(0, 0, all, 12 * pixels)
})

const capTile = () => tile(40, 40, (c) => {
  c.fillStyle = css(cap)
  c.fillRect(0, 0, 40, 40)
  c.fillStyle = 'rgba(255, 232, 214, 0.85)'
  for (const [x, y, r] of [[10, 10, 4], [30, 28, 5]]) {
    c.beginPath()
    c.arc(x, y, r, 0, 2 * Math.PI)
    c.fill()
  }
})

// Of one cell: slabs at a slant, so that one sees that it is not soil.
const rockTile = () => tile(2 * pixels, 2 * pixels, (c) => {
  const all = 2 * pixels
  c.fillStyle = css(rock)
  c.fillRect(0, 0, all, all)
  c.lineWidth = all / 4
  c.strokeStyle = 'rgba(20, 10, 30, 0.4)'
  for (const shift of [-all, 0, all]) {
    c.beginPath()
    c.moveTo(shift - 4, all + 4)
    c.lineTo(shift + all + 4, -4)
    c.stroke()
  }
})

// Bright bands at a slant.
const gleamTile = (colour: string) => tile(64, 64, (c) => {
  c.fillStyle = colour
  c.fillRect(0, 0, 64, 64)
  for (const [at, width, alpha] of [[0, 14, 0.55], [20, 6, 0.3], [44, 12, -0.13]]) {
    c.strokeStyle = alpha > 0 ? `rgba(255, 255, 255, ${alpha})` : `rgba(90, 30, 70, ${-alpha})`
    c.lineWidth = width
    for (const shift of [-64, 0, 64, 128]) {
      c.beginPath()
      c.moveTo(at + shift + 8, -8)
      c.lineTo(at + shift - 72, 72)
      c.stroke()
    }
  }
})

const haloTile = () => tile(128, 128, (c) => {
  const gradient = c.createRadialGradient(64, 64, 0, 64, 64, 64)
  for (const [at, alpha] of [[0, 0.75], [0.35, 0.32], [1, 0]]) gradient.addColorStop(at, `rgba(96, 232, 220, ${alpha})`)
  c.fillStyle = gradient
  c.fillRect(0, 0, 128, 128)
})
