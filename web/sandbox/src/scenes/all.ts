// The scenes of the menu: what each is made of, and who rolls on it.
import { type Document, newDocument, openFiles } from '../documents.js'
import type { Cast } from '../game.js'
import { landscapeGate, landscapeMiddle, landscapeRiders, landscapeView, makeLandscape } from './landscape.js'
import { makeMaterials, makeMillion, makePlatforms, materialsCast, millionCast, platformsCast } from './made.js'

export interface Scene {
  readonly id: string
  readonly name: string
  make(): Document | Promise<Document>
  readonly cast?: () => Cast
  /** Where the name of the ground is written, if it is no ordinary ground: x, y of each. */
  readonly labels?: readonly (readonly [number, number])[]
  /** What is shown of it, in cells: left, bottom, right, top. Everything, if it is not said. */
  readonly view?: readonly [number, number, number, number]
  /** Where the middle is of what a screen shows that is too narrow for that; its left part, if it is not said. */
  readonly middle?: number
}

export const scenes: readonly Scene[] = [
  { id: 'hills', name: 'Hills', make: makeLandscape, cast: () => ({ starts: landscapeRiders(), gate: landscapeGate }), labels: [[31.5, 3.5]], view: landscapeView, middle: landscapeMiddle },
  { id: 'cave', name: 'Cave (Tiled objects)', make: () => fetched('cave.tmx', 'crate.tx') },
  { id: 'quarry', name: 'Quarry (LDtk)', make: () => fetched('quarry.ldtk') },
  { id: 'tiled', name: 'Hills (Tiled)', make: () => fetched('landscape.tmx', 'landscape.tsx') },
  { id: 'platforms', name: 'One-way platforms', make: makePlatforms, cast: () => platformsCast, labels: [[7, 2.75], [25, 3.25]] },
  { id: 'materials', name: 'Ice and conveyor', make: makeMaterials, cast: () => materialsCast, labels: [[10.5, 1], [24.5, 1], [31.5, 1], [38.5, 1]] },
  { id: 'million', name: 'A million cells', make: makeMillion, cast: () => millionCast, view: [478, 490, 522, 508] },
  { id: 'empty', name: 'Empty', make: () => newDocument(), cast: () => ({ starts: [], gate: landscapeGate }) },
]

export function sceneOf(id: string): Scene {
  const scene = scenes.find((each) => each.id === id)
  if (scene === undefined) throw new Error(`There is no scene '${id}'.`)
  return scene
}

async function fetched(...names: string[]): Promise<Document> {
  const files = await Promise.all(
    names.map(async (name) => {
      const response = await fetch(`scenes/${name}`)
      if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`)
      return new File([await response.blob()], name)
    }),
  )
  return (await openFiles(files)).document
}
