// The tools by name. Moving the view is no tool of the ground: the pointer does that itself (pointer.ts).
import { settings } from '../settings.js'
import { Brush } from './brush.js'
import { DropTool } from './drop.js'
import { PolygonTool } from './polygon.js'
import { TileTool } from './tile.js'
import type { Tool } from './tool.js'

export const polygonTool = new PolygonTool()

const tools: Readonly<Record<string, Tool>> = {
  dig: new Brush(true),
  paint: new Brush(false),
  tile: new TileTool(),
  polygon: polygonTool,
  marble: new DropTool('marble'),
  box: new DropTool('box'),
  car: new DropTool('car'),
}

/** The tool in hand; null if it is the one that moves the view. */
export function currentTool(): Tool | null {
  return tools[settings.tool] ?? null
}
