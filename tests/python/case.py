# SPDX-License-Identifier: Apache-2.0
"""Shared code for tests of the Python package: a temporary folder and the command for comparison."""
import os
import pathlib
import subprocess
import tempfile
import unittest
import warnings

PROGRAM = os.environ["VUG"]
SOURCE = pathlib.Path(__file__).resolve().parents[2]

BALL = """param R = 1m  in 50cm..2m  "its radius"
volume rock = level_set(sphere(R), voxel: 10cm)
mesh wall on rock { paint (0.5, 0.4, 0.3) }
light sky = sky(radiance: (1, 1, 1))
camera main { eye (0, 0, 4) }
render main { size 32x18  spp 4 }
"""


class Case(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        room = tempfile.TemporaryDirectory(prefix="vug_python_")
        self.addCleanup(room.cleanup)
        self.folder = pathlib.Path(room.name)
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        shown = warnings.catch_warnings()
        shown.__enter__()
        self.addCleanup(shown.__exit__, None, None, None)
        warnings.simplefilter("error")

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def vug(self, *args):
        """Runs the command and returns its standard output."""
        done = subprocess.run([PROGRAM, *map(str, args), *(["-q"] if args[0] in QUIET else [])],
                              capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def assert_same_files(self, ours, theirs):
        ours, theirs = pathlib.Path(ours), pathlib.Path(theirs)
        self.assertTrue(theirs.exists(), theirs)
        self.assertEqual(ours.read_bytes(), theirs.read_bytes(), f"{ours} and {theirs} differ")


QUIET = ("build", "export", "measure", "render")
