# SPDX-License-Identifier: Apache-2.0
"""Callbacks, cancellation, Ctrl-C, and other Python threads during the work."""
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import vug
from case import BALL, Case

LONG = BALL.replace("spp 4", "spp 100000")  # takes minutes


class Callbacks(Case):
    def test_shares_rise_within_each_stage(self):
        seen = []
        build = vug.loads(BALL).build(progress=lambda share, what: seen.append((what, share)))
        build.render(spp=64)
        self.assertTrue(seen)
        stages = list(dict.fromkeys(what for what, _ in seen))
        self.assertGreaterEqual(len(stages), 2, stages)
        for stage in stages:
            shares = [share for what, share in seen if what == stage]
            self.assertEqual(shares, sorted(shares), stage)
            self.assertTrue(0 <= shares[0] and shares[-1] <= 1, stage)

    def test_a_call_may_have_its_own_callback(self):
        of_build, of_call = [], []
        build = vug.loads(BALL).build(progress=lambda share, what: of_build.append(what))
        hear = {"progress": lambda share, what: of_call.append(what)}
        build.mesh(**hear)
        self.assertTrue(of_call)
        self.assertEqual(of_build, [])
        for work in (lambda: build.level_set(**hear), lambda: build.volume(**hear), lambda: build.measure(**hear),
                     lambda: build.save("out", **hear)):
            work()
        self.assertEqual(of_build, [])
        with self.assertRaises(vug.Cancelled):
            vug.loads(LONG).build().render(progress=lambda share, what: what != "rendering")
        build.render(**hear)
        self.assertIn("rendering", of_call)
        heard = len(of_call)
        build.render(spp=5)
        self.assertEqual((len(of_call), "rendering" in of_build), (heard, True))
        self.assertRaises(TypeError, build.mesh, progress=3)

    def test_they_run_on_the_calling_thread(self):
        threads = set()
        scene = vug.loads(BALL)
        scene.render(spp=16, progress=lambda share, what: threads.add(threading.get_ident()))
        self.assertEqual(threads, {threading.get_ident()})

    def test_they_may_use_vug_but_not_the_same_build(self):
        build = vug.loads(BALL).build()
        volumes, refused = [], []

        def progress(share, what):
            if not volumes:
                volumes.append(vug.loads(BALL).measure()["volume"])
            try:
                build.mesh()
            except RuntimeError as error:
                refused.append(str(error))

        build.progress = progress
        build.render(spp=64)
        self.assertAlmostEqual(volumes[0], 4.19, delta=0.1)
        self.assertEqual(set(refused), {"this build is already running"})

    def test_an_invalid_callback(self):
        with self.assertRaises(TypeError):
            vug.loads(BALL).build(progress=3).mesh()


