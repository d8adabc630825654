// SPDX-License-Identifier: Apache-2.0
// A client of `vug lsp` on the library with which VS Code talks to language servers.
import { spawn } from "node:child_process";
import { createRequire } from "node:module";
import path from "node:path";

// The packages are those of the folder in which the test runs.
const require = createRequire(path.join(process.cwd(), "package.json"));
const { createProtocolConnection, StreamMessageReader, StreamMessageWriter } =
  require("vscode-languageserver-protocol/node");

export { require };
export const uri = "file:///scenes/main.vug";

export class Client {
  constructor(program) {
    this.server = spawn(program, ["lsp", "--debounce", "1"], { stdio: ["pipe", "pipe", "inherit"] });
    this.connection = createProtocolConnection(new StreamMessageReader(this.server.stdout),
      new StreamMessageWriter(this.server.stdin));
    this.waiting = [];
    this.connection.onNotification("textDocument/publishDiagnostics", (params) => {
      if (params.uri === uri && params.diagnostics.length) this.waiting.splice(0).forEach((done) => done(params.diagnostics));
    });
    this.connection.listen();
  }
  async start() {
    const result = await this.connection.sendRequest("initialize", {
      processId: null, rootUri: null,
      capabilities: { textDocument: { completion: { completionItem: { snippetSupport: true } } } } });
    await this.connection.sendNotification("initialized", {});
    return result;
  }
  /** The next diagnostics of the document that are not empty. */
  diagnostics() {
    return new Promise((done) => this.waiting.push(done));
  }
  async open(text) {
    await this.connection.sendNotification("textDocument/didOpen", {
      textDocument: { uri, languageId: "vug", version: 1, text } });
  }
  async close() {
    await this.connection.sendNotification("textDocument/didClose", { textDocument: { uri } });
  }
  /** The result of a request on the document, or its error. */
  async request(method, params) {
    try {
      return await this.connection.sendRequest(`textDocument/${method}`, { textDocument: { uri }, ...params });
    } catch (error) {
      return { error: error.code, message: error.message };
    }
  }
  /** The exit code. */
  async stop() {
    await this.connection.sendRequest("shutdown");
    await this.connection.sendNotification("exit");
    return new Promise((done) => this.server.on("exit", done));
  }
}
