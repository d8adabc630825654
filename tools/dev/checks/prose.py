# SPDX-License-Identifier: Apache-2.0
"""Comments, messages and documents avoid the phrases that docs/style.md rejects.

Each line of the table tools/dev/phrases.txt holds a pattern and its advice. The check reads comments and string
literals of C++, comments of scenes, CMake and shell files, docstrings and comments of Python, and all of Markdown
except code. A line that must quote a phrase ends with "style: quoted".
"""
import re

from .tree import Finding

TABLE = "tools/dev/phrases.txt"
# Pages that quote the phrases, and third-party texts.
EXEMPT = (TABLE, "docs/style.md", "docs/references.bib", "tests/data/", "tests/fuzz/corpus/",
          "tools/dev/checks/prose.py", "LICENSE")
CPP_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"', re.S)


def read_table(tree):
    for number, line in tree.lines(TABLE):
        if line.strip() and not line.startswith("#"):
            pattern, _, advice = line.partition("  ")
            yield re.compile(pattern.strip(), re.I), advice.strip()


def only(pattern, text):
    """The text with all but the matches of the pattern blanked, so that line numbers stay."""
    kept, end = [], 0
    for match in pattern.finditer(text):
        kept.append(re.sub(r"[^\n]", " ", text[end:match.start()]))
        kept.append(match.group(0))
        end = match.end()
    return "".join(kept)


def prose_of(name, text):
    if name.endswith((".h", ".cpp", ".js", ".mjs")):
        # Adjacent literals are one message, and so are consecutive comment lines.
        return only(CPP_TEXT, text)
    if name.endswith((".vug", ".cmake", ".txt", ".sh")) or "/" in name and "." not in name.rpartition("/")[2]:
        return only(re.compile(r"#[^\n]*"), text)
    if name.endswith(".py"):
        return only(re.compile(r'#[^\n]*|"""(?:.*?)"""|"(?:\\.|[^"\\\n])*"', re.S), text)
    if name.endswith(".md"):
        blank = lambda match: re.sub(r"[^\n]", " ", match.group(0))  # noqa: E731
        return re.sub(r"```.*?```|`[^`\n]*`|^    \S[^\n]*", blank, text, flags=re.S | re.M)
    return ""


def check(tree):
    table = list(read_table(tree))
    for name in tree.files:
        if name.startswith(EXEMPT):
            continue
        if not name.endswith((".h", ".cpp", ".js", ".mjs", ".vug", ".cmake", ".txt", ".sh", ".py", ".md")) \
                and not name.startswith("tools/"):
            continue
        for number, line in enumerate(prose_of(name, tree.text(name)).splitlines(), 1):
            if "style: quoted" in line:
                continue
            for pattern, advice in table:
                match = pattern.search(line)
                if match:
                    yield Finding(name, number, f"'{match.group(0).strip()}': {advice}")
