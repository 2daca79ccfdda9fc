// Maps of Tiled and LDtk as polygons in cells.
import { bad, object } from './check.js'
import { engine } from './engine.js'
import { LgsError } from './error.js'
import type { Block, ImportedMap, ImportOptions, MapFiles, World } from './types.js'
import { placeOf } from './world.js'

/** What lgs::web::importMap() returns, apart from the numbers. */
interface Told {
  error?: string
  line?: number
  shapes: number
  placements: number
  numbers: number
  blocks: Record<string, Block>
  tiles: { tileset: string; id: number; class: string }[]
  layers: string[]
  partial: string
  suggestions: string[]
  report: string
}

const nameOf = (path: string) => path.slice(path.search(/[^/\\]*$/))
const folderOf = (path: string) => path.slice(0, -nameOf(path).length - 1) || '.'

/** Files given as an object, as the importer reads them. */
function lookup(files: MapFiles) {
  const all = new Map(Object.entries(object('files', 'contents by their paths', files)))
  // What is found wrong later would end the engine: it can not be reported while the importer runs.
  for (const [path, content] of all)
    if (typeof content !== 'string' && !(content instanceof Uint8Array)) throw bad(path, 'a string or a Uint8Array', content)
  const byName = new Map([...all].map(([path, content]) => [nameOf(path), content]))
  return {
    read(path: string) {
      const content = all.get(path) ?? all.get(path.replace(/^\.\//, '')) ?? byName.get(nameOf(path))
      if (content === undefined) return null
      return typeof content === 'string' ? new TextEncoder().encode(content) : content
    },
    list: (folder: string) => [...all.keys()].filter((path) => folderOf(path) === folder).map(nameOf),
  }
}

const kinds: Record<keyof ImportOptions, (v: unknown) => boolean> = {
  tolerance: Number.isFinite, polylineThickness: Number.isFinite,
  solid: (v) => typeof v === 'boolean', visible: (v) => typeof v === 'boolean', allMaps: (v) => typeof v === 'boolean',
  block: (v) => v === 'one' || v === 'class' || v === 'name' || v === 'layer',
  solidIf: isTexts, layers: isTexts, objects: isTexts, not: isTexts, tiles: isText,
  numbers: (v) => typeof v === 'object' && v !== null && !Array.isArray(v) &&
    Object.entries(v).every(([name, n]) => isText(name) && typeof n === 'number' && n >>> 0 === n),
}

/** Half of a surrogate pair is none: JSON cannot say it, and the importer would end. */
function isText(v: unknown): boolean {
  return typeof v === 'string' && !/\p{Surrogate}/u.test(v)
}

function isTexts(v: unknown): boolean {
  return Array.isArray(v) && Array.from(v).every(isText)  // every() leaves holes out
}

/** A copy: what a getter gives may be another thing the next time. */
function checked(options: ImportOptions): ImportOptions {
  if (Array.isArray(options)) throw bad('options', 'an object', options)
  const all = Object.entries(object('options', 'an object', options))
  for (const [name, value] of all) {
    const isRight = Object.hasOwn(kinds, name) && kinds[name as keyof ImportOptions]
    if (!isRight) throw bad('the option', `one of ${Object.keys(kinds).join(', ')}`, name)
    if (value !== undefined && !isRight(value)) throw bad(`options.${name}`, 'what ImportOptions says', value)
  }
  return Object.fromEntries(all)
}

/**
 * Imports a map of Tiled (.tmx, .tmj, .world) or LDtk. `files` must have it at `path`, and the files that it names.
 * Throws an LgsError 'bad-map' that names the file, the line and what is wrong.
 */
export function importMap(path: string, files: MapFiles, options: ImportOptions = {}): ImportedMap {
  if (typeof path !== 'string') throw bad('path', 'a string', path)
  const e = engine()
  const told = JSON.parse(
    new TextDecoder().decode(e.answerBytes(e.importMap(path, checked(options), lookup(files))))) as Told
  if (told.error !== undefined) throw new LgsError('bad-map', told.error, { line: told.line || null })

  const numbers = e.answer(told.numbers)
  const shapes: Float64Array[] = []
  let next = 0
  while (shapes.length < told.shapes) {
    const end = next + 1 + 2 * numbers[next]!
    shapes.push(numbers.slice(next + 1, end))
    next = end
  }
  const count = told.placements
  const placements = new Int32Array(4 * count), tile = new Int32Array(count), object = new Uint32Array(count)
  const layer = new Uint32Array(count)
  for (let k = 0; k < count; ++k, next += 7) {
    for (let c = 0; c < 4; ++c) placements[4 * k + c] = numbers[next + c]!
    tile[k] = numbers[next + 4]!
    object[k] = numbers[next + 5]!
    layer[k] = numbers[next + 6]!
  }
  const { blocks, tiles, layers, partial, suggestions, report } = told
  return { shapes, placements, tile, object, layer, tiles, layers, blocks, partial, suggestions, report,
    place: (world) => place(world, shapes, placements) }
}

function place(world: World, shapes: readonly Float64Array[], placements: Int32Array): Float64Array {
  placeOf(world)
  const ids = shapes.map((shape) => world.shape(shape))
  return world.addMany(placements.map((value, k) => (k % 4 === 2 ? ids[value]! : value)))
}
