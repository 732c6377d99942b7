// Play the golden scenes and the 150 shots under another C library and processor: CPython in
// WebAssembly, with Emscripten's musl. Needs Node 18 or newer and the package pyodide, which is
// looked for in the current folder:
//
//     cd $(mktemp -d) && npm install pyodide && node .../danggu/tools/elsewhere.mjs
//
// The exit status is that of `python -m benchmarks golden`.
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const found = createRequire(join(process.cwd(), "any.js")).resolve("pyodide/pyodide.mjs");
const { loadPyodide } = await import(pathToFileURL(found));
const python = await loadPyodide({ indexURL: dirname(found) + "/" });
python.mountNodeFS("/danggu", dirname(dirname(fileURLToPath(import.meta.url))));
process.exitCode = python.runPython(`
import platform, sys

sys.dont_write_bytecode = True  # the folder is the real one
sys.path.insert(0, "/danggu")
print("Python", platform.python_version(), platform.platform())
from benchmarks import golden

golden.main([])
`);
