// Uses everything, as the compiler sees it. Nothing here runs: types.test.js has tsc check it. An error that is expected
// and does not come is an error.
import {
  GroundHashes, LgsError, circle, createWorld, init, loadWorld, rectangle, thickLine, unitSquare,
  type Block, type BrushResult, type CellRect, type Changes, type ErrorCode, type HashedSquare, type Hit, type Loop, type Mark,
  type Nearest, type Polygon, type PolygonId, type RayHit, type Region, type Segment, type SegmentList, type ShapeId, type Spot,
  type Stats, type World,
} from 'localgridseg'
import { init as initInline, createWorld as createInline } from 'localgridseg/inline'
import { importMap, type ImportedMap, init as initFull } from 'localgridseg/full'
import {
  Islands, convexParts, init as initIslands, massOf, type Anchors, type ConvexPart, type GroundBody, type Island,
  type Foreseen, type GroundDrawing, type GroundOptions, type IslandChanges, type IslandId, type IslandPair, type Mass, Ground as BareGround,
} from 'localgridseg/islands'
import { Pieces, init as initPieces, type PieceId, type Portal, type SolidPiece } from 'localgridseg/pieces'
import { answer, check, init as initOracle, outline, page, type Checked } from 'localgridseg/oracle'
import { TracePlayer, dump, parseTrace, preserveOf, traceOf, type Edit, type Trace } from 'localgridseg/trace'
import { FallingGround, Ground as PlanckGround, PlanckTerrain, cutOut, type Overlap, type Falling } from 'localgridseg/planck'
import { Box2dTerrain, FallingGround as Box2dFalling, type Box2D, type Falling as Box2dFallen, type ObjectId, type PhysicsId } from 'localgridseg/box2d3'
import { GroundMeshes, GroundPicture, OutlineLines, linesIn, trianglesIn, type ChunkLines, type ChunkMesh } from 'localgridseg/draw'
import { World as Planck, type Body, type Fixture } from 'planck'

export async function starts(module: WebAssembly.Module, bytes: Uint8Array<ArrayBuffer>): Promise<void> {
  await init()
  await init({})
  await init({ url: '/lgs.wasm' })
  await init({ url: new URL('file:///lgs.wasm') })
  await init({ bytes })
  await init({ module })
  await initInline()
  await initFull({ module })
  await initIslands({ url: '/lgs-islands.wasm' })
  await initPieces()
  await initOracle()
  const checked: Checked = check('lgs-trace 1')
  const texts: string[] = [answer('commit'), outline('lgs-trace 1'), page('lgs-trace 1', 'name'), checked.report]
  // @ts-expect-error: a text
  if (checked.isRight) answer(texts)
  // @ts-expect-error: not a path
  await init('/lgs.wasm')
  // @ts-expect-error: nothing to say
  await initInline({ url: '/lgs.wasm' })
}

export function worlds(bytes: Uint8Array): void {
  const world: World = createWorld()
  createWorld({ preserve: (a, b) => a === 1 && b === 2, precision: 'float' }).free()
  createInline({ precision: 'double' })[Symbol.dispose]()
  loadWorld(bytes, { preserve: undefined })
  {
    using scoped = createWorld()
    scoped.commit()
  }
  // @ts-expect-error: no such precision
  createWorld({ precision: 'half' })
  // @ts-expect-error: no such option
  createWorld({ ghosts: true })
  loadWorld(createWorld().saveText())
  // @ts-expect-error: bytes or text
  loadWorld([1, 2])
  edits(world)
  reads(world)
}

