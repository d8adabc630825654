# SPDX-License-Identifier: Apache-2.0
"""Files are small: a note above 400 lines (150 for headers), a finding above 600."""
import statistics

from .tree import Finding, module_of

NOTE, NOTE_HEADER, FAIL = 400, 150, 600
MEDIAN = 53
EXEMPT = ("_table.h", "_table.cpp")  # generated or measured numbers


def check(tree):
    modules = {}
    for name in tree.select(".h", ".cpp", ".py", ".cmake", "CMakeLists.txt"):
        lines = tree.text(name).count("\n")
        limit = NOTE_HEADER if name.endswith(".h") and name.startswith("lib/") else NOTE
        if name.startswith("lib/vug/") and name.endswith((".h", ".cpp")):
            modules.setdefault(module_of(name), []).append(lines)
        if name.endswith(EXEMPT):
            continue
        if lines > FAIL:
            yield Finding(name, 0, f"{lines} lines, at most {FAIL} are allowed: split the file")
        elif lines > limit:
            yield Finding(name, 0, f"{lines} lines, more than the recommended {limit}", note=True)
    everything = [size for sizes in modules.values() for size in sizes]
    if not everything:
        return
    median = statistics.median(everything)
    if median > MEDIAN:
        yield Finding("lib", 0, f"the median file has {median:g} lines, at most {MEDIAN} are allowed")
    yield Finding("", 0, f"{len(everything)} files of lib: median {median:g} lines (at most {MEDIAN}), "
                  f"longest {max(everything)} (at most {FAIL}); medians: " + ", ".join(
                      f"{module} {statistics.median(sizes):g}"
                      for module, sizes in sorted(modules.items())), note=True)
