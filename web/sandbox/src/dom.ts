// Finds elements of the page. A missing one is a mistake of the program.
export function element<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id)
  if (found === null) throw new Error(`the page has no element #${id}`)
  return found as T
}

export function onClick(id: string, action: () => void): void {
  element(id).addEventListener('click', action)
}

/** The radio buttons of a name. */
export function radios(name: string): HTMLInputElement[] {
  return [...document.querySelectorAll<HTMLInputElement>(`input[name="${name}"]`)]
}

export function choose(name: string, value: string): void {
  const radio = radios(name).find((each) => each.value === value)
  if (radio === undefined || radio.checked) return
  radio.checked = true
  radio.dispatchEvent(new Event('change', { bubbles: true }))
}
