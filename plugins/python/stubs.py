# SPDX-License-Identifier: Apache-2.0
"""Writes vug/_vug.pyi, the type stubs of the compiled module, from its signatures.

    stubs.py FOLDER_OF_THE_PACKAGE

pybind11 puts a signature into the first line of each docstring; this program turns them into Python.
"""
import inspect
import pathlib
import re
import sys

HEAD = '''"""Generated from the module's signatures by plugins/python/stubs.py."""
import os
import pathlib
from typing import Any, Callable, Dict, List, Optional, Tuple, Union

import numpy

from ._errors import Cancelled, Diagnostic, Error, SceneWarning

__version__: str
'''
ARGUMENTS = {"os.PathLike": "Union[str, os.PathLike]", "function": "Callable[[float, str], Any]"}
RESULTS = {"os.PathLike": "pathlib.Path", "function": "Callable[[float, str], Any]"}


def in_words(text, words):
    text = re.sub(r"vug\._vug\.|vug\.(?=[A-Z])", "", text)
    text = re.sub(r"numpy\.ndarray\[[\w.]+\]", "numpy.ndarray", text)
    text = re.sub(r"(\*\*?)(kwargs|args)\b", r"\1\2: Any", text)
    for word, meaning in words.items():
        text = re.sub(rf"(?<![\w.]){re.escape(word)}\b", meaning, text)
    return re.sub(r"\b(object|handle)\b", "Any", text)


def signature(doc):
    """(arguments, result) of a docstring's first line."""
    head = (doc or "").strip().split("\n")[0]
    arguments, _, result = head[head.index("("):].rpartition(" -> ")
    arguments = re.sub(r"^\((self|arg0): [\w.]+", "(self", arguments)
    arguments = re.sub(r"<[^<>]*>|PosixPath\('[^']*'\)", "...", arguments)
    return in_words(arguments, ARGUMENTS), in_words(result, RESULTS)


def text_of(doc):
    """The docstring without its signature."""
    lines = inspect.cleandoc(doc or "").split("\n")
    return "\n".join(lines[1:] if "->" in lines[0] else lines).strip()


def function(name, doc, indent, decorators=()):
    arguments, result = signature(doc)
    lines = [f"{indent}{each}" for each in decorators]
    lines.append(f"{indent}def {name}{arguments} -> {result}:")
    if text_of(doc):
        lines.append(f'{indent}    """' + text_of(doc).replace("\n", f"\n{indent}    ") + '"""')
    return [*lines, f"{indent}    ...", ""]


def members(kind):
    for name, member in vars(kind).items():
        if name in ("__module__", "__doc__", "__new__"):
            continue
        if type(member).__name__ == "pybind11_static_property":
            yield f"    {name}: {signature(member.fget.__doc__)[1]}"
        elif isinstance(member, property):
            doc = (member.fget.__doc__ or "").strip() + "\n" + (member.__doc__ or "")
            yield from function(name, doc, "    ", ["@property"])
            if member.fset:
                value = signature(member.fset.__doc__)[0].partition(", ")[2].partition(": ")[2]
                yield from [f"    @{name}.setter", f"    def {name}(self, value: {value}: ...", ""]
        elif callable(member) and "->" in (member.__doc__ or ""):
            yield from function(name, member.__doc__, "    ")


def main(folder):
    sys.path.insert(0, str(folder.parent))
    from vug import _vug
    lines = [HEAD]
    for name, member in vars(_vug).items():
        if inspect.isclass(member) and member.__module__ in ("vug", "vug._vug"):
            base = member.__bases__[0].__name__
            lines += [f"class {name}" + (f"({base})" if base in vars(_vug) else "") + ":",
                      '    """' + inspect.cleandoc(member.__doc__ or "").replace("\n", "\n    ") + '"""',
                      "", *members(member), ""]
        elif inspect.isbuiltin(member):
            lines += function(name, member.__doc__, "")
    text = "\n".join(line.rstrip() for line in "\n".join(lines).split("\n"))
    compile(text, "_vug.pyi", "exec")
    (folder / "_vug.pyi").write_text(text)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
