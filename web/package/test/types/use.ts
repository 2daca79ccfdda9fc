// Uses all that the package exports, as a user of TypeScript would. It is never run: types.test.js lets tsc check it.
// An error that is expected and does not come is an error.
import Box2DFactory from 'box2d3-wasm'
import {
  type Block, type BrushResult, type CellRect, type Changes, type ErrorCode, type Hit, type InitOptions, LgsError,
  type Loop, type Mark, type Nearest, type Polygon, type PolygonId, type RayHit, type Region, type Segment,
  type SegmentId, type SegmentList, type ShapeId, type Spot, type Stats, type Vertices, type World, type WorldOptions,
  circle, createWorld, init, loadWorld, rectangle, thickLine, unitSquare,
} from 'localgridseg'
import { Box2dTerrain, type Material } from 'localgridseg/box2d3'
import * as inline from 'localgridseg/inline'
import { type Edit, type Trace, TracePlayer, dump, parseTrace, preserveOf, traceOf } from 'localgridseg/trace'

// Starting

const options: InitOptions = { url: new URL('https://example.org/lgs.wasm') }
await init()
await init(options)
await init({ bytes: new Uint8Array() })
await init({ module: new WebAssembly.Module(new Uint8Array()) })
// @ts-expect-error: no such option
await init({ file: 'lgs.wasm' })
await inline.init()
const other: World = inline.createWorld()

// Worlds

const worldOptions: WorldOptions = { preserve: (smaller: Block, greater: Block) => smaller !== greater, precision: 'float' }
const world: World = createWorld(worldOptions)
// @ts-expect-error: no such precision
createWorld({ precision: 'single' })
// @ts-expect-error: preserve says yes or no
createWorld({ preserve: () => 'yes' })
{
  using scoped = createWorld()
  scoped.commit()
}

// Edits

const vertices: Vertices = [0, 0, 1, 0, 1, 1]
const shape: ShapeId = world.shape(unitSquare)
world.shape(new Float32Array(6))
// @ts-expect-error: three numbers are no vertex
world.shape([[0, 0, 0]])
const polygon: PolygonId = world.add(1, 2, shape, 3)
const ids: Float64Array = world.addMany(new Int32Array([0, 0, shape, 1]))
// @ts-expect-error: only integers of 32 bits
world.addMany([0, 0, shape, 1])
world.addPolygon(0, 1, vertices, 4)
world.remove(polygon)
world.removeMany(ids)
world.removeMany([polygon])
world.replace(0, 0, shape, 1)
world.setBlock(polygon, 2)
// @ts-expect-error: a block is a number
world.setBlock(polygon, 'stone')
const cells: CellRect = { i0: 0, j0: 0, i1: 9, j1: 9 }
const filled: number = world.fill(cells, shape, 1)
const cleared: number = world.clear(cells) + world.clear(1, 2)
// @ts-expect-error: a cell has two coordinates
world.clear(1)
const region: Region = { rings: [vertices, [[0, 0], [1, 0], [1, 1]]], rule: 'evenOdd' }
const brushed: BrushResult = world.paint(region, 1, 'replace')
world.paint(circle(0, 0, 1), 1)
// @ts-expect-error: no such mode
world.paint(region, 1, 'over')
world.carve(rectangle(0, 0, 1, 0, 1, 1))
world.carve(thickLine([0, 0, 1, 1], 0.5))
// @ts-expect-error: results are not to be written
brushed.went.push(polygon)

// Changes

const changes: Changes = world.commit()
const removed: Uint32Array = changes.removed
const { added, relinked }: { added: SegmentList; relinked: SegmentList } = changes
const geometry: Float32Array | Float64Array = added.geometry
const owner: Float64Array = relinked.owner
const numbers: Uint32Array[] = [added.id, added.block, added.predecessor, added.successor]
const cell: Int32Array = added.cell
const kept: Changes = changes.copy()
const versions: bigint[] = [changes.before, kept.after, world.version]
// @ts-expect-error: versions are bigint
const version: number = world.version
const mark: Mark = world.checkpoint()
world.rollBack(mark).added.copy()
world.forget(mark)

// Questions

const list: SegmentList = world.segments(cells)
const segment: Segment = world.segment(list.id[0] as SegmentId)
// @ts-expect-error: it may have no ghost
segment.ghost1[0]
const loops: Loop[] = world.loops({ merge: true })
const polygons: Polygon[] = [...world.polygonsAt(0, 0), ...world.polygons(), ...world.polygons(cells), world.polygon(polygon)]
const hit: Hit = world.hit(segment.id)
const spot: Spot = world.at(0.5, 0.5)
// @ts-expect-error: no such place
spot.where === 'border'
const nearest: Nearest | null = world.nearest(0, 0, 1)
// @ts-expect-error: there may be none
world.nearest(0, 0, 1).segment
const ray: RayHit | null = world.rayCast(0, 0, 1, 1)
const stats: Stats = world.stats()
const bounds: CellRect | null = world.bounds()
const highest: SegmentId = world.maxSegmentId
const bytes: Uint8Array = world.save()
loadWorld(bytes, worldOptions).free()

// Errors

try {
  world.remove(polygon)
} catch (error) {
  if (error instanceof LgsError) {
    const code: ErrorCode = error.code
    // @ts-expect-error: no such code
    error.code === 'no-such-code'
    console.log(code, error.message)
  }
}

// Traces

const trace: Trace = parseTrace('lgs-trace 1')
const edits: readonly Edit[] = trace.edits
const player = new TracePlayer(createWorld({ preserve: preserveOf(trace) }))
for (const edit of edits) player.apply(edit)
const texts: string[] = [dump(player.world), traceOf(world), traceOf(world, trace.preserve)]

// The terrain for box2d3-wasm takes its module as it is.

const box2d = await Box2DFactory()
const physics = box2d.b2CreateWorld(box2d.b2DefaultWorldDef())
const ice: Material = { friction: 0 }
const terrain = new Box2dTerrain(box2d, physics, world, { cellSize: 0.5, origin: { i: 1, j: 2 }, chunkCells: 8, material: () => ice })
// @ts-expect-error: no such option
new Box2dTerrain(box2d, physics, world, { cellsize: 0.5 })
terrain.sync(changes)
terrain.resync()
const touched = terrain.shape(segment.id)
const struck: Hit | null = touched && terrain.hit(touched)
const name: SegmentId | null = touched && terrain.segment(touched)
const { x, y } = terrain.point(terrain.position(1, 2))
terrain.destroy()

export { bounds, cell, cleared, filled, geometry, highest, hit, loops, name, nearest, numbers, other, owner, polygons, ray,
  removed, stats, struck, texts, version, versions, x, y }
