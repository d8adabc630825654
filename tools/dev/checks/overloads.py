# SPDX-License-Identifier: Apache-2.0
"""Internal functions of different sources of a module have different names.

Unity builds compile several sources as one, in one anonymous namespace. Functions of one name then become overloads,
or definitions of the same function, of which the compiler may select another one than in a build of single sources.
"""
import collections
import pathlib
import re

from .tree import Finding

FOLDERS = ("lib/vug/", "tests/unit/", "tools/vug/", "plugins/python/")
NAMESPACE = re.compile(r"^namespace \{\n(.*?)^\}  // namespace\n", re.S | re.M)
FUNCTION = re.compile(
    r"^(?!return|using|TEST|INSTANTIATE|BENCHMARK|MATCHER|VUG_|struct|class|template)"
    r"(?:[A-Za-z][\w:<>,&*\[\] ]*[ &*]|static )(\w+)\(", re.M)


def internal_functions(text):
    """(line, name) of each function in an anonymous namespace of a source."""
    for block in NAMESPACE.finditer(text):
        for function in FUNCTION.finditer(block[1]):
            yield text.count("\n", 0, block.start(1) + function.start()) + 1, function[1]


def check(tree):
    places = collections.defaultdict(dict)
    for name in tree.select(".cpp"):
        if not name.startswith(FOLDERS):
            continue
        parts = pathlib.PurePath(name).parts
        module = "/".join(parts[:3] if parts[0] in ("lib", "tests") else parts[:2])
        for line, function in internal_functions(tree.text(name)):
            places[module, function].setdefault(name, line)
    for (_, function), where in sorted(places.items()):
        first, *others = sorted(where)
        for name in others:
            yield Finding(name, where[name],
                          f"{first}:{where[first]} has another internal function '{function}': rename one, or share it "
                          "in a header, since unity builds compile both as one source")
