// The kinds of ground. Their numbers are the blocks of the trace. Those of special ground are such as maps seldom have.
import type { Block } from 'localgridseg'

export interface Kind {
  readonly block: Block
  readonly name: string
  readonly hint: string
  readonly friction: number
}

export const GROUND = 1
export const ICE = 101
export const STICKY = 102
export const ONE_WAY = 103
export const CONVEYOR = 104

export const kinds: readonly Kind[] = [
  { block: GROUND, name: 'Ground', hint: 'Ordinary ground', friction: 0.6 },
  { block: ICE, name: 'Ice', hint: 'No friction', friction: 0 },
  { block: STICKY, name: 'Sticky', hint: 'High friction', friction: 1.5 },
  { block: ONE_WAY, name: 'One-way', hint: 'Solid from above, open from below', friction: 0.6 },
  { block: CONVEYOR, name: 'Conveyor', hint: 'Carries bodies to the right', friction: 1 },
]

/** Blocks of imported maps are ordinary ground. */
export function kindOf(block: Block): Kind {
  return kinds.find((kind) => kind.block === block) ?? kinds[0]
}

export type Pairs = readonly (readonly [Block, Block])[]

/** The preserve relation: a wall beside a one-way platform keeps its edge. */
export const keptPairs: Pairs = [GROUND, ICE, STICKY, CONVEYOR].map((block) => [block, ONE_WAY])
