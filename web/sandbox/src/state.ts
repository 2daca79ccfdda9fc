// All that a link holds: the scene, its edits, the view, and the bodies.
import { motionsOf, type Riding } from './bodies.js'
import type { Camera } from './camera.js'
import { openTrace, traceText } from './documents.js'
import type { Game, View } from './game.js'
import { sceneOf } from './scenes/all.js'

export interface State {
  /** Whose ground it is, as it was made; null if the trace has it. */
  readonly scene: string | null
  readonly trace: string | null
  readonly worlds: View
  /** The middle in cells, and pixels per cell. */
  readonly view: readonly [number, number, number]
  readonly riders: readonly Riding[]
}

const largest = 60_000 // polygons

/** `scene` is that which was opened; null if it was a file. */
export function capture(game: Game, camera: Camera, scene: string | null): State {
  const { ground } = game
  ground.commit()
  const isOwn = scene === null || ground.isEdited
  if (isOwn && ground.world.stats().polygons > largest) throw new Error('This terrain is too large for a link. Use "Copy trace" instead.')
  return {
    scene: isOwn ? null : scene,
    trace: isOwn ? traceText(ground.document) : null,
    worlds: game.view,
    view: [camera.x, camera.y, camera.scale],
    riders: game.sides[0].riders.map((rider) => ({ start: rider.start, motions: motionsOf(rider) })),
  }
}

export async function restore(state: State, game: Game): Promise<void> {
  if (state.trace !== null) game.open(openTrace(state.trace))
  else {
    const scene = sceneOf(state.scene!)
    game.open(await scene.make(), scene.cast?.())
  }
  game.cast(state.riders)
}
