"""Faults and warnings."""
from __future__ import annotations

from typing import NamedTuple, Optional, Sequence


class Diagnostic(NamedTuple):
    """A fault or warning and its place in a scene's text; lines and columns count from 1."""

    severity: str  # "error" or "warning"
    file: Optional[str]
    line: Optional[int]
    column: Optional[int]
    message: str
    hint: Optional[str]


class Error(Exception):
    """What Vug refuses or cannot do. Printed, it says what, where, while doing what, and what helps.

    code: "bad_input", "too_large", "io", "cancelled" or "internal".
    message: a sentence; hint: what to do about it, or None; context: what was being done.
    file, line, column: the place in a scene's text, counted from 1; None where there is none.
    diagnostics: all faults and warnings of a text that has several; else empty.
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

    def __reduce__(self):  # with its keywords, so that other processes can send it back
        return _rebuilt, (type(self), self.message, {
            "code": self.code, "file": self.file, "line": self.line, "column": self.column,
            "hint": self.hint, "context": self.context, "diagnostics": self.diagnostics,
            "report": self._report})


def _rebuilt(kind, message, keywords):
    return kind(message, **keywords)


class Cancelled(Error):
    """Work that a progress callback has stopped by returning False."""


class SceneWarning(UserWarning):
    """Something doubtful in a scene's text or in what is made of it."""
