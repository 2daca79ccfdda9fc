// The importer of maps, as far as the page needs it. It is no part of every build.
declare module 'localgridseg/import' {
  import type { World } from 'localgridseg'
  export function importMap(files: readonly File[], options: object): Promise<World>
}
