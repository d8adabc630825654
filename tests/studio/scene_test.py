# SPDX-License-Identifier: Apache-2.0
"""The window of scenes: text, problems, sliders, picture and undo by mouse and keyboard; recovery; its keys."""
import os
import signal
import subprocess
import time
import unittest

from studio import HERE, PROGRAM, SOURCE, StudioTest, require_studio

SCENE = """# A ball on nothing.
param RADIUS = 50cm   in 10cm..90cm  "radius of the ball"  # not too large
param VOXEL = 4cm  in 1mm..10cm
volume ball = level_set(sphere(RADIUS), voxel: VOXEL)
mesh ball on ball { }
object ball on ball { }
camera main { eye (0.4, 0.8, 4) target (0, 0, 0) fov 40deg }
render main { size 320x180 }
"""


class SceneWindow(StudioTest):
    def prepare(self):
        super().prepare()
        self.scene.write_text(SCENE)

    @property
    def scene(self):
        return self.folder / "scene.vug"

    def test_all_functions(self):
        self.studio((HERE / "scene.txt").read_text() + "\nsave\n", "--scene")
        self.assertEqual(self.scene.read_text(), SCENE, "all edits are undone")
        before, slid, undone, turned, moved, home, region, whole, ids = (
            (self.folder / f"{name}.png").read_bytes()
            for name in ("before", "slid", "undone", "turned", "moved", "home", "region", "whole", "ids"))
        self.assertEqual(undone, before)
        self.assertEqual(home, before)
        self.assertEqual(whole, before)
        self.assertEqual(len({before, slid, turned, moved, region, ids}), 6)

    def test_the_event_loop_is_never_blocked_by_a_build(self):
        self.scene.write_text(SCENE.replace("VOXEL = 4cm", "VOXEL = 8mm"))
        self.studio("wait idle\nreset-heartbeat\nparam RADIUS 80cm\nwait idle\norbit 30\nwait idle\n"
                    "expect stale = no\nexpect heartbeat below 300", str(self.scene))

    def test_a_killed_window_loses_nothing(self):
        lines = [f'open {self.scene}', 'wait idle'] + [f'edit 0 0 "# {k}\\n"' for k in range(20)] + ["wait 60000"]
        self.script("\n".join(lines))
        process = subprocess.Popen([PROGRAM, "--scene", "--script", self.folder / "script.txt"],
                                   env=self.environment(), cwd=self.folder, stderr=subprocess.DEVNULL)
        try:
            end = time.monotonic() + 60
            journals = []
            while time.monotonic() < end:
                journals = list((self.folder / "state").glob("*.vugjournal"))
                if journals and journals[0].read_text().count("\n") > 15:
                    break
                time.sleep(0.001)
        finally:
            os.kill(process.pid, signal.SIGKILL)
            process.wait()
        text = journals[0].read_text()
        edits = text[:text.rfind("\n")].count("\nedit ")
        self.assertGreater(edits, 10)
        # The window of facades does not offer it.
        self.assertIn("no visible widget 'recover'", self.studio("click recover", code=2))
        recovered = self.folder / "recovered.vug"
        self.studio(f"click recover\nexpect dirty = yes\nsave {recovered}", "--scene")
        expected = "".join(f"# {k}\n" for k in reversed(range(edits))) + SCENE
        self.assertEqual(recovered.read_text(), expected)
        self.assertEqual(self.scene.read_text(), SCENE)

    def test_all_scales_and_themes(self):
        for scale in ("1", "2"):
            for theme in ("light", "dark"):
                self.studio('wait 300\nexpect audit = ""\nkey Ctrl+Shift+P\nexpect audit = ""', str(self.scene),
                            "--theme", theme, QT_SCALE_FACTOR=scale)

    def test_errors_are_messages(self):
        self.studio('wait idle\nkey Ctrl+Shift+P\ntype "mode wire"\nkey Return\n'
                    'expect message contains "unknown mode \'wire\'"\nkey Escape\nexpect mode = clay',
                    str(self.scene))
        error = self.studio('wait idle\n\nexpect problems = 4', str(self.scene), code=2)
        self.assertIn("script.txt:3:1: expected problems = '4', but it is '0'", error)

    def test_keys_are_documented(self):
        table = subprocess.run([PROGRAM, "--scene", "--keys"], capture_output=True, text=True, check=True,
                               env=self.environment()).stdout
        self.assertIn(table.strip(), (SOURCE / "docs/guides/studio_scenes.md").read_text())


if __name__ == "__main__":
    require_studio()
    unittest.main()
