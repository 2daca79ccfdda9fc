// The colours of the canvas, for light and for dark. They are of Okabe and Ito, whose colours people with any colour
// vision can tell apart. Kinds of ground differ by pattern as well.
import { CONVEYOR, ICE, ONE_WAY, STICKY } from './blocks.js'
import { day, type Mood, nights } from './look.js'

export interface Theme {
  readonly mood: Mood // of the digger's cave
  readonly sky: string
  readonly grid: string
  readonly ground: string
  readonly special: Readonly<Record<number, string>>
  readonly pattern: string
  readonly line: string
  readonly riders: readonly string[]
  readonly ink: string
  readonly close: string // around the close-up
  readonly kick: string
  readonly added: string
  readonly removed: string
  readonly relinked: string
}

const riders = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9']

const light: Theme = {
  mood: day,
  sky: '#fdf3df',
  grid: 'rgba(60, 40, 30, 0.07)',
  ground: '#b5835a',
  special: { [ICE]: '#c4e3f3', [STICKY]: '#e3b48f', [ONE_WAY]: '#c9d6b8', [CONVEYOR]: '#d8c3dd' },
  pattern: 'rgba(40, 34, 26, 0.28)',
  line: '#3a2a22',
  riders,
  ink: '#2a2338',
  close: '#d8c6a4',
  kick: '#d55e00',
  added: '#009e73',
  removed: '#d55e00',
  relinked: '#0072b2',
}

const dark: Theme = {
  mood: nights[0],
  sky: '#241f45',
  grid: 'rgba(235, 225, 255, 0.06)',
  ground: '#6d4f4e',
  special: { [ICE]: '#355d74', [STICKY]: '#8a5226', [ONE_WAY]: '#45583d', [CONVEYOR]: '#5b4762' },
  pattern: 'rgba(255, 255, 255, 0.24)',
  line: '#1a1430',
  riders: ['#3f9fdc', '#e69f00', '#1fb58b', '#d68fb5', '#7cc8f2'],
  ink: '#efeaf6',
  close: '#4b4470',
  kick: '#ff8432',
  added: '#2fcf9f',
  removed: '#ff8432',
  relinked: '#5cb6f0',
}

const darkQuery = matchMedia('(prefers-color-scheme: dark)')
const calmQuery = matchMedia('(prefers-reduced-motion: reduce)')

export function theme(): Theme {
  return darkQuery.matches ? dark : light
}

export function onThemeChange(listener: () => void): void {
  darkQuery.addEventListener('change', listener)
}

export function wantsCalm(): boolean {
  return calmQuery.matches
}

/** Hatching, dots or chevrons for special ground; null for ordinary ground. */
export function patternOf(context: CanvasRenderingContext2D, block: number): CanvasPattern | null {
  const draw = patterns[block]
  if (draw === undefined) return null
  const size = 12
  const tile = document.createElement('canvas')
  tile.width = size
  tile.height = size
  const c = tile.getContext('2d')!
  c.strokeStyle = c.fillStyle = theme().pattern
  c.lineWidth = 1.2
  c.beginPath()
  draw(c, size)
  return context.createPattern(tile, 'repeat')
}

const patterns: Readonly<Record<number, (c: CanvasRenderingContext2D, size: number) => void>> = {
  [ICE](c, n) {
    for (const shift of [-n, 0, n]) {
      c.moveTo(shift, n)
      c.lineTo(shift + n, 0)
    }
    c.stroke()
  },
  [STICKY](c, n) {
    for (const [x, y] of [[n / 4, n / 4], [(3 * n) / 4, (3 * n) / 4]]) {
      c.moveTo(x + 1.6, y)
      c.arc(x, y, 1.6, 0, 2 * Math.PI)
    }
    c.fill()
  },
  [ONE_WAY](c, n) {
    c.moveTo(n / 4, (2 * n) / 3)
    c.lineTo(n / 2, n / 3)
    c.lineTo((3 * n) / 4, (2 * n) / 3)
    c.stroke()
  },
  [CONVEYOR](c, n) {
    c.moveTo(n / 3, n / 4)
    c.lineTo((2 * n) / 3, n / 2)
    c.lineTo(n / 3, (3 * n) / 4)
    c.stroke()
  },
}
