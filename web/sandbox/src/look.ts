// What land looks like in the digger and in all tools: sky and hills, soil with pebbles, crystals that glow. Tiles are
// filled as patterns, which cost hardly more than colours.
import { shine } from './crystals.js'

type Colour = readonly [number, number, number]
export interface Tiles {
  readonly soil: HTMLCanvasElement
  readonly caps: HTMLCanvasElement
  readonly rock: HTMLCanvasElement
  readonly gleams: readonly { readonly block: number; readonly tile: HTMLCanvasElement }[]
  readonly halo: HTMLCanvasElement
}
export interface Mood {
  readonly sky: Colour
  readonly low: Colour // of the sky
  readonly hills: Colour
  readonly rim: Colour // of what faces up
  readonly shadow: Colour
  readonly dark: number // 0 to 1
}
// By night; the first is that of the first cavern.
export const nights: readonly Mood[] = [
  { sky: [22, 26, 58], low: [92, 66, 112], hills: [46, 42, 86], rim: [158, 150, 236], shadow: [26, 22, 62], dark: 0.5 },
  { sky: [8, 38, 52], low: [34, 104, 104], hills: [20, 70, 80], rim: [126, 232, 196], shadow: [6, 40, 58], dark: 0.52 },
  { sky: [44, 16, 34], low: [148, 58, 46], hills: [92, 34, 46], rim: [255, 164, 110], shadow: [56, 12, 36], dark: 0.5 },
]
export const dawn: Mood = { sky: [92, 92, 164], low: [252, 178, 142], hills: [134, 104, 152], rim: [255, 204, 178], shadow: [40, 26, 62], dark: 0.22 }
export const day: Mood = { sky: [126, 198, 234], low: [253, 240, 212], hills: [158, 200, 206], rim: [255, 240, 190], shadow: [40, 26, 62], dark: 0 }
export const stays = 0.3 // of the night's colours, until it is day
export const rock: Colour = [87, 67, 74], stone: Colour = [150, 142, 152], cap: Colour = [217, 93, 74], soil: Colour = [181, 131, 90]
export const pixels = 16 // of a cell, in a pattern

const mix = (a: number, b: number, t: number): number => a + (b - a) * t
export const mixed = (a: Colour, b: Colour, t: number): Colour => [0, 1, 2].map((n) => a[n] + (b[n] - a[n]) * t) as unknown as Colour
export const css = ([r, g, b]: Colour, alpha = 1) => `rgba(${Math.round(r)}, ${Math.round(g)}, ${Math.round(b)}, ${alpha})`

/** From one column to another; hills are nearer than the sky, and go along with who walks. */
export function drawSky(c: CanvasRenderingContext2D, { sky, low, hills }: Mood, from: number, to: number, x: number): void {
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

export function makeTiles(): Tiles {
  const gleams = Object.entries(shine).map(([block, colour]) => ({ block: Number(block), tile: gleamTile(colour) }))
  return { soil: soilTile(), caps: capTile(), rock: rockTile(), halo: haloTile(), gleams }
}

export const keyOf = ({ sky, low, shadow, dark }: Mood) => [...sky, ...low, ...shadow, 100 * dark].map(Math.round).join()

export function mixedMoods(a: Mood, b: Mood, t: number): Mood {
  const of = (name: 'sky' | 'low' | 'hills' | 'rim' | 'shadow') => mixed(a[name], b[name], t)
  return { sky: of('sky'), low: of('low'), hills: of('hills'), rim: of('rim'), shadow: of('shadow'), dark: mix(a.dark, b.dark, t) }
}

export function darkened(from: HTMLCanvasElement, { dark, shadow }: Mood): HTMLCanvasElement {
  return tile(from.width, from.height, (c) => {
    c.drawImage(from, 0, 0)
    c.fillStyle = css(shadow, dark)
    c.fillRect(0, 0, from.width, from.height)
  })
}

// Of 32 cells, as the land is high: darker far up, with layers and pebbles, the same at each visit.
export const soilTile = () => tile(32 * pixels, 32 * pixels, (c) => {
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
