// Which part of the world a canvas shows. All panes share one camera.
const readable = 12 // pixels per cell
const comfortable = 16

export class Camera {
  /** The cell coordinates of the middle of the pane. */
  x = 0
  y = 0
  /** CSS pixels per cell. */
  scale = 24

  /** Shows a rectangle of cells as large as it fits. Where that is too small to see, as on a phone, it fits in height. */
  fit([x0, y0, x1, y1]: readonly [number, number, number, number], width: number, height: number, middle?: number): void {
    const whole = Math.min(width / (x1 - x0), height / (y1 - y0))
    this.scale = whole >= readable ? whole : Math.max(whole, Math.min(comfortable, height / (y1 - y0)))
    this.x = this.scale === whole ? (x0 + x1) / 2 : (middle ?? x0 + width / this.scale / 2)
    this.y = (y0 + y1) / 2
  }

  zoom(factor: number, cellX: number, cellY: number): void {
    const scale = Math.min(200, Math.max(2, this.scale * factor))
    const change = this.scale / scale
    this.x = cellX + (this.x - cellX) * change
    this.y = cellY + (this.y - cellY) * change
    this.scale = scale
  }

  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale
    this.y += dy / this.scale
  }

  toCell(px: number, py: number, width: number, height: number): [number, number] {
    return [this.x + (px - width / 2) / this.scale, this.y - (py - height / 2) / this.scale]
  }

  toPixel(x: number, y: number, width: number, height: number): [number, number] {
    return [width / 2 + (x - this.x) * this.scale, height / 2 - (y - this.y) * this.scale]
  }
}
