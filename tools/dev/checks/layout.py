# SPDX-License-Identifier: Apache-2.0
"""Files are in their designated folders, and every kind is listed once, in alphabetical order."""
import re

from .tree import Finding

TOP = {"CMakeLists.txt", "lib", "tools", "plugins", "tests", "data", "docs", "README.md",
       "CMakePresets.json", "LICENSE"}


def check(tree):
    for entry in sorted({name.split("/")[0] for name in tree.files}):
        if entry not in TOP and not entry.startswith("."):
            yield Finding(entry, 0, "the top level is fixed: " + " ".join(sorted(TOP)))
    for name in tree.files:
        if name.startswith("lib/vug/") and name.count("/") > 4:
            yield Finding(name, 0, "at most one folder below a module")
        if re.search(r"[A-Z]|-", name.split("/")[-1]) and name.endswith((".h", ".cpp")):
            yield Finding(name, 0, "source files are named in snake_case")
    for name in tree.select("CMakeLists.txt", under="lib/vug/"):
        yield from check_kinds(tree, name)
        yield from check_map(tree, name)


def check_map(tree, name):
    page = "docs/architecture.md"
    if page not in tree.files:
        return
    for module, folder in re.findall(r"vug_kinds\(\s*(\w+)\s+(\w+)", tree.text(name)):
        if f"`{module}/{folder}/`" not in tree.text(page):
            yield Finding(page, 0, f"does not name the folder of kinds {module}/{folder}/")


def check_kinds(tree, name):
    folder = name.rpartition("/")[0]
    for _, kinds_folder, body in re.findall(r"vug_kinds\(\s*(\w+)\s+(\w+)([^)]*)\)",
                                            tree.text(name)):
        listed = re.sub(r"#[^\n]*", "", body).split()
        if listed != sorted(listed):
            yield Finding(name, 0, f"the kinds of {kinds_folder} are not in alphabetical order")
        for kind in {kind for kind in listed if listed.count(kind) > 1}:
            yield Finding(name, 0, f"{kinds_folder} lists {kind} twice")
        place = f"{folder}/{kinds_folder}/"
        present = {path[len(place):-4] for path in tree.select(".cpp", under=place)}
        for kind in sorted(set(listed) - present):
            yield Finding(name, 0, f"{kinds_folder} lists {kind}, but {place}{kind}.cpp is missing")
        shared = re.search(r"FOLDERS[^)]*\b" + kinds_folder + r"\b", tree.text(name))
        for kind in sorted(present - set(listed)):
            if not shared:
                yield Finding(f"{place}{kind}.cpp", 0, f"not listed by vug_kinds in {name}")
