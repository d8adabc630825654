# SPDX-License-Identifier: Apache-2.0
"""Each source names its licence in an SPDX line."""
from .tree import Finding

LINE = "SPDX-License-" + "Identifier: Apache-2.0"  # reuse reads this file too
SUFFIXES = (".h", ".cpp", ".py", ".cmake", ".sh", ".js", ".mjs", "CMakeLists.txt")
UNCHECKED = ("tests/data/", "tests/fuzz/corpus/", "data/")


def check(tree):
    for name in tree.files:
        if name.startswith(UNCHECKED) or not (tree.root / name).stat().st_size:
            continue
        # The first line may be "#!" or, in a template of tools/dev/new, "//@".
        head = tree.text(name).split("\n", 2)[:2] if name.endswith(SUFFIXES) else []
        if not head and "." not in name.rsplit("/", 1)[-1]:
            script = tree.text(name).split("\n", 2)[:2]
            head = script if script[0].startswith("#!") else []
        if head and not any(line.endswith(LINE) for line in head):
            comment = "//" if name.endswith((".h", ".cpp", ".js", ".mjs")) else "#"
            yield Finding(name, 1, f"no licence: add the line '{comment} {LINE}' at the top")
