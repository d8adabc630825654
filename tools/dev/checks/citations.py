# SPDX-License-Identifier: Apache-2.0
"""Every cited source is in docs/references.bib, and every entry is cited at least once.

A kind cites with .cite("key"), comments and documents with [@key].
"""
import re

from .tree import Finding

BIB = "docs/references.bib"


def check(tree):
    entries = {}
    if BIB in tree.files:
        for number, line in tree.lines(BIB):
            match = re.match(r"\s*@(\w+)\s*\{\s*([^,\s]+)", line)
            if match and match.group(1).lower() not in ("comment", "string", "preamble"):
                if match.group(2) in entries:
                    yield Finding(BIB, number, f"duplicate entry {match.group(2)}, listed twice")
                entries[match.group(2)] = number
    everything = ""
    for name in tree.select(".h", ".cpp", ".md", ".vug"):
        text = tree.text(name)
        everything += text
        for match in re.finditer(r'\.cite\("([^"]+)"\)|\[@([\w:.-]+)\]', text):
            key = match.group(1) or match.group(2)
            if key not in entries:
                yield Finding(name, text.count("\n", 0, match.start()) + 1,
                              f"{key} is not in {BIB}")
    for key, number in entries.items():
        if key not in everything:
            yield Finding(BIB, number, f"nothing cites {key}", note=True)
