// What a stranger hands in: of each type of an argument the values that are right, the first one plain, and those that
// look like them: stale, made up, of another world, one beyond each limit. And what is of no type of ours.
import { Circle, World as Planck } from 'planck'
import { circle, createWorld, GroundHashes, LgsError } from 'localgridseg'
import { Ground, Islands } from 'localgridseg/islands'
import { Pieces } from 'localgridseg/pieces'
import { FallingGround, Ground as PlanckGround, PlanckTerrain } from 'localgridseg/planck'
import { Box2dTerrain, FallingGround as Box2dFalling } from 'localgridseg/box2d3'
import { GroundMeshes, GroundPicture, OutlineLines } from 'localgridseg/draw'
import { parseTrace, TracePlayer } from 'localgridseg/trace'
import { importMap } from 'localgridseg/full'
import { b2, makeBody, makePhysics } from '../box2d3.js'

/** What a getter of a stranger throws. It comes out as it is. */
export class Mine extends Error {}
const mine = () => { throw new Mine() }

/** Handed in for any argument, whatever its type; but for what is the physics engine's own. */
export const anything = [
  undefined, null, NaN, 0, -0, 1, -1, 0.5, -1e-300, 5e-324, 7, 255, 4096, 4097, 65_536, 2 ** 30, 2 ** 30 + 1, 2 ** 31 - 1, 2 ** 31,
  -(2 ** 31), -(2 ** 31) - 1, 2 ** 32 - 1, 2 ** 32, 2 ** 53 - 1, 2 ** 53, 2 ** 60, 1e308, Infinity, -Infinity, 1n, true, '', '1', 'abc',
  '\ud800', '\0', Symbol('no'), mine, {}, [], [[]], [undefined], [1, 2, 3], [[1, 2], [3]], new Array(9), { length: 2 ** 32 }, { length: -1 },
  { valueOf: mine }, new Proxy({}, { get: mine }), new Float64Array(6).fill(NaN), new Int32Array(3), new BigInt64Array(4),
  new Uint8Array(100).fill(255), Object.create(null), new Date(NaN), new Map([[1, 2]]), class {},
]

const square = [0, 0, 1, 0, 1, 1, 0, 1], ramp = [0, 0, 1, 0, 1, 1], trace = 'lgs-trace 1\nadd a 0 0 1 0 0 1 0 1 1\ncommit\n'
const map = (data, more = '') => `<map orientation="orthogonal" width="2" height="1" tilewidth="16" tileheight="16">
  <tileset firstgid="1" tilewidth="16" tileheight="16" tilecount="2" columns="2"><tile id="0"/></tileset>
  <layer width="2" height="1"><data encoding="csv">${data}</data></layer>${more}</map>`
const ground = { i: 0, j: 5, polygons: [{ i: 0, j: 0, block: 1, vertices: square }, { i: 1, j: 0, block: 2, vertices: ramp }], mass: { area: 1, x: 0, y: 0, secondMoment: 1 } }
const rects = [[0, 0, 1, 1], [1, 1, 0, 0], [-3, -3, 40, 33], [2 ** 30, 2 ** 30, 2 ** 30, 2 ** 30], [0, 0, 2 ** 30 + 1, 0], [-(2 ** 31), -(2 ** 31), 2 ** 31 - 1, 2 ** 31 - 1],
  [0, 0, 2 ** 30, 0], [0, 0, 0.5, 1]].map(([i0, j0, i1, j1]) => ({ i0, j0, i1, j1 }))
const numbers = [1, 0, 3, -2, 0.5, 2048, 2049, 1 / 65_536, 2 ** 46]
const whole = [0, 1, -1, 2, 31, 32]
const rings = [ramp, [], [0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 1, 1, 1, 0, 0, 1], [0, 0, 1, 0, NaN, 1], [-1, -1, 5, -1, 2, 4], new Float32Array(square), [[0, 0], [1, 0], [1, 1]],
  [0, 0, 1e300, 0, 0, 1], [0, 0, 2049, 0, 0, 1], Array.from({ length: 8194 }, (_, k) => k % 7)]
