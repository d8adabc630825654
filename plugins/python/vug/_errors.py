# SPDX-License-Identifier: Apache-2.0
"""Errors and warnings."""
from __future__ import annotations

from typing import NamedTuple, Optional, Sequence


class Diagnostic(NamedTuple):
    """An error or warning with its location in a scene text; lines and columns count from 1."""

    severity: str  # "error" or "warning"
    file: Optional[str]
    line: Optional[int]
    column: Optional[int]
    message: str
    hint: Optional[str]


class Error(Exception):
    """An error of Vug. str() gives the message, location, context and hint.

    code: "bad_input", "too_large", "io", "cancelled" or "internal".
    message: a sentence; hint: the remedy, or None; context: the operations during which it occurred.
    file, line, column: the location in a scene text, counted from 1, or None.
    diagnostics: all errors and warnings of a faulty text; otherwise empty.
    """

    def __init__(self, message: str, *, code: str = "bad_input", file: Optional[str] = None,
                 line: Optional[int] = None, column: Optional[int] = None,
                 hint: Optional[str] = None, context: Sequence[str] = (),
                 diagnostics: Sequence[Diagnostic] = (), report: str = "") -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.file = file
        self.line = line
        self.column = column
        self.hint = hint
        self.context = tuple(context)
        self.diagnostics = list(diagnostics)
        self._report = report

    def __str__(self) -> str:
        if self._report:
            return self._report.rstrip("\n")
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part)
        lines = [f"{place}: {self.message}" if place else self.message]
        lines += [f"  while {doing}" for doing in self.context]
        if self.hint:
            lines.append(f"hint: {self.hint}")
        return "\n".join(lines)

    def __reduce__(self):  # with its keywords, so that errors can be pickled between processes
        return _rebuilt, (type(self), self.message, {
            "code": self.code, "file": self.file, "line": self.line, "column": self.column,
            "hint": self.hint, "context": self.context, "diagnostics": self.diagnostics,
            "report": self._report})


def _rebuilt(kind, message, keywords):
    return kind(message, **keywords)


class Cancelled(Error):
    """Raised when a progress callback stops the work by returning False."""


class SceneWarning(UserWarning):
    """A warning about a scene text or its products."""
