// What the browser keeps of a visit: the digger, and the ground of all tools. It may keep nothing, and say so by throwing.
const digger = 'localgridseg-digger-1'
const ground = 'localgridseg-sandbox'
const most = 1_000_000 // characters

function held(name: string): string | null {
  try {
    return localStorage.getItem(name)
  } catch {
    return null
  }
}

function hold(name: string, text: string | null): void {
  try {
    if (text === null) localStorage.removeItem(name)
    else localStorage.setItem(name, text)
  } catch {
    // then it is not there the next time
  }
}

export const keptGround = () => held(ground)
export const forgetGround = () => hold(ground, null)
export const keepGround = (text: string) => hold(ground, text.length < most ? text : null)
export const keptDigger = () => held(digger)
export const keepDigger = (text: string) => hold(digger, text.length < most ? text : null)
