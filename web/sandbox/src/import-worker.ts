// Imports a map of Tiled or LDtk. The importer has a WebAssembly of its own, so it is in a worker, and is loaded only
// when a map is opened.
import { importMap, init, type MapFiles } from 'localgridseg/full'

export interface Imported {
  /** Polygons in the unit cell. */
  readonly shapes: readonly Float64Array[]
  /** i, j, index in `shapes`, block. */
  readonly placements: Int32Array
  readonly suggestions: readonly string[]
  /** What says that it is solid and was not taken; '' if all of it was. */
  readonly partial: string
}

export type ImportAnswer = Imported | { readonly error: string }

addEventListener('message', async (event: MessageEvent<{ path: string; files: MapFiles }>) => {
  let answer: ImportAnswer
  try {
    await init()
    const { shapes, placements, suggestions, partial } = importMap(event.data.path, event.data.files)
    answer = { shapes, placements, suggestions, partial }
  } catch (error) {
    answer = { error: (error as Error).message }
  }
  postMessage(answer)
})