const rowsOf = (shape) => [[9, 9, shape, 1], [], [9, 9, shape, 1, 9, 9, shape, 1], [2 ** 30 + 1, 0, shape, 1], [9, 9, 999, 1], [-(2 ** 31), -(2 ** 31), shape, -1],
  [9, 9, shape], Array.from({ length: 800 }, (_, k) => [k % 40, 100 + Math.trunc(k / 160), shape, 5][k % 4])].map((row) => Int32Array.from(row))
const places = [{ x: 3, y: 6, angle: 0 }, { x: 1e300, y: 0, angle: 0 }, { x: NaN, y: 0, angle: 0 }, { x: 0, y: 0, angle: Infinity }, { x: 2 ** 30, y: -(2 ** 30), angle: 9 }, { x: '1' }]
const cells = [{ i: 0, j: 0 }, { i: -7, j: 9 }, { i: 2 ** 31 - 1, j: -(2 ** 31) }, { i: 0.5, j: 0 }]

/** Of each type, as the sources write it. A function of the scene where names are asked for. */
const ofType = {
  "'drop' | 'keep'": ['drop', 'keep'],
  "'fill' | 'replace'": ['fill', 'replace'],
  "'solid' | 'free'": ['solid', 'free'],
  '(world: World) => void': (s) => [() => s.world.clear(0, 0), () => {}, () => s.world.commit(), () => s.world.rollBack(s.marks[0]), () => s.receivers.Islands.free(),
    () => s.receivers.Islands.foresee(() => {}), () => { s.world.clear(0, 0); mine() }, () => s.world.remove(-1), () => s.world.forget(s.marks[0])],
  Anchors: [{}, { blocks: [9], cells: rects.slice(0, 1) }, { blocks: [0.5] }, { cells: rects }, { blocks: new Array(3) }],
  AtEdge: ['holds', 'open', 'closed'],
  'ArrayLike<PolygonId>': ({ polygons }) => [[polygons()[0]], [], [polygons()[0], polygons()[0]], polygons(), new Array(3000).fill(polygons()[0])],
  Block: [1, 0, 9, 2 ** 32 - 1],
  Body: (s) => [s.planck.ball, s.planck.platform, s.planck.gone],
  Box2D: [b2],
  Box2dTerrain: (s) => [s.box2d.terrain],
  CellRect: [...rects, undefined],
  Changes: (s) => [s.changes, s.old, s.other.changes, { before: s.version(), after: s.version() }, { before: -1, after: s.version(), added: [], removed: [], relinked: [] },
    { before: s.shown, after: s.version(), added: s.old.added, removed: [2 ** 32], relinked: s.old.added }, { before: s.shown, after: s.version() }],
  Edit: [{ line: 1, kind: 'add', name: 'q', i: 9, j: 0, block: 1, vertices: ramp }, { line: 1, kind: 'remove', goes: { by: 'name', name: 'nobody' } }, { line: 1, kind: 'remove' }, { line: 1, kind: 'many', comes: [7] }, { line: 1, kind: 'repeat', times: 2 }, { line: 1, kind: 'commit' }, { kind: 'dance' },
    { line: 1, kind: 'carve', region: circle(0, 0, 1) }, { line: 1, kind: 'add', name: 'q', i: 9, j: 0, block: -1, vertices: [0] }],
  ErrorCode: ['overlap'],
  FallingOptions: [{}, { density: () => NaN }, { density: () => -1 }, { material: () => null }, { density: mine }],
  Fixture: (s) => [s.planck.ball.getFixtureList(), s.planck.physics.getBodyList().getFixtureList()],
  'Fixture | Contact': (s) => [s.planck.ball.getFixtureList(), s.planck.physics.getBodyList().getFixtureList()],
  GroundOptions: [{}, { anchors: { blocks: [9] } }, { undoSteps: 0 }, { undoSteps: NaN }, { atEdge: 'open' }, { atEdge: 'shut' }, { chunksAtOnce: 1 }, { chunksAtOnce: 0 }, { shelf: {} }, { shelf: 7 }, { land: mine }, { follow: 7 }, { anchors: { blocks: [0.5] } }, { preserve: mine }],
  GroundBody: [ground, { ...ground, polygons: [] }, { ...ground, i: 2 ** 31 - 1 }, { ...ground, polygons: [{ i: 2 ** 31 - 1, j: 0, block: 1, vertices: square }] },
    { ...ground, polygons: [{ i: 0, j: 0, block: 1, vertices: [0, 0, 9, 0, 0, 9] }] }, { ...ground, polygons: [null] }, { ...ground, polygons: new Array(2) }],
  GroundHashes: (s) => [s.receivers.GroundHashes, s.other.hashes],
  ImportOptions: [{}, { tolerance: 1e308 }, { tolerance: -1 }, { solid: true }, { polylineThickness: 0 }, { tiles: '[]' }, { tiles: '{' }, { numbers: { a: 2 ** 32 } }, { nothing: 1 }, { layers: ['*', '['] }],
  '{ draw(): GroundDrawing[]; rocks(): readonly Rock<unknown>[] }': [{ draw: () => [], rocks: () => [] }, {}],
  'Readonly<Record<number, Fill>>': [{ 1: 'red' }, {}],
  'readonly [number, number, number, number, number, number]': [[1, 0, 0, 1, 0, 0]],
  HTMLCanvasElement: [{ getContext: () => new Proxy({}, { get: () => () => {}, set: () => true }), clientWidth: 20, clientHeight: 9 }],
  'Int32Array': ({ square: shape }) => rowsOf(shape),
  IslandId: (s) => [1, 0, 2, 999, 2 ** 32 - 1],
  Islands: (s) => [s.receivers.Islands, s.other.islands],
  MapFiles: [{ 'a.tmx': map('1,2'), 'b.tmx': map('1,2,3', '<objectgroup><object/></objectgroup>'), 'c.tmx': '<map', 'd.tmj': '{"a":' }, {}, { 'a.tmx': new Uint8Array([60, 0, 255]) }, { 'a.tmx': map('4294967295,-1') },
    { 'a.tmx': map(' '.repeat(1e5)) }, { 'a.tmx': 5 }],
  Mark: (s) => [s.marks[0], s.marks[1], s.marks[2], 0, 2 ** 53 - 1],
  ObjectId: (s) => [s.box2d.body, s.box2d.gone, s.box2d.shape],
  OnOverlap: ['push', 'disable', 'leave', 'eat'],
  'Partial<ErrorDetails> & { cause?: unknown }': [{}, { cause: 7 }, { line: -1 }],
  Physics: (s) => [s.planck.physics, s.other.physics],
  PhysicsId: (s) => [s.box2d.physics],
  PieceId: [{ i: 1, j: 1, index: 0 }, { i: 2, j: 0, index: 0 }, { i: 1, j: 1, index: 2 ** 32 - 1 }, { i: 2 ** 31 - 1, j: -(2 ** 31), index: 0 }, { i: 0.5, j: 0, index: 0 }],
  PiecesOptions: [{}, { maxVertices: 3 }, { maxVertices: 2 }, { maxVertices: 4096 }, { maxVertices: 4097 }, { maxVertices: NaN }],
  PlanckTerrain: (s) => [s.planck.terrain],
  Point: places,
  PolygonId: (s) => [s.polygons()[0], s.gone, s.other.polygon, s.polygons()[0] + 0.5],
  Region: [circle(1, 1, 1.2), ...rings.map((ring) => ({ rings: [ring] })), { rings: [] }, { rings: [square, ramp], rule: 'evenOdd' }, { rings: [ramp], rule: 'odd' }, { rings: new Array(2) }, { rings: 7 },
    circle(2 ** 30, 2 ** 30, 3), { rings: new Array(3000).fill(ramp) }],
  'Region | number': [circle(3, 1, 0.4), 3, NaN, 2 ** 46],
  '(number | string | undefined)[]': [1, 3, 'fill'],
  SegmentId: (s) => [s.segments()[0] ?? 0, s.old.removed[0] ?? 0, s.segments().length + 1, 2 ** 32 - 1],
  ShapeId: (s) => [s.square, s.ramp, 3, 2 ** 32 - 1],
  'TerrainBase<Body, Material>': (s) => [s.planck.terrain, s.box2d.terrain],
  TerrainOptions: [{}, { cellSize: 0.5, chunkCells: 1, origin: cells[1] }, { cellSize: 0 }, { cellSize: 1e9 }, { chunkCells: 4097 }, { origin: cells[3] }, { origin: cells[2] }, { onOverlap: 'eat' },
    { material: () => null }, { material: mine }, { material: 7 }],
  "Pick<Trace, 'preserve'>": [parseTrace(trace), { preserve: [[1, 2]] }, { preserve: [7] }, { preserve: 7 }],
  Trace: [parseTrace(trace), { preserve: [[1, 2]], edits: [] }, { preserve: [7] }, { preserve: 7 }],
  Uint8Array: (s) => [s.chunk, s.chunk.slice(0, -1), s.saved, ...Array.from({ length: 40 }, (_, k) => s.chunk.map((byte, n) => (n === (7 * k) % s.chunk.length ? byte ^ 129 : byte)))],
  'Uint8Array | string': (s) => [s.saved, s.saved.slice(0, -1), s.savedText, 'AAAA', 'ä', ...Array.from({ length: 40 }, (_, k) => s.saved.map((byte, n) => (n === (7 * k) % s.saved.length ? byte ^ 129 : byte)))],
  Vertices: rings,
  World: (s) => [s.world, s.other.world, s.freed],
  WorldOptions: [{}, { precision: 'float' }, { precision: 'half' }, { preserve: () => true }, { preserve: mine }, { preserve: 7 }],
  number: numbers,
  'readonly (readonly [Block, Block])[]': [[], [[1, 2]], [7]],
  'readonly GroundPolygon[]': [ground.polygons, [], [null], [{ i: 0, j: 0, block: 1, vertices: [0, 0, NaN, 0, 1, 1] }], [{ i: 2 ** 31 - 1, j: -(2 ** 31), block: -1, vertices: square }]],
  string: ['a.tmx', 'b.tmx', 'c.tmx', 'd.tmj', '../a.tmx', trace, 'lgs-trace 2\npaint 1 over 0 0', 'lgs-trace 1\nadd a 0 0 1 1/0 0'],
  PictureOptions: [{}, { x: 3, y: -2, size: 9, line: 'red' }, { size: 0 }, { x: NaN }, { line: 7 }, { scale: 2 }],
  '{ merge?: boolean }': [{}, { merge: true }],
  '{ readonly i: number; readonly j: number }': cells,
  '{ readonly offsetX: number; readonly offsetY: number }': [{ offsetX: 3, offsetY: 4 }, {}],
  '{ readonly polygons: readonly GroundPolygon[] }': [ground, { polygons: [] }, { polygons: [null] }, { polygons: 7 }],
  '{ x: number; y: number; angle: number }': places,
}
/** Of these a game hands in what the physics engine or the browser gave it: nothing is promised for anything else. */
const ofPhysics = ['Body', 'Box2D', 'HTMLCanvasElement', 'Fixture', 'Fixture | Contact', 'ObjectId', 'Physics', 'PhysicsId']
/** In the terrain for Box2D a body is an id of its module. */
const ofBox2d = { Body: (s) => [s.box2d.body] }
/** In the ground without physics it is how a rock lies and moves. */
const ofIslands = { Body: (s) => [rockOf(s.receivers['islands/Ground']), { x: 0, y: 0, angle: 0 }, null] }
const rockOf = (ground) => {
  try {
    return ground.rocks()[0]?.body
  } catch (error) {
    if (error instanceof LgsError && error.code === 'freed') return undefined
    throw error
  }
}
/** Cells, where a number alone would be a coordinate. */
const isCell = /^World\.(add|addPolygon|replace|clear|polygonsAt)\(|^pieces\/Pieces\.(solid|free)Pieces\(/

export function valuesFor(scene, name, type) {
  const values = (name.startsWith('box2d3/') && ofBox2d[type]) || (name.startsWith('islands/') && ofIslands[type]) || (type === 'number' && isCell.test(name) ? whole : ofType[type])
  if (!values) throw new Error(`web/package/test/attack/values.js has no values of the type ${type} of ${name}`)
  const fits = name.includes('/Ground.paint(') && type === 'number' ? values.filter((value) => value !== 2048) : values // it would fill 13 million cells
  const strange = type.startsWith('(') ? anything.filter((value) => typeof value !== 'function' || value === mine) : anything
  return [...(typeof fits === 'function' ? fits(scene) : fits), ...(ofPhysics.includes(type) ? [] : strange)]
}

/** A world in the middle of its life, another one that it knows nothing of, and of what follows it what these doors need. */
export class Scene {
  world = createWorld()
  square = this.world.shape(square)
  ramp = this.world.shape(ramp)

  constructor(doors) {
    const { world } = this, needs = (...modules) => doors.some(({ name }) => modules.some((module) => name.startsWith(module)))
    world.fill({ i0: -1, j0: -1, i1: 1, j1: 1 }, this.square, 1)
    world.replace(1, 1, this.ramp, 2 ** 32 - 1)
    world.add(2 ** 30, -(2 ** 30), this.square, 9)
    this.gone = world.add(31, 31, this.ramp, 3)
    world.commit()
    this.marks = [world.mark(), world.mark()]
    world.forget(this.marks[1])
    world.remove(this.gone)
    world.clear(0, 1)
    this.old = world.commit().copy()
    this.saved = world.save()
    this.savedText = world.saveText()
    this.freed = createWorld()
    this.freed.free()
    const far = createWorld()
    far.fill({ i0: 64, j0: 64, i1: 70, j1: 64 }, far.shape(ramp), 5)
    this.chunk = far.unload({ i0: 64, j0: 64, i1: 95, j1: 95 })[0].bytes
    far.free()
    const other = createWorld(), polygon = other.addPolygon(-40, 77, square, 9)
    this.other = { world: other, polygon, changes: other.commit().copy() }
    world.add(0, 2, this.ramp, 2)
    world.forget(this.marks[0])
    this.changes = world.commit()
    this.shown = world.version
    // What follows a world begins while it has no mark.
    const receivers = (this.receivers = { World: world, ChangesCopy: this.old, TracePlayer: new TracePlayer(world) })
    if (needs('GroundHashes')) {
      receivers.GroundHashes = new GroundHashes(world)
      this.other.hashes = new GroundHashes(other)
    }
    if (needs('draw/')) Object.assign(receivers, { GroundPicture: new GroundPicture({ draw: () => [], rocks: () => [] }, ofType.HTMLCanvasElement[0], {}), OutlineLines: new OutlineLines(world), GroundMeshes: new GroundMeshes(world) })
    if (needs('ImportedMap')) receivers.ImportedMap = importMap('a.tmx', ofType.MapFiles[0], { solid: true })
    if (needs('pieces/')) receivers.Pieces = new Pieces(world)
    if (needs('islands/', 'planck/', 'box2d3/FallingGround')) {
      receivers.Islands = new Islands(world, { blocks: [9] })
      this.other.islands = new Islands(other)
    }
    if (needs('planck/', 'box2d3/cutOut')) this.#makePlanck()
    if (needs('box2d3/', 'planck/cutOut')) this.#makeBox2d()
    if (needs('islands/Ground')) this.#makeGround('islands/Ground', new Ground({ anchors: { blocks: [9] } }))
    if (needs('planck/Ground')) this.#makeGround('planck/Ground', new PlanckGround(this.planck.physics, { anchors: { blocks: [9] } }))
    this.marks[0] = world.mark()
    this.marks.push(other.mark())
  }

  /** Ids of what is there; none when somebody has freed the world. */
  polygons = () => (seen(this.world) === 'freed' ? [] : this.world.polygons().map(({ id }) => id))
  version = () => (seen(this.world) === 'freed' ? 0 : this.world.version)
  segments = () => (seen(this.world) === 'freed' ? [] : this.world.segments().id)

  /** All of which is looked at. */
  get worlds() { return [this.world, this.other.world, ...this.#grounds.map((each) => each.world)] }
  #grounds = []

  /** With a rock in the air, and something to undo and to redo. */
  #makeGround(name, made) {
    made.edit((world) => world.fill({ i0: 0, j0: 0, i1: 6, j1: 0 }, world.shape(square), 9))
    made.place(3, 2, square, 1)
    made.dig(1, 1, 0.5)
    made.dig(5, 1, 0.5)
    made.undo()
    this.receivers[name] = made
    this.#grounds.push(made)
  }

  #makePlanck() {
    const physics = new Planck({ x: 0, y: -10 }), terrain = new PlanckTerrain(physics, this.world, { chunkCells: 2 })
    const bodyAt = (type, x, y) => {
      const body = physics.createBody({ type, position: { x, y } })
      body.createFixture(new Circle(0.4), { density: 1 })
      return body
    }
    const gone = bodyAt('dynamic', 9, 9)
    physics.destroyBody(gone)
    this.planck = { physics, terrain, ball: bodyAt('dynamic', 0.5, 3.2), platform: bodyAt('static', 5, 5), gone }
    this.receivers.PlanckTerrain = terrain
    if (this.receivers.Islands) this.receivers['planck/FallingGround'] = new FallingGround(physics, terrain, this.receivers.Islands)
    this.other.physics = new Planck({ x: 0, y: 0 })
  }

  #makeBox2d() {
    const physics = makePhysics(), terrain = new Box2dTerrain(b2, physics, this.world, { chunkCells: 2 })
    const body = makeBody(physics, { x: 0.5, y: 3.2, ball: 0.4 }), gone = makeBody(physics, { x: 9, y: 9, ball: 0.4 })
    const shape = b2.b2Body_GetShapes(body, 1)[0]
    b2.b2DestroyBody(gone)
    this.box2d = { physics, terrain, body, gone, shape }
    this.receivers.Box2dTerrain = terrain
    if (this.receivers.Islands) this.receivers['box2d3/FallingGround'] = new Box2dFalling(b2, physics, terrain, this.receivers.Islands)
  }

  /** On what a method of a class is called. */
  receiver(of, module) {
    const made = of === 'SegmentList' ? this.world.segments() : of === 'Changes' ? this.changes : this.receivers[`${module}/${of}`] ?? this.receivers[of]
    if (!made) throw new Error(`web/package/test/attack/values.js makes no ${of}`)
    return made
  }

  free() {
    for (const each of this.#grounds) each.free()
    if (this.box2d) b2.b2DestroyWorld(this.box2d.physics)
    this.receivers.Islands?.free()
    for (const follower of [this.receivers.Pieces, this.receivers.GroundHashes, this.other.hashes]) follower?.free()
    this.other.islands?.free()
    this.world.free()
    this.other.world.free()
  }
}

/** What nobody may change who is refused. */
export function seen(world) {
  try {
    const { polygons, segments, shapes, chunks } = world.stats()
    const list = world.segments()
    return JSON.stringify([polygons, segments, shapes, chunks, world.version, world.maxSegmentId,
      world.polygons().map(({ id, i, j, block, vertices }) => [id, i, j, block, ...vertices]), [list.id, list.geometry, list.block, list.owner].map((array) => Array.from(array))])
  } catch (error) {
    if (error instanceof LgsError && error.code === 'freed') return 'freed'
    throw error
  }
}
