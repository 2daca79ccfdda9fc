// The page: puts the parts together, and the controls to them.
import { init } from 'localgridseg/islands'
import { Camera } from './camera.js'
import { Digger } from './digger.js'
import { Game } from './game.js'
import { listenToKeys } from './keys.js'
import { Loop } from './loop.js'
import { measure, type Place, prepare } from './measure.js'
import { recolour, setUpPalette } from './palette.js'
import { RaceStage } from './race/stage.js'
import { onThemeChange } from './theme.js'
import { polygonTool } from './tools/all.js'
import { Ui } from './ui.js'
import { Viewer } from './viewer.js'
import { Welcome } from './welcome.js'

await init()
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
const isNew = !(await ui.openAddress())
// Who knows the page, or was sent to something on it, has all tools at once.
const digger = new Digger(), isFirst = isNew && location.hash === '' && !Welcome.wasSeen()
let welcome: Welcome | null = null
loop.start()
if (isFirst) {
  loop.running = false
  await digger.open(() => {
    loop.running = true
    viewer.showHome()
    ui.isShowing = true
    welcome = new Welcome(game, viewer, () => (ui.isShowing = false))
  })
}
const race = new RaceStage(() => (loop.running = false), () => (loop.running = true))
document.body.dataset.ready = 'true'

// For tests and for the curious: steps without a clock, and what is going on.
Object.assign(window, {
  sandbox: {
    game,
    step(count = 1): void {
      welcome?.end()
      loop.playing = false
      for (let k = 0; k < count; ++k) game.step()
    },
    race,
    digger,
    prepare: () => prepare(game, viewer),
    measure(place: Place, frames: number) {
      return measure(game, viewer, loop, place, frames)
    },
    kicks: () => game.sides.map((side) => side.kicks.count),
    toPage: (x: number, y: number) => viewer.toPage(x, y),
  },
})
