# SPDX-License-Identifier: Apache-2.0
"""vug lsp: the protocol, its errors, positions, changes and diagnostics."""
import json
import pathlib
import tempfile
import unittest

from lsp_client import Client

URI = "file:///scenes/main.vug"
SCENE = "volume v = level_set(sphere(1m), voxel: 5cm)\nmesh m on v {}\n"


class Errors(unittest.TestCase):
    def setUp(self):
        self.client = Client()

    def tearDown(self):
        self.client.process.kill()
        self.client.process.wait()
        self.client.process.stdin.close()
        self.client.process.stdout.close()

    def code(self, method, params=None):
        return self.client.request(method, params).get("code")

    def test_codes_of_the_specification(self):
        self.assertEqual(self.code("textDocument/hover"), -32002)
        self.client.start()
        self.assertEqual(self.code("textDocument/none"), -32601)
        self.assertEqual(self.code("textDocument/hover"), -32602)
        self.assertEqual(self.code("textDocument/hover", self.client.at("file:///other.vug", 0, 0)), -32602)
        self.assertEqual(self.code("initialize", {"capabilities": {}}), -32600)
        for content, code in (("{", -32700), ("", -32700), ("[]", -32600), ("1", -32600),
                              ('{"jsonrpc": "2.0", "id": 7}', -32600),
                              ('{"jsonrpc": "2.0", "id": [1], "method": "x"}', -32600)):
            self.client.write(content)
            self.assertEqual(self.client.receive()["error"]["code"], code, content)

    def test_unknown_notifications_and_headers_are_ignored(self):
        self.client.start()
        self.client.send("$/something")
        self.client.send("textDocument/didChange", {"textDocument": 3})
        data = b'{"jsonrpc": "2.0", "id": 91, "method": "shutdown"}'
        self.client.process.stdin.write(b"Content-Type: x\r\ncontent-length: %d\r\n\r\n" % len(data) + data)
        self.client.process.stdin.flush()
        self.assertIsNone(self.client.answer(91)["result"])

    def test_cancelled_requests_have_an_error(self):
        self.client.start()
        self.client.open(URI, SCENE * 400)
        request = {"jsonrpc": "2.0", "id": 0, "method": "textDocument/completion",
                   "params": self.client.at(URI, 0, 11)}
        messages = [{**request, "id": id} for id in range(100, 140)]
        messages.append({"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {"id": 139}})
        self.client.write(*map(json.dumps, messages))  # at once, so that the last one waits when it is cancelled
        self.assertEqual(self.client.answer(139)["error"]["code"], -32800)

    def test_exit_codes(self):
        self.client.start()
        self.assertEqual(self.client.stop(), 0)
        self.client.process.stdin.close()
        self.client.process.stdout.close()
        self.client = Client()
        self.client.start()
        self.client.send("exit")
        self.assertEqual(self.client.process.wait(timeout=60), 1)

    def test_requests_after_shutdown_are_refused(self):
        self.client.start()
        self.client.request("shutdown")
        self.assertEqual(self.code("textDocument/hover", self.client.at(URI, 0, 0)), -32600)


class Session(unittest.TestCase):
    def setUp(self):
        self.client = Client("--debounce", "20")

    def tearDown(self):
        self.assertEqual(self.client.stop(), 0)
        self.client.process.stdin.close()
        self.client.process.stdout.close()

    def diagnostics(self, uri=URI, matches=lambda found: True):
        params = self.client.notification(
            "textDocument/publishDiagnostics",
            lambda params: params["uri"] == uri and matches(params["diagnostics"]))
        return params["diagnostics"]

    def change(self, version, *changes, uri=URI):
        self.client.send("textDocument/didChange", {
            "textDocument": {"uri": uri, "version": version}, "contentChanges": list(changes)})

    def test_positions_in_utf16_and_utf8(self):
        text = 'let a = 1  # \U0001f9ca\u00e4\nlet b = [a, "\U0001f9ca\u00e4", a]\n'
        for encodings, units in ((None, 19), (["utf-8", "utf-16"], 22)):
            client = Client()
            capabilities = {"general": {"positionEncodings": encodings}} if encodings else {}
            result = client.start(capabilities)
            self.assertEqual(result["capabilities"]["positionEncoding"],
                             "utf-8" if encodings else "utf-16")
            client.open(URI, text)
            found = client.request("textDocument/references", client.at(
                URI, 1, units, context={"includeDeclaration": False}))
            self.assertEqual([each["range"]["start"]["character"] for each in found], [9, units])
            client.stop()
            client.process.stdin.close()
            client.process.stdout.close()
        self.client.start()

    def test_incremental_changes(self):
        self.client.start()
        self.client.open(URI, "let a = 1\r\nlet b = a\r\n")

        def edit(line, begin, end_line, end, text):
            return {"range": {"start": {"line": line, "character": begin},
                              "end": {"line": end_line, "character": end}}, "text": text}
        self.change(2, edit(0, 4, 0, 5, "size"), edit(1, 8, 1, 9, "size"), edit(0, 12, 1, 0, "\n\n"))
        found = self.client.request("textDocument/definition", self.client.at(URI, 2, 9))
        self.assertEqual(found["range"], {"start": {"line": 0, "character": 4},
                                          "end": {"line": 0, "character": 8}})
        self.change(3, {"text": "let c = 3\n"})
        symbols = self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": URI}})
        self.assertEqual([each["name"] for each in symbols], ["c"])

    def test_diagnostics_appear_and_disappear_with_a_fix(self):
        self.client.start()
        self.client.open(URI, SCENE.replace("sphere", "sphree"))
        found = self.diagnostics()
        self.assertEqual(found[0]["severity"], 1)
        self.assertIn("did you mean 'sphere'?", found[0]["message"])
        where = found[0]["range"]
        self.assertEqual(where["start"], {"line": 0, "character": 21})
        actions = self.client.request("textDocument/codeAction", {
            "textDocument": {"uri": URI}, "range": where, "context": {"diagnostics": found}})
        edit = actions[0]["edit"]["changes"][URI][0]
        self.assertEqual(edit["newText"], "sphere")
        self.change(2, {"range": edit["range"], "text": edit["newText"]})
        self.assertEqual(self.diagnostics(), [])

    def test_duplicates_relate_to_the_first_declaration(self):
        self.client.start()
        self.client.open(URI, "let a = 1\nlet a = 2\n" + SCENE)
        found = [each for each in self.diagnostics() if "duplicate" in each["message"]]
        location = found[0]["relatedInformation"][0]["location"]
        self.assertEqual((location["uri"], location["range"]["start"]["line"]), (URI, 0))

    def test_diagnostics_of_included_texts_are_in_their_files(self):
        with tempfile.TemporaryDirectory() as folder:
            part = pathlib.Path(folder) / "part of it.vug"
            part.write_text("let ball = sphere(1s)\n")
            main = (pathlib.Path(folder) / "main.vug").as_uri()
            self.client.start()
            self.client.open(main, 'include "part of it.vug"\nvolume v = level_set(ball, voxel: 5cm)\nmesh m on v {}\n')
            self.assertEqual(len(self.diagnostics(part.as_uri())), 1)
            self.client.open(part.as_uri(), "let ball = sphere(1m)\n")
            self.assertEqual(self.diagnostics(part.as_uri()), [])
            self.client.send("textDocument/didClose", {"textDocument": {"uri": part.as_uri()}})
            self.assertEqual(len(self.diagnostics(part.as_uri(), lambda found: found)), 1)

    def test_formatting_changes_the_lines_that_need_it(self):
        self.client.start()
        self.client.open(URI, "let a = 1\nlet   b=2\nlet c = 3\n")
        edits = self.client.request("textDocument/formatting",
                                    {"textDocument": {"uri": URI}, "options": {}})
        self.assertEqual(len(edits), 1)
        self.assertEqual(edits[0]["newText"], "let b = 2\n")
        self.assertEqual(edits[0]["range"]["start"]["line"], 1)
        self.assertEqual(edits[0]["range"]["end"]["line"], 2)


if __name__ == "__main__":
    unittest.main()