function edits(world: World): void {
  const shape: ShapeId = world.shape(unitSquare)
  world.shape([0, 0, 1, 0, 1, 1])
  world.shape([[0, 0], [1, 0], [1, 1]])
  world.shape(Float64Array.of(0, 0, 1, 0, 1, 1))
  // @ts-expect-error: triples are no vertices
  world.shape([[0, 0, 0]])
  // @ts-expect-error: nor is text
  world.shape('0 0 1 0 1 1')
  const polygon: PolygonId = world.add(0, 0, shape, 1)
  // @ts-expect-error: a block is missing
  world.add(0, 0, shape)
  const ids: Float64Array = world.addMany(Int32Array.of(0, 0, shape, 1))
  // @ts-expect-error: whole numbers only
  world.addMany(Float64Array.of(0, 0, shape, 1))
  world.addPolygon(0, 0, [0, 0, 1, 0, 1, 1], 1)
  world.remove(polygon)
  world.removeMany(ids)
  world.removeMany([polygon])
  world.replace(0, 0, shape, 2)
  world.setBlock(polygon, 3)
  const cells: CellRect = { i0: 0, j0: 0, i1: 9, j1: 9 }
  const count: number = world.fill(cells, shape, 1) + world.clear(cells) + world.clear(1, 2)
  // @ts-expect-error: a corner is missing
  world.fill({ i0: 0, j0: 0, i1: 9 }, shape, count)
  // @ts-expect-error: one of two indices
  world.clear(1)
  const region: Region = circle(1, 2, 3, 32)
  const result: BrushResult = world.paint(region, 1, 'replace')
  world.carve(rectangle(0, 0, 1, 0, 2, 1))
  world.carve(thickLine([[0, 0], [1, 1]], 0.5, 16))
  world.paint({ rings: [[0, 0, 1, 0, 1, 1]], rule: 'evenOdd' }, 1)
  // @ts-expect-error: no such mode
  world.paint(region, 1, 'over')
  // @ts-expect-error: results are not to be changed
  result.removed.push(polygon)
  const mark: Mark = world.mark()
  const back: Changes = world.rollBack(mark)
  world.rollBack(mark, 'keep')
  const forth: Changes = world.redo(mark)
  void forth
  // @ts-expect-error: no such choice
  world.rollBack(mark, 'forget')
  world.forget(mark)
  // @ts-expect-error: a mark is no polygon
  world.rollBack(polygon)
  // @ts-expect-error: nor is a polygon a shape
  world.add(0, 0, polygon, 1)
  const named: PolygonId[] = [...result.removed, ...result.added, ...result.rounded, ...result.changed.flatMap(({ now }) => now)]
  void named
  const [block]: (Block | undefined)[] = Array.from(back.added.block)
  if (block !== undefined) world.setBlock(polygon, block)
}

function reads(world: World): void {
  const { removed, added, relinked, before, after }: Changes = world.commit()
  const kept: Changes = world.commit().copy()
  const list: SegmentList = world.segments()
  const inCells: SegmentList = world.segments({ i0: 0, j0: 0, i1: 1, j1: 1 }).copy()
  const numbers: (Uint32Array | Int32Array | Float64Array | Float32Array)[] = [
    removed, added.id, added.geometry, relinked.block, list.cell, inCells.owner, list.predecessor, list.successor,
  ]
  const versions: number[] = [before, after, kept.before, world.version]
  // @ts-expect-error: lists are read
  added.id = removed
  // @ts-expect-error: geometry may be of floats
  const doubles: Float64Array = added.geometry
  const segments: Segment[] = [...added, ...relinked]
  const buffers: ArrayBuffer[] = kept.copy().buffers()
  // @ts-expect-error: what is overwritten can not be handed over
  world.rollBack(1).buffers()
  void [segments, buffers]
  const segment: Segment = world.segment(1)
  const x: number | undefined = segment.ghost1?.[0]
  // @ts-expect-error: there may be no ghost
  segment.ghost2[1].toFixed()
  const hit: Hit = world.hit(segment.id)
  const loops: Loop[] = world.loops({ merge: true })
  const polygons: Polygon[] = [...world.polygonsAt(0, 0), ...world.polygons(), world.polygon(hit.polygon)]
  const spot: Spot = world.at(1, 2)
  const near: Nearest | null = world.nearest(1, 2, 3)
  const ray: RayHit | null = world.rayCast(0, 0, 1, 1)
  // @ts-expect-error: nothing may be near
  near.distance.toFixed()
  // @ts-expect-error: no such place
  const isAbove = spot.where === 'above'
  const saved: Uint8Array = world.save()
  const stats: Stats = world.stats()
  const bounds: CellRect | null = world.bounds()
  const id: number = world.maxSegmentId
  // @ts-expect-error: it is read
  world.maxSegmentId = 3
  void [numbers, versions, doubles, x, loops, polygons, ray, isAbove, saved, stats, bounds, id]
}

export function errors(f: () => void): ErrorCode | undefined {
  try {
    f()
  } catch (error) {
    if (!(error instanceof LgsError)) throw error
    const where: number = error.cell?.i ?? error.vertex ?? error.index ?? 0
    // @ts-expect-error: no such code
    if (error.code === 'wrong') return undefined
    return where >= 0 ? error.code : undefined
  }
  return undefined
}

export function traces(text: string, world: World): string {
  const trace: Trace = parseTrace(text)
  const player = new TracePlayer(createWorld({ preserve: preserveOf(trace) }))
  const names = trace.edits.map((edit: Edit) => (edit.kind === 'add' ? edit.name : ''))
  for (const edit of trace.edits) player.apply(edit)
  player.play(trace)
  // @ts-expect-error: a commit has no name
  trace.edits.filter((edit) => edit.kind === 'commit').map((edit) => edit.name)
  return names.join() + dump(player.world) + traceOf(world, [[1, 2]])
}

