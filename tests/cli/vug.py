# SPDX-License-Identifier: Apache-2.0
"""Runs the built vug command in tests and examines its output and files.

VUG in the environment names the program; VUG_SLOW says that a sanitizer makes it slow and large.
"""
import hashlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["VUG"]
SLOW = bool(os.environ.get("VUG_SLOW"))
SOURCE = pathlib.Path(__file__).resolve().parents[2]

BALL = "volume rock = level_set(sphere(1m), voxel: 10cm)\n"


class Result:
    def __init__(self, process):
        self.code = process.returncode
        self.out = process.stdout
        self.err = process.stderr

    @property
    def messages(self):
        """Standard error without the lines of stages, which slow machines print for short stages, too."""
        lines = self.err.splitlines(keepends=True)
        return "".join(line for line in lines if not re.fullmatch(r"[^:]+: \d+\.\d s\n", line))


def digest(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


class Running:
    """A running command, whose stage is read from its progress bar."""

    def __init__(self, folder, *args):
        self.process = subprocess.Popen([PROGRAM, *map(str, args), "--progress"], cwd=folder,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE)
        self.said = ""

    def read(self):
        """Reads more output; returns False at its end."""
        text = os.read(self.process.stderr.fileno(), 4096).decode(errors="replace")
        self.said += text
        return bool(text)

    def wait_for(self, stage):
        while stage not in self.said and self.read():
            pass

    def wait_until_it_handles_signals(self):
        """Waits until the command has installed its signal handlers."""
        while True:
            status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
            caught = int(status.split("SigCgt:")[1].split()[0], 16)
            if caught >> (signal.SIGINT - 1) & 1:
                return
            time.sleep(0.001)

    def stop(self, how):
        """Exit code and standard output after the signal."""
        self.process.send_signal(how)
        while self.read():
            pass
        out, _ = self.process.communicate(timeout=120)
        return self.process.returncode, out.decode()


class VugTest(unittest.TestCase):
    """A test whose commands run in a folder of its own. The folder is empty or contains a copy of the
    files that `prepare` creates once for all tests of the class."""

    maxDiff = None
    prepared = None

    def prepare(self):
        """Creates the files with which every test of the class starts."""

    @classmethod
    def setUpClass(cls):
        if cls.prepare is VugTest.prepare:
            return
        maker = cls()
        maker.make_folder()
        cls.addClassCleanup(maker.doCleanups)
        maker.prepare()
        cls.prepared = maker.folder

    def setUp(self):
        self.make_folder()
        if self.prepared:
            shutil.copytree(self.prepared, self.folder, dirs_exist_ok=True)

    def make_folder(self):
        room = tempfile.TemporaryDirectory(prefix="vug_test_")
        self.addCleanup(room.cleanup)
        self.folder = pathlib.Path(room.name)

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content)
        return path

    def vug(self, *args, **options):
        """Runs the command to its end and returns its output as text."""
        options.setdefault("cwd", self.folder)
        options.setdefault("stdout", subprocess.PIPE)
        return Result(subprocess.run([PROGRAM, *map(str, args)], stdin=subprocess.DEVNULL,
                                     stderr=subprocess.PIPE, text=True, timeout=300, **options))

    def expect(self, code, *args, **options):
        """Runs and asserts the exit code. Diagnostics are on stderr, results on stdout; an
        error has a message and leaves stdout empty."""
        result = self.vug(*args, **options)
        said = f"vug {' '.join(map(str, args))}\n{result.out}\n{result.err}"
        self.assertEqual(result.code, code, said)
        if code >= 2:
            self.assertIn("error: ", result.err, said)
            self.assertFalse(result.out, said)
        elif code == 0:
            self.assertNotIn("error: ", result.err, said)
        return result

    def files(self):
        """Names of all files in the test's folder, including hidden ones."""
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*") if p.is_file())
