// Opens what people drop onto the page: traces, saved worlds, maps of Tiled and LDtk.
import { createWorld, loadWorld, type World } from 'localgridseg'
import { parseTrace, traceOf, TracePlayer } from 'localgridseg/trace'
import { keepsEdges } from './blocks.js'

export async function openFiles(files: readonly File[]): Promise<World> {
  const [first] = files
  const name = first.name.toLowerCase()
  if (/\.(tmx|tmj|json|ldtk|world)$/.test(name)) return openMap(files)
  if (name.endsWith('.lgs')) return loadWorld(new Uint8Array(await first.arrayBuffer()), { preserve: keepsEdges })
  return openTrace(await first.text())
}

export function openTrace(text: string): World {
  const trace = parseTrace(text)
  const player = new TracePlayer(trace)
  player.play()
  return player.world
}

export function traceText(world: World): string {
  return traceOf(world)
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

export function emptyWorld(): World {
  return createWorld({ preserve: keepsEdges })
}
