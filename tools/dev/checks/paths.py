# SPDX-License-Identifier: Apache-2.0
"""Files, folders and names that documents mention in backquotes exist.

Paths such as `loading/load.cpp` may be relative to the top level, to lib/vug, to tests/unit or to the
document's folder. A name next to its file, as in `unite` in `field/boolean.cpp` or `field/boolean.cpp`,
`unite`, must occur in that file or in its header.
"""
import posixpath
import re

from .tree import Finding

BASES = ("", "lib/vug/", "lib/", "tests/unit/")
PATH = r"`((?:[\w.-]+/)+(?:[\w.-]+\.(?:h|cpp|py|md|txt|json|bib|vug|cmake))?)`"
NAME = r"`([A-Za-z_]\w*(?:::\w+)*)`"
PAIRS = (rf"(?P<name>{NAME})\s+in\s+(?P<path>{PATH})", rf"(?P<path>{PATH}),\s+(?P<name>{NAME})")
GENERATED = ("build/", "out/")  # by a build; not in the sources


def resolve(known, document, path):
    for base in (*BASES, posixpath.dirname(document) + "/"):
        full = posixpath.normpath(base + path)
        if full in known:
            return full
    return None


def check(tree):
    known = {posixpath.join(*parts[:end + 1]) for parts in (name.split("/") for name in tree.files)
             for end in range(len(parts))}
    for document in tree.select(".md"):
        # Code blocks are blanked, their line breaks kept.
        text = re.sub(r"^```.*?^```", lambda block: re.sub(r"[^\n]", "", block.group(0)),
                      tree.text(document), flags=re.M | re.S)
        for match in re.finditer(PATH, text):
            path = match.group(1)
            if "NAME" in path or path.startswith(GENERATED):
                continue
            if not resolve(known, document, path):
                yield Finding(document, text.count("\n", 0, match.start()) + 1, f"missing file: {path}")
        for match in (match for pattern in PAIRS for match in re.finditer(pattern, text)):
            path = match.group("path").strip("`")
            file = resolve(known, document, path)
            if file not in tree.files:
                continue
            header = re.sub(r"\.cpp$", ".h", file)
            code = tree.text(file) + (tree.text(header) if header in known else "")
            for part in match.group("name").strip("`").split("::"):
                if not re.search(rf"\b{part}\b", code):
                    yield Finding(document, text.count("\n", 0, match.start()) + 1,
                                  f"{path} does not contain {part}")
