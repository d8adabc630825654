# SPDX-License-Identifier: Apache-2.0
"""The package as installed by `cmake --install`, without the build folder."""
import os
import pathlib
import subprocess
import sys
import unittest

from case import BALL, Case


class Installed(Case):
    def test_it_works_from_there(self):
        prefix = self.folder / "prefix"
        done = subprocess.run(["cmake", "--install", os.environ["VUG_BUILD"], "--prefix", prefix],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        [package] = prefix.glob("lib/python3*/*-packages/vug")
        self.assertEqual({p.name for p in package.iterdir()} & {"__init__.py", "_vug.pyi", "py.typed"},
                         {"__init__.py", "_vug.pyi", "py.typed"})
        program = (f"import vug\nscene = vug.loads({BALL!r})\n"
                   "print(vug.__file__)\nprint(scene.measure()['genus'])\n")
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(package.parent)})
        self.assertEqual(done.stdout.split(), [str(package / "__init__.py"), "0"], done.stderr)
        self.assertEqual(pathlib.Path(done.stdout.split()[0]).parent, package)
        self.check_messages_of_missing_modules(package)

    def check_messages_of_missing_modules(self, package):
        """The messages of a Python without numpy, and of one for which the package is not built."""
        blind = self.write("blind/numpy.py", "raise ImportError('none here')").parent

        def said(path):
            done = subprocess.run([sys.executable, "-c", "import vug"], capture_output=True, text=True,
                                  env={**os.environ, "PYTHONPATH": f"{path}:{package.parent}"})
            self.assertNotEqual(done.returncode, 0)
            return done.stderr.strip().splitlines()[-1]

        self.assertIn("ImportError: vug needs numpy", said(blind))
        [built] = package.glob("_vug.*.so")
        built.rename(package / "_vug.cpython-27-nowhere.so")
        self.assertIn("is built for cpython-27-nowhere, and this is Python 3.", said(self.folder))


if __name__ == "__main__":
    unittest.main()
