# SPDX-License-Identifier: Apache-2.0
"""`vug facade scan` finds a synthetic facade in its points; `vug facade rectify` rectifies an oblique photo."""
import json
import math
import random
import re
import struct
import subprocess
import unittest

from vug import SOURCE, VugTest

# x, y, width, height and metres behind the wall; 0: no points.
HOLES = [(1, 3, 1.2, 1.5, 0.15), (4, 3, 1.2, 1.5, 0), (7, 3, 1.2, 1.5, 0.15), (4, 0, 1.2, 2.1, 0.2)]


def points():
    """A wall of 9 m x 5.5 m far from the origin, y north, z up, seen from the south."""
    for j in range(110):
        for i in range(180):
            x, z, back = 0.05 * i + 0.025, 0.05 * j + 0.025, 0.0
            for left, foot, width, height, behind in HOLES:
                if left <= x < left + width and foot <= z < foot + height:
                    back = behind or math.nan
            if not math.isnan(back):
                yield 4500000 + x, 5300000 + back + 0.004 * ((7 * i + 13 * j) % 5 - 2), 100 + z


def ply(rows):
    rows = list(rows)
    head = ("ply\nformat binary_big_endian 1.0\nelement vertex %d\nproperty double z\nproperty double x\n"
            "property double y\nend_header\n" % len(rows))
    return head.encode() + b"".join(struct.pack(">ddd", z, x, y) for x, y, z in rows)


def common(a, b):
    across = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
    up = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
    return max(0, across) * max(0, up)


def iou(a, b):
    both = common(a, b)
    return both / (a[2] * a[3] + b[2] * b[3] - both)


