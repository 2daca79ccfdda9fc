import type { Ground } from 'localgridseg/planck'

export function digger(canvas: HTMLCanvasElement, size?: number): Promise<Ground>
