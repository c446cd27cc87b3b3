// Runs the Khronos validator on the files that are named. Anything but hints and information fails.
import { readFile } from 'node:fs/promises';
import validator from 'gltf-validator';

const ERROR = 0;
const WARNING = 1;

let failed = false;
for (const path of process.argv.slice(2)) {
  const bytes = new Uint8Array(await readFile(path));
  const { issues, info } = await validator.validateBytes(bytes, { uri: path, maxIssues: 20 });
  const bad = issues.messages.filter(({ severity }) => severity === ERROR || severity === WARNING);
  for (const { code, message, pointer } of bad)
    console.error(`${path}: ${code} at ${pointer}: ${message}`);
  failed ||= bad.length > 0;
  console.log(`${path}: ${info.totalVertexCount} vertices, ${bad.length} errors and warnings`);
}
process.exitCode = failed ? 1 : 0;
