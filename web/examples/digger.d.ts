import type { Fill, GroundPicture } from 'localgridseg/draw'
import type { CellRect, World } from 'localgridseg/islands'
import type { Ground } from 'localgridseg/planck'

/** Of each block: yours to change. */
export const colours: Record<number, Fill>
export function digger(canvas: HTMLCanvasElement, size?: number): Promise<{ ground: Ground; picture: GroundPicture }>
/** What a chunk is made of. */
export function land(world: World, chunk: Pick<CellRect, 'i0' | 'j0'>): void
/** A boulder: x, y of each corner, about its middle. */
export const stone: readonly number[]
