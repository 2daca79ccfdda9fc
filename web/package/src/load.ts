// The code of WebAssembly: from a module, from bytes, or from a URL.
import { options as known } from './check.js'
import { LgsError } from './error.js'
import type { InitOptions } from './types.js'

/** Reads a file. In Node alone: fetch() takes no files there. */
type ReadFile = (file: URL) => Promise<BufferSource>

/** What to do when a server has something else in the place of the code. */
const remedy = "Has a bundler moved the module away from its .wasm? In Vite's configuration: optimizeDeps: { exclude: " +
  "['localgridseg'] }. Elsewhere: give init({ url }) the place of a copy of that file, or import 'localgridseg/inline', " +
  "which has it within"

/** Null if it is no code. Browsers keep code that they compiled from a stream, which must have the right type for that. */
async function compiled(response: Response): Promise<WebAssembly.Module | null> {
  if (!response.ok) return null
  if (/^application\/wasm\b/.test(response.headers.get('content-type') ?? '')) return WebAssembly.compileStreaming(response)
  const bytes = await response.arrayBuffer()
  return new DataView(bytes).byteLength >= 4 && new DataView(bytes).getUint32(0) === 0x0061736d ? WebAssembly.compile(bytes) : null
}

/** Vite's development server moves modules into another folder; the package itself is where it was. */
function unmoved(url: string): string | null {
  const parts = /^(.*?)(\/node_modules)?\/\.vite\/deps[^/]*\/([^/?]+)/.exec(url)
  return parts && `${parts[1]}/node_modules/localgridseg/dist/${parts[3]}`
}

export async function compile(options: InitOptions, beside: () => URL, readFile?: ReadFile): Promise<WebAssembly.Module> {
  const { url, bytes, module } = known('options', ['url', 'bytes', 'module'], options)
  if (module) return module
  if (bytes) return WebAssembly.compile(bytes)
  const from = String(url === undefined ? unmoved(beside().href) ?? beside() : url)
  if (readFile && from.startsWith('file:')) return WebAssembly.compile(await readFile(new URL(from)))
  const response = await fetch(from), found = await compiled(response)
  if (found) return found
  const what = response.ok ? 'it is no code of WebAssembly' : `${response.status} ${response.statusText}`
  throw new LgsError('not-ready', `${response.url || from}: ${what}. ${remedy}`)
}
