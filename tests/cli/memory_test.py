# SPDX-License-Identifier: Apache-2.0
"""--max-memory: checked before the work starts, enforced, and accurate compared with the actual memory."""
import os
import re
import subprocess
import time
import unittest

from vug import BALL, PROGRAM, SLOW, VugTest

UNITS = {"B": 1, "KiB": 2**10, "MiB": 2**20, "GiB": 2**30, "TiB": 2**40}


def told(error):
    """Bytes of "... would take about 1.5 GiB of memory, ..."."""
    number, unit = re.search(r"would take about (\S+) (\w+) of memory", error).groups()
    return float(number) * UNITS[unit]


class Memory(VugTest):
    def peak(self, *args):
        """Maximum resident memory in bytes, as reported by the kernel."""
        process = subprocess.Popen([PROGRAM, *args], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        error = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        process.stderr.close()
        self.assertEqual(process.returncode, 0, error)
        return usage.ru_maxrss * 1024

    def test_a_voxel_of_a_nanometre(self):
        self.write("ball.vug", BALL.replace("10cm", "1e-9"))
        start = time.monotonic()
        error = self.expect(2, "build", "ball.vug", "-o", "out").err
        self.assertLess(time.monotonic() - start, 5 if not SLOW else 60)
        # An area of 4 pi in a band of 6 voxels of 1e-9 m, 4 bytes each: about 3e20 bytes.
        self.assertGreater(told(error), 1e20)
        self.assertLess(told(error), 1e22)
        self.assertIn("while making the volume 'rock'", error)
        self.assertRegex(error, r"hint: use voxels of at least \S+ m, a smaller region, or raise --max-memory")
        self.assertEqual(self.files(), ["ball.vug"])

    def test_the_voxel_of_the_hint_fits(self):
        self.write("rock.vug", "param v = 1cm\nvolume rock = level_set(sphere(10m), voxel: v)\n")
        limited = ("build", "rock.vug", "-o", "out", "--max-memory", "300M")
        error = self.expect(2, *limited).err
        voxel = float(re.search(r"hint: use voxels of at least (\S+) m, a smaller region, or raise --max-memory",
                                error).group(1))
        self.expect(0, *limited, "-D", f"v={voxel}m")
        self.expect(2, *limited, "-D", f"v={0.8 * voxel}m")

    def test_a_picture_that_is_too_large(self):
        self.write("ball.vug", BALL)
        error = self.expect(2, "render", "ball.vug", "-o", "a.exr", "--size", "60000x60000",
                            "--max-memory", "8G").err
        self.assertIn("a picture of 60000x60000", error)
        self.assertIn("hint: use a smaller --size, or raise --max-memory", error)
        self.assertGreater(told(error), 60000 * 60000 * 4 * 10)

    def test_a_mesh_that_is_too_large_is_rejected_before_its_grid(self):
        self.write("rock.vug", "volume rock = level_set(sphere(10m), voxel: 1cm)\nmesh wall on rock {}\n"
                               "camera main { eye (0, 0, 30) }\nrender main { size 4x3  spp 1 }\n")
        # The grid alone, with 1.3e7 voxels per layer of its band, would take about half of this.
        for args in [("build", "rock.vug", "-o", "out"), ("measure", "rock.vug"),
                     ("render", "rock.vug", "-o", "rock.exr")]:
            with self.subTest(args=args):
                start = time.monotonic()
                error = self.expect(2, *args, "--max-memory", "2G").err
                self.assertLess(time.monotonic() - start, 3 if not SLOW else 60)
                self.assertIn("while making the mesh 'wall'", error)
                self.assertGreater(told(error), 4 * 2**30)
        self.assertEqual(self.files(), ["rock.vug"])

    @unittest.skipIf(SLOW, "a sanitizer takes memory of its own")
    def test_the_estimates_are_accurate(self):
        """The estimate is within a factor of 1.5 of the memory used in addition to a trivial build."""
        self.write("little.vug", BALL.replace("10cm", "50cm"))
        self.write("grid.vug", "volume rock = level_set(sphere(1m), voxel: 4mm)\n")
        self.write("mesh.vug", "volume rock = level_set(sphere(1m), voxel: 6mm)\nmesh w on rock {}\n")
        little = self.peak("build", "little.vug", "-o", "out")
        for scene, limit in [("grid.vug", "20M"), ("mesh.vug", "60M")]:
            with self.subTest(scene=scene):
                refused = self.expect(2, "build", scene, "-o", "out", "--max-memory", limit)
                estimate = told(refused.err)
                taken = self.peak("build", scene, "-o", "out") - little
                self.assertGreater(estimate, taken / 1.5)
                self.assertLess(estimate, taken * 1.5)
                self.expect(0, "build", scene, "-o", "out", "--max-memory", str(int(1.3 * estimate)))

    def test_all_grids_together_keep_the_limit(self):
        one = "volume v{} = level_set(sphere(1m), voxel: 1cm)\n"
        self.write("one.vug", one.format(1))
        self.write("five.vug", "".join(one.format(i) for i in range(5)))
        limit = "24M"  # one grid takes 12 MiB
        self.expect(0, "build", "one.vug", "-o", "out", "--max-memory", limit)
        self.assertIn("more than the limit", self.expect(2, "build", "five.vug", "-o", "more",
                                                         "--max-memory", limit).err)


if __name__ == "__main__":
    unittest.main()
