# SPDX-License-Identifier: Apache-2.0
"""The sources contain none of the constructs that the project forbids."""
import re

from .tree import Finding, module_of

TRANSCENDENTAL = (r"(?:sin|cos|tan|asin|acos|atan2?|sinh|cosh|tanh|exp2?|expm1"
                  r"|log(?:2|10|1p)?|pow|cbrt|hypot)")

# (pattern in code without comments and literals, modules of lib or None for all, what to do)
IN_LIBRARY = [
    (rf"\bstd::{TRANSCENDENTAL}f?\b|(?<![\w:.>]){TRANSCENDENTAL}f\s*\(",
     {"field", "volume", "sgm", "grammar", "mesh", "meshing", "metrics", "scene",
      "cells"},
     "results differ between machines in the last bits: use <vug/base/maths.h>"),
    (r"\bstd::(?:cout|cerr|clog)\b|\b(?:std::)?(?:printf|fprintf|puts|fputs|putchar)\s*\(", None,
     "the library never prints: return a value or throw vug::Error"),
    (r"(?<![\w.>:])(?:std::)?(?:exit|abort|_Exit|quick_exit|terminate)\s*\(", None,
     "the library never ends the process: throw vug::Error"),
    (r"\bthrow\s+std::", None, "the only exception type is vug::Error"),
    (r"\bstd::(?:random_device|mt19937\w*|default_random_engine|\w+_distribution)\b"
     r"|(?<![\w.>:])(?:std::)?s?rand\s*\(", None, "randomness comes from <vug/base/rng.h> only"),
    (r"\bsystem_clock\b|(?<![\w.>:])(?:std::)?(?:localtime|gmtime|strftime)\w*\s*\(", None,
     "products carry no time stamps: steady_clock measures durations"),
]
IN_HEADERS = [(r"^\s*using\s+namespace\s+(?!v\d)", "headers must not contain using-directives")]
# In all texts, including comments and strings. ([D] and the like keep this file from matching itself.)
IN_ALL = [
    (r"\b(?:TO[D]O|FIX[M]E|XX[X])\b", "finish it, or record it as an open point in docs/"),
    (r"\bST[U]B:", "tools/dev/new left this text to be written"),
    (r"(?<![\w.~}$])/(?:work|root|home)/\w", "an absolute path of one machine"),
    (r"\b(?:deb|snapshot|security)\.debian\.org|\bpypi\.org|\bregistry\.npmjs\.org"
     r"|\bproxy\.golang\.org", "name of a package server: use the settings of the machine"),
]

# Inputs of tests, and the templates of tools/dev/new.
UNCHECKED = ("tests/data/", "tests/fuzz/corpus/", "tools/dev/templates/")


def number_of(text, position):
    return text.count("\n", 0, position) + 1


def check(tree):
    for name in tree.sources(under="lib/"):
        code = tree.code(name)
        for pattern, modules, advice in IN_LIBRARY:
            if modules is None or module_of(name) in modules:
                for match in re.finditer(pattern, code):
                    yield Finding(name, number_of(code, match.start()),
                                  f"{match.group(0).strip()}: {advice}")
    for name in tree.select(".h"):
        if "#pragma once" not in tree.text(name):
            yield Finding(name, 1, "a header starts with #pragma once")
        if name.startswith("lib/") and not tree.text(name).startswith("// "):
            yield Finding(name, 1, "a header starts with a comment that states its purpose and its guarantees")
        for pattern, advice in IN_HEADERS if name.startswith("lib/") else ():
            for match in re.finditer(pattern, tree.code(name), re.M):
                yield Finding(name, number_of(tree.code(name), match.start()), advice)
    for name in tree.files:
        if name.startswith(UNCHECKED) or is_binary(tree, name):
            continue
        for pattern, advice in IN_ALL:
            for match in re.finditer(pattern, tree.text(name)):
                yield Finding(name, number_of(tree.text(name), match.start()),
                              f"{match.group(0)}: {advice}")


def is_binary(tree, name):
    with open(tree.root / name, "rb") as file:
        return b"\0" in file.read(4096)
