// Makes the moving picture of the README from a real race: node test/race-picture.js FILE.svg
// It moves by CSS, so that a reader who wants no motion sees how it ended; and it has a dark side.
import { writeFile } from 'node:fs/promises'
import { openBrowser } from './browser.js'

const [width, height] = [880, 420]
const unit = 23 // pixels a cell
const left = 14
const rest = 2.4 // seconds after the end, before it begins again
const lens = { x: 760, y: 190, radius: 96, cells: 2.4, slower: 14 }
const colours = ['#0072b2', '#e69f00']
const round = (x) => Math.round(x * 100) / 100

const browser = await openBrowser()
let lanes
try {
  await browser.onPage(async (page) => {
    await page.locator('#race').click()
    lanes = await page.evaluate(() => {
      window.sandbox.race.step(400, 0)
      return window.sandbox.race.race.lanes.map(({ moments, kicks, time, replay, kickInReplay }) => ({
        moments: moments.filter(({ x }) => x < 24.8),
        kicks: kicks.map(({ at }) => at),
        time,
        replay,
        kickInReplay,
      }))
    })
  })
} finally {
  await browser.close()
}

const total = lanes[1].time + rest
const styles = []
const parts = []
const text = (x, y, content, kind = '', size = 15) =>
  parts.push(`<text x="${x}" y="${y}" class="${kind}" font-size="${size}">${content}</text>`)

/** Keyframes of a value over the whole loop. The last one stays: it is what one sees without motion. */
function animate(name, frames, seconds = total) {
  const lines = frames.map(([at, value]) => `${round((100 * at) / seconds)}%{${value}}`)
  styles.push(`@keyframes ${name}{${lines.join('')}}.${name}{${frames.at(-1)[1]};animation:${name} ${round(seconds)}s linear infinite}`)
}

lanes.forEach(({ moments, kicks, time }, k) => {
  const floor = 92 + 118 * k
  const place = ({ x, y }) => [round(left + x * unit), round(floor - (y - 1) * unit)]
  text(left, floor - 66, k === 0 ? 'With ghost vertices' : 'Without', 'strong', 17)
  for (let i = 0; i < 26; ++i) parts.push(`<rect class="ground" x="${left + i * unit + 0.5}" y="${floor}" width="${unit - 1}" height="16"/>`)
  parts.push(`<path class="flag" d="M${left + 24 * unit} ${floor}v-34"/>`)
  kicks.filter(([x]) => x < 24.8).forEach(([x, y], n) => {
    const at = moments.findIndex((moment) => moment.x >= x) / 60
    animate(`k${k}${n}`, [[0, 'opacity:0'], [at, 'opacity:0'], [at + 0.01, 'opacity:1'], [total, 'opacity:1']])
    parts.push(`<circle class="kick k${k}${n}" cx="${round(left + x * unit)}" cy="${round(floor - (y - 1) * unit)}" r="4"/>`)
  })
  const steps = moments.filter((_, n) => n % 3 === 0 || n === moments.length - 1)
  const frames = steps.map((moment) => [moments.indexOf(moment) / 60, `transform:translate(${place(moment).join('px,')}px)`])
  animate(`w${k}`, [...frames, [total, frames.at(-1)[1]]])
  parts.push(`<g class="w${k}"><circle r="${round(0.35 * unit)}" fill="${colours[k]}"/></g>`)
  animate(`t${k}`, [[0, 'opacity:0'], [time, 'opacity:0'], [time + 0.01, 'opacity:1'], [total, 'opacity:1']])
  parts.push(`<text class="strong t${k}" x="${left + 24 * unit}" y="${floor - 62}" font-size="24" text-anchor="end">${time.toFixed(2)} s</text>`)
})

// Speed over distance, below the tracks. A curtain goes away with the slower wheel.
const [top, bottom] = [262, 392]
const speed = ({ x, vx }) => `${round(left + x * unit)} ${round(bottom - ((bottom - top) * (vx - 4.6)) / 2.9)}`
for (const v of [5, 6, 7]) {
  const y = round(bottom - ((bottom - top) * (v - 4.6)) / 2.9)
  parts.push(`<path class="grid" d="M${left} ${y}H${left + 24.8 * unit}"/>`)
  parts.push(`<text class="soft" x="${left + 24.8 * unit}" y="${y + 14}" font-size="12" text-anchor="end">${v === 7 ? '7 cells a second' : v}</text>`)
}
lanes.forEach(({ moments }, k) => {
  parts.push(`<path class="speed s${k}" pathLength="1" stroke="${colours[k]}" d="M${moments.map(speed).join('L')}"/>`)
  const frames = moments.filter((_, n) => n % 6 === 0).map((moment) => [moments.indexOf(moment) / 60, `stroke-dashoffset:${round(1 - moments.indexOf(moment) / moments.length)}`])
  animate(`s${k}`, [...frames, [moments.length / 60, 'stroke-dashoffset:0'], [total, 'stroke-dashoffset:0']])
})

