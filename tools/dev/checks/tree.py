# SPDX-License-Identifier: Apache-2.0
"""The checked tree with its files and their texts, and the type of findings."""
import dataclasses
import functools
import pathlib
import re
import subprocess


@dataclasses.dataclass(order=True)
class Finding:
    path: str
    line: int
    message: str
    note: bool = False  # information, not an error

    def __str__(self):
        place = f"{self.path}:{self.line}: " if self.line else f"{self.path}: " if self.path else ""
        return f"{place}{'note: ' if self.note else ''}{self.message}"


class Tree:
    """The files that git tracks or would add; outside of git, all files but build/ and out/."""

    def __init__(self, root):
        self.root = pathlib.Path(root).resolve()
        if (self.root / ".git").exists():
            listed = subprocess.run(
                ["git", "-C", self.root, "ls-files", "-co", "--exclude-standard", "-z"],
                capture_output=True, text=True, check=True).stdout.split("\0")
            names = {name for name in listed if name and (self.root / name).is_file()}
        else:
            names = {str(path.relative_to(self.root)) for path in self.root.rglob("*")
                     if path.is_file()}
            names = {name for name in names
                     if name.split("/")[0] not in ("build", "out") and "__pycache__" not in name}
        self.files = sorted(names)

    def select(self, *suffixes, under=""):
        return [name for name in self.files if name.endswith(suffixes) and name.startswith(under)]

    def sources(self, under=""):
        return self.select(".h", ".cpp", under=under)

    @functools.lru_cache(maxsize=None)
    def text(self, name):
        return (self.root / name).read_text(encoding="utf-8", errors="replace")

    def lines(self, name):
        return enumerate(self.text(name).splitlines(), 1)

    @functools.lru_cache(maxsize=None)
    def code(self, name):
        """C++ text with comments and literals replaced by blanks; line numbers are preserved."""
        def blank(match):
            return re.sub(r"[^\n]", " ", match.group(0))
        return re.sub(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"'
                      r"|'(?:\\.|[^'\\\n])+'", blank, self.text(name), flags=re.S)

    def includes(self, name):
        """(line, included path, whether in angle brackets) of every include."""
        for number, line in self.lines(name):
            match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
            if match:
                yield number, match.group(2), match.group(1) == "<"


def module_of(name):
    """The module of a path in lib/vug or of an include <vug/...>, or None."""
    match = re.match(r"(?:lib/)?vug/(\w+)/", name)
    return match.group(1) if match else None
