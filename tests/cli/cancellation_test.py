# SPDX-License-Identifier: Apache-2.0
"""A killed build leaves the complete old file or none; a cancelled build reports it."""
import pathlib
import signal
import subprocess
import time
import unittest

from vug import PROGRAM, SLOW, Running, VugTest, digest

SCENE = """
let rough = displace(sphere(2m), noise: fbm(scale: 0.5, octaves: 6), amount: 30cm)
volume rock = level_set(rough, voxel: 4cm)
mesh wall on rock {}
camera main { eye (0, 0, 6) }
render main { size 320x180  spp 512 }
"""


class Stopped(VugTest):
    def setUp(self):
        super().setUp()
        self.write("rock.vug", SCENE.replace("4cm", "10cm") if SLOW else SCENE)

    def results(self):
        """The visible files."""
        return [f for f in self.files() if not pathlib.Path(f).name.startswith(".")]

    def test_a_killed_build_leaves_old_files_intact(self):
        self.expect(0, "build", "rock.vug", "-o", "new")
        for name in ("rock.vdb", "rock.ply"):
            self.write(f"out/{name}", "old\n")
        old = digest(self.folder / "out/rock.vdb")
        # The grid is written before the mesh is built, the mesh some time later.
        for stage, later in [("voxels", 0), ("] 100%", 0), ("] 100%", 0.02), ("polishing", 0),
                             ("polishing", 0.5)]:
            running = Running(self.folder, "build", "rock.vug", "-o", "out")
            running.wait_for(stage)
            time.sleep(later)
            code, _ = running.stop(signal.SIGKILL)
            self.assertIn(code, (0, -signal.SIGKILL))
            for name in ("rock.vdb", "rock.ply"):
                self.assertIn(digest(self.folder / "out" / name),
                              (old, digest(self.folder / "new" / name)))
            self.assertEqual([f for f in self.results() if f.startswith("out/")],
                             ["out/rock.ply", "out/rock.vdb"])

    def test_a_killed_build_leaves_no_new_file(self):
        running = Running(self.folder, "build", "rock.vug", "-o", "out")
        running.wait_for("polishing")
        self.assertEqual(running.stop(signal.SIGKILL)[0], -signal.SIGKILL)
        self.assertEqual([f for f in self.results() if f.endswith(".ply")], [])

    def test_cancellation(self):
        for how, stage, *args in [
                (signal.SIGINT, "voxels", "build", "rock.vug", "-o", "out"),
                (signal.SIGTERM, "polishing", "measure", "rock.vug"),
                (signal.SIGINT, "rendering", "render", "rock.vug", "-o", "out/rock.exr")]:
            with self.subTest(how=how.name, stage=stage):
                running = Running(self.folder, *args)
                running.wait_for(stage)
                asked = time.monotonic()
                code, out = running.stop(how)
                self.assertLess(time.monotonic() - asked, 10 if not SLOW else 60)
                self.assertEqual(code, 3, running.said)
                self.assertIn("error: stopped on request", running.said)
                self.assertEqual(out, "")
                self.assertEqual(self.files(), ["rock.vug"])

    def test_the_next_run_removes_files_of_a_killed_run(self):
        """Removes the hidden files of the same outputs, but not those of running processes."""
        args = ("render", "rock.vug", "-o", "out/rock.exr", "--checkpoint", "out/rock.state", "--spp", "100000",
                "--size", "640x360", "--checkpoint-every", "0")
        hidden = lambda: [f for f in self.files() if "/." in f]
        left = []
        for _ in range(40):  # until a process is killed while it writes
            running = Running(self.folder, *args, "--resume")
            running.wait_for("rendering   ")
            time.sleep(0.05)
            running.stop(signal.SIGKILL)
            left = hidden()
            if left:
                break
        self.assertEqual(len(left), 1)
        self.write("out/.other.1.part.state", "of another output")
        self.write("out/.rock.1.part.state", "of a process that lives")
        self.write("out/.rock.x1.part.state", "of no process")
        living = Running(self.folder, *(a.replace("rock.exr", "two.exr") for a in args), "--resume")
        living.wait_for("rendering   ")
        self.vug("render", "rock.vug", "-o", "out/rock.exr", "--checkpoint", "out/rock.state", "--spp", "1")
        self.assertNotIn(left[0], hidden())
        self.assertLessEqual({"out/.other.1.part.state", "out/.rock.1.part.state", "out/.rock.x1.part.state"},
                             set(hidden()))
        self.assertEqual(living.stop(signal.SIGINT)[0], 3, living.said)
        self.assertTrue((self.folder / "out/rock.state").exists())

    def test_a_cancelled_sweep_keeps_completed_rows(self):
        ball = "param R = 1m\n" + SCENE.replace("sphere(2m)", "sphere(R)")
        self.write("ball.vug", ball)
        running = Running(self.folder, "sweep", "ball.vug", "-p", "R", "-v", "20cm,3m", "-o", "out/a")
        running.wait_for("polishing")
        while "voxels" not in running.said.rpartition("polishing")[2] and running.read():
            pass  # until the second value's grid is being built
        code, out = running.stop(signal.SIGINT)
        self.assertEqual(code, 3, running.said)
        self.assertIn("while measuring R = 3m\n", running.said)
        self.assertEqual([line.split(",")[0] for line in out.splitlines()], ["R", "20cm"])
        self.assertEqual((self.folder / "out/a.csv").read_text(), out)

    def test_cancellation_before_the_work_starts(self):
        self.write("long.vug", "".join(f"let a{i} = {i} + 1\n" for i in range(150000)))

        def heeds(process):
            status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
            caught = int(status.split("SigCgt:")[1].split()[0], 16)
            return caught >> (signal.SIGINT - 1) & 1

        for how in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen([PROGRAM, "check", "long.vug"], cwd=self.folder, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            while not heeds(process):
                time.sleep(0.001)
            process.send_signal(how)
            out, said = process.communicate()
            self.assertEqual((process.returncode, out, said), (3, b"", b"error: stopped on request\n"))

    def test_a_second_signal_ends_it_immediately(self):
        running = Running(self.folder, "render", "rock.vug", "-o", "out/rock.exr", "--spp", "100000")
        running.wait_for("rendering")
        running.process.send_signal(signal.SIGINT)
        code, _ = running.stop(signal.SIGINT)
        self.assertIn(code, (3, -signal.SIGINT))  # 3 if the first signal was handled quickly


if __name__ == "__main__":
    unittest.main()
