// Opens what people drop onto the page: traces, saved worlds, maps of Tiled and LDtk.
import { createWorld, LgsError, loadWorld, type World, type WorldOptions } from 'localgridseg'
import type { MapFiles } from 'localgridseg/full'
import { parseTrace, preserveOf, traceOf, TracePlayer } from 'localgridseg/trace'
import { keptPairs, type Pairs } from './blocks.js'
import type { ImportAnswer, Imported } from './import-worker.js'

/** A world, and the preserve relation that it was made with. */
export interface Document {
  readonly world: World
  readonly preserve: Pairs
  /** The text that it was opened from, if it was a trace. */
  readonly trace?: string
}

/** What was opened, and the file that it was in. */
export interface Opened {
  readonly document: Document
  readonly name: string
  /** What of a map could not be taken. */
  readonly partial?: string
}

export async function openFiles(files: readonly File[]): Promise<Opened> {
  const map = files.find(({ name }) => /\.(tmx|tmj|json|ldtk|world)$/i.test(name))
  if (map !== undefined) return openMap(map.name, files)
  for (const file of files) {
    const { name } = file
    if (/\.lgs$/i.test(name)) return { document: openSaved(new Uint8Array(await file.arrayBuffer())), name }
    const text = await file.text()
    if (text.trimStart().startsWith('lgs-trace')) return { document: openTrace(text), name }
  }
  const names = files.map(({ name }) => name).join(', ')
  throw new Error(`${names}: neither a trace, nor a saved world (.lgs), nor a map (.tmx, .tmj, .json, .ldtk, .world).`)
}

// The file does not hold the relation itself: it is none, or that of this page.
function openSaved(bytes: Uint8Array): Document {
  try {
    return { world: loadWorld(bytes), preserve: [] }
  } catch (error) {
    if (!(error instanceof LgsError) || error.code !== 'relation') throw error
    return { world: loadWorld(bytes, { preserve: relationOf(keptPairs) }), preserve: keptPairs }
  }
}

/** A trace without a preserve relation gets that of one-way ground. */
export function openTrace(text: string): Document {
  const trace = parseTrace(text)
  const preserve = trace.preserve.length > 0 ? trace.preserve : keptPairs
  const { world } = newDocument(preserve)
  const player = new TracePlayer(world)
  try {
    player.play(trace)
  } catch (error) {
    player.world.free()
    throw error
  }
  return { world: player.world, preserve, trace: text }
}

export function newDocument(preserve = keptPairs): Document {
  return { world: createWorld({ preserve: relationOf(preserve) }), preserve }
}

function relationOf(pairs: Pairs): WorldOptions['preserve'] {
  return preserveOf({ preserve: pairs })
}

export function traceText({ world, preserve }: Document): string {
  return traceOf(world, preserve)
}

async function openMap(path: string, files: readonly File[]): Promise<Opened> {
  const contents = await Promise.all(
    files.map(async (file) => [file.name, new Uint8Array(await file.arrayBuffer())] as const),
  )
  const { shapes, placements, suggestions, partial } = await importInWorker(path, Object.fromEntries(contents))
  if (placements.length === 0) throw new Error(`${path}: nothing in it is solid. ${suggestions.join(' ')}`)
  const document = newDocument([])
  const ids = shapes.map((shape) => document.world.shape(shape))
  document.world.addMany(placements.map((value, k) => (k % 4 === 2 ? ids[value] : value)))
  document.world.commit()
  return { document, name: path, partial }
}

function importInWorker(path: string, files: MapFiles): Promise<Imported> {
  const worker = new Worker(new URL('import-worker.js', import.meta.url), { type: 'module' })
  return new Promise((resolve, reject) => {
    worker.addEventListener('message', ({ data }: MessageEvent<ImportAnswer>) => {
      worker.terminate()
      if ('error' in data) reject(new Error(data.error))
      else resolve(data)
    })
    worker.postMessage({ path, files })
  })
}
