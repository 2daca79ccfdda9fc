// What console.log() of Node shows: names, and what getters say, which are no properties of their own.
export const inspect = Symbol.for('nodejs.util.inspect.custom')

/** An object that is shown with this name and these parts. */
export function shown(name: string, parts: object): unknown {
  const types = { [name]: class {} }  // a class has the name of its key
  return Object.assign(new types[name]!(), parts)
}
