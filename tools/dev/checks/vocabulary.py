# SPDX-License-Identifier: Apache-2.0
"""Names that gave way to the field's standard terms do not come back.

Each line of tools/dev/retired_names.txt holds a retired name and its replacement; docs/glossary.md explains the terms.
A name is compared as a whole word, with its case, in every text of the project.
"""
import re

from .tree import Finding

TABLE = "tools/dev/retired_names.txt"
# The table itself, the history of changes, and inputs of tests.
EXEMPT = (TABLE, "docs/CHANGELOG.md", "tests/data/", "tests/fuzz/corpus/", "docs/references.bib", "LICENSE")
SUFFIXES = (".h", ".cpp", ".py", ".md", ".vug", ".cmake", ".txt", ".in", ".js", ".mjs", ".html", ".json")


def read_table(tree):
    return dict(line.split(maxsplit=1) for _, line in tree.lines(TABLE)
                if line.strip() and not line.startswith("#"))


def check(tree):
    retired = read_table(tree)
    pattern = re.compile(r"(?<!\w)(?:" + "|".join(map(re.escape, retired)) + r")(?!\w)")
    for name in tree.files:
        if name.startswith(EXEMPT) or not name.endswith(SUFFIXES):
            continue
        text = tree.text(name)
        for match in pattern.finditer(text):
            yield Finding(name, text.count("\n", 0, match.start()) + 1,
                          f"'{match.group(0)}' is a retired name: write {retired[match.group(0)]}")
