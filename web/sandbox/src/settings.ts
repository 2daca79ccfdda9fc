// What the controls say that tools use.
import { GROUND } from './blocks.js'

export type ToolName = 'hand' | 'dig' | 'paint' | 'tile' | 'polygon' | 'marble' | 'box' | 'car'

export interface Settings {
  tool: ToolName
  /** Of the brush, in cells. */
  radius: number
  block: number
  /** Index into the palette; -1 takes a tile away. */
  tile: number
  /** Quarter turns of the tile. */
  quarters: number
}

export const settings: Settings = { tool: 'dig', radius: 0.8, block: GROUND, tile: 0, quarters: 0 }
