# SPDX-License-Identifier: Apache-2.0
"""Jobs of `vug farm`: any order, division, repetition and interruption of tasks gives the picture of `vug render`."""
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import time
import unittest

from vug import PROGRAM, VugTest, digest

SCENE = """seed 5
volume rock = level_set(box(size: (6, 4, 6)) - sphere(1.8m), voxel: 20cm)
camera main { eye (-1.2, 0.3, 0.4)  target (1, 0, 0)  fov 70deg }
light lamp = sphere(center: (keys(1: 0.5, 3: 0.9), 0.6, 0.3), radius: 10cm, radiance: (90, 60, 30))
medium dust = haze(extinction: 5%/m)
camera pair { interaxial 20cm  eye (-1.2, 0.3, 0.4)  target (1, 0, 0) }
render main { size 64x40  spp 24 }
"""


def children(process):
    """The renders that a process has started and that have not ended."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rsplit(")", 1)[1].split()
            if fields[1] == str(process.pid) and fields[0] != "Z":
                if b"\0render\0" in (stat.parent / "cmdline").read_bytes():
                    found.append(int(stat.parent.name))
        except OSError:  # it has ended
            pass
    return found


class Farm(VugTest):
    def prepare(self):
        self.write("s.vug", SCENE)

    def plan(self, *args, job="job"):
        return self.expect(0, "farm", "plan", "s.vug", "-o", job, *args)

    def tasks(self, job="job"):
        return json.loads((self.folder / job / "job.json").read_text())["tasks"]

    def render(self, *args):
        self.expect(0, "render", "s.vug", *args)

    def expect_picture(self, name="s", whole="whole", job="job"):
        for end in ("exr", "png"):
            self.assertEqual(digest(self.folder / job / f"{name}.{end}"),
                             digest(self.folder / f"{whole}.{end}"), f"{name}.{end}")

    def status(self, code, job="job"):
        return json.loads(self.expect(code, "farm", "status", job, "--json").out)

    def test_one_worker(self):
        self.render("-o", "whole.exr")
        self.plan("--parts", 5)
        self.assertEqual(self.status(1)["tasks"]["waiting"], 5)
        self.expect(0, "farm", "run", "job")
        self.expect_picture()
        self.assertEqual(self.status(0)["finished"], 1)
        self.assertIn("already contains a job", self.expect(2, "farm", "plan", "s.vug", "-o", "job").err)

    def test_options_reach_the_tasks(self):
        options = ("--size", "40x30", "--spp", 6, "-D", "unused=1", "--exposure", "1.5", "--denoise", "--seed", 7)
        self.write("s.vug", SCENE.replace("seed 5", "param unused = 2\nseed 5").replace("20cm", "unused * 20cm"))
        self.render("-o", "whole.exr", *options)
        self.plan("--parts", 3, *options)
        self.expect(0, "farm", "run", "job")
        self.expect_picture()

    def test_any_order_and_repetition(self):
        self.render("-o", "whole.exr")
        self.plan("--parts", 4)
        order = list(range(1, 5)) * 2
        random.Random(3).shuffle(order)
        self.assertIn("waits for", self.expect(3, "farm", "run", "job", "--task", 2).err)
        self.expect(0, "farm", "run", "job", "--task", 0)
        for task in order:
            self.expect(0, "farm", "run", "job", "--task", task)
        self.expect_picture()

    def test_two_workers_on_the_same_tasks(self):
        self.render("-o", "whole.exr")
        self.plan("--parts", 3)
        self.expect(0, "farm", "run", "job", "--task", 0)
        for task in (1, 2, 3):
            pair = [subprocess.Popen([PROGRAM, "farm", "run", "job", "--task", str(task)], cwd=self.folder,
                                     stdout=subprocess.DEVNULL) for _ in range(2)]
            self.assertEqual([each.wait() for each in pair], [0, 0])
        self.expect_picture()

    def test_frames_on_two_workers(self):
        self.plan("--frames", "1..3", "--parts", 2)
        workers = [subprocess.Popen([PROGRAM, "farm", "run", "job", "--threads", "1"], cwd=self.folder,
                                    stdout=subprocess.DEVNULL) for _ in range(2)]
        self.assertEqual([each.wait() for each in workers], [0, 0])
        self.render("-o", "whole.####.exr", "--frames", "1..3")
        for frame in (1, 2, 3):
            self.expect_picture(f"s.{frame:04}", f"whole.{frame:04}")
        runs = [line for file in (self.folder / "job/state").glob("*.runs") for line in file.read_text().splitlines()]
        self.assertEqual(len(runs), 9)  # no task ran twice

    def test_whole_frames(self):
        self.plan("--frames", "1..2", "--parts", 1)
        self.expect(0, "farm", "run", "job")
        self.render("-o", "whole.####.exr", "--frames", "1..2")
        self.expect_picture("s.0002", "whole.0002")

    def test_an_interrupted_task_continues(self):
        self.write("s.vug", SCENE.replace("spp 24", "spp 300"))
        self.plan("--parts", 1)
        running = subprocess.Popen([PROGRAM, "farm", "run", "job", "--task", "0"], cwd=self.folder,
                                   stdout=subprocess.DEVNULL)
        log = self.folder / "job/state/s.log"
        while running.poll() is None and not (log.exists() and "BVH" in log.read_text()):
            time.sleep(0.02)
        time.sleep(0.3)
        running.terminate()
        if running.wait() != 0:  # else the machine was faster than the signal
            self.assertEqual(running.returncode, 3)
            self.assertIn("stopped", (self.folder / "job/state/s.runs").read_text())
        self.expect(0, "farm", "run", "job", "--task", 0)
        self.render("-o", "whole.exr")
        self.expect_picture()

    def runs(self, name):
        path = self.folder / f"job/state/s.{name}.runs"
        return [line.split()[0] for line in path.read_text().splitlines()] if path.exists() else []

    def chunk(self, tasks):
        return subprocess.Popen([PROGRAM, "farm", "run", "job", "--tasks", tasks], cwd=self.folder,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def wait_until(self, process, condition):
        """Waits for the condition; returns False if the process has ended before."""
        while not condition():
            if process.poll() is not None:
                return False
            time.sleep(0.01)
        return True

    def test_chunks_make_each_task_in_one_process(self):
        self.render("-o", "whole.exr")
        self.plan("--parts", 6, "--chunk", 3)
        self.assertIn("waits for", self.expect(3, "farm", "run", "job", "--tasks", "1-2").err)
        self.expect(0, "farm", "run", "job", "--task", 0)
        running, seen = self.chunk("1-5"), set()
        while running.poll() is None:
            seen.update(children(running))
            time.sleep(0.002)
        self.assertEqual(running.returncode, 0)
        self.assertEqual(len(seen), 1, "one process renders all parts")
        parts = [self.folder / "job" / task["makes"] for task in self.tasks()[1:]]
        self.assertEqual([part.exists() for part in parts], [True] * 5 + [False])
        for part in range(5):
            self.assertEqual(self.runs(f"part0{part}"), ["done"])
            self.assertTrue((self.folder / f"job/state/s.part0{part}.log").exists())
        self.assertEqual(list((self.folder / "job/state").glob("*.claim")), [])
        self.assertEqual(list((self.folder / "job/state").glob("*.checkpoint")), [])
        # The bytes of a part do not depend on the chunk.
        before = digest(parts[2])
        parts[2].unlink()
        self.expect(0, "farm", "run", "job", "--task", 3)
        self.assertEqual(digest(parts[2]), before)
        self.expect(0, "farm", "run", "job", "--tasks", "4,6-6,0-2:2")
        self.expect_picture()
        self.assertEqual(self.runs("part00"), ["done"], "tasks that are done do not run again")

    def test_a_stopped_chunk_keeps_its_finished_parts(self):
        self.write("s.vug", SCENE.replace("spp 24", "spp 400"))
        self.plan("--parts", 3)
        self.expect(0, "farm", "run", "job", "--task", 0)
        running = self.chunk("1-3")
        first = self.folder / "job" / self.tasks()[1]["makes"]
        self.wait_until(running, lambda: self.runs("part00") and children(running))
        running.terminate()
        code = running.wait()
        before = first.stat().st_mtime_ns
        if code != 0:  # else the machine was faster than the signal
            self.assertEqual(code, 3)
            self.assertIn("stopped", self.runs("part01") + self.runs("part02"))
            self.assertFalse((self.folder / "job/s.exr").exists())
        self.assertEqual(list((self.folder / "job/state").glob("*.claim")), [])
        self.expect(0, "farm", "run", "job", "--tasks", "1-3")
        self.assertEqual(first.stat().st_mtime_ns, before)
        self.assertEqual(self.runs("part00"), ["done"])
        self.render("-o", "whole.exr")
        self.expect_picture()

    def test_a_killed_render_costs_a_chunk_one_part(self):
        self.write("s.vug", SCENE.replace("spp 24", "spp 400"))
        self.plan("--parts", 3)
        self.expect(0, "farm", "run", "job", "--task", 0)
        running = self.chunk("1-3")
        self.wait_until(running, lambda: self.runs("part00") and children(running))
        for child in children(running):
            os.kill(child, signal.SIGKILL)
        code = running.wait()
        if code != 0:
            self.assertEqual(code, 3)
            ends = [self.runs(f"part0{part}") for part in range(3)]
            self.assertEqual(sorted(ends), [["done"], ["done"], ["killed"]])
        self.expect(0, "farm", "run", "job", "--tasks", "1-3")
        self.render("-o", "whole.exr")
        self.expect_picture()

    def test_a_part_that_cannot_work_does_not_stop_its_chunk(self):
        self.render("-o", "whole.exr")
        self.plan("--parts", 3)
        self.expect(0, "farm", "run", "job", "--task", 0)
        checkpoint = self.folder / "job/state/s.part01.checkpoint"
        checkpoint.write_text("damaged")
        done = self.expect(2, "farm", "run", "job", "--tasks", "1-3")
        self.assertIn("warning: task s.part01 cannot work: see ", done.err)
        self.assertIn("error: 1 of 3 tasks are not done", done.err)
        self.assertEqual([self.runs(f"part0{part}") for part in range(3)], [["done"], ["unusable"], ["done"]])
        self.assertIn("checkpoint", (self.folder / "job/state/s.part01.log").read_text())
        self.assertNotIn("checkpoint", (self.folder / "job/state/s.part02.log").read_text())
        checkpoint.unlink()
        (self.folder / "job/state/s.part01.runs").unlink()
        self.expect(0, "farm", "run", "job", "--tasks", "1-3")
        self.expect_picture()

    def test_part_requests_share_what_the_first_has_prepared(self):
        self.render("--guiding", "light")
        for part, samples in (("a", "0..5"), ("b", "5..24")):
            self.render("--guiding", "light", "--part", f"{part}.alone", "--samples", samples)
        command = [PROGRAM, "render", "s.vug", "--quiet", "--guiding", "light", "--part-requests"]
        with subprocess.Popen(command, cwd=self.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True) as running:
            def request(text):
                running.stdin.write(text + "\n")
                running.stdin.flush()
                return json.loads(running.stdout.readline())["exit"]
            self.assertEqual(request('{"part": "a", "samples": "0..5"}'), 0)
            (self.folder / "light").unlink()
            self.assertEqual(request("nonsense"), 2)
            self.assertEqual(request('{"part": "c", "samples": "5..5"}'), 2)
            self.assertEqual(request('{"part": "s.vug", "samples": "5..24"}'), 2)
            self.assertEqual(request('{"part": "b", "samples": "5..24", "log": "b.log"}'), 0)
            running.stdin.close()
            self.assertEqual(running.wait(), 0)
        self.assertFalse((self.folder / "light").exists(), "it is not learned again")
        for part in "ab":
            self.assertEqual(digest(self.folder / part), digest(self.folder / f"{part}.alone"))
        self.assertTrue((self.folder / "b.log").exists())
        self.expect(2, "render", "s.vug", "--part-requests")
        self.expect(2, "render", "s.vug", "--guiding", "light", "--part-requests", "--part", "a")

    def test_damaged_parts_are_made_again(self):
        self.render("-o", "whole.exr")
        self.plan("--parts", 3)
        for task in (0, 1, 2):
            self.expect(0, "farm", "run", "job", "--task", task)
        part = self.folder / "job" / self.tasks()[1]["makes"]
        content = bytearray(part.read_bytes())
        content[len(content) // 2] ^= 1
        part.write_bytes(content)
        done = self.expect(3, "farm", "run", "job", "--task", 3)
        self.assertIn("damaged", done.err)
        self.expect(0, "farm", "run", "job")
        self.expect_picture()

    def test_changed_scenes_are_refused(self):
        self.plan("--parts", 2)
        self.write("s.vug", SCENE + "# changed\n")
        done = self.expect(2, "farm", "run", "job")
        self.assertIn("has changed since the job was planned", done.err)

    def test_a_task_that_cannot_work_fails_once(self):
        self.plan("--parts", 2)
        path = self.folder / "job/job.json"
        job = json.loads(path.read_text())
        job["tasks"][0]["arguments"].append("--camera=none")
        path.write_text(json.dumps(job))
        done = self.expect(2, "farm", "run", "job")
        self.assertIn("warning: task s.learn cannot work: see ", done.err)
        self.assertIn("error: the tasks that are left have failed", done.err)
        self.assertEqual(self.status(1)["tasks"]["failed"], 1)
        self.assertIn("task s.learn cannot work", self.expect(2, "farm", "run", "job", "--task", 0).err)

    def estimate(self, *args):
        return json.loads(self.expect(0, "estimate", "s.vug", "--json", *args).out)

    def test_estimates_scale_with_the_work(self):
        still = self.estimate("--cores", "1")
        self.assertGreater(still["active voxels"], 1000)
        more = self.estimate("--cores", "1", "--spp", "48")
        rendering = [each["core seconds of a picture"]["rendering"] for each in (still, more)]
        self.assertAlmostEqual(rendering[1], 2 * rendering[0], delta=1)
        frames = self.estimate("--cores", "1", "--frames", "1..30", "--machines", "3", "--parts", "1")
        self.assertEqual(frames["products"], "the same in all frames", "only the lamp moves")
        self.assertEqual(frames["tasks of a farm"], 30)
        self.assertGreater(frames["disk"]["pictures"], 25 * still["disk"]["pictures"])
        self.assertEqual(frames["disk"]["grids"], still["disk"]["grids"])
        alone, farm, spot = frames["places"]
        self.assertLess(farm["hours"], alone["hours"])
        self.assertGreater(spot["core hours"], farm["core hours"])

    def test_estimates_see_what_moves(self):
        self.write("s.vug", SCENE.replace("sphere(1.8m)", "sphere(keys(1: 1.8, 3: 1.9))"))
        self.assertEqual(self.estimate("--frames", "1..3")["products"], "others in each frame")

    def test_refused_estimates(self):
        self.expect(2, "estimate", "s.vug", "--core-price", "-1")
        self.expect(2, "estimate", "s.vug", "--machines", "0")
        self.expect(2, "estimate", "missing.vug")

    def test_refusals(self):
        for args, text in ((("--noise", "5%", "--parts", 2), "cannot use 'noise'"),
                           (("--exposure", "locked", "--frames", "1..3"), "needs the first frame"),
                           (("--parts", 100), "more than the 24 samples"), (("--render", "none"), "none"),
                           (("--camera", "pair"), "--eye left")):
            self.assertIn(text, self.expect(2, "farm", "plan", "s.vug", "-o", "other", *args).err)
            self.assertFalse((self.folder / "other").exists())
        self.assertIn("job.json", self.expect(2, "farm", "run", "nothing").err)
        self.plan("--parts", 2)
        self.assertIn("0 to 2", self.expect(2, "farm", "run", "job", "--task", 7).err)
        self.assertIn("0 to 2", self.expect(2, "farm", "run", "job", "--tasks", "1-3").err)
        self.assertIn("0-20:5", self.expect(2, "farm", "run", "job", "--tasks", "2-1").err)
        self.expect(2, "farm", "run", "job", "--task", 1, "--tasks", "1-2")

    @unittest.skipUnless(shutil.which("ninja"), "ninja is not installed")
    def test_ninja(self):
        self.render("-o", "whole.exr")
        for chunk in (1, 2):
            job = f"job{chunk}"
            self.plan("--parts", 3, "--cores", 1, "--chunk", chunk, job=job)
            for _ in range(2):  # the second time, all is done
                subprocess.run(["ninja", "-j", "2"], cwd=self.folder / job, check=True, stdout=subprocess.DEVNULL)
                self.expect_picture(job=job)
            self.assertEqual((self.folder / job / "state/s.part00.runs").read_text().count("done"), 1)

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
    def test_gnu_parallel(self):
        self.render("-o", "whole.exr")
        for chunk in (1, 2):
            job = f"job{chunk}"
            self.plan("--parts", 3, "--cores", 1, "--chunk", chunk, job=job)
            subprocess.run(["./parallel.sh"], cwd=self.folder / job, check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL,
                           env={"JOBS": "2", "PATH": "/usr/bin:/bin", "HOME": str(self.folder)})
            self.expect_picture(job=job)


if __name__ == "__main__":
    unittest.main()
