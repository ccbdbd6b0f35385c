// SPDX-License-Identifier: GPL-3.0-or-later
// node validate.js FILE.glb ...: prints every error and warning of Khronos' validator; exit code 1 if there are any.
'use strict';
const fs = require('fs');
const path = require('path');
const validator = require('gltf-validator');

async function problems(file) {
  const folder = path.dirname(file);
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
    uri: path.basename(file),
    maxIssues: 0,
    externalResourceFunction: (uri) => fs.promises.readFile(path.join(folder, decodeURIComponent(uri))).then((b) => new Uint8Array(b)),
  });
  const {numErrors, numWarnings, messages} = report.issues;
  const lines = messages.filter((m) => m.severity < 2).map((m) => `${m.code} ${m.pointer || ''} ${m.message}`);
  return numErrors + numWarnings > 0 ? lines.concat(`${numErrors} errors, ${numWarnings} warnings`) : [];
}

(async () => {
  let found = 0;
  for (const file of process.argv.slice(2)) {
    for (const line of await problems(file)) {
      console.log(`${path.basename(file)}: ${line}`);
      ++found;
    }
  }
  process.exitCode = found > 0 ? 1 : 0;
})().catch((error) => {
  console.log(String(error));
  process.exitCode = 1;
});
