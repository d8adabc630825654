# SPDX-License-Identifier: Apache-2.0
"""Look development: denoising, layers, kept pictures and comparisons; the queue of renders."""
import hashlib
import os
import signal
import subprocess
import time
import unittest

from studio import HERE, PROGRAM, StudioTest, require_studio
from vug import PROGRAM as VUG

SCENE = """param RADIUS = 50cm in 10cm..90cm
volume ball = level_set(sphere(RADIUS), voxel: 5cm)
mesh ball on ball { }
object ball on ball { }
light key = sphere(center: (-1, 1, 1), radius: 20cm, radiance: (9, 8, 6), group: "lamps")
camera main { eye (0.4, 0.8, 4) target (0, 0, 0) fov 40deg }
render main { size 64x36 spp 4 layers ["beauty", "light_lamps"] }
render long { size 320x180 spp 4096 }
render middle { size 160x90 spp 512 }
"""


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


class LookDevelopment(StudioTest):
    def prepare(self):
        super().prepare()
        self.scene.write_text(SCENE)

    @property
    def scene(self):
        return self.folder / "scene.vug"

    def render(self, block, output):
        subprocess.run([VUG, "render", self.scene, "--render", block, "-o", output, "--quiet"], check=True,
                       cwd=self.folder)

    def test_pictures_are_denoised_kept_and_compared(self):
        self.studio((HERE / "look_dev.txt").read_text(), "--scene")
        names = ("noisy", "smooth", "again", "albedo", "wipe", "moved", "difference", "kept", "restored")
        images = {name: (self.folder / f"{name}.png").read_bytes() for name in names}
        self.assertEqual(images["noisy"], images["again"])
        self.assertEqual(images["noisy"], images["restored"])
        self.assertEqual(len({images[name] for name in names}), 7)

    def test_the_queue_renders_one_after_the_other(self):
        self.studio(f"""open {self.scene}
queue_render {self.folder}/a.exr main
queue_render {self.folder}/b.exr nothing
queue_render {self.folder}/c.exr main RADIUS=70cm
wait-renders
expect renders = "1 done, 2 failed, 3 done"
expect render_error contains "error:"
expect render_error contains "nothing"
key Ctrl+5
expect audit = ""
cancel_render 2
expect renders = "1 done, 3 done"
""", "--scene", VUG=VUG)
        self.render("main", self.folder / "expected.exr")
        self.assertEqual(digest(self.folder / "a.exr"), digest(self.folder / "expected.exr"))
        self.assertNotEqual(digest(self.folder / "a.exr"), digest(self.folder / "c.exr"))
        self.assertFalse((self.folder / "a.exr.checkpoint").exists())

    def test_a_paused_render_lets_the_next_one_run(self):
        self.studio(f"""open {self.scene}
queue_render {self.folder}/long.exr long
queue_render {self.folder}/a.exr main
wait 300
expect renders = "1 running, 2 waiting"
pause_render 1
wait-renders
expect renders = "1 paused, 2 done"
cancel_render 1
expect renders = "2 done"
""", "--scene", VUG=VUG)
        self.assertEqual(sorted(path.name for path in self.folder.glob("*.exr*")), ["a.exr"])

    def test_another_session_continues_a_render(self):
        output = self.folder / "middle.exr"
        checkpoint = self.folder / "middle.exr.checkpoint"
        self.script(f"open {self.scene}\nqueue_render {output} middle\nwait 120000")
        process = subprocess.Popen([PROGRAM, "--scene", "--script", self.folder / "script.txt"],
                                   env=self.environment(VUG=VUG), cwd=self.folder, stderr=subprocess.DEVNULL)
        queue = self.folder / "state/renders.vugqueue"
        end = time.monotonic() + 60
        while time.monotonic() < end and not (queue.exists() and "render running" in queue.read_text()):
            time.sleep(0.01)
        time.sleep(1)
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
        # The render ends with its window, and writes its checkpoint if it had begun.
        while time.monotonic() < end and any(str(output).encode() in command for command in commands()):
            time.sleep(0.05)
        self.assertFalse(output.exists())
        began = checkpoint.exists()
        self.studio('expect renders = "1 paused"\nresume_render 1\nwait-renders\nexpect renders = "1 done"',
                    "--scene", VUG=VUG)
        self.render("middle", self.folder / "expected.exr")
        self.assertEqual(digest(output), digest(self.folder / "expected.exr"), f"had begun: {began}")
        self.assertFalse(checkpoint.exists())


def commands():
    """The command lines of all processes."""
    for folder in os.listdir("/proc"):
        if folder.isdigit():
            try:
                with open(f"/proc/{folder}/cmdline", "rb") as file:
                    yield file.read()
            except OSError:
                continue


if __name__ == "__main__":
    require_studio()
    unittest.main()
