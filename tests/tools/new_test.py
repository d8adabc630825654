# SPDX-License-Identifier: Apache-2.0
"""tools/dev/new on a copy of the tree: the files it writes are listed, in order, and compile.

    new_test.py BUILD    the build folder whose compile_commands.json says how to compile
"""
import difflib
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = None
sys.path.insert(0, str(ROOT / "tools/dev"))
sys.dont_write_bytecode = True
from checks.tree import Tree  # noqa: E402

TEMPLATES = ROOT / "tools/dev/templates"
KINDS = sorted(path.stem for path in TEMPLATES.glob("*.cpp") if not path.stem.endswith("_test"))


def place_of(kind):
    return (TEMPLATES / f"{kind}.cpp").read_text().splitlines()[0].split()[1].rstrip(",")


class NewTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.tree = pathlib.Path(self.folder.name)
        for name in Tree(ROOT).select(".h", ".cpp", ".txt", ".cmake", ".clang-format"):
            if not name.startswith("tests/") or name.startswith("tests/unit"):
                (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / name, self.tree / name)

    def tearDown(self):
        self.folder.cleanup()

    def new(self, *words):
        return subprocess.run([sys.executable, ROOT / "tools/dev/new", *words, "--root", self.tree],
                              capture_output=True, text=True)

    def syntax_errors(self, file, like):
        """Compiler errors of `file`, compiled with the command of the build's file `like`."""
        for entry in json.loads((BUILD / "compile_commands.json").read_text()):
            folder = pathlib.Path(entry["file"]).parent
            if folder.name == "Unity":  # BUILD/lib/vug/field/CMakeFiles/vug_field.dir/Unity
                folder = ROOT / folder.parents[2].relative_to(BUILD)
            if folder in (like, like.parent):
                break
        else:
            self.fail(f"no file of {like} is built")
        words = [word for word in shlex.split(entry["command"]) if "ccache" not in word]
        end = words.index("-o")
        # These lists stand in for those written by CMake and contain the new name.
        includes = [f"-I{self.tree}/build/include", f"-I{self.tree}/lib"]
        done = subprocess.run([words[0], *includes, *words[1:end], "-fsyntax-only", "-c", file],
                              cwd=entry["directory"], capture_output=True, text=True)
        return done.stderr if done.returncode else ""

    def write_lists(self):
        """Writes the files that CMake generates from the lists of kinds, families and verbs."""
        calls = ["cmake_minimum_required(VERSION 3.25)",
                 f"include({self.tree}/tools/cmake/VugKinds.cmake)",
                 f"include({self.tree}/lib/families.cmake)"]
        for name in Tree(self.tree).select("CMakeLists.txt"):
            calls += re.findall(r"^vug_kinds\([^)]*\)", (self.tree / name).read_text(), re.M)
        calls.append(f"vug_registries({self.tree}/build/include/vug)")
        script = self.tree / "build/registries.cmake"
        script.parent.mkdir(exist_ok=True)
        script.write_text("\n".join(calls))
        subprocess.run(["cmake", "-P", script], check=True)
        verbs = self.tree / "tools/vug/CMakeLists.txt"
        if verbs.exists():
            body = re.search(r"set\(verbs\b([^)]*)\)", verbs.read_text()).group(1)
            (self.tree / "build/include/verbs.inc").write_text(
                "".join(f"VUG_VERB({verb})\n" for verb in body.split()))

    def test_every_template_gives_a_kind_that_compiles(self):
        for kind in KINDS:
            with self.subTest(kind=kind):
                place = place_of(kind)
                self.assertTrue((ROOT / place).is_dir(), f"the folder of the template is {place}")
                name = f"brand_new_{kind}"
                done = self.new(kind, name)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(f"{place}/{name}.cpp", done.stdout)
                cmake = (self.tree / place).parent / "CMakeLists.txt"
                self.assertEqual(len(re.findall(rf"\b{name}\b", cmake.read_text())), 1)
                self.assertIn("ST" + "UB", (self.tree / place / f"{name}.cpp").read_text())
                self.write_lists()
                errors = self.syntax_errors(self.tree / place / f"{name}.cpp", ROOT / place)
                self.assertEqual(errors, "")
        layout = subprocess.run([sys.executable, ROOT / "tools/dev/check", "--root", self.tree,
                                 "layout"], capture_output=True, text=True)
        self.assertEqual(layout.returncode, 0, layout.stdout)

    def texts(self):
        return {name: (self.tree / name).read_text() for name in Tree(self.tree).files}

    def test_a_kind_is_one_file_and_one_line(self):
        for kind in KINDS:
            with self.subTest(kind=kind):
                place, name = place_of(kind), f"one_more_{kind}"
                before = self.texts()
                self.assertEqual(self.new(kind, name).returncode, 0)
                after = self.texts()
                self.assertLessEqual(set(before), set(after))
                in_tests = {path for path in after if path.startswith("tests/")}
                self.assertEqual(set(after) - set(before) - in_tests, {f"{place}/{name}.cpp"})
                changed = {path for path in before if before[path] != after[path]}
                listed = place.rpartition("/")[0] + "/CMakeLists.txt"
                self.assertEqual(changed - in_tests, {listed})
                lines = [line for line in difflib.ndiff(before[listed].split("\n"),
                                                        after[listed].split("\n"))
                         if line[0] in "+-"]
                self.assertEqual(lines, [f"+   {name}"])
                for path in in_tests & (changed | set(after) - set(before)):
                    self.assertIn(f"{name}_test", path + after[path])

    def documented_changes(self, of_a_kind):
        """The diffs of docs/adding.md that add a file, or the others."""
        changes = re.findall(r"^```diff\n(.*?)^```$", (ROOT / "docs/adding.md").read_text(), re.M | re.S)
        return [change for change in changes if ("--- /dev/null" in change) == of_a_kind]

    def apply(self, change):
        done = subprocess.run(["git", "apply", "-C1", "-"], cwd=self.tree, input=change,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_render_setting_in_the_documentation(self):
        """A member and its row in one file, and one line that uses it; the table compiles with it."""
        change, = self.documented_changes(of_a_kind=False)
        table, use = re.findall(r"^\+\+\+ b/(.*)", change, re.M)
        lines = [re.findall(r"^[+-](?![+-]).*", part, re.M) for part in re.split(r"^--- .*\n", change, flags=re.M)[1:]]
        self.assertFalse(any(line.startswith("-") for part in lines for line in part))
        self.assertEqual((table, len(lines[1])), ("lib/vug/shot/render_settings.h", 1))
        self.assertEqual("\n".join(lines[0]).count(".param("), 1)
        self.apply(change)
        self.write_lists()
        for file in ("lib/vug/shot/render_settings.cpp", use):
            self.assertEqual(self.syntax_errors(self.tree / file, (ROOT / file).parent), "")

    def test_the_changes_in_the_documentation(self):
        changes = self.documented_changes(of_a_kind=True)
        self.assertGreaterEqual(len(changes), 6)
        for change in changes:
            files = re.findall(r"^\+\+\+ b/(.*)", change, re.M)
            with self.subTest(files=files):
                made = [file for file in files if not (self.tree / file).exists()]
                lists = [file for file in files
                         if file.endswith("CMakeLists.txt") or file == "lib/families.cmake"]
                self.assertEqual((len(files), len(made), len(lists)), (2, 1, 1))
                lines = re.findall(r"^[+-](?![+-]).*", change.partition("--- /dev/null")[0], re.M)
                line = f"+  {pathlib.Path(made[0]).stem}"
                if lists == ["lib/families.cmake"]:
                    line = f"+vug_family({made[0].split('/')[2]} "
                self.assertEqual([each[:len(line)] for each in lines], [line])
                self.apply(change)
                self.write_lists()
                new, like = self.tree / made[0], ROOT / made[0].rpartition("/")[0]
                if new.suffix == ".h":  # a family: compile what CMake generates from its line
                    new = self.tree / "build/include/vug/loading/scene_families.cpp"
                    like = ROOT / "lib/vug/loading"
                    self.assertIn(made[0].removeprefix("lib/"), new.read_text())
                self.assertEqual(self.syntax_errors(new, like), "")

    def test_its_first_test_compiles_and_is_listed(self):
        self.assertEqual(self.new("primitive", "egg").returncode, 0)
        tests = self.tree / "tests/unit/field"
        text = (tests / "CMakeLists.txt").read_text()
        self.assertTrue("SOURCES" not in text or "egg_test.cpp" in text, text)
        self.write_lists()
        errors = self.syntax_errors(tests / "egg_test.cpp", ROOT / "tests/unit/field")
        self.assertEqual(errors, "")

    def test_refusals(self):
        cases = {("primitive", "Egg"): "invalid name", ("primitive", "9lives"): "invalid name",
                 ("primitive", "../egg"): "invalid name", ("primitive", "sphere"): "already",
                 ("deformer", "sphere"): "already", ("primitives", "egg"): "unknown template"}
        for words, reason in cases.items():
            done = self.new(*words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertIn(reason, done.stderr)
        self.assertEqual(self.new("primitive").returncode, 2)

    def test_a_name_twice(self):
        self.assertEqual(self.new("light", "glow").returncode, 0)
        self.assertEqual(self.new("light", "glow").returncode, 2)
        self.assertEqual(self.new("material", "glow").returncode, 0)


if __name__ == "__main__":
    BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
