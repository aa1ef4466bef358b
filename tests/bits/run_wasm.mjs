// Runs a WebAssembly program in Node: node run_wasm.mjs MODULE FOLDER [ARGUMENT ...]. FOLDER is all that it sees of the disk, as ".".
import { readFileSync } from "node:fs";
import { WASI } from "node:wasi";

const [module, folder, ...words] = process.argv.slice(2);
const wasi = new WASI({ version: "preview1", args: [module, ...words], preopens: { ".": folder }, returnOnExit: true });
const { instance } = await WebAssembly.instantiate(readFileSync(module), { wasi_snapshot_preview1: wasi.wasiImport });
process.exitCode = wasi.start(instance);
