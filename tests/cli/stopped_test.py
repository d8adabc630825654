"""A build that is killed leaves the whole old file or none; one that is asked to stop says so."""
import os
import pathlib
import signal
import subprocess
import time
import unittest

from vug import PROGRAM, SLOW, VugTest, digest

SCENE = """
let rough = displace(sphere(2m), noise: fbm(scale: 0.5, octaves: 6), amount: 30cm)
volume rock = level_set(rough, voxel: 4cm)
mesh wall on rock {}
camera main { eye (0, 0, 6) }
render main { size 320x180  spp 512 }
"""


class Running:
    """The command, whose progress bar tells what it is doing."""

    def __init__(self, folder, *args):
        self.process = subprocess.Popen([PROGRAM, *args, "--progress"], cwd=folder,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE)
        self.said = ""

    def read(self):
        """More of what it says; False at its end."""
        text = os.read(self.process.stderr.fileno(), 4096).decode(errors="replace")
        self.said += text
        return bool(text)

    def wait_for(self, stage):
        while stage not in self.said and self.read():
            pass

    def stop(self, how):
        """Exit code and standard output after the signal."""
        self.process.send_signal(how)
        while self.read():
            pass
        out, _ = self.process.communicate(timeout=120)
        return self.process.returncode, out.decode()


class Stopped(VugTest):
    def setUp(self):
        super().setUp()
        self.write("rock.vug", SCENE.replace("4cm", "10cm") if SLOW else SCENE)

    def results(self):
        """What a user sees: files that ls shows."""
        return [f for f in self.files() if not pathlib.Path(f).name.startswith(".")]

    def test_a_killed_build_leaves_old_files_whole(self):
        self.expect(0, "build", "rock.vug", "-o", "new")
        for name in ("rock.vdb", "rock.ply"):
            self.write(f"out/{name}", "old\n")
        old = digest(self.folder / "out/rock.vdb")
        # The grid is written before the mesh is made, the mesh some time after it is whole.
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

    def test_asked_to_stop(self):
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

    def test_a_sweep_keeps_what_it_has(self):
        ball = "param R = 1m\n" + SCENE.replace("sphere(2m)", "sphere(R)")
        self.write("ball.vug", ball)
        running = Running(self.folder, "sweep", "ball.vug", "-p", "R", "-v", "20cm,3m", "-o", "out/a")
        running.wait_for("polishing")
        while "voxels" not in running.said.rpartition("polishing")[2] and running.read():
            pass  # until the second value's grid is on its way
        code, out = running.stop(signal.SIGINT)
        self.assertEqual(code, 3, running.said)
        self.assertIn("while measuring R = 3m\n", running.said)
        self.assertEqual([line.split(",")[0] for line in out.splitlines()], ["R", "20cm"])
        self.assertEqual((self.folder / "out/a.csv").read_text(), out)

    def test_a_second_signal_ends_it_the_hard_way(self):
        running = Running(self.folder, "render", "rock.vug", "-o", "out/rock.exr", "--spp", "100000")
        running.wait_for("rendering")
        running.process.send_signal(signal.SIGINT)
        code, _ = running.stop(signal.SIGINT)
        self.assertIn(code, (3, -signal.SIGINT))  # 3 where the first was quick


if __name__ == "__main__":
    unittest.main()
