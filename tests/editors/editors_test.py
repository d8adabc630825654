# SPDX-License-Identifier: Apache-2.0
"""The language server with the library of VS Code and with Neovim, and the packages of plugins/editors."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
EDITORS = SOURCE / "plugins/editors"
VUG = os.environ["VUG"]


def require_node():
    """Node and the folder of the packages of tests/dcc/package.json."""
    program, packages = os.environ.get("VUG_NODE", ""), pathlib.Path(os.environ.get("VUG_NODE_PACKAGES", ""))
    if not shutil.which(program) or not (packages / "complete").exists():
        raise unittest.SkipTest("Node or its packages are missing: tools/dev/install_node_packages")
    return program, packages


def node(script, *arguments):
    program, packages = require_node()
    out = subprocess.run([program, HERE / script, VUG, *map(str, arguments)], cwd=packages, capture_output=True,
                         text=True, timeout=300, check=False)
    if out.returncode != 0:
        raise AssertionError(out.stderr)
    return json.loads(out.stdout)


class Server(unittest.TestCase):
    maxDiff = None

    def test_golden_requests(self):
        found = node("golden.mjs", HERE / "golden.json")
        self.assertGreaterEqual(found["requests"], 60)
        self.assertEqual(found["requests"], found["known"])
        self.assertEqual(found["different"], [])
        self.assertEqual(found["code"], 0)

    def test_neovim(self):
        program = os.environ.get("VUG_NVIM", "")
        if not shutil.which(program):
            raise unittest.SkipTest("Neovim is missing (Debian's package neovim)")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "part.vug").write_text("let ball = sphere(1m)\n")
            (folder / "main.vug").write_text(
                'include "part.vug"\nvolume v = level_set( ball, voxel: 5cm)\nmesh m on v { smooth 1s }\n')
            runtime = f"{EDITORS / 'vim'},{EDITORS / 'neovim'}"
            out = subprocess.run(
                [program, "--headless", "-u", "NONE", "-i", "NONE", "-n", "--cmd", f"set rtp^={runtime}",
                 "-c", f"luafile {HERE / 'neovim.lua'}"], cwd=folder, capture_output=True, text=True, timeout=300,
                env={**os.environ, "VUG_RESULTS": str(folder / "results.json"), "HOME": name}, check=False)
            result = json.loads((folder / "results.json").read_text()) if out.returncode == 0 else {}
            self.assertNotIn("failure", result)
            self.assertEqual(result["filetype"], "vug")
            self.assertIn("let ball = sphere(1m)", result["hover"])
            self.assertEqual(result["definition"], (folder / "part.vug").as_uri())
            self.assertGreater(result["completion"], 20)
            self.assertEqual(len(result["diagnostics"]), 1)
            self.assertEqual((folder / "part.vug").read_text(), "let globe = sphere(1m)\n")
            self.assertEqual((folder / "main.vug").read_text().splitlines()[1],
                             "volume v = level_set(globe, voxel: 5cm)")


class Packages(unittest.TestCase):
    def test_generated_files_are_up_to_date(self):
        out = subprocess.run([sys.executable, SOURCE / "tools/dev/editor_packages", VUG, "--check"],
                             capture_output=True, text=True, check=False)
        self.assertEqual((out.returncode, out.stdout), (0, ""))

    def test_highlighting_of_all_scenes_equals_semantic_tokens(self):
        scenes = sorted((SOURCE / "data").rglob("*.vug"))
        found = node("highlighting.mjs", EDITORS / "vscode/syntaxes/vug.tmLanguage.json", *scenes)
        self.assertEqual(found["different"], [])
        self.assertGreater(found["words"], 20000)
        self.assertGreater(found["statements"], 1500)

    def test_highlighting_of_a_scene(self):
        program, packages = require_node()
        out = subprocess.run(
            [program, packages / "node_modules/vscode-tmgrammar-test/dist/unit.js", "-g",
             EDITORS / "vscode/syntaxes/vug.tmLanguage.json", HERE / "scene.test.vug"],
            cwd=packages, capture_output=True, text=True, check=False)
        self.assertEqual(out.returncode, 0, out.stdout)

    def test_vim_highlights_statements(self):
        program = os.environ.get("VUG_NVIM", "")
        if not shutil.which(program):
            raise unittest.SkipTest("Neovim is missing (Debian's package neovim)")
        script = ("syntax on | edit +1 " + str(SOURCE / "data/scenes/grotto.vug") + " | set filetype=vug syntax=vug | "
                  "call search('^param') | let a = synIDattr(synID(line('.'), col('.'), 1), 'name') | "
                  "call search('level_set(') | let b = synIDattr(synID(line('.'), col('.'), 1), 'name') | "
                  "call search('#') | let c = synIDattr(synID(line('.'), col('.'), 1), 'name') | "
                  "call writefile([a, b, c], $VUG_RESULTS) | qall!")
        with tempfile.TemporaryDirectory() as name:
            results = pathlib.Path(name) / "names"
            subprocess.run([program, "--headless", "-u", "NONE", "-i", "NONE", "-n", "--cmd",
                            f"set rtp^={EDITORS / 'vim'}", "-c", script], timeout=60, check=True,
                           env={**os.environ, "VUG_RESULTS": str(results), "HOME": name})
            self.assertEqual(results.read_text().split(), ["vugStatement", "vugFunction", "vugComment"])

    def test_kate_rules_are_well_formed(self):
        from xml.etree import ElementTree
        root = ElementTree.parse(EDITORS / "kate/vug.xml").getroot()
        lists = {each.get("name") for each in root.iter("list")}
        self.assertEqual({each.get("String") for each in root.iter("keyword")}, lists)
        styles = {each.get("name") for each in root.iter("itemData")}
        used = {each.get("attribute") for each in root.iter() if each.get("attribute")}
        self.assertLessEqual(used, styles)


if __name__ == "__main__":
    unittest.main()
