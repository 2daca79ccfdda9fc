/** lgs-islands.wasm in base64. The build puts it here. */
export declare const wasm: string
