#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prepares the documentation for mkdocs: writes FOLDER/pages and FOLDER/mkdocs.yml.

    prepare.py --vug FILE --out FOLDER

Pages are those of docs/ with three changes. Links to scenes lead to copies in the site, and other links out of
docs/ become plain text. Citations [@key] become links to a page of sources made from docs/references.bib. Reference
pages about kinds and commands are generated from `vug list --json` and `vug VERB --help`.
"""
import argparse
import collections
import html
import json
import pathlib
import posixpath
import re
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
LINK = re.compile(r"(!?\[[^\]]*\])\(([^)\s]+)\)")
FENCE = re.compile(r"(^```.*?^```|`[^`\n]*`)", re.M | re.S)


def outside_code(text, change):
    """The text with `change` applied to everything but code blocks and code spans."""
    parts = FENCE.split(text)
    return "".join(part if i % 2 else change(part) for i, part in enumerate(parts))


# Sources ------------------------------------------------------------------------------------------

def plain(value):
    value = re.sub(r"\\['\"`^~=.c]\{?\\?([A-Za-z])\}?", r"\1", value)
    return re.sub(r"[{}]|\\(?=[&%$#_])", "", value).replace("--", "–").replace("\\", "")


def sources():
    """{key: {field: value}} of docs/references.bib."""
    text = (ROOT / "docs/references.bib").read_text()
    found = {}
    for key, body in re.findall(r"^@\w+\{([^,\s]+),\n(.*?)^\}", text, re.M | re.S):
        fields = re.findall(r"(\w+)\s*=\s*(\{(?:[^{}]|\{[^{}]*\})*\}|\d+)", body)
        found[key] = {name.lower(): plain(value.strip("{}")) for name, value in fields}
    return found


def label(key, entry):
    names = re.split(r"\s+and\s+", entry.get("author") or entry.get("organization") or key)
    last = [name.split(",")[0] if "," in name else name.split()[-1] for name in names]
    who = last[0] if len(last) == 1 else f"{last[0]} and {last[1]}" if len(last) == 2 else f"{last[0]} et al."
    return f"{who} {entry.get('year', '')}".strip()


def sources_page(entries):
    lines = ["# Sources", ""]
    for key, entry in sorted(entries.items(), key=lambda item: label(*item).lower()):
        where = ", ".join(entry[f] for f in ("journal", "booktitle", "publisher", "institution", "howpublished", "note")
                          if f in entry)
        who = entry.get("author") or entry.get("organization") or ""
        who = f"{who.replace(' and ', '; ')}. " if who else ""
        lines += [f'<a id="{key}"></a>**{html.escape(label(key, entry))}**', ":   " + html.escape(
            f"{who}{entry.get('title', key)}. {where + ', ' if where else ''}{entry.get('year', '')}."), ""]
    return "\n".join(lines)


# Pages --------------------------------------------------------------------------------------------

def converted(name, text, entries):
    folder = posixpath.dirname(name)
    up = posixpath.relpath(".", folder or ".")

    def cite(match):
        keys = re.findall(r"@([\w:.-]+)", match.group(0))
        return "; ".join(f"[{label(key, entries[key])}]({posixpath.join(up, 'sources.md')}#{key})" for key in keys)

    def link(match):
        path, _, anchor = match.group(2).partition("#")
        if re.match(r"\w+:", match.group(2)) or not path:
            return match.group(0)
        full = posixpath.normpath(posixpath.join("docs", folder, path))
        if full == "docs/references.bib":
            return f"{match.group(1)}({posixpath.join(up, 'sources.md')})"
        if full.startswith("docs/"):
            return match.group(0)
        if full.startswith("data/") and (ROOT / full).is_file():
            return f"{match.group(1)}({posixpath.join(up, full)})"
        return match.group(1).lstrip("!").strip("[]")

    return outside_code(text, lambda part: LINK.sub(link, re.sub(r"\[@[^\]]+\]", cite, part)))


def escaped(text):
    return html.escape(text, quote=False).replace("|", "&#124;").replace("*", "&#42;").replace("_", "&#95;") \
        .replace("[", "&#91;").replace("\n", " ")


def limits(param):
    words = [param["type"]]
    if param.get("dimension") and param["dimension"] != "number":
        words.append(f"({param['dimension']}{', ' + param['unit'] if param.get('unit') else ''})")
    if param.get("choices"):
        words.append("one of " + ", ".join(map(str, param["choices"])))
    if "min" in param:
        words.append(f"at least {param['min']:g}")
    if "above" in param:
        words.append(f"above {param['above']:g}")
    if "max" in param:
        words.append(f"at most {param['max']:g}")
    return " ".join(words)


def kinds_pages(vug, entries):
    """{path: text} of an overview and of one page for each category of kinds."""
    kinds = json.loads(subprocess.run([vug, "list", "--json"], capture_output=True, text=True, check=True).stdout)
    categories = collections.defaultdict(list)
    for kind in kinds:
        categories[kind["category"]].append(kind)
    pages = {}
    overview = ["# Kinds", "",
                "Everything that a scene, a comparison or an export can name, generated from `vug list`. Examples refer",
                "to a field `rock`, its level set `cave`, its mesh `skin`, an object `pebble`, an L-system `fern` and a",
                "facade `front`.", "",
                "| category | kinds |", "|---|---|"]
    for category, members in categories.items():
        file = category.replace(" ", "_") + ".md"
        overview.append(f"| [{category}]({file}) | " + ", ".join(
            f"[{kind['name']}]({file}#{kind['name']})" for kind in members) + " |")
        lines = [f"# Kinds: {category}", ""]
        for kind in members:
            lines += [f"## {kind['name']}", "", escaped(kind["doc"]), ""]
            if kind.get("synonyms"):
                lines += ["Also found as: " + escaped(", ".join(kind["synonyms"])) + ".", ""]
            if kind.get("cite") in entries:
                name = label(kind["cite"], entries[kind["cite"]])
                lines += [f"Source: [{name}](../../sources.md#{kind['cite']})", ""]
            if kind.get("params"):
                lines += ["| parameter | value | default | description |", "|---|---|---|---|"]
                for param in kind["params"]:
                    default = "required" if param.get("required") else param.get("default", "")
                    default = f"`{default}`" if default not in ("", "required") else default
                    default = str(default).replace("|", "&#124;")
                    lines.append(f"| `{param['name']}` | {escaped(limits(param))} | {default} "
                                 f"| {escaped(param.get('doc', ''))} |")
                lines.append("")
            if kind.get("example"):
                lines += ["```text" if kind["example"].startswith("vug ") else "```vug", kind["example"], "```", ""]
        pages[f"reference/kinds/{file}"] = "\n".join(lines)
    pages["reference/kinds/index.md"] = "\n".join(overview) + "\n"
    return pages


def help_of(vug, *words):
    return subprocess.run([vug, *words, "--help"], capture_output=True, text=True, check=True).stdout.rstrip()


def verbs_in(text):
    block = re.search(r"^Subcommands:\n((?:  .*\n?)+)", text, re.M)
    return re.findall(r"^  (\w+)", block.group(1), re.M) if block else []


def commands_page(vug):
    top = help_of(vug)
    lines = ["# Commands", "", "Generated from `vug VERB --help`.", "", "```text", top, "```", ""]
    for verb in verbs_in(top):
        text = help_of(vug, verb)
        lines += [f"## vug {verb}", "", "```text", text, "```", ""]
        for word in verbs_in(text):
            lines += [f"### vug {verb} {word}", "", "```text", help_of(vug, verb, word), "```", ""]
    return "\n".join(lines)


def python_page(vug):
    """The stubs of the Python module next to the command, if it was built."""
    stub = pathlib.Path(vug).resolve().parent.parent / "python/vug/_vug.pyi"
    if not stub.is_file():
        return "# Python API\n\nThis site was made from a build without the Python module.\n"
    return ("# Python API\n\nThe signatures of the module; [Python](../guides/python.md) explains them.\n\n"
            f"```python\n{stub.read_text().rstrip()}\n```\n")


# Plain HTML, since mkdocs does not know the pages of Doxygen.
CPP_PAGE = """# C++ API

The <a href="../api/cpp/index.html">headers of the library</a> are documented by Doxygen;
[architecture](../architecture.md) explains the modules.
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--vug", required=True, help="the vug command")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="an empty folder")
    options = parser.parse_args()
    entries = sources()
    pages = options.out / "pages"
    for path in sorted((ROOT / "docs").rglob("*")):
        name = path.relative_to(ROOT / "docs").as_posix()
        if path.is_file() and path.suffix != ".bib":
            target = pages / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if path.suffix == ".md":
                target.write_text(converted(name, path.read_text(), entries))
            else:
                shutil.copy(path, target)
    for path in sorted((ROOT / "data").rglob("*")):
        if path.suffix in (".vug", ".json", ".svx"):
            target = pages / path.relative_to(ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target)
    generated = {"sources.md": sources_page(entries), "reference/commands.md": commands_page(options.vug),
                 "reference/python_api.md": python_page(options.vug),
                 "reference/cpp_api.md": CPP_PAGE,
                 **kinds_pages(options.vug, entries)}
    for name, text in generated.items():
        target = pages / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)
    (options.out / "mkdocs.yml").write_text(
        (HERE / "mkdocs.yml").read_text().replace("DOCS_DIR", str(pages)))


main()
