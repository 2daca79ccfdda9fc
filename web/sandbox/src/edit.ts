// An edit of the ground, as data: so that redo can make it again.
import type { Block, CellRect, Region, World } from 'localgridseg'
import type { Corner } from './tiles.js'

export type Edit =
  | { readonly kind: 'paint'; readonly region: Region; readonly block: Block }
  | { readonly kind: 'carve'; readonly region: Region }
  | {
      readonly kind: 'tile'
      readonly i: number
      readonly j: number
      readonly vertices: readonly Corner[]
      readonly block: Block
    }
  | { readonly kind: 'clear'; readonly i: number; readonly j: number }

export function apply(world: World, edit: Edit): void {
  switch (edit.kind) {
    case 'paint':
      world.paint(edit.region, edit.block, 'replace')
      break
    case 'carve':
      world.carve(edit.region)
      break
    case 'tile':
      world.clear(edit.i, edit.j)
      world.addPolygon(edit.i, edit.j, edit.vertices, edit.block)
      break
    case 'clear':
      world.clear(edit.i, edit.j)
      break
  }
}

/** The cells that an edit may change. */
export function cellsOf(edit: Edit): CellRect {
  if (edit.kind === 'tile' || edit.kind === 'clear') return { i0: edit.i, j0: edit.j, i1: edit.i, j1: edit.j }
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity]
  for (const ring of edit.region.rings) {
    for (const [x, y] of corners(ring)) {
      x0 = Math.min(x0, x)
      x1 = Math.max(x1, x)
      y0 = Math.min(y0, y)
      y1 = Math.max(y1, y)
    }
  }
  return { i0: Math.floor(x0), j0: Math.floor(y0), i1: Math.floor(x1), j1: Math.floor(y1) }
}

export function union(a: CellRect | null, b: CellRect): CellRect {
  if (a === null) return b
  return {
    i0: Math.min(a.i0, b.i0),
    j0: Math.min(a.j0, b.j0),
    i1: Math.max(a.i1, b.i1),
    j1: Math.max(a.j1, b.j1),
  }
}

function* corners(ring: Region['rings'][number]): Iterable<Corner> {
  for (let k = 0; k < ring.length; ++k) {
    const entry = ring[k]
    if (typeof entry === 'number') yield [entry, ring[++k] as number]
    else yield [entry[0], entry[1]]
  }
}
