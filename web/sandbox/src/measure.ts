// The load that the frame times are measured with: 500 bodies on 300 x 100 cells, dug at every frame.
import { circle, type Region } from 'localgridseg'
import { GROUND } from './blocks.js'
import { newDocument } from './documents.js'
import type { Game } from './game.js'
import type { Loop } from './loop.js'
import type { Viewer } from './viewer.js'

const bodies = 500
const settling = 300 // steps before the first frame that is measured

export type Place = 'along' | 'everywhere'

export interface Measured {
  readonly bodies: number
  /** The mean over the frames. */
  readonly awake: number
  readonly cells: number
  readonly segments: number
  /** In milliseconds, of each frame. */
  readonly times: Readonly<Record<string, readonly number[]>>
}

/** Most bodies have come to rest then. */
export function prepare(game: Game, viewer: Viewer): void {
  fill(game)
  for (let k = 0; k < settling; ++k) game.step()
  viewer.layer.reset()
  viewer.fit()
  viewer.draw()
}

export async function measure(game: Game, viewer: Viewer, loop: Loop, place: Place, frames: number): Promise<Measured> {
  loop.running = false
  const times = {
    'from frame to frame': [] as number[],
    'work of a frame': [] as number[],
    edit: [] as number[],
    'step and commit': [] as number[],
    draw: [] as number[],
  }
  let awake = 0
  let last = await nextFrame()
  game.ground.begin()
  for (let k = 0; k < frames; ++k) {
    const begin = performance.now()
    game.ground.edit({ kind: 'carve', region: dig(k, place) })
    const edited = performance.now()
    game.step()
    const stepped = performance.now()
    viewer.draw()
    const end = performance.now()
    times['edit'].push(edited - begin)
    times['step and commit'].push(stepped - edited)
    times['draw'].push(end - stepped)
    times['work of a frame'].push(end - begin)
    for (const rider of game.sides[0].riders) if (rider.bodies[0].isAwake()) ++awake
    const now = await nextFrame()
    times['from frame to frame'].push(now - last)
    last = now
  }
  game.ground.end()
  loop.running = true
  const { world } = game.ground
  return {
    bodies: game.sides[0].riders.length,
    awake: awake / frames,
    cells: world.stats().cells,
    segments: world.stats().segments,
    times,
  }
}

// Along the surface, as somebody digs who holds the button down; or now here, now there, so that no body comes to rest.
function dig(k: number, place: Place): Region {
  const x = place === 'along' ? 20 + 0.4 * k : 5 + ((k * 29.03) % 290)
  const depth = place === 'along' ? 0.3 : 0.3 + 0.8 * Math.floor(k / 180)
  return circle(x, surface(x) - depth, 0.9, 16)
}

function surface(x: number): number {
  return 94 + 3 * Math.sin(x / 9)
}

function fill(game: Game): void {
  const document = newDocument()
  const ring = [
    [0, 0],
    [300, 0],
  ]
  for (let x = 300; x >= 0; --x) ring.push([x, surface(x)])
  document.world.paint({ rings: [ring as [number, number][]] }, GROUND)
  document.world.commit()
  game.open(document)
  game.removeRiders()
  for (let k = 0; k < bodies; ++k) {
    game.drop({
      kind: k % 3 === 0 ? 'box' : 'marble',
      x: 2 + (k % 250) * 1.18,
      y: 99 + 1.5 * Math.floor(k / 250),
      speed: 0,
      size: 0.35,
      colour: k,
      stays: true,
    })
  }
}

function nextFrame(): Promise<number> {
  return new Promise(requestAnimationFrame)
}