export function maps(world: World): number {
  const map: ImportedMap = importMap('a.tmx', { 'a.tmx': '<map/>', 'b.tsx': new Uint8Array(3) },
    { tolerance: 1, solid: true, solidIf: ['a'], block: 'class', numbers: { ice: 3 }, layers: ['Ground'] })
  // @ts-expect-error: no such option
  importMap('a.tmx', {}, { tolerances: 1 })
  const blocks: number[] = Object.values(map.blocks)
  return map.place(world).length + blocks.length + (map.tiles[0]?.id ?? 0)
}

export function physics(world: World, box2d: Box2D, id: PhysicsId, fixture: Fixture, shape: ObjectId): void {
  const terrain = new PlanckTerrain(new Planck(), world, {
    cellSize: 0.5, origin: { i: 3, j: 4 }, chunkCells: 8, material: (block) => ({ friction: block === 3 ? 0 : 0.5 }),
  })
  terrain.sync(world.commit())
  const hit: Hit | null = terrain.hit(fixture)
  const there: Fixture | null = terrain.fixture(terrain.segment(fixture))
  terrain.ghosts = false
  terrain.resync()
  terrain.destroy()
  // @ts-expect-error: a terrain is fed with changes
  terrain.sync(world.segments())
  // @ts-expect-error: no such option
  new PlanckTerrain(new Planck(), world, { cells: 3 })
  const other = new Box2dTerrain(box2d, id, world, { cellSize: 0.5 })
  other.sync(world.commit())
  terrain.sync(world.commit(), 'disable')
  const overlaps: Overlap<Body>[] = [...terrain.overlapsWith(terrain.commit()), ...terrain.overlaps]
  const bodies: Body[] = [...terrain.disabled, ...terrain.afterStep(), ...terrain.bodiesIn({ i0: 0, j0: 0, i1: 1, j1: 1 })]
  const isRoom: boolean = bodies.every((body) => terrain.fits(body) && terrain.fits(body, { x: 1, y: 2, angle: 0 }))
  world.carve(terrain.outlinesOf(overlaps[0]!.body))
  cutOut(terrain, world, world.commit())
  terrain.moveOrigin({ i: 1, j: 2 })
  // @ts-expect-error: no such way
  terrain.sync(world.commit(), 'kill')
  void isRoom
  const hits: (Hit | null)[] = [hit, other.hit(shape)]
  // @ts-expect-error: planck's fixtures are not Box2D's
  other.hit(fixture)
  void [there, hits, other.position(0, 0).x, other.point({ x: 1, y: 2 }).y, terrain.position(1, 2)]
}

export function drawing(world: World): number {
  const outline = new OutlineLines(world, 32)
  const lines: ChunkLines[] = [...outline.all(), ...outline.update(world.commit())]
  const meshes = new GroundMeshes(world, 32)
  const mesh: ChunkMesh[] = [...meshes.all(), ...meshes.update(world.commit())]
  const cells: CellRect = { i0: 0, j0: 0, i1: 1, j1: 1 }
  return lines.length + linesIn(world, cells).length + trianglesIn(world, cells).indices.length + mesh.length
}

export function inStep(world: World, other: World): boolean {
  using hashes = new GroundHashes(world)
  hashes.update()
  const squares: HashedSquare[] = [hashes.whole(), ...hashes.in({ i0: 0, j0: 0, i1: 9, j1: 9 }), ...hashes.in(hashes.whole().cells, 1)]
  const hash: bigint = squares[0]!.hash
  // @ts-expect-error: a hash has 64 bits, more than a number
  const number: number = hash
  void number
  const chunks: CellRect[] = hashes.differences(new GroundHashes(other))
  return chunks.length === 0 && hash === hashes.hash
}

