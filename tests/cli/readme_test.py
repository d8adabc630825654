# SPDX-License-Identifier: Apache-2.0
"""The commands of the README work after tools/demo, which builds everything that they need."""
import pathlib
import re
import shlex
import subprocess
import unittest

from vug import PROGRAM, SOURCE, VugTest

BUILD = pathlib.Path(PROGRAM).resolve().parents[1]
README = (SOURCE / "README.md").read_text()
COMMANDS = [shlex.split(line, comments=True)[1:]
            for line in re.findall(r"^ +(build/release/bin/vug .*)$", README, re.M)]


def inputs_of(target):
    """The files from which the build makes a target."""
    graph = (BUILD / "build.ninja").read_text()
    if not re.search(rf"^build {re.escape(target)}\b.*:", graph, re.M):
        raise unittest.SkipTest(f"this build has no target {target}")
    result = subprocess.run(["ninja", "-C", BUILD, "-t", "inputs", target], capture_output=True, text=True, check=True)
    return {line.strip() for line in result.stdout.splitlines()}


class Readme(VugTest):
    def test_the_demo_builds_all_targets_and_installs_their_packages(self):
        demo = (SOURCE / "tools/demo").read_text()
        [build] = re.findall(r"cmake --build .*", demo)
        self.assertNotIn("--target", build)
        packages = (SOURCE / "tools/dev/packages").read_text()
        needed = packages[packages.index("[build]"):packages.index("[docs]")]
        for name in ("npm", "pybind11-dev", "python3-dev", "python3-numpy"):
            self.assertRegex(needed, rf"(?m)^{name} ")

    def test_the_target_vug_includes_the_page_of_vug_preview(self):
        if not (BUILD / "preview").exists():
            self.skipTest("this build has no preview page")
        self.assertTrue([name for name in inputs_of("vug") if name.endswith("plugins/preview/page.html")])

    def test_the_module_and_the_add_on_are_built_by_default(self):
        files = inputs_of("all")
        self.assertTrue([name for name in files if name.endswith("plugins/blender/vug_addon/operators.py")])
        if (BUILD / "python").exists():
            self.assertTrue([name for name in files if "python/vug/_vug." in name])

    def test_light_commands_work_as_written(self):
        ran = []
        for verb, *args in COMMANDS:
            if verb not in ("check", "tree", "derive", "list", "measure", "preview"):
                continue
            if verb == "preview" and not (BUILD / "preview/preview.html").exists():
                continue  # without access to npm's registry
            with self.subTest(verb=verb):
                self.expect(0, verb, *[SOURCE / arg if arg.startswith("data/") else arg for arg in args])
                ran.append(verb)
        self.assertGreaterEqual(len(ran), 5)
        if "preview" in ran:
            self.assertIn("<html", (self.folder / "grammar.html").read_text()[:200])

    def test_scenes_and_options_of_all_commands_exist(self):
        self.assertGreater(len(COMMANDS), 10)
        for verb, *args in COMMANDS:
            help_text = self.expect(0, verb, *(["fit"] if verb == "facade" else []), "--help").out
            for arg in args:
                if arg.startswith("data/") or arg.startswith("tests/"):
                    self.assertTrue((SOURCE / arg).exists(), arg)
                elif arg.startswith("-") and not re.search(rf"(?<![\w-]){re.escape(arg)}(?![\w-])", help_text):
                    self.fail(f"vug {verb} has no option {arg}")

    def test_inputs_exist_or_are_made_by_an_earlier_command(self):
        made = {f"out/grotto.{end}" for end in ("exr", "png", "vdb", "ply")}  # by tools/demo
        for verb, *args in COMMANDS:
            words = args[1:] if verb == "facade" else args
            for before, word in zip(["", *words], words):
                if before.startswith("-") or not re.fullmatch(r"[\w/]+\.\w+", word):
                    continue
                self.assertTrue((SOURCE / word).exists() or word in made, f"vug {verb} {word}")
            if verb == "new":
                made.add(f"{args[0]}.vug")
            if verb == "export":  # --for blender
                made.add(f"out/{pathlib.Path(args[0]).stem}.glb")
        self.assertIn("recipe", [verb for verb, *_ in COMMANDS], "a command that reads the output of another")

    def test_a_missing_page_is_reported_without_blaming_what_is_there(self):
        page = BUILD / "preview/preview.html"
        program = pathlib.Path(PROGRAM).read_bytes()
        old = str(page).encode()
        self.assertIn(old, program)
        copy = self.write("vug", program.replace(old, old[:-5] + b"_html"))
        copy.chmod(0o755)
        self.write("s.vug", "volume rock = level_set(sphere(1m), voxel: 20cm)\nmesh wall on rock {}\n")
        result = subprocess.run([copy, "preview", "s.vug"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertIn("_html' has not been built", result.stderr)
        self.assertIn("with npm installed and access to its registry", result.stderr)


if __name__ == "__main__":
    unittest.main()
