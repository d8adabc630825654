# SPDX-License-Identifier: Apache-2.0
"""docs/reference/scenes.md lists every scene with the first sentence of its comment."""
import posixpath
import re

from .tree import Finding

LIST = "docs/reference/scenes.md"
FOLDER = "data/scenes/"


def sentence(text):
    """The first sentence of the comment that opens a scene."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        lines.append(line[1:].strip())
    comment = " ".join(lines)
    end = re.search(r"\.(?:\s|$)", comment)
    return comment[:end.start() + 1] if end else comment


def check(tree):
    scenes = {name: sentence(tree.text(name)) for name in tree.select(".vug", under=FOLDER)}
    if not scenes and LIST not in tree.files:
        return
    listed = {}
    if LIST in tree.files:
        for number, line in tree.lines(LIST):
            entry = re.match(r"- \[([^\]]*)\]\(([^)]*)\): (.*)", line)
            if entry:
                target = posixpath.normpath(posixpath.join(posixpath.dirname(LIST), entry.group(2)))
                listed[target] = (number, entry.group(1), entry.group(3))
    for name, says in scenes.items():
        if not says:
            yield Finding(name, 1, "a scene starts with a comment that says what it shows")
        title = posixpath.basename(name)[:-len(".vug")]
        line = f"- [{title}]({posixpath.relpath(name, posixpath.dirname(LIST))}): {says}"
        number, *entry = listed.get(name, (0,))
        if entry != [title, says]:
            yield Finding(LIST, number, f"this line is missing or differs: {line}")
    for name in sorted(set(listed) - set(scenes)):
        yield Finding(LIST, listed[name][0], f"missing scene: {name}")
