# SPDX-License-Identifier: Apache-2.0
"""The default classifier of `vug facade fit` is made from the files of this repository alone, and finds windows."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["VUG"]
SHIPPED = SOURCE / "data/facades/looks.json"


class Looks(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory(prefix="vug_test_")
        self.addCleanup(room.cleanup)
        self.folder = pathlib.Path(room.name)

    def test_training_needs_no_photo(self):
        """Two of the facades, without any file or variable of the user's surroundings."""
        subprocess.run([sys.executable, SOURCE / "tools/dev/train_looks", "--vug", PROGRAM, "--facades", "2", "--trees", "1",
                        "-o", self.folder / "looks.json"], cwd=self.folder, env={"PATH": os.defpath}, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        made, shipped = (json.loads(path.read_text()) for path in (self.folder / "looks.json", SHIPPED))
        for key in ("format", "version", "classes", "working"):
            self.assertEqual(made[key], shipped[key], key)
        self.assertEqual(made["first"]["features"], shipped["first"]["features"])

    def test_the_shipped_classifier_is_the_default_and_finds_all_windows(self):
        picture = SOURCE / "docs/images/facade_figure2.jpg"
        subprocess.run([PROGRAM, "facade", "fit", picture, "--iterations", "40000", "--no-carving", "-q", "-o", self.folder],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.assertTrue((self.folder / "facade_figure2.labels.png").exists(), "a classifier was used")
        tree = json.loads((self.folder / "facade_figure2.json").read_text())
        kinds = [element["kind"] for element in tree["elements"]]
        self.assertEqual((kinds.count("window"), kinds.count("door")), (11, 1))


if __name__ == "__main__":
    unittest.main()
