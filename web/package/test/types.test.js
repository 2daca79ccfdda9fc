// The types: a file that uses everything compiles, with errors where they belong.
import { execFileSync } from 'node:child_process'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

test('test/types/use.ts compiles', () => {
  const tsc = fileURLToPath(import.meta.resolve('typescript/bin/tsc'))
  try {
    execFileSync(process.execPath, [tsc, '-p', fileURLToPath(new URL('types', import.meta.url))], { encoding: 'utf8' })
  } catch (error) {
    throw new Error(error.stdout)  // tsc says there what is wrong
  }
})
