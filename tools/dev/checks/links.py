# SPDX-License-Identifier: Apache-2.0
"""Links between Markdown files refer to existing files and headings; the site's navigation has every page."""
import posixpath
import re

from .tree import Finding


def anchors(text):
    found = set()
    for heading in re.findall(r"^#+\s+(.*?)\s*#*$", re.sub(r"```.*?```", "", text, flags=re.S), re.M):
        slug = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        found.add(slug)
    return found


NAVIGATION = "tools/docs.d/mkdocs.yml"


def missing_pages(tree):
    if NAVIGATION not in tree.files:
        return
    listed = tree.text(NAVIGATION)
    for name in tree.select(".md"):
        page = name.removeprefix("docs/")
        if re.fullmatch(r"docs/(tutorials|guides|reference|explanation|explanation/theory)/\w+\.md", name):
            if f": {page}\n" not in listed:
                yield Finding(NAVIGATION, 1, f"the page {page} is not in the navigation")


def check(tree):
    yield from missing_pages(tree)
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
