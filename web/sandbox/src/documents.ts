// Opens what people drop onto the page: traces, saved worlds, maps of Tiled and LDtk.
import { createWorld, loadWorld, type World } from 'localgridseg'
import { parseTrace, preserveOf, traceOf, TracePlayer } from 'localgridseg/trace'
import { keptPairs, type Pairs } from './blocks.js'

/** A world, and the preserve relation that it was made with. */
export interface Document {
  readonly world: World
  readonly preserve: Pairs
}

export async function openFiles(files: readonly File[]): Promise<Document> {
  const [first] = files
  const name = first.name.toLowerCase()
  if (/\.(tmx|tmj|json|ldtk|world)$/.test(name)) return { world: await openMap(files), preserve: [] }
  if (name.endsWith('.lgs')) return { world: loadWorld(new Uint8Array(await first.arrayBuffer())), preserve: [] }
  return openTrace(await first.text())
}

/** A trace without a preserve relation gets that of one-way ground. */
export function openTrace(text: string): Document {
  const trace = parseTrace(text)
  const preserve = trace.preserve.length > 0 ? trace.preserve : keptPairs
  const { world } = newDocument(preserve)
  const player = new TracePlayer(world)
  try {
    for (const edit of trace.edits) player.apply(edit)
  } catch (error) {
    world.free()
    throw error
  }
  world.commit()
  return { world, preserve }
}

export function newDocument(preserve = keptPairs): Document {
  return { world: createWorld({ preserve: preserveOf({ preserve, edits: [] }) }), preserve }
}

export function traceText({ world, preserve }: Document): string {
  return traceOf(world, preserve)
}

// The importer is large, so it is loaded when it is needed.
async function openMap(files: readonly File[]): Promise<World> {
  let importer: typeof import('localgridseg/import')
  try {
    importer = await import('localgridseg/import')
  } catch {
    throw new Error('This build of the page has no importer of maps. Open a trace: "lgs import MAP -o FILE.trace" makes one.')
  }
  return importer.importMap(files, {})
}
