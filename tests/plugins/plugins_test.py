# SPDX-License-Identifier: Apache-2.0
"""The plugins of plugins/hello_*: built against an installed Vug, loaded, refused."""
import json
import math
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM, BUILD = os.environ["VUG"], os.environ["VUG_BUILD"]
COMPILER, PYTHON = os.environ["CXX"], os.environ["VUG_MODULE_PYTHON"]
SOURCE = pathlib.Path(__file__).resolve().parents[2]

SCENE = """volume glass = level_set(lens(radius: 2m, thickness: 1m), voxel: 4cm)
mesh wall on glass {}
"""
WARM = SCENE + """cells skin on wall {
  spacing 10cm  files ["csv"]
  run set("heat", 1), cooling(rate: 10%, begin: 1, steps: 3)
}
"""
STALE = """extern "C" const char* vug_plugin_interface() { return "interface 0 of vug 0.0.9"; }
extern "C" void vug_plugin_kinds(void*) { __builtin_trap(); }
"""


def run(*command, **options):
    return subprocess.run([str(c) for c in command], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=500, **options)


def need(*command):
    done = run(*command)
    if done.returncode:
        raise AssertionError(f"{command}\n{done.stdout}{done.stderr}")


class Plugins(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        room = tempfile.TemporaryDirectory(prefix="vug_plugins_")
        cls.addClassCleanup(room.cleanup)
        cls.room = pathlib.Path(room.name)
        need("cmake", "--install", BUILD, "--prefix", cls.room / "prefix")
        cls.lens = cls.build("hello_primitive", SOURCE / "plugins/hello_primitive")
        cls.cooling = cls.build("hello_rule", SOURCE / "plugins/hello_rule")

    @classmethod
    def build(cls, name, source):
        folder = cls.room / "build" / source.name
        need("cmake", "-S", source, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             f"-DCMAKE_PREFIX_PATH={cls.room / 'prefix'}", f"-DCMAKE_CXX_COMPILER={COMPILER}")
        need("cmake", "--build", folder)
        return folder / f"{name}.so"

    def setUp(self):
        (self.room / "lens.vug").write_text(SCENE)
        (self.room / "warm.vug").write_text(WARM)

    def vug(self, code, *args, path=""):
        done = run(PROGRAM, *args, cwd=self.room, env={**os.environ, "VUG_PLUGIN_PATH": path})
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout if code == 0 else done.stderr

    def test_a_primitive(self):
        # Without the plugin, 'lens' is only a section of passages.
        self.assertIn("'lens' has no parameter 'radius'", self.vug(2, "check", "lens.vug"))
        report = json.loads(self.vug(0, "measure", "lens.vug", "--json", "--plugin", self.lens))
        cap = 0.5  # height of each half in metres
        self.assertAlmostEqual(report["volume"] / (2 * math.pi * cap**2 * (3 * 2 - cap) / 3), 1, delta=2e-3)
        self.assertAlmostEqual(report["area"] / (2 * 2 * math.pi * 2 * cap), 1, delta=2e-3)
        listed = self.vug(0, "--plugin", self.lens, "list", "lens")
        self.assertIn("lens (primitive): ", listed)
        (self.room / "bad.vug").write_text(SCENE.replace("1m", "4m"))
        self.assertIn("bad.vug:1:26: error: the thickness of a lens must be less than the diameter of its balls",
                      self.vug(2, "check", "bad.vug", "--plugin", self.lens))

    def test_a_rule(self):
        folders = f"/nowhere:{self.lens.parent}:{self.cooling.parent}"
        self.vug(0, "build", "warm.vug", "-o", "out", path=folders)
        lines = (self.room / "out/warm_skin.csv").read_text().splitlines()
        heat = lines[0].split(",").index("heat")
        # Uniform heat stays uniform, and three steps leave 0.9^3 of it.
        for line in lines[1:]:
            self.assertAlmostEqual(float(line.split(",")[heat]), 0.9**3, places=5)
        self.assertGreater(len(lines), 300)
        one = run(PROGRAM, "build", "warm.vug", "-o", "one", "--threads", "1", cwd=self.room,
                  env={**os.environ, "VUG_PLUGIN_PATH": folders})
        self.assertEqual(one.returncode, 0, one.stderr)
        self.assertEqual((self.room / "one/warm_skin.csv").read_bytes(),
                         (self.room / "out/warm_skin.csv").read_bytes())

    def test_rejected_input(self):
        broken = self.room / "broken"
        broken.mkdir()
        stale = broken / "stale.so"
        (self.room / "stale.cpp").write_text(STALE)
        need(COMPILER, "-shared", "-fPIC", self.room / "stale.cpp", "-o", stale)
        error = self.vug(2, "list", "--plugin", stale)
        self.assertIn(f"error: the plugin '{stale}' was built for interface 0 of vug 0.0.9, but this is "
                      "interface 1 of vug ", error)
        self.assertIn("hint: rebuild it with the headers of this version", error)
        empty = broken / "empty.so"
        (self.room / "empty.cpp").write_text("")
        need(COMPILER, "-shared", "-fPIC", self.room / "empty.cpp", "-o", empty)
        self.assertIn("is not a plugin: it lacks VUG_PLUGIN", self.vug(2, "list", "--plugin", empty))
        done = run(PROGRAM, "check", "lens.vug", cwd=self.room, env={
            **os.environ, "VUG_PLUGIN_PATH": f"{broken}:{self.lens.parent}"})
        self.assertEqual(done.returncode, 0, done.stderr)  # unusable plugins of the path are skipped
        self.assertIn(f"warning: the plugin '{stale}' was built for interface 0 of vug 0.0.9", done.stderr)
        self.assertIn(f"warning: the plugin '{empty}' is not a plugin", done.stderr)
        done = run(PROGRAM, "check", "lens.vug", cwd=self.room, env={
            **os.environ, "VUG_PLUGIN_PATH": str(broken)})
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("'lens' has no parameter 'radius'", done.stderr)
        self.assertIn("no such file", self.vug(2, "list", "--plugin", "nowhere.so"))
        self.assertIn("cannot be loaded", self.vug(2, "list", "--plugin", "lens.vug"))
        self.assertIn("it is a folder", self.vug(2, "list", "--plugin", "."))

    def test_names_that_already_exist(self):
        self.vug(0, "check", "lens.vug", "--plugin", self.lens, "--plugin", self.lens)
        copy = self.room / "copy.so"
        shutil.copy(self.lens, copy)
        self.assertIn("provides a field 'lens', which already exists",
                      self.vug(2, "check", "lens.vug", "--plugin", self.lens, "--plugin", copy))

    @unittest.skipUnless(PYTHON, "the Python module is missing")
    def test_python(self):
        program = f"""
import warnings
import vug
vug.load_plugin({str(self.lens)!r})
scene = vug.load("lens.vug")
print("genus", scene.measure()["genus"])
print(vug.catalogue["lens"].category)
vug.load_plugin({str(self.lens)!r})
try:
    vug.load_plugin({str(self.cooling)!r})
except vug.Error as error:
    print("late" if "loaded too late" in str(error) else error)
"""
        environment = {**os.environ, "PYTHONPATH": f"{BUILD}/python", "VUG_PLUGIN_PATH": ""}
        done = run(PYTHON, "-c", program, cwd=self.room, env=environment)
        self.assertEqual(done.stdout.split(), ["genus", "0", "primitive", "late"], done.stderr)
        environment["VUG_PLUGIN_PATH"] = f"{self.lens.parent}:{self.cooling.parent}"
        done = run(PYTHON, "-c", "import vug; print(len(vug.load('warm.vug').build().cells('skin')) > 300)",
                   cwd=self.room, env=environment)
        self.assertEqual(done.stdout, "True\n", done.stderr)


if __name__ == "__main__":
    unittest.main()
