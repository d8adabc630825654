# SPDX-License-Identifier: Apache-2.0
"""Handles of the text in the picture, presets, and the display of the light, by the mouse."""
import json
import os
import re
import signal
import subprocess
import time
import unittest

from studio import HERE, PROGRAM, StudioTest, require_studio

SCENE = """# A ball and two lights.
param RADIUS = 50cm in 10cm..90cm  "radius of the ball"
let ball = sphere(radius: RADIUS)
let block = box(size: (0.4, 0.4, 0.4)).translate((1.00, 0, 0.2))
material stone = lambert(albedo: (0.5, 0.4, 0.3))
light key  = sphere(center: (-90cm, 0.8m, 0.5),  radius: 6cm, lumen: 900)  # the key
light spot = spot(center: (0.9m, 0.9m, 0.4m), direction: (-0.5, -1, 0), lumen: 400)
volume solid = level_set(union([ball, block]), voxel: 5cm)
mesh ball on solid { }
object ball on ball { material stone }
camera main { eye (0.4, 0.8, 4)  target (0, 0, 0)  fov 50deg }
render main { size 320x180  spp 4 }
"""
NUMBER = r"(-?[\d.]+)(cm|m|)"


def line_of(path, word):
    return next(line for line in path.read_text().splitlines() if line.startswith(word))


class Handles(StudioTest):
    def prepare(self):
        super().prepare()
        self.scene.write_text(SCENE)

    @property
    def scene(self):
        return self.folder / "scene.vug"

    def metres(self, line):
        return [float(value) * (0.01 if unit == "cm" else 1)
                for value, unit in re.findall(NUMBER, line.split("center: (")[1].split(")")[0])]

    def test_all_functions(self):
        self.studio((HERE / "handles.txt").read_text(), "--scene")
        before = line_of(self.scene, "light key")
        dragged, undone, lifted, turned = (self.folder / f"{name}.vug"
                                           for name in ("dragged", "undone", "lifted", "turned"))
        self.assertEqual(undone.read_text(), SCENE)
        # Only the numbers differ, and their units and the spaces stay.
        shape = re.sub(NUMBER, r"#\2", before)
        self.assertEqual(re.sub(NUMBER, r"#\2", line_of(dragged, "light key")).replace("#m)", "#)"),
                         shape.replace("0.5)", "#)"))
        self.assertEqual(dragged.read_text().replace(line_of(dragged, "light key"), before), SCENE)
        start, moved = self.metres(before), self.metres(line_of(dragged, "light key"))
        self.assertGreater(moved[0], start[0] + 0.1)
        self.assertGreater(moved[1], start[1] + 0.05)
        # Along y, the other numbers keep their texts.
        self.assertRegex(line_of(lifted, "light key"), r"center: \(-90cm, [\d.]+m, 0.5\),  radius: 6cm")
        self.assertGreater(self.metres(line_of(lifted, "light key"))[1], start[1] + 0.05)
        self.assertNotIn("direction: (-0.5, -1, 0)", turned.read_text())
        self.assertRegex(line_of(turned, "let block"), r"translate\(\(1\.\d+, ")
        images = {name: (self.folder / f"{name}.png").read_bytes()
                  for name in ("handles", "none", "path", "bright", "restored")}
        self.assertNotEqual(images["handles"], images["none"])
        self.assertNotEqual(images["path"], images["bright"])
        self.assertEqual(images["path"], images["restored"])

    def test_presets_survive_a_killed_window(self):
        self.script(f"open {self.scene}\nparam RADIUS 70cm\nsave_preset big\nsave_preset other\nlock_preset big\n"
                    "wait 60000")
        process = subprocess.Popen([PROGRAM, "--scene", "--script", self.folder / "script.txt"],
                                   env=self.environment(), cwd=self.folder, stderr=subprocess.DEVNULL)
        end = time.monotonic() + 60
        while time.monotonic() < end:
            files = list((self.folder / "state").glob("scene-*.vugpresets"))
            if files and "locked" in files[0].read_text():
                break
            time.sleep(0.01)
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
        self.studio('expect presets = "big* other"\npreset big\nexpect param RADIUS = 70cm', str(self.scene))


    def start(self, script, journalled):
        """Runs a script until its journal contains a text."""
        self.script(script)
        process = subprocess.Popen([PROGRAM, "--scene", "--script", self.folder / "script.txt"],
                                   env=self.environment(), cwd=self.folder, stderr=subprocess.PIPE, text=True)
        end = time.monotonic() + 60
        while time.monotonic() < end:
            if any(journalled in journal.read_text() for journal in (self.folder / "state").glob("*.vugjournal")):
                break
            time.sleep(0.01)
        return process

    def test_a_file_that_another_program_writes_is_not_replaced(self):
        mine = SCENE.replace(line_of(self.scene, "param RADIUS"), "param RADIUS = 55cm")
        theirs = SCENE + "# from another program\n"
        process = self.start(f"""open {self.scene}
edit 0 {len(SCENE)} {json.dumps(mine)}
wait 3000
expect widget changed_file text = "Another program has changed line 13 of the file."
expect audit = ""
key Ctrl+S
expect dirty = yes
click reload_file
expect changed_on_disk = ""
expect dirty = no
undo
expect param RADIUS = 55cm
save
expect dirty = no
""", "edit")
        self.scene.write_text(theirs)
        error = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 0, error)
        self.assertEqual(self.scene.read_text(), mine)

    def test_a_second_window_is_announced(self):
        first = self.start(f"open {self.scene}\nwait 60000", "open")
        try:
            self.studio(f'open {self.scene}\nexpect message = "This scene is open in another window, too. '
                        'What is saved there is reported here."', "--scene")
        finally:
            first.kill()
            first.communicate()


if __name__ == "__main__":
    require_studio()
    unittest.main()
