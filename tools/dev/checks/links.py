# SPDX-License-Identifier: Apache-2.0
"""Links between Markdown files refer to existing files and headings."""
import posixpath
import re

from .tree import Finding


def anchors(text):
    found = set()
    for heading in re.findall(r"^#+\s+(.*?)\s*#*$", re.sub(r"```.*?```", "", text, flags=re.S), re.M):
        slug = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        found.add(slug)
    return found


def check(tree):
    known = set(tree.files) | {posixpath.dirname(name) for name in tree.files}
    known |= {parent for name in list(known) for parent in (posixpath.dirname(name),)}
    for name in tree.select(".md"):
        fenced = False
        for number, line in tree.lines(name):
            fenced ^= line.lstrip().startswith("```")
            if fenced:
                continue
            for target in re.findall(r"!?\[[^\]]*\]\(([^)\s]+)[^)]*\)", re.sub(r"`[^`]*`", "", line)):
                if re.match(r"\w+:", target):
                    continue
                path, _, anchor = target.partition("#")
                full = posixpath.normpath(posixpath.join(posixpath.dirname(name), path)) if path else name
                if full not in known:
                    yield Finding(name, number, f"broken link: {target}")
                elif anchor and full.endswith(".md") and anchor not in anchors(tree.text(full)):
                    yield Finding(name, number, f"unknown heading: {target}")
