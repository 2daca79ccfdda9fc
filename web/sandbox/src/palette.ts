// The controls of the tools: brush size, materials, shapes.
import { kinds } from './blocks.js'
import { element, onClick, radios } from './dom.js'
import { settings, type ToolName } from './settings.js'
import { theme } from './theme.js'
import { tiles, turned } from './tiles.js'

export function setUpPalette(onTool: () => void): void {
  for (const radio of radios('tool')) {
    radio.addEventListener('change', () => {
      settings.tool = radio.value as ToolName
      showGroups()
      onTool()
    })
  }
  const size = element<HTMLInputElement>('size')
  size.addEventListener('input', () => {
    settings.radius = Number(size.value)
    element('size-value').textContent = size.value
  })
  kinds.forEach((kind, k) => addKind(kind.block, kind.name, `${kind.hint} (${k + 1})`))
  tiles.forEach((tile, k) => addTile(k, tile.name))
  addTile(-1, 'Eraser: empties the cell')
  onClick('turn', turn)
  showGroups()
}

export function turn(): void {
  settings.quarters = (settings.quarters + 1) % 4
  drawTiles()
}

export function resize(by: number): void {
  const size = element<HTMLInputElement>('size')
  size.valueAsNumber += by
  size.dispatchEvent(new Event('input'))
}

/** After the theme has changed. */
export function recolour(): void {
  for (const chip of document.querySelectorAll<HTMLElement>('.chip')) {
    chip.style.background = theme().special[Number(chip.dataset.block)] ?? theme().ground
  }
}

// Only what the tool uses is shown.
function showGroups(): void {
  const { tool } = settings
  element('size-group').hidden = tool !== 'dig' && tool !== 'paint'
  element('kinds').hidden = tool !== 'paint' && tool !== 'tile' && tool !== 'polygon'
  element('tiles').hidden = tool !== 'tile'
  element('drive').hidden = tool !== 'car'
}

function addKind(block: number, name: string, hint: string): void {
  const label = document.createElement('label')
  label.title = hint
  const checked = block === settings.block ? 'checked' : ''
  label.innerHTML = `<input type="radio" name="block" value="${block}" ${checked}>
    <i class="chip" data-block="${block}"></i><span>${name}</span>`
  label.querySelector('input')!.addEventListener('change', () => {
    settings.block = block
  })
  element('kinds').append(label)
  recolour()
}

function addTile(index: number, name: string): void {
  const label = document.createElement('label')
  label.title = name
  const checked = index === settings.tile ? 'checked' : ''
  label.innerHTML = `<input type="radio" name="tile" value="${index}" aria-label="${name}" ${checked}>
    <svg viewBox="-1 -1 18 18"><path data-tile="${index}"/></svg>`
  label.querySelector('input')!.addEventListener('change', () => {
    settings.tile = index
  })
  element('tiles').insertBefore(label, element('turn'))
  drawTiles()
}

function drawTiles(): void {
  for (const path of document.querySelectorAll<SVGPathElement>('path[data-tile]')) {
    const index = Number(path.dataset.tile)
    const corners = index < 0 ? [] : turned(tiles[index].vertices, settings.quarters)
    const outline = corners.map(([x, y]) => `${16 * x} ${16 * (1 - y)}`).join('L')
    path.setAttribute('d', index < 0 ? 'M2 4 4 2 8 6 12 2 14 4 10 8 14 12 12 14 8 10 4 14 2 12 6 8z' : `M${outline}z`)
  }
}