class Cancelling(Case):
    def test_false_stops_a_render(self):
        begin = time.monotonic()
        with self.assertRaises(vug.Cancelled) as caught:
            vug.loads(LONG).render(progress=lambda share, what: what != "rendering")
        self.assertLess(time.monotonic() - begin, 30)
        self.assertIsInstance(caught.exception, vug.Error)
        self.assertEqual(caught.exception.code, "cancelled")

    def test_none_and_zero_do_not(self):
        for answer in (None, True, 0, "", 1):
            vug.loads(BALL).render(spp=1, progress=lambda share, what: answer)

    def test_exceptions_of_callbacks_are_raised(self):
        class Mine(BaseException):
            pass

        def progress(share, what):
            if what == "rendering":
                raise Mine("enough")

        with self.assertRaisesRegex(Mine, "enough"):
            vug.loads(LONG).render(progress=progress)

    def test_a_build_continues_with_completed_results(self):
        build = vug.loads(LONG).build(progress=lambda share, what: what != "rendering")
        mesh = build.mesh()
        with self.assertRaises(vug.Cancelled):
            build.render()
        build.progress = None
        again = build.mesh()
        self.assertEqual(mesh.positions.__array_interface__["data"],
                         again.positions.__array_interface__["data"])
        self.assertEqual(build.render(spp=1).width, 32)

    def test_every_stage_can_be_cancelled(self):
        text = BALL + "cells skin on wall { spacing 10cm  run life(steps: 2000) }\n"
        stages = []
        vug.loads(text).build(progress=lambda share, what: stages.append(what)).save("out")
        for stage in set(stages):
            build = vug.loads(text).build(progress=lambda share, what: what != stage)
            with self.assertRaises(vug.Cancelled, msg=stage):
                build.save(f"{stage}/out")

    def test_a_picture_continues_from_its_checkpoint(self):
        scene = vug.loads(BALL)
        scene.render(spp=2048).save("whole.exr")
        with self.assertRaises(vug.Cancelled):
            scene.render(spp=2048, checkpoint="half.part",
                         progress=lambda share, what: what != "rendering" or share < 0.4)
        self.assertTrue((self.folder / "half.part").exists())
        with self.assertRaisesRegex(vug.Error, "belongs to another picture"):
            scene.render(spp=1024, checkpoint="half.part")
        shares = []
        image = scene.render(spp=2048, checkpoint="half.part",
                             progress=lambda share, what: shares.append(share) if what == "rendering" else None)
        self.assertGreater(min(share for share in shares if share), 0.2)
        image.save("again.png")
        self.assertTrue((self.folder / "half.part").exists())
        image.save("again.exr")
        self.assertFalse((self.folder / "half.part").exists())
        self.assert_same_files("again.exr", "whole.exr")

    def test_cells_continue_from_their_checkpoint(self):
        scene = vug.loads(BALL + "cells skin on wall { spacing 10cm  run life(steps: 2000) }\n")
        scene.build().save("whole")
        with self.assertRaises(vug.Cancelled):
            scene.build(checkpoint="run.vdb",
                        progress=lambda share, what: "rewriting" not in what or share < 0.4).cells("skin")
        self.assertTrue((self.folder / "run.vdb").exists())
        shares = []
        build = scene.build(checkpoint="run.vdb", progress=lambda share, what: shares.append(what))
        build.save("again")
        self.assertIn("rewriting", " ".join(shares))
        self.assertNotIn("2000 steps", " ".join(shares))
        self.assertFalse((self.folder / "run.vdb").exists())
        for path in (self.folder / "whole").iterdir():
            self.assert_same_files(f"again/{path.name}", f"whole/{path.name}")
        with self.assertRaisesRegex(ValueError, "must end in .vdb"):
            scene.build(checkpoint="run.part")

    def test_control_c(self):
        self.write("long.vug", LONG)
        for callback in ("", ", progress=lambda share, what: None"):
            program = ("import vug\nscene = vug.load('long.vug')\nprint('begun', flush=True)\n"
                       f"try:\n    scene.render(spp=100000{callback})\n"
                       "except KeyboardInterrupt:\n    print('interrupted', flush=True)\n")
            work = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
            self.assertEqual(work.stdout.readline(), "begun\n")
            time.sleep(0.5)
            os.kill(work.pid, signal.SIGINT)
            out, _ = work.communicate(timeout=60)
            self.assertEqual((out, work.returncode), ("interrupted\n", 0))


class Threads(Case):
    def test_other_python_threads_keep_running(self):
        done = threading.Event()
        beats = 0

        def work():
            with self.assertRaises(vug.Cancelled):
                vug.loads(LONG).render(progress=lambda share, what: not done.is_set())
            finished.append(True)

        finished = []
        worker = threading.Thread(target=work)
        worker.start()
        until = time.monotonic() + 0.5
        while time.monotonic() < until:
            beats += 1
        done.set()
        worker.join(60)
        self.assertTrue(finished)
        self.assertGreater(beats, 10000)

    def test_several_at_once_and_their_bytes(self):
        scene = vug.loads(BALL)
        images = {}

        def render(threads):
            images[threads] = scene.render(spp=16, threads=threads)["beauty"]

        workers = [threading.Thread(target=render, args=(n,)) for n in (0, 1, 2, 3)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join(120)
        self.assertEqual(len(images), 4)
        for image in images.values():
            self.assertEqual(image.tobytes(), images[1].tobytes())

    def test_limits_are_checked(self):
        scene = vug.loads(BALL)
        with self.assertRaises(ValueError):
            scene.build(threads=-1)
        with self.assertRaises(ValueError):
            scene.build(max_memory=0)
        with self.assertRaisesRegex(vug.Error, "invalid amount|memory|bytes"):
            scene.build(max_memory="lots")
        with self.assertRaises(vug.Error) as caught:
            vug.loads(BALL.replace("10cm", "1mm")).build(max_memory="20M").level_set()
        self.assertEqual(caught.exception.code, "too_large")


if __name__ == "__main__":
    unittest.main()
