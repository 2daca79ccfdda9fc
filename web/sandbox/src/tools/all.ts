// The tools by name.
import { settings, type ToolName } from '../settings.js'
import { Brush } from './brush.js'
import { DropTool } from './drop.js'
import { Hand } from './hand.js'
import { PolygonTool } from './polygon.js'
import { TileTool } from './tile.js'
import type { Tool } from './tool.js'

export const polygonTool = new PolygonTool()

const tools: Readonly<Record<ToolName, Tool>> = {
  hand: new Hand(),
  dig: new Brush(true),
  paint: new Brush(false),
  tile: new TileTool(),
  polygon: polygonTool,
  marble: new DropTool('marble'),
  box: new DropTool('box'),
  car: new DropTool('car'),
}

export function currentTool(): Tool {
  return tools[settings.tool]
}