class FacadeScan(VugTest):
    def prepare(self):
        self.write("wall.ply", ply(points()))

    def test_finds_plane_and_openings(self):
        for windows in ("raster", "delaunay"):
            said = self.expect(0, "facade", "scan", "wall.ply", "--windows", windows, "-o", "out/wall.exr",
                               "--pixel", "2cm", "--json")
            report = json.loads(said.out)
            self.assertLess(report["plane"]["rms"], 0.03)
            self.assertGreater(report["plane"]["y"][2], 0.999)
            self.assertLess(report["plane"]["z"][1], -0.999)  # towards the south
            self.assertAlmostEqual(report["range"]["width"], 9, delta=0.1)
            self.assertAlmostEqual(report["range"]["height"], 5.5, delta=0.1)
            self.assertEqual(report["range"]["points_per_square_metre"] // 100, 4)
            found = [(one["kind"], one["rect"]) for one in report["openings"]]
            self.assertEqual(len(found), len(HOLES), said.out)
            for hole in HOLES:
                best = max(found, key=lambda one: iou(one[1], hole))
                self.assertGreater(iou(best[1], hole), 0.8)
                self.assertEqual(best[0], "door" if hole[1] == 0 else "window")
            self.assertEqual(json.loads((self.folder / "out/wall.json").read_text()), report)
            svg = (self.folder / "out/wall.svg").read_text()
            self.assertEqual(svg.count("<rect"), len(HOLES))
            self.assertIn('href="wall.png"', svg)
            self.assertIn("depth", self.expect(0, "info", "out/wall.exr").out)

    def test_files_make_one_cloud(self):
        rows = [f"{x:.3f};{y:.3f};{z:.3f}" for x, y, z in points()]
        self.write("a.xyz", "x;y;z\n" + "\n".join(rows[:4000]) + "\nnan;0;0\n")
        self.write("b.txt", "# the rest\n" + "\n".join(rows[4000:]))
        report = json.loads(self.expect(0, "facade", "scan", "a.xyz", "b.txt", "--json").out)
        self.assertEqual(report["points"], len(rows))
        self.assertEqual(report["dropped"], 1)
        self.assertEqual(len(report["openings"]), len(HOLES))

    def test_a_cloud_without_a_facade_causes_a_warning(self):
        floor = [f"{0.05 * i:.2f} {0.05 * j:.2f} {0.004 * ((7 * i + 13 * j) % 5 - 2):.3f}" for i in range(120) for j in range(80)]
        self.write("floor.xyz", "\n".join(floor))
        draw = random.Random(1)
        self.write("swarm.xyz", "\n".join(f"{draw.uniform(0, 9)} {draw.uniform(0, 9)} {draw.uniform(0, 9)}" for _ in range(9000)))
        for name, said in (("floor.xyz", "m high and 5.9"), ("swarm.xyz", "% of the points near the plane lie on it")):
            result = self.expect(0, "facade", "scan", name, "--json")
            self.assertRegex(result.err, f"warning: .*{said}")
            self.assertRegex(json.loads(result.out)["doubts"][0], said)
        for args in (("wall.ply",), ("floor.xyz", "--up", "y")):
            result = self.expect(0, "facade", "scan", *args, "--json")
            self.assertEqual((result.err, json.loads(result.out)["doubts"]), ("", []))

    def test_same_bytes_for_any_threads(self):
        for threads in (1, 2, 5, 8):
            self.expect(0, "facade", "scan", "wall.ply", "-o", f"out{threads}/wall.exr", "--threads", threads)
        for name in ("wall.exr", "wall.png", "wall.svg", "wall.json"):
            bytes_of = [(self.folder / f"out{threads}" / name).read_bytes() for threads in (1, 2, 5, 8)]
            self.assertEqual(len(set(bytes_of)), 1, name)

    def test_invalid_clouds_are_rejected(self):
        for text, said in (("", "empty"), ("1 2 3\n", "three points"), ("1 2\n", "broken.xyz:1:1"),
                           ("1 2 3\n4 x 6\n", "broken.xyz:2:3"), ("nan 0 0\n", "finite"),
                           ("0 0 0\n" * 9, "collinear"), ("0 0 0\n1 1 1\n2 2 2\n", "collinear"),
                           ("ply\nformat ascii 1.0\n", "end_header")):
            self.write("broken.xyz", text)
            self.assertIn(said, self.expect(2, "facade", "scan", "broken.xyz", "-o", "x.exr").err)
        self.expect(2, "facade", "scan", "missing.xyz")
        self.expect(2, "facade", "scan")
        self.assertIn("--max-memory", self.expect(2, "facade", "scan", "wall.ply", "--pixel", "1e-5m").err)
        self.expect(2, "facade", "scan", "wall.ply", "--max-memory", "100k")
        self.expect(2, "facade", "scan", "wall.ply", "--pixel", "0")
        self.expect(2, "facade", "scan", "wall.ply", "-o", "wall.jpg")
        self.assertEqual(self.files(), ["broken.xyz", "wall.ply"])


class RenderedScan(VugTest):
    """Figure 1 of the gallery: a house with a tree in front, rendered as a scan."""

    def prepare(self):
        self.expect(0, "render", SOURCE / "data/scenes/facades/figure1.vug", "-o", "scan.exr", "-D", "voxel=4cm",
                    "--size", "600x450", "-q")

    def test_windows_behind_a_tree_are_not_found(self):
        table = self.expect(0, "tree", SOURCE / "data/scenes/facades/figure1.vug", "--elements").out
        rows = [line.split(",") for line in table.splitlines()]
        true = [[float(v) for v in row[1:5]] for row in rows if row[0] in ("window", "door")]
        self.assertEqual(len(true), 21)
        for windows in ("raster", "delaunay"):
            report = json.loads(self.expect(0, "facade", "scan", "scan.exr", "--up", "y", "--plain", "--pixel", "4cm",
                                            "--windows", windows, "--json", "-q").out)
            self.assertGreater(report["plane"]["z"][2], 0.999)  # the normals show the position of the scanner
            left, foot = (-report["plane"]["origin"][axis] - half for axis, half in ((0, 7.5), (1, 0)))
            found = [[one["rect"][0] - left, one["rect"][1] - foot] + one["rect"][2:] for one in report["openings"]]
            seen = [max((iou(rect, one) for one in found), default=0) > 0.5 for rect in true]
            self.assertGreaterEqual(sum(seen), 14, windows)
            for rect, known in zip(true, seen):
                behind = 0.4 < rect[0] < 3.7 and 4 < rect[1] < 5
                self.assertFalse(known and behind, f"{windows}: {rect} stands behind the tree")

    def test_pictures_without_positions_are_not_scans(self):
        self.write("ball.vug", "volume rock = level_set(sphere(1m), voxel: 20cm)\nmesh ball on rock {}\nobject shown on ball {}\n"
                   "camera main { eye (0, 0, 5)  target (0, 0, 0) }\nlight day = sky(radiance: (1, 1, 1))\n")
        self.expect(0, "render", "ball.vug", "-o", "ball.exr", "--size", "32x32", "--spp", "1", "--layers", "beauty",
                    "-q")
        said = self.expect(2, "facade", "scan", "ball.exr").err
        self.assertIn("no layers P and Z", said)
        self.expect(2, "facade", "scan", "missing.exr")


class FacadeRectify(VugTest):
    def prepare(self):
        rows = []
        for y in range(150):
            row = []
            for x in range(200):
                row.append(255 if 20 + 0.07 * y < x < 180 - 0.07 * y else 40)
            rows.append(bytes(row))
        self.write("photo.pgm", b"P5\n200 150\n255\n" + b"".join(rows))

    def test_writes_the_area_between_the_corners(self):
        corners = ["--corners", "20,10", "180,30", "170,140", "30,120"]
        said = self.expect(0, "facade", "rectify", "photo.pgm", *corners, "--size", "8mx5m", "--pixel", "2cm",
                           "-o", "out.exr")
        self.assertEqual(said.out, "400 x 250 pixels, 8 x 5 m\n")
        self.assertIn("400", self.expect(0, "info", "out.exr").out)
        self.expect(0, "facade", "rectify", "photo.pgm", *corners, "-o", "out.png")
        wrong = ["--corners", "30,120", "170,140", "180,30", "20,10"]
        self.assertIn("clockwise", self.expect(2, "facade", "rectify", "photo.pgm", *wrong, "-o", "x.png").err)
        said = self.expect(2, "facade", "rectify", "photo.pgm", "--corners", "20,10,180,30", "-o", "x.png").err
        self.assertIn("a rectangle has four corners, but one is given: '20,10,180,30'", said)
        self.assertIn("0,0 90,0 90,120 0,120", said)
        far = ["--corners", "20,10", "180,30", "170,900", "30,800"]
        self.assertIn("the corner 170,900 lies far outside of the photo, which has 200 x 150 pixels",
                      self.expect(2, "facade", "rectify", "photo.pgm", *far, "-o", "x.png").err)
        for bad in (["--size", "8m"], ["--size", "0x3"], ["--pixel", "1e-6m", "--size", "8mx5m"],
                    ["--at", "0,0", "1,0", "1,1", "0,1"]):
            self.expect(2, "facade", "rectify", "photo.pgm", *corners, *bad, "-o", "x.exr")
        self.expect(2, "facade", "rectify", "photo.pgm", "-o", "x.exr")
        self.expect(2, "facade", "rectify", "photo.pgm", "--corners", "1,2", "3,4", "-o", "x.exr")
        self.expect(2, "facade", "rectify", "photo.pgm", *corners, "-o", "x.jpg")
        self.expect(2, "facade", "rectify", "missing.png", *corners, "-o", "x.png")
        self.assertNotIn("x.png", self.files())

    def test_sizes_are_metres_or_a_ratio(self):
        corners = ["--corners", "20,10", "180,30", "170,140", "30,120"]

        def rectify(*args, code=2):
            result = self.expect(code, "facade", "rectify", "photo.pgm", *args, "-o", "x.exr")
            return result.err if code else result.out
        self.assertIn("8 x 5 m\n", rectify(*corners, "--size", "800cm x 5m", code=0))
        self.assertIn("8 x 5 (the ratio)\n", rectify(*corners, "--size", "8x5", code=0))
        (self.folder / "x.exr").unlink()
        for size in ("8mx5", "8x5m"):
            error = rectify(*corners, "--size", size)
            self.assertIn(f"invalid size '{size}': only one number has a unit\nhint: write metres as in 12mx9m", error)
        for bad in ("8m x", "8degx5deg", "8x5x2", "m x m", " x "):
            self.assertIn("is not a size; expected e.g. 12mx9m or 4x3", rectify(*corners, "--size", bad))
        for size in ((), ("--size", "8x5")):
            self.assertIn("hint: write --size in metres", rectify(*corners, *size, "--pixel", "1cm"))
        error = rectify("--corners", "20m,10m", *corners[2:], "--size", "8mx5m")
        self.assertIn("'20m,10m' is not a position in the photo; expected X,Y in pixels without a unit", error)
        self.assertNotIn("x.exr", self.files())

    def test_aligns_with_a_range_image(self):
        self.write("wall.ply", ply(points()))
        self.expect(0, "facade", "scan", "wall.ply", "-o", "wall.exr", "--pixel", "5cm")
        self.expect(0, "facade", "rectify", "photo.pgm", "--onto", "wall.exr", "-o", "both.exr")
        info = self.expect(0, "info", "both.exr").out
        self.assertIn("depth", info)
        self.assertIn("vug:frame", info)
        self.expect(0, "facade", "rectify", "photo.pgm", "--onto", "both.exr", "-o", "again.exr")
        self.assertEqual((self.folder / "again.exr").read_bytes(), (self.folder / "both.exr").read_bytes())
        self.expect(2, "facade", "rectify", "photo.pgm", "--onto", "wall.exr", "-o", "both.png")
        onto = ("facade", "rectify", "photo.pgm", "--onto", "wall.exr", "-o", "no.exr")
        corners = ("--corners", "20,10", "180,30", "170,140", "30,120")
        for option, value in (("--size", "8mx5m"), ("--pixel", "1cm")):
            self.assertIn(f"error: {option} does not apply with --onto", self.expect(2, *onto, *corners, option, value).err)
        self.assertIn("error: --at requires --corners",
                      self.expect(2, *onto, "--at", "0,0", "1,0", "1,1", "0,1").err)
        self.assertNotIn("no.exr", self.files())

    def test_the_next_run_removes_files_of_a_killed_run(self):
        self.write("wall.ply", ply(points()))
        with subprocess.Popen(["true"]) as process:
            process.wait()
        left = f"out/.wall.{process.pid}.part"
        for name in (f"{left}/wall.exr", "out/.wall.1.part/wall.exr", f"out/.other.{process.pid}.part/a.exr"):
            self.write(name, "half of it")
        self.expect(0, "facade", "scan", "wall.ply", "-o", "out/wall.exr", "--pixel", "5cm")
        self.assertEqual([name for name in self.files() if "/." in name],
                         sorted((f"out/.other.{process.pid}.part/a.exr", "out/.wall.1.part/wall.exr")))
        self.assertFalse((self.folder / left).exists())


class Documented(VugTest):
    def test_options_in_the_docs_exist(self):
        text = (SOURCE / "docs/guides/scans.md").read_text()
        for verb in ("scan", "rectify"):
            known = set(re.findall(r"--[a-z-]+", self.expect(0, "facade", verb, "--help").out))
            told = set()
            for line in text.splitlines():
                if f"vug facade {verb}" in line:
                    told |= set(re.findall(r"--[a-z-]+", line))
            self.assertTrue(told, verb)
            self.assertLessEqual(told, known)


if __name__ == "__main__":
    unittest.main()
