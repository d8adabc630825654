// SPDX-License-Identifier: Apache-2.0
// Prints the report of the Khronos glTF validator on a file, as JSON.
const fs = require('fs');
const validator = require('gltf-validator');

const bytes = new Uint8Array(fs.readFileSync(process.argv[2]));
validator.validateBytes(bytes, {maxIssues: 0, writeTimestamp: false})
    .then((report) => console.log(JSON.stringify(report)));
