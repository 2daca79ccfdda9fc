import type { Fill, GroundPicture } from 'localgridseg/draw'
import type { Ground } from 'localgridseg/planck'

/** Of each block: yours to change. */
export const colours: Record<number, Fill>
export function digger(canvas: HTMLCanvasElement, size?: number): Promise<{ ground: Ground; picture: GroundPicture }>
