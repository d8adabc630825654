"""Files, folders and names in backquotes that documents point to exist.

`loading/load.cpp` may be written from the top, from lib/vug, from tests/unit or from the document's
folder. A name beside its file, as in `unite` in `field/boolean.cpp` or `field/boolean.cpp`, `unite`,
has to stand in that file or in its header.
"""
import posixpath
import re

from .tree import Finding

BASES = ("", "lib/vug/", "lib/", "tests/unit/")
PATH = r"`((?:[\w.-]+/)+(?:[\w.-]+\.(?:h|cpp|py|md|txt|json|bib|vug|cmake))?)`"
NAME = r"`([A-Za-z_]\w*(?:::\w+)*)`"
PAIRS = (rf"(?P<name>{NAME})\s+in\s+(?P<path>{PATH})", rf"(?P<path>{PATH}),\s+(?P<name>{NAME})")
MADE = ("build/", "out/")  # by a build; not in the sources


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
            if "NAME" in path or path.startswith(MADE):
                continue
            if not resolve(known, document, path):
                yield Finding(document, text.count("\n", 0, match.start()) + 1, f"there is no {path}")
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
                                  f"{path} has no {part}")
