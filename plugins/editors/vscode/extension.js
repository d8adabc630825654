// SPDX-License-Identifier: Apache-2.0
// Starts the language server `vug lsp` and runs the commands of its code lenses in a terminal.
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

/** Runs `vug VERB FILE` in the terminal "Vug". */
function run(program, verb, uri, options) {
  const name = "Vug";
  const terminal = vscode.window.terminals.find((each) => each.name === name) ?? vscode.window.createTerminal(name);
  terminal.show(true);
  const quote = (text) => `'${text.replaceAll("'", "'\\''")}'`;
  terminal.sendText([program, verb, vscode.Uri.parse(uri).fsPath, ...options].map(quote).join(" "));
}

function activate(context) {
  const program = vscode.workspace.getConfiguration("vug").get("program");
  const server = { command: program, args: ["lsp"] };
  client = new LanguageClient("vug", "Vug", server, { documentSelector: [{ language: "vug" }] });
  const command = (name, verb, options) =>
    context.subscriptions.push(
      vscode.commands.registerCommand(name, (uri, item) => run(program, verb, uri, options(item))));
  command("vug.render", "render", (item) => ["--render", item]);
  command("vug.preview", "preview", () => []);
  command("vug.measure", "measure", () => []);
  client.start();
}

function deactivate() {
  return client?.stop();
}

module.exports = { activate, deactivate };
