"""The package as `cmake --install` lays it down, without the build's folder."""
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


if __name__ == "__main__":
    unittest.main()
