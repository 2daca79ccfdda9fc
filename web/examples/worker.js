// The world is in a worker. This page keeps a copy of its segments, and draws them.
const scale = 20
const canvas = Object.assign(document.createElement('canvas'), { width: 32 * scale, height: 16 * scale })
document.body.append(canvas)
const context = canvas.getContext('2d')
context.setTransform(scale, 0, 0, -scale, 0, canvas.height) // cells, y up
context.lineWidth = 2 / scale

const segments = new Map() // by id: start x, y, end x, y
const worker = new Worker(new URL('./ground.js', import.meta.url), { type: 'module' })
worker.onmessage = ({ data: { removed, added } }) => {
  for (const id of removed) segments.delete(id)
  added.id.forEach((id, k) => segments.set(id, added.geometry.subarray(8 * k, 8 * k + 4)))
  context.clearRect(0, 0, 32, 16)
  context.beginPath()
  for (const [x0, y0, x1, y1] of segments.values()) {
    context.moveTo(x0, y0)
    context.lineTo(x1, y1)
  }
  context.stroke()
  document.body.dataset.ready = String(segments.size)
}
canvas.addEventListener('pointerdown', ({ offsetX, offsetY }) =>
  worker.postMessage({ x: offsetX / scale, y: (canvas.height - offsetY) / scale, radius: 1.5 }))
