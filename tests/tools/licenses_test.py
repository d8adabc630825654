# SPDX-License-Identifier: Apache-2.0
"""All files have a licence and a copyright by the REUSE specification (reuse lint).

The specification wants the licence texts in a folder LICENSES; this test lints a copy of the tree in which the file
LICENSE is that folder's text.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/dev"))
sys.dont_write_bytecode = True
from checks.tree import Tree  # noqa: E402


def main():
    if not shutil.which("reuse"):
        print("SKIPPED: reuse is not installed (tools/dev/install_packages test)")
        return 0
    with tempfile.TemporaryDirectory(dir=sys.argv[1]) as folder:
        copy = pathlib.Path(folder)
        for name in Tree(ROOT).files:
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            try:
                os.link(ROOT / name, copy / name)
            except OSError:  # another file system
                shutil.copy(ROOT / name, copy / name)
        (copy / "LICENSES").mkdir()
        (copy / "LICENSE").rename(copy / "LICENSES/Apache-2.0.txt")
        return subprocess.run(["reuse", "--root", str(copy), "lint"]).returncode


if __name__ == "__main__":
    sys.exit(main())
