# SPDX-License-Identifier: Apache-2.0
"""The add-on in a Blender with a window on a virtual screen (Xvfb): its event loop, Esc and undo, which a headless
Blender lacks. in_window.py runs inside Blender."""
import os
import shutil
import subprocess
import sys
import unittest

from external_tools import HERE, VugTest, require_blender, skip

SCENE = """param R = 70cm  in 50cm..1m  "radius of the ball"
volume rock = level_set(sphere(R), voxel: 5cm)
mesh wall on rock {}
camera main { eye (0, 0, 4) }
render main { size 320x160 spp 1 }
"""


class Window(VugTest):
    def prepare(self):
        self.write("cave.vug", SCENE)
        self.write("slow.vug", SCENE.replace("voxel: 5cm", "voxel: 4mm"))

    def screen(self):
        """The number of a virtual screen that exists until the test ends."""
        there, told = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(told), "-screen", "0", "1280x800x24", "-nolisten", "tcp"],
                                  pass_fds=[told], stderr=subprocess.DEVNULL)
        os.close(told)
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        with os.fdopen(there) as said:
            return said.readline().strip()

    def test_clicks_and_keys(self):
        program = require_blender()
        own = {f"BLENDER_USER_{name}": str(self.folder / name.lower())
               for name in ("CONFIG", "SCRIPTS", "DATAFILES")}
        path = f"{os.path.dirname(program)}:{os.environ['PATH']}"
        done = subprocess.run(
            [program, "--factory-startup", "--enable-event-simulate", "--window-geometry", "0", "0", "1280", "800",
             "--python-exit-code", "1", "--python", HERE / "in_window.py", "--", self.folder,
             HERE.parents[1] / "plugins/blender"],
            capture_output=True, text=True, timeout=300,
            env={**os.environ, **own, "PATH": path, "DISPLAY": f":{self.screen()}", "LIBGL_ALWAYS_SOFTWARE": "1"})
        print("\n".join(line for line in done.stdout.splitlines() if line.startswith("ok ")), file=sys.stderr)
        self.assertIn("\nALL GOOD\n", done.stdout, done.stdout[-5000:] + done.stderr[-5000:])
        self.assertEqual(done.returncode, 0)
        self.assertNotIn("Traceback", done.stdout + done.stderr)


if __name__ == "__main__":
    require_blender()
    if not shutil.which("Xvfb"):
        skip("no virtual screen (Debian's package xvfb)")
    unittest.main()
