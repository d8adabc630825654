# SPDX-License-Identifier: Apache-2.0
"""Facade verbs with unreadable input: a message, exit code 2, no partial files. After a full disk or a cancellation,
existing results are kept."""
import json
import math
import os
import resource
import signal
import struct
import subprocess
import time
import unittest
import zlib

from pictures import write_exr, write_png
from vug import PROGRAM, SLOW, Running, VugTest

WIDTH, HEIGHT = 90, 120


def is_window(x, y):
    return y < 110 and 8 < x % 30 < 22 and 10 < y % 40 < 32


def rows(at, width=WIDTH, height=HEIGHT):
    return [[at(x, y) for x in range(width)] for y in range(height)]


def photo():
    return rows(lambda x, y: (30, 35, 60) if is_window(x, y) else (190 + (x * 7 + y * 13) % 9, 170, 140))


def depth():
    """Depth map in metres in front of the wall."""
    return rows(lambda x, y: -0.2 if is_window(x, y) else 0.004 * ((7 * x + 13 * y) % 5 - 2))


def huge_png(path, width, height):
    """A PNG with a header and almost no data."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b""))


class FacadeInput(VugTest):
    def fit(self, *args, code=2):
        return self.expect(code, "facade", "fit", *args, "-o", "out", "--no-carving", "--steps", 2000)

    def refused(self, said, *args):
        before = self.files()
        error = self.fit(*args).err
        self.assertIn(said, error)
        self.assertEqual(self.files(), before)
        return error

    def test_pictures_that_show_nothing(self):
        write_png(self.folder / "one.png", [[(9, 9, 9)]])
        self.refused("'one.png' has 1 x 1 pixels", "one.png")
        write_png(self.folder / "post.png", [[(i, i, 9)] for i in range(200)])
        self.refused("has 1 x 200 pixels", "post.png")
        write_png(self.folder / "flat.png", [[(120, 100, 80)] * 40] * 30)
        self.refused("'flat.png' has only one colour", "flat.png")
        write_png(self.folder / "tower.png", [[(i % 250, j, 9) for j in range(20)] for i in range(400)])
        self.assertIn("hint: give its width or its height", self.refused("12 m wide is 240 m high", "tower.png"))
        self.assertIn("facade    3 x 60 m\n", self.fit("tower.png", "--width", "3m", code=0).out)

    def test_invalid_depths(self):
        for bad in (math.nan, math.inf, -math.inf):
            write_exr(self.folder / "depth.exr", {"depth": rows(lambda x, y: bad)})
            self.refused("'depth.exr' has no depth in any pixel", "depth.exr")
            holes = depth()
            for y in range(40, 60):
                holes[y][3:60] = [bad] * 57
            write_exr(self.folder / "holes.exr", {"depth": holes})
            self.assertRegex(self.fit("holes.exr", code=0).out, r"elements +\d+ windows?\n")
        write_png(self.folder / "photo.png", photo())
        self.refused("'photo.png' has no depth channel", "photo.png", "--depth", "photo.png")
        write_exr(self.folder / "small.exr", {"depth": [[0.0] * 30] * 20})
        self.assertIn("30 x 20", self.refused("both must show the same rectangle", "photo.png", "--depth", "small.exr"))
        nothing = rows(lambda x, y: math.nan)
        write_exr(self.folder / "dark.exr", {"R": nothing, "G": nothing, "B": nothing})
        self.refused("'dark.exr' has no valid pixel", "dark.exr")

    def test_sizes(self):
        """Sizes refer to the original picture, not to the reduced one."""
        write_png(self.folder / "photo.png", photo())
        for more, size in (((), (12, 16)), (("--rows", 37), (12, 16)), (("--height", "8m"), (6, 8)),
                           (("--width", "3m", "--height", "8m"), (3, 8)), (("--width", "9m"), (9, 12))):
            said = self.fit("photo.png", *more, code=0)
            self.assertTrue(said.out.startswith(f"facade    {size[0]} x {size[1]} m"), said.out)
            self.assertEqual("assumed size 12 x 16 m" in said.err, "m" not in str(more), said.err)
        self.expect(0, "facade", "rectify", "photo.png", "--corners", "0,0", "90,0", "90,120", "0,120", "--size", "6mx8m",
                    "-o", "square.exr")
        self.assertTrue(self.fit("square.exr", code=0).out.startswith("facade    6 x 8 m"))
        self.write("scan.txt", "\n".join(f"{0.1 * i} 0 {0.1 * j}" for i in range(60) for j in range(40)))
        self.refused("do not apply to a scan", "--cloud", "scan.txt", "--width", "3m")

    def test_grammars(self):
        write_png(self.folder / "photo.png", photo())
        self.refused("there is no grammar 'nope.vug': no such file", "photo.png", "--grammar", "nope.vug")
        self.refused("did you mean 'ripperda.vug'?", "photo.png", "--grammar", "riperda.vug")
        self.refused("cannot be fitted", "photo.png", "--grammar", "mine_portal.vug")
        self.fit("photo.png", "--grammar", "ripperda.vug", code=0)

    def test_unknown_verbs(self):
        self.assertRegex(self.expect(2, "facade").err,
                         "^error: no verb given\nhint: write vug facade VERB, where VERB is one of fit, .*; see 'vug facade --help'\n$")
        error = self.expect(2, "facade", "fitt", "photo.png").err
        self.assertIn("unknown verb 'facade fitt'\nhint: did you mean 'fit'?", error)
        self.assertIn("other.png", self.expect(2, "facade", "fit", "photo.png", "other.png", "-o", "out").err)

    def test_empty_clouds(self):
        for name, text in (("empty.ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                                         "property float z\nend_header\n"),
                           ("empty.txt", ""), ("heading.txt", "x y z\n"), ("nowhere.txt", "nan 0 0\ninf 1 1\n")):
            self.write(name, text)
            self.assertIn(name, self.refused("", "--cloud", name))
            self.assertIn(name, self.expect(2, "facade", "scan", name, "-o", "scan.exr").err)
        self.assertNotIn("scan.exr", self.files())

    def test_several_clouds_are_reported(self):
        lines = [f"{0.1 * i} 0 {0.1 * j}" for i in range(60) for j in range(40)]
        self.write("left.txt", "\n".join(lines[:1200]))
        self.write("right.txt", "\n".join(lines[1200:]))
        both = ("--cloud", "left.txt", "right.txt")
        self.assertIn("is named 'left'", self.fit(*both, code=0).err)
        self.assertNotIn("is named", self.fit(*both, "--name", "house", code=0).err)
        self.assertIn("out/house.json", self.files())


class Memory(VugTest):
    def refused(self, *args):
        """Refused before any work, with the required memory."""
        before = self.files()
        error = self.expect(2, "facade", *args).err
        self.assertRegex(error, r"would take about \S+ [KMGT]iB of memory, more than the limit")
        self.assertIn("hint: ", error)
        self.assertEqual(self.files(), before)
        return error

    def test_a_hundred_megapixels(self):
        for name in ("photo.png", "set/images/a.png"):
            huge_png(self.folder / name, 10000, 10000)
        write_png(self.folder / "set/images/b.png", photo())
        (self.folder / "set/labels").mkdir()
        for name in "ab":
            write_png(self.folder / f"set/labels/{name}.png", [[(0, 0, 0)] * 4] * 3)
        self.write("classes.json", '{"0": "wall", "1": "window"}')
        for args in (("fit", "photo.png", "-o", "out"), ("train", "set", "--classes", "classes.json", "-o", "looks.json"),
                     ("rectify", "photo.png", "--corners", "0,0", "9,0", "9,9", "0,9", "-o", "out.exr")):
            with self.subTest(args=args):
                self.assertIn("10000 x 10000 pixels", self.refused(*args, "--max-memory", "500M"))
        # The pixels of a session's photo are not read.
        self.expect(0, "facade", "model", "--grammar", "ripperda.vug", "--photo", "photo.png", "--width", "12m",
                    "-o", "s.json", "--max-memory", "100M")
        self.refused("model", "s.json", "--carve", "wall.vdb", "--voxel", "0.1mm", "--max-memory", "500M")

    def test_range_images_and_scans(self):
        flat = [[0.0] * 400] * 300
        write_exr(self.folder / "range.exr", {"depth": flat})
        write_png(self.folder / "photo.png", photo())
        error = self.refused("rectify", "photo.png", "--onto", "range.exr", "-o", "both.exr", "--max-memory", "1M")
        self.assertIn("400 x 300 pixels of range.exr", error)
        self.refused("rectify", "photo.png", "--onto", "range.exr", "-o", "both.exr", "--max-memory", "2M")
        self.expect(0, "facade", "rectify", "photo.png", "--onto", "range.exr", "-o", "both.exr", "--max-memory", "5M")
        self.write("scan.txt", "\n".join(f"{0.1 * i} 0 {0.1 * j}" for i in range(60) for j in range(40)))
        for more in (("--max-memory", "20K"), ("--max-memory", "100M", "--pixel", "0.1mm")):
            self.refused("scan", "scan.txt", "-o", "scan.exr", *more)
        self.refused("fit", "--cloud", "scan.txt", "-o", "out", "--max-memory", "20K")

    @unittest.skipIf(SLOW, "a sanitizer takes memory of its own")
    def test_the_estimate_is_accurate(self):
        """The additional memory of a large picture does not exceed the estimate."""
        def peak(name):
            process = subprocess.Popen([PROGRAM, "facade", "fit", name, "-o", "out", "--no-carving", "--steps", "1000"],
                                       cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            said = process.stderr.read()
            process.stderr.close()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(process.returncode, 0, said)
            return usage.ru_maxrss * 1024
        write_png(self.folder / "small.png", photo())
        large = [line * 30 for line in photo() for _ in range(20)]  # 6.5 megapixels
        write_png(self.folder / "large.png", large)
        told = self.refused("fit", "large.png", "-o", "out", "--max-memory", "100M")
        self.assertIn("2700 x 2400 pixels", told)
        self.assertLess(peak("large.png") - peak("small.png"), 1.15 * 2700 * 2400 * 6 * 4)


class Kept(VugTest):
    def prepare(self):
        write_png(self.folder / "photo.png", photo())

    def outcome(self):
        """A stopped fit writes a complete tree that other verbs can read."""
        tree = json.loads((self.folder / "out/photo.json").read_text())
        self.assertTrue(json.loads((self.folder / "out/photo.report.json").read_text()))
        listed = self.expect(0, "tree", "out/photo.vug", "--elements").out
        self.assertEqual(listed.count("\nwindow,"), sum(one["kind"] == "window" for one in tree["elements"]))
        self.expect(0, "check", "out/photo_scene.vug")
        self.assertNotIn("out/photo.vdb", self.files())
        return tree

    def test_a_cancelled_fit_writes_the_best_tree_so_far(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            running = Running(self.folder, "facade", "fit", "photo.png", "-o", "out", "--steps", 1000000000)
            running.wait_for("sampling")
            code, out = running.stop(how)
            self.assertEqual(code, 3, running.said)
            self.assertIn("stopped: this is the best tree so far", running.said)
            self.assertTrue(out.startswith("facade    12 x 16 m"), out)
            tree = self.outcome()
            self.assertTrue(any(one["kind"] == "window" for one in tree["elements"]), out)
            (self.folder / "out/photo.json").unlink()

    def test_cancelled_at_the_start(self):
        for how, later in ((signal.SIGINT, 0), (signal.SIGTERM, 0.02), (signal.SIGINT, 0.1)):
            running = Running(self.folder, "facade", "fit", "photo.png", "-o", "out", "--steps", 1000000000)
            running.wait_until_it_handles_signals()
            time.sleep(later)
            code, _ = running.stop(how)
            self.assertEqual(code, 3, running.said)
            if "error: stopped on request" in running.said:  # before it has read the picture
                self.assertNotIn("out/photo.json", self.files())
            else:
                self.outcome()
                (self.folder / "out/photo.json").unlink()

    def test_other_cancelled_verbs_leave_no_files(self):
        self.write("scan.txt", "\n".join(f"{0.02 * i:.2f} {0.001 * (i * j % 7):.3f} {0.02 * j:.2f}"
                                         for i in range(400) for j in range(300)))
        before = self.files()
        for args in (("scan", "scan.txt", "-o", "scan.exr", "--pixel", "2mm"),
                     ("model", "--grammar", "ripperda.vug", "--width", "60m", "--height", "60m", "--carve", "w.vdb",
                      "--voxel", "1cm")):
            running = Running(self.folder, "facade", *args)
            running.wait_until_it_handles_signals()
            time.sleep(0.1)
            code, out = running.stop(signal.SIGTERM)
            self.assertEqual((code, out), (3, ""), running.said)
            self.assertIn("error: stopped on request", running.said)
            self.assertEqual(self.files(), before)

    def test_a_carving_that_is_too_large_keeps_the_tree(self):
        said = self.expect(2, "facade", "fit", "photo.png", "-o", "out", "--width", "60m", "--steps", "1000",
                           "--max-memory", "60M").err
        self.assertIn("more than the limit of 60 MiB", said)
        self.assertNotIn("earlier", said)
        self.outcome()
        self.assertFalse([name for name in self.files() if ".part" in name])
        self.write("out/photo.vdb", "older")
        said = self.expect(2, "facade", "fit", "photo.png", "-o", "out", "--width", "60m", "--steps", "1000",
                           "--max-memory", "60M").err
        self.assertIn("warning: 'out/photo.vdb' is from an earlier fit\n", said)
        self.assertEqual((self.folder / "out/photo.vdb").read_text(), "older")

    def test_a_full_disk(self):
        """A limit on the size of files makes writes fail in the middle, like a full disk."""
        def small_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (600, 600))

        for name in ("json", "report.json"):
            self.write(f"out/photo.{name}", "old\n")
        self.write("scan.txt", "\n".join(f"{0.1 * i} 0 {0.1 * j}" for i in range(60) for j in range(40)))
        before = self.files()
        for args in (("fit", "photo.png", "-o", "out", "--steps", "1000"), ("fit", "photo.png", "-o", "new/out", "--steps", "1000"),
                     ("scan", "scan.txt", "-o", "out/scan.exr"),
                     ("rectify", "photo.png", "--corners", "1,1", "80,1", "80,80", "1,80", "-o", "r.exr"),
                     ("model", "--grammar", "ripperda.vug", "--width", "9m", "--height", "9m", "--carve", "m.vdb")):
            self.expect(3, "facade", *args, preexec_fn=small_files, restore_signals=False)
            self.assertEqual(self.files(), before, "all files, or none")
        for name in ("json", "report.json"):
            self.assertEqual((self.folder / f"out/photo.{name}").read_text(), "old\n")


if __name__ == "__main__":
    unittest.main()
