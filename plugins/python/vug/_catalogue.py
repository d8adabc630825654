# SPDX-License-Identifier: Apache-2.0
"""The kinds of the scene language, with documentation from their schemas."""
from __future__ import annotations

from typing import Dict, Iterator, List, NamedTuple, Optional, Sequence

from . import _vug


class KindParam(NamedTuple):
    """A parameter of a kind. Bounds are in `unit`, or None."""

    name: str
    type: str  # "number", "vector", "field", "name", ...
    doc: str
    default: Optional[str]  # as scene text; None for required and optional parameters
    required: bool
    low: Optional[float]
    high: Optional[float]
    above: bool  # low itself is excluded
    unit: Optional[str]  # "m", "rad", "s", "1/m", "1"
    choices: Sequence[str]
    text: str  # type, range and default in one line


class Kind:
    """A kind of the scene language, e.g. a torus, a light or a rule of cells. str() gives its manual."""

    def __init__(self, data: dict) -> None:
        self.name: str = data["name"]
        self.category: str = data["category"]
        self.doc: str = data["doc"]
        self.cite: Optional[str] = data.get("cite")  # a key of docs/references.bib
        self.example: str = data["example"]  # scene text
        self.synonyms: List[str] = data.get("synonyms", [])
        self.params: Dict[str, KindParam] = {p["name"]: _param(p) for p in data["params"]}
        self.__doc__ = str(self)

    def __str__(self) -> str:
        lines = [f"{self.name} ({self.category}): {self.doc}"]
        for p in self.params.values():
            lines.append(f"  {p.name:<14} {p.text}" + (f"; {p.doc}" if p.doc else ""))
        lines += ["example:", *(f"  {line}" for line in self.example.splitlines())]
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<vug.Kind '{self.name}', {self.category}>"


class Catalogue:
    """All kinds: iterate over them, or `vug.catalogue["torus"]`, `vug.catalogue.find("light")`."""

    def find(self, word: str) -> List[Kind]:
        """Kinds of that name, of that category, or accepted by that declaration."""
        return [Kind(data) for data in _vug.find_kinds(word)] if word else []

    def search(self, text: str) -> List[Kind]:
        """Kinds whose names, descriptions, synonyms or parameters contain all words of the text."""
        return [Kind(data) for data in _vug.search_kinds(text)]

    def __iter__(self) -> Iterator[Kind]:
        return iter([Kind(data) for data in _vug.find_kinds()])

    def __len__(self) -> int:
        return len(_vug.find_kinds())

    def __getitem__(self, name: str) -> Kind:
        for data in _vug.find_kinds(name) if name else []:
            if data["name"] == name:
                return Kind(data)
        raise KeyError(f"unknown kind '{name}'; {_vug.suggestion(name, _vug.kind_words())}")

    def __contains__(self, name: str) -> bool:
        return any(data["name"] == name for data in _vug.find_kinds(name)) if name else False

    def __repr__(self) -> str:
        return f"<vug.Catalogue of {len(self)} kinds>"


def _param(data: dict) -> KindParam:
    above = data.get("above")
    return KindParam(data["name"], data["type"], data["doc"], data.get("default"),
                     data.get("required", False), data.get("min", above), data.get("max"),
                     above is not None, data.get("unit"), tuple(data.get("choices", ())),
                     data["text"])
