// Serves the built page on localhost: node serve.js [PORT]
import { readFile } from 'node:fs/promises'
import { createServer } from 'node:http'
import { extname } from 'node:path'

const types = { '.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript', '.wasm': 'application/wasm' }
const root = new URL('dist/', import.meta.url)

/** Listens on a port of localhost; 0 takes any that is free. The page is in the folder. */
export async function serve(port, folder = '/') {
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, 'http://localhost').pathname
    try {
      if (!path.startsWith(folder)) throw new Error('outside')
      const file = new URL(path.slice(folder.length) || 'index.html', root)
      if (!file.pathname.startsWith(root.pathname)) throw new Error('outside')
      const body = await readFile(file)
      response.writeHead(200, { 'content-type': types[extname(file.pathname)] ?? 'application/octet-stream' }).end(body)
    } catch {
      response.writeHead(404).end('not found')
    }
  })
  await new Promise((resolve) => server.listen(port, 'localhost', resolve))
  return server
}

if (import.meta.url === `file://${process.argv[1]}`) {
  const server = await serve(Number(process.argv[2] ?? 8080))
  console.log(`open http://localhost:${server.address().port}`)
}
