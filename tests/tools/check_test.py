# SPDX-License-Identifier: Apache-2.0
"""The checks of tools/dev/check: a small correct tree passes, and faulty trees are reported."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

GOOD = {
    "CMakeLists.txt": "",
    ".clang-format": (ROOT / ".clang-format").read_text(),
    "lib/CMakeLists.txt": "foreach(module\n    base\n    scene mesh\n    field\n    volume\n    session)\n",
    "lib/vug/base/CMakeLists.txt": "vug_module(base PUBLIC TBB::tbb)\n",
    "lib/vug/base/vec.h": "// Vectors.\n#pragma once\n",
    "lib/vug/mesh/CMakeLists.txt": "vug_module(mesh DEPENDS base)\n",
    "lib/vug/mesh/mesh.h": "// Triangles.\n#pragma once\n\n#include <vug/base/vec.h>\n",
    "lib/vug/field/CMakeLists.txt": "vug_module(field DEPENDS mesh PUBLIC fmt::fmt)\n"
                                    "vug_kinds(field primitives\n  box\n  sphere\n)\n",
    "lib/vug/field/primitives/box.cpp": '#include <vug/base/vec.h>\n// s.cite("lorensen1987")\n',
    "lib/vug/field/primitives/sphere.cpp": "#include <vug/mesh/mesh.h>\n",
    "lib/vug/volume/CMakeLists.txt": "vug_module(volume DEPENDS field)\n",
    "lib/vug/volume/grid.cpp": "// Grids.\n#include <openvdb/openvdb.h>\n",
    "lib/vug/session/CMakeLists.txt": "vug_module(session DEPENDS volume)\n",
    "docs/references.bib": "@article{lorensen1987, title = {Marching Cubes}}\n",
    "docs/tour.md": "# The tour\n\n[there](theory.md#two-words) and [here](#the-tour): `zero` in `mesh/zero.cpp`\n",
    "lib/vug/mesh/zero.cpp": "// Nothing.\nint zero() { return 0; }\n",
    "docs/theory.md": "# Theory\n\n## Two words\n\nSee [@lorensen1987].\n",
    "data/cave.vug": "seed 1\n",
    "tools/dev/phrases.txt": (ROOT / "tools/dev/phrases.txt").read_text(),
    "tools/dev/retired_names.txt": (ROOT / "tools/dev/retired_names.txt").read_text(),
}
SPDX = "SPDX-License-Identifier: Apache-2.0\n"
for _name in GOOD:
    if _name.endswith((".txt", ".vug", ".clang-format")) and not _name.startswith("tools/dev/"):
        GOOD[_name] = "# " + SPDX + GOOD[_name]
    elif _name.endswith((".h", ".cpp")):
        GOOD[_name] = "// " + SPDX + GOOD[_name]
BODY = "int zero() { return 0; }\n"


def run(changes, *names):
    """Exit code and output of the check on GOOD with some files added, changed or removed."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**GOOD, **changes}.items():
            if text is None:
                continue
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text if isinstance(text, bytes) else text.encode())
        done = subprocess.run([sys.executable, ROOT / "tools/dev/check", "--root", folder, *names],
                              capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


class CheckTest(unittest.TestCase):
    def finds(self, check, changes, *expected):
        code, output = run(changes, check)
        self.assertEqual(code, 1, output)
        for text in expected:
            self.assertIn(text, output)

    def passes(self, check, changes):
        code, output = run(changes, check)
        self.assertEqual(code, 0, output)

    def test_a_good_tree_passes_every_check(self):
        code, output = run({})
        self.assertEqual(code, 0, output)
        checks = [path for path in (ROOT / "tools/dev/checks").glob("*.py") if path.stem != "tree"]
        self.assertEqual(output.count(" ok "), len(checks), output)

    def test_unknown_check(self):
        code, output = run({}, "layer")
        self.assertEqual(code, 2)
        self.assertIn("unknown check: layer", output)

    def test_many_arguments(self):
        seven = ("const std::map<int, int>& a, int b = 0, std::function<void(int, int)> c = {}, "
                 "double* d,\n       unsigned int e, const float (&f)[3], Vec3d&&")
        self.finds("arguments", {"lib/vug/mesh/a.h": f"// A.\nvoid draw({seven});\n"},
                   "lib/vug/mesh/a.h:2", "draw takes 7 arguments, at most 6")
        self.finds("arguments", {"lib/vug/mesh/a.cpp": f"Mesh::Mesh({seven}) : a_(a) {{}}\n"},
                   "Mesh takes 7 arguments")
        self.finds("arguments", {"tools/a.py": "def draw(a, b, c, d, e, f, g=0):\n    pass\n"},
                   "tools/a.py:1", "draw takes 7 positional arguments")
        self.passes("arguments", {
            "lib/vug/mesh/a.cpp": "void f(int a, int b, int c, int d, int e, int f) { g(a, b, c, d, e, f, 1); }\n",
            "tools/a.py": "class A:\n    def draw(self, a, b, c, d, e, f, *, g=0):\n        pass\n",
            "plugins/python/a.cpp": f'void f({seven}) {{}}\nvoid b() {{ m.def("f", &f, py::kw_only()); }}\n'})

    def test_overloads_in_unity_builds(self):
        one, other = ("namespace vug {{\nnamespace {{\n\n{} draw(int n) {{ return n; }}\n\n}}  // namespace\n}}\n"
                      .format(kind) for kind in ("int", "const std::vector<int>&"))
        self.finds("overloads", {"lib/vug/mesh/a.cpp": one, "lib/vug/mesh/formats/b.cpp": other},
                   "lib/vug/mesh/formats/b.cpp:4", "lib/vug/mesh/a.cpp:4 has another internal function 'draw'")
        self.passes("overloads", {"lib/vug/mesh/a.cpp": one, "lib/vug/scan/b.cpp": other})

    def test_upward_and_sideways_includes(self):
        self.finds("layers", {"lib/vug/base/a.cpp": "#include <vug/mesh/mesh.h>\n"},
                   "lib/vug/base/a.cpp:1", "base includes up")
        self.finds("layers", {"lib/vug/mesh/a.cpp": "\n#include <vug/scene/scene.h>\n"},
                   "lib/vug/mesh/a.cpp:2", "mesh includes sideways")

    def test_includes_need_a_dependency(self):
        self.finds("layers", {"lib/vug/volume/CMakeLists.txt": "vug_module(volume DEPENDS base)\n",
                              "lib/vug/volume/a.cpp": "#include <vug/mesh/mesh.h>\n"},
                   "add mesh to the DEPENDS of volume")
        self.passes("layers", {"lib/vug/volume/a.cpp": "#include <vug/mesh/mesh.h>\n"})

    def test_include_style_and_unknown_modules(self):
        self.finds("layers", {"lib/vug/mesh/a.cpp": '#include "mesh.h"\n'}, "write #include <vug/")
        self.finds("layers", {"lib/vug/mesh/a.cpp": "#include <vug/rocks/a.h>\n"}, "unknown module")
        self.finds("layers", {"lib/vug/rocks/a.cpp": BODY}, "not in the list")

    def test_wrappers_of_libraries(self):
        for library, owner in (("openvdb/openvdb.h", "volume"), ("embree3/rtcore.h", "raytree and render"),
                               ("OpenImageIO/imageio.h", "image"), ("OpenEXR/ImfArray.h", "image")):
            self.finds("layers", {"lib/vug/field/a.cpp": f"#include <{library}>\n"},
                       f"only {owner} may include {library}")

    def test_include_cycles(self):
        self.finds("layers", {"lib/vug/mesh/a.h": "#pragma once\n#include <vug/mesh/b.h>\n",
                              "lib/vug/mesh/b.h": "#pragma once\n#include <vug/mesh/a.h>\n"},
                   "include cycle: lib/vug/mesh/a.h -> lib/vug/mesh/b.h -> lib/vug/mesh/a.h")

    def test_heavy_headers_stay_private(self):
        private = {"lib/vug/volume/vdb.h": "#pragma once\n#include <openvdb/openvdb.h>\n",
                   "lib/vug/volume/step.h": "#pragma once\n#include <vug/volume/vdb.h>\n",
                   "lib/vug/volume/a.cpp": "#include <vug/volume/step.h>\n"}
        self.passes("layers", private)
        self.finds("layers", {**private, "lib/vug/session/a.cpp": "#include <vug/volume/step.h>\n"},
                   "brings openvdb/openvdb.h into another module")

    def test_internal_headers(self):
        internal = {"lib/vug/mesh/in.h": f"// {SPDX}// Internal to mesh/: a detail.\n#pragma once\n"}
        self.passes("layers", {**internal, "lib/vug/mesh/a.cpp": "#include <vug/mesh/in.h>\n"})
        self.finds("layers", {**internal, "lib/vug/mesh/a.h": "// A.\n#pragma once\n#include <vug/mesh/in.h>\n"},
                   "vug/mesh/in.h is internal and not installed")
        self.finds("layers", {**internal, "lib/vug/field/a.cpp": "#include <vug/mesh/in.h>\n"},
                   "vug/mesh/in.h is internal to its module")

    def test_sizes(self):
        self.finds("sizes", {"lib/vug/mesh/a.cpp": "\n" * 601}, "601 lines, at most 600")
        self.passes("sizes", {"lib/vug/mesh/a.cpp": "\n" * 600})
        self.passes("sizes", {"lib/vug/mesh/a_table.h": "\n" * 601})
        self.assertIn("a.cpp: note: 401 lines", run({"tools/a.cpp": "\n" * 401}, "sizes")[1])
        self.finds("sizes", {f"lib/vug/base/a{i}.cpp": "\n" * 130 for i in range(20)},
                   "the median file has 130 lines")

    def test_format(self):
        self.finds("format", {"lib/vug/mesh/a.cpp": "int  a;\n"}, "a.cpp:1: not formatted")

    def test_spelling(self):
        self.finds("spelling", {"docs/a.md": "rec" + "ieve\n"}, "docs/a.md:1")
        self.passes("spelling", {"docs/a.md": "rec" + "ieve\n",
                                 "tools/dev/spelling.txt": "rec" + "ieve\n"})

    def test_scenes(self):
        scene = {"data/scenes/a.vug": "# A ball. Round.\nseed 1\n"}
        line = "- [a](../../data/scenes/a.vug): A ball."
        self.passes("scenes", {**scene, "docs/reference/scenes.md": line + "\n"})
        self.finds("scenes", {**scene, "docs/reference/scenes.md": ""}, line)
        self.finds("scenes", {**scene, "docs/reference/scenes.md": line + "\n" + line.replace("a", "b")}, "b.vug")
        self.finds("scenes", {**scene, "docs/reference/scenes.md": line[:-5] + "\n"}, "docs/reference/scenes.md:1")
        self.finds("scenes", {"data/scenes/a.vug": "seed 1\n"}, "data/scenes/a.vug:1")

    def test_forbidden_in_the_library(self):
        for code in ("std::sin(x)", "std::pow(x, y)", "sinf(x)", "std::cout << 1", "printf(text)",
                     "exit(1)", "std::abort()", "throw std::runtime_error(text)", "std::mt19937 g",
                     "std::rand()", "std::chrono::system_clock::now()"):
            bad = f"void f() {{ {code}; }}\n"
            self.finds("forbidden", {"lib/vug/field/a.cpp": bad}, "lib/vug/field/a.cpp:1")
            self.passes("forbidden", {"lib/vug/field/a.cpp": f"// {code}\n"})
            self.passes("forbidden", {"tests/a.cpp": bad})
        self.passes("forbidden", {"lib/vug/field/a.cpp": "void f() { sin(x); std::sqrt(x); }\n"})
        self.passes("forbidden", {"lib/vug/base/a.cpp": "void f() { std::sin(x); }\n"})

    def test_forbidden_in_headers(self):
        self.finds("forbidden", {"lib/vug/mesh/a.h": BODY}, "#pragma once")
        self.finds("forbidden", {"lib/vug/mesh/a.h": "// A.\n#pragma once\nusing namespace std;\n"}, "a.h:3")
        self.finds("forbidden", {"lib/vug/mesh/a.h": "#pragma once\n"}, "starts with a comment")

    def test_forbidden_everywhere(self):
        for text in ("// TO" + "DO: more", "ST" + "UB: what it is", "see /" + "root/a", "http://deb.deb" + "ian.org/x"):
            self.finds("forbidden", {"tools/a.sh": text + "\n"}, "tools/a.sh:1")
        self.passes("forbidden", {"tools/a.sh": "$root/work ~/home/a build/work/x\n"})

    def test_layout(self):
        self.finds("layout", {"scripts/a.sh": ""}, "the top level is fixed")
        self.finds("layout", {"lib/vug/mesh/a/b/c.cpp": BODY}, "at most one folder below a module")
        self.finds("layout", {"lib/vug/mesh/MyMesh.cpp": BODY}, "snake_case")

    def test_index_of_the_sources(self):
        page = ("# Architecture\n\n`field/primitives/`\n\n## Index of the sources\n\n"
                "The first sentence of each file of the library, and of the programs and tests that have one. Folders\n"
                "of kinds contain one file per kind. A header without a source of its name is followed by the sources "
                "that\ndefine its functions. `tools/dev/source_index` writes this list.\n\n"
                "### base\n\n- `base/vec.h`: Vectors.\n\n"
                "### mesh\n\n- `mesh/mesh.h`: Triangles.\n- `mesh/zero.cpp`: Nothing.\n")
        # Modules without headers are not in the index.
        self.passes("source_index", {"docs/architecture.md": page})
        self.finds("source_index", {"docs/architecture.md": page.replace("Triangles", "Polygons")}, "out of date")
        self.finds("source_index", {"docs/architecture.md": page, "lib/vug/mesh/weld.h": "// Welding.\n"},
                   "out of date")
        self.finds("source_index", {"lib/vug/mesh/weld.cpp": BODY}, "needs a header comment")
        for name, text in (("run", "#!/usr/bin/env bash\n# SPDX-License-Identifier: Apache-2.0\n"
                                   "# tools/dev/run [--all]\n# Runs it. Or not.\n\n# More.\n"),
                           ("run.py", "#!/usr/bin/env python3\n# SPDX-License-Identifier: Apache-2.0\n"
                                      '"""Runs\nit.\n\nOr not."""\n')):
            index = page + f"\n### tools/dev\n\n- `tools/dev/{name}`: Runs it.\n"
            self.passes("source_index", {"docs/architecture.md": index, f"tools/dev/{name}": text})
        header = {"lib/vug/mesh/weld.h": "// SPDX-License-Identifier: Apache-2.0\n// Welding.\n#pragma once\n"
                                         "struct Welder {\n  Welder();\n  int count() const { return sum(3); }\n};\n"
                                         "int weld(int mesh = {});\n"}
        for body, source in (("int weld(int mesh) { return mesh; }\n", " (in `mesh/join.cpp`)"),
                             ("Welder::Welder() {}\n", " (in `mesh/join.cpp`)"),
                             ("int twice() { return weld(2); }\nOther::weld() {}\nint sum(int n) { return n; }\n", "")):
            other = "// SPDX-License-Identifier: Apache-2.0\n// Joins.\n#include <vug/mesh/weld.h>\n" + body
            lines = (f"### mesh\n\n- `mesh/join.cpp`: Joins.\n- `mesh/mesh.h`: Triangles.\n"
                     f"- `mesh/weld.h`{source}: Welding.\n")
            index = page.replace("### mesh\n\n- `mesh/mesh.h`: Triangles.\n", lines)
            self.passes("source_index", {"docs/architecture.md": index, "lib/vug/mesh/join.cpp": other} | header)

    def test_kinds_are_listed_once_and_in_order(self):
        name = "lib/vug/field/CMakeLists.txt"
        self.finds("layout", {name: GOOD[name].replace("box\n  sphere", "sphere\n  box")},
                   "not in alphabetical order")
        self.finds("layout", {name: GOOD[name].replace("box", "box box")}, "lists box twice")
        self.finds("layout", {name: GOOD[name].replace("box", "box cone")}, "cone.cpp is missing")
        self.finds("layout", {"lib/vug/field/primitives/cone.cpp": BODY}, "not listed by vug_kinds")

    def test_links(self):
        self.finds("links", {"docs/a.md": "\n[x](nowhere.md)\n"}, "docs/a.md:2")
        self.finds("links", {"docs/a.md": "[x](theory.md#three-words)\n"}, "unknown heading")
        self.finds("links", {"docs/a.md": "![x](picture.png)\n"}, "picture.png")
        self.passes("links", {"docs/a.md": "```\n[x](nowhere.md)\n```\n[y](https://a.b/c)\n"})
        navigation = {"tools/docs.d/mkdocs.yml": "nav:\n  - One: guides/one.md\n"}
        self.passes("links", {"docs/guides/one.md": "# One\n", **navigation})
        self.finds("links", {"docs/guides/two.md": "# Two\n", **navigation},
                   "guides/two.md is not in the navigation")

    def test_paths(self):
        for text, what in (("see `mesh/nowhere.cpp`", "docs/a.md:2: missing file: mesh/nowhere.cpp"),
                           ("`lib/nowhere/`", "missing file: lib/nowhere/"),
                           ("`one` in\n`mesh/zero.cpp`", "mesh/zero.cpp does not contain one"),
                           ("| `mesh/zero.cpp`, `Zero::one` |", "mesh/zero.cpp does not contain Zero")):
            self.finds("paths", {"docs/a.md": "\n" + text + "\n"}, what)
        self.passes("paths", {"docs/a.md": "`a / b`, `out/a.vdb`, `lib/vug/mesh/`, `field/primitives/box.cpp`"
                                           "\n```\n`mesh/nowhere.cpp`\n```\n"})

    def test_pictures(self):
        def jpeg(marker):
            return b"\xff\xd8\xff\xe0\x00\x04ab\xff" + marker + b"\x00\x04cd\xff\xda\x00\x02\xff\xe1"
        for marker in (b"\xe1", b"\xed", b"\xfe"):
            self.finds("pictures", {"docs/images/a.jpg": jpeg(marker)}, "docs/images/a.jpg: it has metadata")
        self.passes("pictures", {"docs/images/a.jpg": jpeg(b"\xdb"), "data/photo.jpg": jpeg(b"\xe1")})

    def test_citations(self):
        self.finds("citations", {"lib/vug/mesh/a.cpp": 'void f() { s.cite("nobody1999"); }\n'},
                   "nobody1999 is not in docs/references.bib")
        self.finds("citations", {"docs/a.md": "as in [@nobody1999]\n"}, "docs/a.md:1")
        self.finds("citations", {"docs/references.bib": GOOD["docs/references.bib"] * 2}, "twice")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
