// The code beside a scene: how a game makes ground of that kind, and what it hands on to physics.

export interface Code {
  readonly js: string
  readonly cpp: string
}

const jsEnd = `
const { removed, added, relinked } = world.commit()
console.log(removed.length, 'removed,', added.length, 'added,', relinked.length, 'relinked')
// With planck: new PlanckTerrain(physics, world) once, and terrain.sync(world.commit()) after each edit.`

const cppEnd = `
  for (const lgs::SegmentId id : world.commit().added) {
    const lgs::Segment s = *world.segment(id);  // Box2D: SetOneSided(s.ghost1, s.start, s.end, s.ghost2)
    std::printf("block %u in cell (%d, %d)\\n", s.block, s.cell.i, s.cell.j);
  }
}`

function js(imports: string, options: string, lines: readonly string[]): string {
  const head = `import { init, createWorld${imports} } from 'localgridseg'\n\nawait init()\nconst world = createWorld(${options})`
  return [head, ...lines].join('\n') + jsEnd
}

function cpp(includes: readonly string[], world: string, lines: readonly string[]): string {
  const head = ['#include <cstdio>', ...includes.map((name) => `#include <lgs/${name}.h>`), '', 'int main() {', `  ${world}`]
  return [...head, ...lines.map((line) => `  ${line}`)].join('\n') + cppEnd
}

const map = (name: string, ...others: string[]): Code => ({
  js: `import { readFile } from 'node:fs/promises'
import { createWorld, importMap, init } from 'localgridseg/full'

await init()
const files = {}
for (const name of ${JSON.stringify([name, ...others])}) files[name] = await readFile(name)
const map = importMap('${name}', files)
const world = createWorld()
map.place(world)${jsEnd}`,
  cpp: cpp(['tiled/import', 'world'], 'lgs::World world;', [
    `const auto map = lgs::tiled::importMap("${name}");`,
    'if (!map) return std::puts(lgs::tiled::message(map.error()).c_str()), 1;',
    'std::vector<lgs::ShapeId> shapes;',
    'for (const auto& shape : map->shapes) shapes.push_back(*world.shape(shape));',
    'for (const lgs::tiled::MapPolygon& p : map->placements)',
    '  if (!world.add(p.cell, shapes[p.shape], p.block)) return 1;',
  ]),
})

export const codes: Readonly<Record<string, Code>> = {
  hills: {
    js: js(', circle', '', [
      'const hills = [0, 0, 48, 0, 48, 3, 40, 3, 26, 4, 11, 5, 7, 6, 3, 8, 0, 8]',
      'world.paint({ rings: [hills] }, 1)',
      'world.commit()',
      '',
      'world.carve(circle(16, 5, 1.5))  // somebody digs',
    ]),
    cpp: cpp(['brush', 'world'], 'lgs::World world;', [
      'const std::vector<std::vector<lgs::DoublePoint>> hills = {',
      '    {{0, 0}, {48, 0}, {48, 3}, {40, 3}, {26, 4}, {11, 5}, {7, 6}, {3, 8}, {0, 8}}};',
      'if (!lgs::paint(world, lgs::region(hills), 1, lgs::PaintMode::fill)) return 1;',
      'world.commit();',
      '',
      'const auto hole = lgs::circle(lgs::latticePoint({16.0, 5.0}), 3 * lgs::kUnitsPerCell / 2);',
      'if (!lgs::carve(world, hole)) return 1;  // somebody digs',
    ]),
  },
  cave: map('cave.tmx', 'crate.tx'),
  quarry: map('quarry.ldtk'),
  tiled: map('landscape.tmx', 'landscape.tsx'),
  platforms: {
    js: js('', '{ preserve: (a, b) => a !== b }', [
      'const ground = 1, oneWay = 103  // a platform keeps its edges where it touches a wall',
      'world.paint({ rings: [[0, 0, 32, 0, 32, 1, 0, 1]] }, ground)',
      'world.paint({ rings: [[4, 3, 10, 2.5, 10, 2.75, 4, 3.25]] }, oneWay)',
    ]),
    cpp: cpp(['brush', 'world'], 'lgs::World world([](lgs::Block a, lgs::Block b) { return a != b; });', [
      'const lgs::Block ground = 1, oneWay = 103;  // a platform keeps its edges where it touches a wall',
      'const std::vector<std::vector<lgs::DoublePoint>> floor = {{{0, 0}, {32, 0}, {32, 1}, {0, 1}}};',
      'const std::vector<std::vector<lgs::DoublePoint>> top = {{{4, 3}, {10, 2.5}, {10, 2.75}, {4, 3.25}}};',
      'if (!lgs::paint(world, lgs::region(floor), ground, lgs::PaintMode::fill)) return 1;',
      'if (!lgs::paint(world, lgs::region(top), oneWay, lgs::PaintMode::fill)) return 1;',
    ]),
  },
  materials: {
    js: js(', unitSquare', '', [
      'const square = world.shape(unitSquare)',
      'const ice = 101, conveyor = 104  // numbers of yours: each segment tells its block',
      'world.fill({ i0: 0, j0: 0, i1: 6, j1: 1 }, square, ice)',
      'world.fill({ i0: 7, j0: 0, i1: 13, j1: 1 }, square, conveyor)',
    ]),
    cpp: cpp(['world'], 'lgs::World world;', [
      'const lgs::ShapeId square = *world.shape(lgs::kUnitSquare);',
      'const lgs::Block ice = 101, conveyor = 104;  // numbers of yours: each segment tells its block',
      'if (!world.fill({.min = {0, 0}, .max = {6, 1}}, square, ice)) return 1;',
      'if (!world.fill({.min = {7, 0}, .max = {13, 1}}, square, conveyor)) return 1;',
    ]),
  },
  million: {
    js: js(', circle, unitSquare', '', [
      'world.fill({ i0: 0, j0: 0, i1: 999, j1: 999 }, world.shape(unitSquare), 1)',
      'world.commit()',
      '',
      'world.carve(circle(500, 500, 2))  // costs what it changes',
    ]),
    cpp: cpp(['brush', 'world'], 'lgs::World world;', [
      'const lgs::ShapeId square = *world.shape(lgs::kUnitSquare);',
      'if (!world.fill({.min = {0, 0}, .max = {999, 999}}, square, 1)) return 1;',
      'world.commit();',
      '',
      'const auto hole = lgs::circle(lgs::latticePoint({500.0, 500.0}), 2 * lgs::kUnitsPerCell);',
      'if (!lgs::carve(world, hole)) return 1;  // costs what it changes',
    ]),
  },
}
