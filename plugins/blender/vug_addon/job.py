# SPDX-License-Identifier: Apache-2.0
"""A running worker process, its messages and its cancellation. This module does not use bpy."""
import json
import os
import queue
import shutil
import subprocess
import sys
import tempfile
import threading

WORKER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "worker.py")


class Job:
    """Starts a worker. `poll` processes its messages; one of `error`, `same` and `done` is set when it has ended.
    `close` ends the worker in any state and removes its files."""

    def __init__(self, order, python="", package=""):
        self.folder = tempfile.mkdtemp(prefix="vug_blender_")
        self.share, self.what = 0.0, "loading"
        self.scene = self.done = self.error = None
        self.same = False
        environment = dict(os.environ)
        if package:
            environment["PYTHONPATH"] = os.pathsep.join(
                part for part in (package, environment.get("PYTHONPATH")) if part)
        self._said = queue.SimpleQueue()
        self._complaints = open(os.path.join(self.folder, "stderr"), "w+", errors="replace")
        try:
            self._process = subprocess.Popen(
                [python or sys.executable, WORKER], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                stderr=self._complaints, text=True, encoding="utf-8", env=environment)
        except OSError as error:
            self._process = None
            self.error = f"cannot start the Python '{python or sys.executable}': {error.strerror}"
            return
        self.pid = self._process.pid
        self._reader = threading.Thread(target=self._listen, daemon=True)
        self._reader.start()
        order = dict(order, folder=os.path.join(self.folder, "set"))
        try:
            self._process.stdin.write(json.dumps(order) + "\n")
            self._process.stdin.flush()
        except OSError:
            pass  # the worker has ended, and poll reports why

    def _listen(self):
        for line in self._process.stdout:
            self._said.put(line)
        self._said.put(None)

    @property
    def ended(self):
        return bool(self.error or self.same or self.done is not None)

    def poll(self, wait=0.0):
        """Processes messages and waits up to `wait` seconds for one. Returns whether the worker has ended."""
        while not self.ended:
            try:
                line = self._said.get(timeout=wait) if wait else self._said.get_nowait()
            except queue.Empty:
                break
            wait = 0.0
            if line is None:
                self._complaints.seek(0)
                last = self._complaints.read().strip().splitlines()[-1:]
                self.error = "the worker ended without a result" + "".join(f": {each}" for each in last)
            else:
                for name, value in json.loads(line).items():
                    setattr(self, name, value)
        return self.ended

    def close(self):
        if self._process:
            self._process.kill()
            self._process.wait()
            self._reader.join()
            self._process.stdout.close()
            try:
                self._process.stdin.close()
            except OSError:
                pass
            self._process = None
        self._complaints.close()
        shutil.rmtree(self.folder, ignore_errors=True)
