# SPDX-License-Identifier: Apache-2.0
"""Every stage of the work has a name and a time, on terminals and in logs."""
import os
import pty
import re
import signal
import subprocess
import unittest

from vug import PROGRAM, Running, VugTest

# Drips, cells with surroundings, and a picture: each of these used to work in silence.
CAVE = """
let hall = displace(shell(sphere(2m), thickness: 40cm), noise: fbm(scale: 0.5, octaves: 5), amount: 20cm)
let dripping = dripstone(hall, from: (-2, -2, -2), to: (2, 2, 2), spacing: 12cm, age: 2000, tip: 1cm)
volume rock = level_set(dripping, voxel: 2.5cm)
mesh wall on rock {}
cells skin on wall { spacing 6cm  relax 4  steps 20  run run_off(steps: 20) }
object shown on skin {}
light lamp = sphere(center: (0, 0, 0), radius: 10cm, power: 50)
camera main { eye (0.5, 0, 0.5)  target (0, 0, -1)  fov 80deg }
render main { size 160x90  spp 64 }
"""
LINE = re.compile(r"^(.+): (\d+\.\d) s$", re.M)


class Stages(VugTest):
    def prepare(self):
        self.write("cave.vug", CAVE)
        self.log = self.expect(0, "render", "cave.vug", "-o", "cave.exr", "--denoise").err
        self.write("log.txt", self.log)

    def setUp(self):
        super().setUp()
        self.log = (self.folder / "log.txt").read_text()

    def test_a_log_has_a_line_for_each_stage_that_takes_time(self):
        names = [name for name, _ in LINE.findall(self.log)]
        for name in ("voxels of 'rock'", "polishing the mesh of 'wall'", "rendering"):
            self.assertIn(name, names, self.log)
        self.assertNotIn("\r", self.log)

    def test_the_last_line_says_where_the_time_went(self):
        summary = self.log.splitlines()[-1]
        total = float(re.match(r"(\d+\.\d) s in all: ", summary)[1])
        parts = dict(re.findall(r"(?:: |, )([^:,]+(?:, \d+ steps)?) (\d+\.\d) s", summary))
        self.assertIn("rendering", parts, summary)
        self.assertIn("voxels", parts, summary)
        self.assertAlmostEqual(sum(map(float, parts.values())), total, delta=0.05 * total + 0.5, msg=summary)
        self.assertLess(float(parts.get("other", 0)), 0.1 * total + 0.2, summary)

    def test_drips_are_a_stage_and_the_memory_is_estimated_once(self):
        shown = self.vug("build", "cave.vug", "-o", "out", "--progress").err
        self.assertIn("finding drips of 'rock'", shown)
        self.assertLessEqual(len(re.findall(r"estimating the memory.*?100%", shown)), 1)
        self.assertIn("writing cave.vdb", shown)

    def test_drafts_do_not_polish(self):
        self.write("ball.vug", "volume rock = level_set(sphere(1m), voxel: 20cm)\nmesh wall on rock {}\n")
        for quality, polishes in (("final", True), ("draft", False)):
            shown = self.vug("build", "ball.vug", "-o", "out", "--progress", "--quality", quality).err
            self.assertEqual("polishing the mesh of 'wall'" in shown, polishes, shown)

    def test_quiet_runs_print_nothing(self):
        self.assertEqual(self.expect(0, "build", "cave.vug", "-o", "out", "-q").err, "")

    def test_a_terminal_shows_bars_with_names(self):
        primary, secondary = pty.openpty()
        with subprocess.Popen([PROGRAM, "build", "cave.vug", "-o", "out"], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=secondary) as process:
            os.close(secondary)
            shown = b""
            try:
                while part := os.read(primary, 4096):
                    shown += part
            except OSError:  # the end of a terminal
                pass
        os.close(primary)
        self.assertEqual(process.returncode, 0)
        self.assertRegex(shown.decode(), r"voxels of 'rock' +\[=+ *\] +\d+%")

    def test_the_estimate_includes_the_preparation(self):
        running = Running(self.folder, "render", "cave.vug", "-o", "long.exr", "--spp", "4096")
        running.wait_for(" in all")
        running.stop(signal.SIGINT)
        found = re.search(r"rendering takes about (\d+) s and .*, after (\d+) s of preparation: about (\d+) s in all",
                          running.said)
        if not found:
            self.skipTest("the rendering takes longer than a minute here")
        rendering, before, total = map(int, found.groups())
        self.assertAlmostEqual(rendering + before, total, delta=1)
        self.assertGreater(before, 0)


if __name__ == "__main__":
    unittest.main()
