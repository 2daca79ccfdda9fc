// The keyboard. Every control has its key; while the focus is in a control that uses a key, the control has it.
import { kinds } from './blocks.js'
import { choose, element } from './dom.js'
import { resize, turn } from './palette.js'

export interface KeyActions {
  /** -1, 0 or 1. */
  drive(direction: number): void
  moveCursor(dx: number, dy: number): void
  /** By a tenth of the view. */
  moveView(dx: number, dy: number): void
  useTool(): void
  cancel(): void
  zoom(factor: number): void
}

const tools: Readonly<Record<string, string>> = {
  d: 'dig',
  p: 'paint',
  t: 'tile',
  g: 'polygon',
  m: 'marble',
  b: 'box',
  c: 'car',
  v: 'hand',
}
const buttons: Readonly<Record<string, string>> = {
  ' ': 'play',
  '.': 'step',
  f: 'zoom-fit',
  '0': 'restart',
  '?': 'help',
  o: 'overlay',
  s: 'slow',
}
const arrows: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

export function listenToKeys(actions: KeyActions): void {
  const driving = new Set<string>()
  addEventListener('keydown', (event) => {
    if (document.querySelector('dialog[open]') !== null || belongsToControl(event)) return
    if (!onKey(event, actions, driving)) return
    event.preventDefault()
  })
  addEventListener('keyup', (event) => {
    if (driving.delete(event.key)) actions.drive(directionOf(driving))
  })
  addEventListener('blur', () => {
    if (driving.size === 0) return
    driving.clear()
    actions.drive(0)
  })
}

function onKey(event: KeyboardEvent, actions: KeyActions, driving: Set<string>): boolean {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key
  const arrow = arrows[key]
  if (event.ctrlKey || event.metaKey) {
    if (arrow !== undefined) actions.moveView(...arrow)
    else if (key === 'z') element(event.shiftKey ? 'redo' : 'undo').click()
    else if (key === 'y') element('redo').click()
    return arrow !== undefined || key === 'z' || key === 'y'
  }
  if (arrow !== undefined && event.shiftKey) actions.moveCursor(...arrow)
  else if (arrow !== undefined) {
    driving.add(key)
    actions.drive(directionOf(driving))
  } else if (key === 'Enter') actions.useTool()
  else if (key === 'Escape') actions.cancel()
  else if (key === '+' || key === '=') actions.zoom(1.25)
  else if (key === '-') actions.zoom(0.8)
  else if (key === '[') resize(-0.2)
  else if (key === ']') resize(0.2)
  else if (key === 'r') turn()
  else if (key === 'z') element(event.shiftKey ? 'redo' : 'undo').click()
  else if (tools[key] !== undefined) choose('tool', tools[key])
  else if (/^[1-5]$/.test(key)) choose('block', String(kinds[Number(key) - 1].block))
  else if (buttons[key] !== undefined) element(buttons[key]).click()
  else return false
  return true
}

function directionOf(driving: ReadonlySet<string>): number {
  return Number(driving.has('ArrowRight')) - Number(driving.has('ArrowLeft'))
}

// A focused control keeps the keys that it uses itself.
function belongsToControl(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement
  if (target instanceof HTMLInputElement && target.type !== 'file')
    return event.key.startsWith('Arrow') || event.key === ' ' || event.key === 'Enter'
  return target instanceof HTMLButtonElement && (event.key === ' ' || event.key === 'Enter')
}
