// SPDX-License-Identifier: Apache-2.0
// node golden.mjs VUG FILE [--write]: sends the golden requests to `vug lsp` and prints those whose
// answers differ from FILE, or writes FILE.
import fs from "node:fs";
import { Client, uri } from "./client.mjs";
import { cases } from "./requests.mjs";

const [program, file, write] = process.argv.slice(2);

/** The text without its marker, and the position. */
function unmarked(text) {
  const index = text.indexOf("|");
  if (index < 0) return [text, { line: 0, character: 0 }];
  const lines = text.slice(0, index).split("\n");
  return [text.slice(0, index) + text.slice(index + 1),
    { line: lines.length - 1, character: lines.at(-1).length }];
}

/** The parts of an answer that new kinds and longer descriptions do not change, and no paths. */
function reduced(method, answer) {
  if (method === "completion") {
    const items = [...answer.items].sort((a, b) => (a.sortText < b.sortText ? -1 : 1));
    return items.slice(0, 6).map((item) => `${item.label} -> ${item.textEdit.newText}`);
  }
  const text = JSON.stringify(answer ?? null);
  return JSON.parse(text.replaceAll(/file:\/\/[^"]*\/data\//g, "file:///data/"));
}

const client = new Client(program);
await client.start();
const answers = [];
for (const { method, text, more } of cases) {
  const [plain, position] = unmarked(text);
  const { diagnostics, ...params } = more ?? {};
  const found = diagnostics ? client.diagnostics() : null;
  await client.open(plain);
  if (found) await found;
  answers.push({ method, text, answer: reduced(method, await client.request(method, { position, ...params })) });
  await client.close();
}
const code = await client.stop();
if (write) {
  fs.writeFileSync(file, "[\n" + answers.map((each) => JSON.stringify(each)).join(",\n") + "\n]\n");
} else {
  const known = JSON.parse(fs.readFileSync(file, "utf8"));
  const different = answers.flatMap((each, i) =>
    JSON.stringify(each) === JSON.stringify(known[i]) ? [] : [{ expected: known[i], actual: each }]);
  console.log(JSON.stringify({ requests: answers.length, known: known.length, code, different }));
}
