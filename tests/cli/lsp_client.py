# SPDX-License-Identifier: Apache-2.0
"""A client of `vug lsp`, for tests."""
import json
import os
import queue
import subprocess
import threading


class Client:
    def __init__(self, *options):
        self.process = subprocess.Popen([os.environ["VUG"], "lsp", *options], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE)
        self.messages = queue.Queue()
        self.next_id = 0
        self.notifications = []
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        out = self.process.stdout
        while True:
            length = None
            while (line := out.readline()) not in (b"\r\n", b""):
                name, value = line.decode().split(":")
                if name.lower() == "content-length":
                    length = int(value)
            if length is None:
                self.messages.put(None)
                return
            self.messages.put(json.loads(out.read(length)))

    def write(self, *contents):
        messages = [content.encode() for content in contents]
        self.process.stdin.write(b"".join(b"Content-Length: %d\r\n\r\n" % len(data) + data for data in messages))
        self.process.stdin.flush()

    def send(self, method, params=None, **more):
        self.write(json.dumps({"jsonrpc": "2.0", "method": method, "params": params or {}, **more}))

    def receive(self, timeout=120):
        """The next message, or None at the end."""
        return self.messages.get(timeout=timeout)

    def answer(self, id):
        """The response of that id; notifications before it are kept."""
        while True:
            message = self.receive()
            assert message is not None, "the server has ended"
            if "method" not in message and message.get("id") == id:
                return message
            self.notifications.append(message)

    def request(self, method, params=None):
        """The result of a request, or its error."""
        self.next_id += 1
        self.send(method, params, id=self.next_id)
        message = self.answer(self.next_id)
        return message["result"] if "result" in message else message["error"]

    def notification(self, method, matches=lambda params: True):
        """The parameters of the next notification of this method that matches."""
        while True:
            for index, message in enumerate(self.notifications):
                if message.get("method") == method and matches(message["params"]):
                    del self.notifications[:index + 1]
                    return message["params"]
            message = self.receive()
            assert message is not None, "the server has ended"
            self.notifications.append(message)

    def start(self, capabilities=None, **more):
        result = self.request("initialize", {"processId": None, "rootUri": None,
                                             "capabilities": capabilities or {}, **more})
        self.send("initialized")
        return result

    def open(self, uri, text):
        self.send("textDocument/didOpen",
                  {"textDocument": {"uri": uri, "languageId": "vug", "version": 1, "text": text}})

    def at(self, uri, line, character, **more):
        return {"textDocument": {"uri": uri}, "position": {"line": line, "character": character}, **more}

    def stop(self):
        """The exit code after shutdown and exit."""
        self.request("shutdown")
        self.send("exit")
        return self.process.wait(timeout=120)