export function islandsOf(world: World, physics: Planck, terrain: PlanckTerrain): void {
  const anchors: Anchors = { blocks: [9], cells: [{ i0: 0, j0: 0, i1: 99, j1: 0 }] }
  using islands = new Islands(world, anchors)
  islands.update(world.commit())
  const { cutOff, added }: IslandChanges = islands.changes
  const pair: IslandPair | undefined = cutOff[0]
  const [id]: IslandId[] = [...islands.loose(), ...islands.all(), ...added, pair?.into ?? 0]
  if (id === undefined) return
  const facts: Island | null = islands.island(id)
  // @ts-expect-error: the id may name none
  facts.area.toFixed()
  const polygon: PolygonId = world.polygons()[0]!.id
  const same: IslandId = islands.of(polygon)
  // @ts-expect-error: an island is no polygon
  world.remove(same)
  const body: GroundBody = islands.take(id)
  islands.put(body)
  islands.put(body, 1, 2)
  const bodies: GroundBody[] = islands.takeApart(id)
  const { changes, after }: Foreseen = islands.foresee((given) => { given.clear(1, 2) })
  // @ts-expect-error: what is foreseen is to be read
  after.push(facts)
  void [bodies, changes]
  islands.putAsItLies(body, { x: 1, y: 2, angle: 3 })
  // @ts-expect-error: an angle is missing
  islands.putAsItLies(body, { x: 1, y: 2 })
  const parts: ConvexPart[] = [...convexParts(body), ...convexParts(body, 4)]
  const mass: Mass = massOf(body.polygons)
  // @ts-expect-error: a body is to be read
  body.mass = mass
  const falling = new FallingGround(physics, terrain, islands, { density: (block) => block, material: () => ({ friction: 1 }) })
  falling.takeAsBody(id)
  const fallen: readonly Falling[] = [...falling.afterSync(), ...falling.bodies]
  for (const { body: each } of fallen) if (!each.isAwake() && !falling.settle(each)) falling.forget(each)
  const other: Falling | null = falling.make(body, { x: 0, y: 0, angle: 0 })
  void [parts, other && falling.placeOf(other.body)]
  islands.free()
}

export function piecesOf(world: World): number {
  using pieces = new Pieces(world, { maxVertices: 4 })
  const cells: { readonly i: number; readonly j: number }[] = pieces.update(world.commit())
  const solid: SolidPiece[] = cells.flatMap(({ i, j }) => pieces.solidPieces(i, j))
  const at: PieceId | null = pieces.freePieceAt(1, 2)
  // @ts-expect-error: there may be none
  pieces.portals(at)
  const ways: Portal[] = at ? pieces.portals(at) : []
  const rects: CellRect[] = pieces.wholeCells({ i0: 0, j0: 0, i1: 9, j1: 9 }, 'free')
  // @ts-expect-error: solid or free
  pieces.wholeCells({ i0: 0, j0: 0, i1: 9, j1: 9 }, 'full')
  return solid.length + ways.length + rects.length + pieces.freePieces(0, 0).length
}

export function fallsInBox2d(box2d: Box2D, physics: PhysicsId, terrain: Box2dTerrain, islands: Islands): ObjectId[] {
  const falling = new Box2dFalling(box2d, physics, terrain, islands, { material: () => ({ friction: 1 }) })
  const made: Box2dFallen[] = falling.afterSync()
  return made.map(({ body }) => body).filter((body) => !falling.settle(body))
}

export function groundOf(physics: Planck, saved: Uint8Array): number {
  const options: GroundOptions = {
    anchors: { blocks: [9] }, undoSteps: 10, land: (land, { i0, j0 }) => { land.addPolygon(i0, j0, [0, 0, 1, 0, 0, 1], 9) },
    shelf: { put: (i, j, bytes) => void [i, j, bytes], get: () => undefined }, follow: (world, { after }) => void [world, after],
  }
  using bare = new BareGround(options)
  using ground = new PlanckGround(physics, options, { cellSize: 0.5, merge: true }, { density: () => 2 })
  // @ts-expect-error: it has another name
  new BareGround({ anchor: {} })
  const picture = new GroundPicture(ground, document.createElement('canvas'), { 1: 'red', 2: '#00f' }, { size: 20, line: 'black' })
  addEventListener('pointermove', (event) => picture.at(event))
  ground.window(picture.cells)
  picture.draw()
  ground.dig(1, 2, 3)
  ground.dig(circle(1, 2, 3))
  ground.paint(1, 2, 3, 4, 'replace')
  ground.paint(circle(1, 2, 3), 4)
  ground.place(1, 2, [0, 0, 1, 0, 0, 1], 4)
  // @ts-expect-error: a radius is missing
  ground.dig(1, 2)
  const id: PolygonId = ground.edit((world) => world.addPolygon(9, 9, [0, 0, 1, 0, 0, 1], 4))
  const done: boolean = ground.undo() && ground.redo() && ground.window({ i0: 0, j0: 0, i1: 9, j1: 9 }) && ground.canUndo && ground.canRedo
  ground.step(1 / 60)
  for (const { body, x, y, angle, ground: { mass } } of ground.rocks()) if (body && !body.isAwake()) void [ground.settle(body), x, y, angle, mass.area]
  for (const { body } of bare.rocks()) if (body) body.y -= 1
  const drawn: GroundDrawing[] = ground.draw()
  ground.load(saved.length > 0 ? saved : ground.save())
  const hit: Hit | null = ground.terrain.hit(physics.getContactList()!)
  void [id, done, hit, ground.world.stats(), ground.islands.all()]
  return drawn.flatMap(({ fills, lines }) => [...fills.map(({ vertices }) => vertices.length), ...lines.map((line) => line.length)]).length
}
