// What is compared. A subject has edits(count), which makes that many edits and reads what changed, or build(), which
// makes a world from nothing and reads its outline. Both are for one kind of world.
import { spawn } from 'node:child_process'
import { createInterface } from 'node:readline'
import RAPIER from '@dimforge/rapier2d-compat'
import Clipper from 'clipper2-wasm/dist/es/clipper2z.js'
import { createWorld, init } from 'localgridseg'
import polygonClipping from 'polygon-clipping'
import { Package, cells, timed } from './package-subject.mjs'
import { Edits, holes, randomNumbers, shapesOf, shapesOfCells, side } from './scenario.mjs'

/** The program of native.cpp, which goes on running: so its code and memory are as warm as those here. */
export class Native {
  #process
  #answers
  constructor(program) {
    this.#process = spawn(program, { stdio: ['pipe', 'pipe', 'inherit'] })
    this.#answers = createInterface({ input: this.#process.stdout })[Symbol.asyncIterator]()
  }
  async ask(line) {
    this.#process.stdin.write(line + '\n')
    const { value, done } = await this.#answers.next()
    if (done) throw new Error('the native engine has ended')
    return value.split(' ').map(Number)
  }
  end() { this.#process.stdin.end() }
}

/** Squares alone, and no outline is handed out. In one collider, or in four that tell each other of their borders. */
class Rapier {
  #world = new RAPIER.World({ x: 0, y: 0 })
  #half
  #colliders
  #edits = new Edits(randomNumbers())
  constructor(parts) {
    this.#half = side / parts
    this.#make()
  }
  #make() {
    const half = this.#half
    const places = cells.slice(0, half * half).flatMap((_, k) => [k % half, Math.floor(k / half)])
    const parts = (side / half) ** 2
    this.#colliders = Array.from({ length: parts }, (_, part) => {
      const [x, y] = [part % 2, part >> 1].map((n) => n * half)
      return this.#world.createCollider(RAPIER.ColliderDesc.voxels(Int32Array.from(places), { x: 1, y: 1 }).setTranslation(x, y))
    })
    this.#colliders.forEach((a, k) => this.#colliders.forEach((b, n) => {
      if (k < n) a.combineVoxelStates(b, ...this.#shift(k, n))
    }))
  }
  #shift(from, to) { return [(to % 2) - (from % 2), (to >> 1) - (from >> 1)].map((n) => n * this.#half) }
  build() {
    for (const collider of this.#colliders) this.#world.removeCollider(collider, false)
    return timed(() => this.#make())
  }

  #set(cell, isFilled) {
    const [i, j] = cells[cell], half = this.#half
    const part = (i >= half ? 1 : 0) + (j >= half ? 2 : 0)
    const [x, y] = [i % half, j % half]
    const collider = this.#colliders[part]
    collider.setVoxel(x, y, isFilled)
    for (let other = 0; other < this.#colliders.length; ++other)
      if (other !== part) collider.propagateVoxelChange(this.#colliders[other], x, y, ...this.#shift(part, other))
  }
  digHoles() { for (let k = 0; k < holes; ++k) this.#set(this.#edits.dig(), false) }
  edits(count) {
    return timed(() => {
      for (let k = 0; k < count; k += 2) {
        this.#set(this.#edits.refill(), true)
        this.#set(this.#edits.dig(), false)
      }
    }) / count
  }
}

/** All polygons of the world, as rings. For these libraries an edit costs the union of all. */
function rings(kind) {
  const shapes = shapesOfCells(kind, randomNumbers())
  return cells.map(([i, j], cell) => shapesOf[kind][shapes[cell]].map(([x, y]) => [i + x, j + y]))
}

function clipper2(clipper, kind) {
  const paths = new clipper.Paths64()
  for (const ring of rings(kind)) paths.push_back(clipper.MakePath64(BigInt64Array.from(ring.flat(), BigInt)))
  return {
    build: () => timed(() => {
      const outline = clipper.UnionSelf64(paths, clipper.FillRule.NonZero)
      for (let k = 0; k < outline.size(); ++k) outline.get(k).view()
      outline.delete()
    }),
  }
}

function clipping(kind) {
  const polygons = rings(kind).map((ring) => [ring])
  return { build: () => timed(() => polygonClipping.union(...polygons)) }
}

export async function makeSubjects(kind) {
  await Promise.all([init(), RAPIER.init()])
  const clipper = await Clipper()
  return {
    'localgridseg': new Package(createWorld, kind),
    ...(kind === 'full' && { 'Rapier, one collider': new Rapier(1), 'Rapier, four colliders': new Rapier(2) }),
    'clipper2-wasm, all anew': clipper2(clipper, kind),
    'polygon-clipping, all anew': clipping(kind),
  }
}
