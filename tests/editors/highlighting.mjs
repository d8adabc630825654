// SPDX-License-Identifier: Apache-2.0
// node highlighting.mjs VUG GRAMMAR FILES...: highlights scenes with the TextMate grammar and prints
// the words to which it gives another class than the semantic tokens of `vug lsp`.
import fs from "node:fs";
import path from "node:path";
import { Client, require } from "./client.mjs";

const { loadWASM, OnigScanner, OnigString } = require("vscode-oniguruma");
const textmate = require("vscode-textmate");
const [program, grammarFile, ...files] = process.argv.slice(2);

await loadWASM(fs.readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")));
const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new OnigScanner(patterns), createOnigString: (text) => new OnigString(text) }),
  loadGrammar: async () => textmate.parseRawGrammar(fs.readFileSync(grammarFile, "utf8"), path.basename(grammarFile)),
});
const grammar = await registry.loadGrammar("source.vug");

/** The class of each character of each line. */
function classes(lines) {
  let stack = textmate.INITIAL;
  return lines.map((line) => {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, stack);
    stack = ruleStack;
    const all = [];
    for (const { startIndex, endIndex, scopes } of tokens)
      all.fill(scopes.at(-1), all.length, (all.length = endIndex)) && startIndex;
    return all;
  });
}
const expected = { comment: /^comment/, string: /^string|^constant\.character/, number: /^constant\.numeric/ };

const client = new Client(program);
const { capabilities } = await client.start();
const legend = capabilities.semanticTokensProvider.legend.tokenTypes;
const result = { words: 0, different: [], statements: 0 };
for (const file of files) {
  const text = fs.readFileSync(file, "utf8");
  const lines = text.split("\n");
  await client.open(text);
  const { data } = await client.request("semanticTokens/full", {});
  await client.close();
  const found = classes(lines);
  let line = 0, character = 0;
  for (let i = 0; i < data.length; i += 5) {
    character = data[i] ? data[i + 1] : character + data[i + 1];
    line += data[i];
    const type = legend[data[i + 3]], scope = found[line][character] ?? "";
    const first = lines[line].slice(0, character).trim() === "";
    const statement = type === "keyword" && character === 0 && first;
    result.words += 1;
    result.statements += statement ? 1 : 0;
    const pattern = statement ? /^keyword\.control/ : expected[type];
    const plain = !pattern && Object.values(expected).some((each) => each.test(scope));
    if (pattern ? !pattern.test(scope) : plain)
      result.different.push([path.basename(file), line + 1, character, type, scope]);
  }
}
await client.stop();
console.log(JSON.stringify({ ...result, different: result.different.slice(0, 20), count: result.different.length }));