// The lens: the first kick, slowly.
const { replay, kickInReplay } = lanes[1]
const focus = replay[kickInReplay]
const zoom = (2 * lens.radius) / lens.cells
const inLens = ({ x, y }) => [round(lens.x + (x - focus.x) * zoom), round(lens.y - (y - focus.y) * zoom)]
const span = (replay.length * lens.slower) / 60
parts.push(`<clipPath id="glass"><circle cx="${lens.x}" cy="${lens.y}" r="${lens.radius}"/></clipPath><g clip-path="url(#glass)">`)
for (let i = Math.floor(focus.x) - 2; i < focus.x + 2; ++i) {
  const [x, y] = inLens({ x: i, y: 1 })
  parts.push(`<rect class="ground" x="${x + 1}" y="${y}" width="${round(zoom - 2)}" height="200"/>`)
}
const seam = Math.round(focus.x)
parts.push(`<path class="push" d="M${inLens({ x: seam, y: 1 })}H${inLens({ x: seam + 1, y: 1 })[0]}"/>`)
animate('lens', replay.map((moment, k) => [(k * lens.slower) / 60, `transform:translate(${inLens(moment).join('px,')}px)`]).concat([[span, `transform:translate(${inLens(focus).join('px,')}px)`]]), span)
parts.push(`<g class="lens"><circle r="${round(0.35 * zoom)}" fill="${colours[1]}"/></g>`)
const before = replay[kickInReplay - 1]
const [dx, dy] = [focus.vx - before.vx, focus.vy - before.vy]
const push = 62 / Math.hypot(dx, dy)
const at = (kickInReplay * lens.slower) / 60
animate('push', [[0, 'opacity:0'], [at, 'opacity:0'], [at + 0.01, 'opacity:1'], [span, 'opacity:1']], span)
parts.push(`<path class="push" marker-end="url(#tip)" d="M${lens.x} ${lens.y}l${round(dx * push)} ${round(-dy * push)}"/></g>`)
parts.push(`<circle class="frame" cx="${lens.x}" cy="${lens.y}" r="${lens.radius}"/>`)
parts.push(`<text class="soft" x="${lens.x}" y="${lens.y - lens.radius - 10}" font-size="13" text-anchor="middle">the first kick, ${lens.slower} times slower</text>`)
parts.push(`<text class="soft" x="${lens.x}" y="${lens.y + lens.radius + 48}" font-size="13" text-anchor="middle">no friction, Moon gravity</text>`)
parts.push(`<text class="strong" x="${lens.x}" y="${lens.y + lens.radius + 26}" font-size="13" text-anchor="middle">it hits the end of the next edge</text>`)

const colour = ([paper, ink, soft, ground, grid]) =>
  `.paper{fill:${paper}}text{fill:${ink}}.soft{fill:${soft}}.ground{fill:${ground}}.grid{stroke:${grid}}.flag,.frame{stroke:${ink}}`
// No custom properties: not every program that draws SVG knows them.
const style = `svg{font-family:system-ui,-apple-system,'Segoe UI',Roboto,'Noto Sans',sans-serif}
${colour(['#fffdf9', '#2a2338', '#685e74', '#d5b48c', '#ece4d8'])}
@media(prefers-color-scheme:dark){${colour(['#1b1733', '#efeaf6', '#afa5c2', '#6b5149', '#2e2849'])}}
.strong{font-weight:650}.flag{stroke-width:4;stroke-dasharray:4 4}.kick{fill:#d55e00}.speed{fill:none;stroke-width:3;stroke-linejoin:round;stroke-dasharray:1 1}.frame{fill:none;stroke-width:3}.push{stroke:#d55e00;stroke-width:4}
${styles.join('\n')}
@media(prefers-reduced-motion:reduce){*{animation:none!important}}`
const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" role="img" aria-label="Two wheels race over a floor of tiles. With ghost vertices ${lanes[0].time.toFixed(2)} s, without ${lanes[1].time.toFixed(2)} s.">
<style>${style}</style>
<marker id="tip" viewBox="0 0 8 8" refX="5" refY="4" markerWidth="4" markerHeight="4" orient="auto"><path d="M0 0l8 4l-8 4z" fill="#d55e00"/></marker>
<rect class="paper" width="${width}" height="${height}" rx="12"/>
${parts.join('\n')}
</svg>
`
await writeFile(process.argv[2], svg)
console.log(`${process.argv[2]}: ${svg.length} bytes`)
