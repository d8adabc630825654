# SPDX-License-Identifier: Apache-2.0
"""All C++ sources are formatted by clang-format 14."""
import concurrent.futures
import os
import re
import shutil
import subprocess

from .tree import Finding


def check(tree):
    program = shutil.which("clang-format-14") or shutil.which("clang-format")
    if not program:
        yield Finding("", 0, "clang-format-14 is missing: tools/dev/install_packages test")
        return
    names = tree.sources()
    workers = os.cpu_count() or 1
    parts = [part for part in (names[i::workers] for i in range(workers)) if part]

    def run(part):
        return subprocess.run([program, "-n", "--ferror-limit=1", *part], cwd=tree.root,
                              capture_output=True, text=True).stderr

    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for output in pool.map(run, parts):
            for path, line in re.findall(r"^(\S+?):(\d+):\d+: (?:warning|error):", output, re.M):
                yield Finding(path, int(line), f"not formatted: clang-format-14 -i {path}")
