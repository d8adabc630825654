# SPDX-License-Identifier: Apache-2.0
"""codespell finds no misspelt words; exceptions are in tools/dev/spelling.txt."""
import shutil
import subprocess

from .tree import Finding

TEXT = (".h", ".cpp", ".py", ".cmake", ".txt", ".md", ".json", ".vug", ".sh")


def check(tree):
    if not shutil.which("codespell"):
        yield Finding("", 0, "codespell is missing: tools/dev/install_packages test")
        return
    names = [name for name in tree.files if name.endswith(TEXT) or "." not in name.split("/")[-1]]
    names = [name for name in names if not name.startswith(("tests/data/", "tests/fuzz/corpus/"))
             and name != "tools/dev/spelling.txt"
             and not name.endswith("package-lock.json")]  # hashes contain arbitrary letters
    command = ["codespell", "--quiet-level=7"]
    exceptions = tree.root / "tools/dev/spelling.txt"
    if exceptions.exists():
        command += ["--ignore-words", str(exceptions)]
    output = subprocess.run(command + names, cwd=tree.root, capture_output=True, text=True).stdout
    for line in output.splitlines():
        place, _, words = line.partition(": ")
        path, _, number = place.rpartition(":")
        if number.isdigit():
            yield Finding(path.removeprefix("./"), int(number), words)
