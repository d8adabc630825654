# SPDX-License-Identifier: Apache-2.0
"""Functions of scenes."""
from __future__ import annotations

from typing import Any, Dict, NamedTuple

from . import _vug


class FunctionParam(NamedTuple):
    """A parameter of a function."""

    name: str
    doc: str
    required: bool  # it has no default


class Function(NamedTuple):
    """A function of a scene. A call returns its text in the scene language, which scene.evaluate,
    scene.with_text and parameters of scenes accept: `ring(6)` is the text "ring(6)"."""

    name: str  # those of modules have their prefix: "rocks.slab"
    doc: str
    parameters: Dict[str, FunctionParam]

    def __call__(self, *args: Any, **kwargs: Any) -> str:
        """The text of the call. Numbers are in metres or have no unit; a tuple or array of three numbers is a
        vector, every other sequence is a list, and a str is text of the language: "20deg"."""
        given = dict(zip(self.parameters, args))
        if len(args) > len(self.parameters):
            raise TypeError(f"'{self.name}' takes {len(self.parameters)} arguments, not {len(args)}")
        for name in kwargs:
            if name not in self.parameters:
                raise TypeError(f"'{self.name}' has no parameter '{name}'; "
                                + _vug.suggestion(name, list(self.parameters)))
            if name in given:
                raise TypeError(f"'{self.name}': '{name}' is given twice")
        given.update(kwargs)
        missing = [p.name for p in self.parameters.values() if p.required and p.name not in given]
        if missing:
            raise TypeError(f"'{self.name}' needs '{missing[0]}'")
        texts = [_vug.argument_text(name, value) for name, value in list(given.items())[:len(args)]]
        texts += [f"{name}: {_vug.argument_text(name, value)}" for name, value in kwargs.items()]
        return f"{self.name}({', '.join(texts)})"

    def __str__(self) -> str:
        lines = [f"{self.name}({', '.join(self.parameters)})" + (f": {self.doc}" if self.doc else "")]
        lines += [f"  {p.name:<14} {p.doc}".rstrip() for p in self.parameters.values()]
        return "\n".join(lines)
