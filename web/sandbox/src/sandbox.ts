// All tools: puts the parts together, and the controls to them.
import { Camera } from './camera.js'
import { Game } from './game.js'
import { listenToKeys } from './keys.js'
import { Loop } from './loop.js'
import { measure, type Place, prepare } from './measure.js'
import { recolour, setUpPalette } from './palette.js'
import { neckOf, rocks } from './scenes/landscape.js'
import { onThemeChange } from './theme.js'
import { polygonTool } from './tools/all.js'
import { Ui } from './ui.js'
import { Viewer } from './viewer.js'

export interface Sandbox {
  pause(): void
  goOn(): void
  /** For tests and for the curious: steps without a clock, and what is going on. */
  readonly handles: object
}

/** Opens what the address holds, or what was here last time. If there is none, it shows where to dig until somebody does something. */
export async function openSandbox(): Promise<Sandbox> {
  const game = new Game()
  const camera = new Camera()
  const viewer = new Viewer(game, camera)
  const loop = new Loop(() => game.step(), () => viewer.draw())
  const ui = new Ui(game, viewer, loop)

  setUpPalette(() => polygonTool.cancel())
  onThemeChange(() => {
    recolour()
    viewer.layer.reset()
  })
  listenToKeys({
    drive: (direction) => game.drive(direction),
    moveView: (dx, dy) => viewer.moveView(dx, dy),
    moveCursor: (dx, dy) => viewer.moveCursor(dx, dy),
    useTool: () => viewer.useTool(),
    cancel: () => polygonTool.cancel(),
    zoom: (factor) => viewer.zoom(factor),
  })
  viewer.showHome()
  if (!(await ui.openAddress())) {
    viewer.invitation = neckOf(rocks[1])
    for (const event of ['pointerdown', 'keydown', 'wheel', 'hashchange']) addEventListener(event, () => (viewer.invitation = null), { once: true, capture: true })
  }
  loop.start()
  return {
    pause: () => (loop.running = false),
    goOn: () => (loop.running = true),
    handles: {
      game,
      viewer,
      step(count = 1): void {
        viewer.invitation = null
        loop.playing = false
        for (let k = 0; k < count; ++k) game.step()
      },
      prepare: () => prepare(game, viewer),
      measure(place: Place, frames: number) {
        return measure(game, viewer, loop, place, frames)
      },
      kicks: () => game.sides.map((side) => side.kicks.count),
      toPage: (x: number, y: number) => viewer.toPage(x, y),
    },
  }
}
