# SPDX-License-Identifier: Apache-2.0
"""vug build --tiles: the tiles have what the whole has, whatever their size; errors."""
import json
import signal
import struct
import time
import unittest

from vug import Running, VugTest, digest

# A rough rock with caves, crumbs that smallest_piece removes, and a wide inside.
SCENE = """let rock = displace(box((5m, 3m, 4m)), noise: fbm(scale: 60cm, octaves: 3), amount: 20cm)
let crumb = sphere(12cm).translate((0m, 2.5m, 0m))
volume cave = level_set(union([difference(rock, sphere(90cm)), crumb]), voxel: 5cm)
mesh cave on cave { smallest_piece 50cm }
"""


def ply(path):
    """Vertices (as bytes of x, y, z) and triangles of a binary PLY file."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    vertices = faces = 0
    properties = []
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[:2] == ["element", "vertex"]:
            vertices = int(words[2])
        elif words[:2] == ["element", "face"]:
            faces = int(words[2])
        elif words[0] == "property" and words[1] != "list":
            properties.append(words)
    sizes = {"float": 4, "int": 4, "uint": 4, "uchar": 1, "char": 1, "short": 2, "ushort": 2, "double": 8}
    stride = sum(sizes[p[1]] for p in properties)
    points = [data[end + i * stride:end + i * stride + 12] for i in range(vertices)]
    at = end + vertices * stride
    triangles = []
    for _ in range(faces):
        assert data[at] == 3
        triangles.append(struct.unpack_from("<3I", data, at + 1))
        at += 13
    return points, triangles


def corners(path):
    """The triangles by the positions of their corners, from the smallest one, and their number."""
    points, triangles = ply(path)
    out = []
    for t in triangles:
        p = [points[i] for i in t]
        k = p.index(min(p))
        out.append(tuple(p[k:] + p[:k]))
    return out


class Tiles(VugTest):
    def setUp(self):
        super().setUp()
        self.write("cave.vug", SCENE)

    def build(self, *args, code=0):
        return self.expect(code, "build", "cave.vug", *args)

    def tiles(self, folder):
        return self.folder / folder / "cave.tiles"

    def index(self, folder):
        return json.loads((self.tiles(folder) / "index.json").read_text())

    def test_have_the_triangles_of_the_whole(self):
        self.build("-o", "whole")
        whole = sorted(corners(self.folder / "whole" / "cave.ply"))
        active = None
        for edge in (64, 136):
            folder = f"tiles{edge}"
            self.build("-o", folder, f"--tiles={edge}")
            index = self.index(folder)
            self.assertEqual(index["edge"], edge)
            mesh, volume = index["meshes"][0], index["volumes"][0]
            self.assertEqual(mesh["pieces_removed"], 1)
            found = []
            for tile in mesh["tiles"]:
                own = corners(self.tiles(folder) / tile["file"])
                self.assertEqual(len(own), tile["triangles"])
                found += own
            self.assertEqual(sorted(found), whole)
            total = sum(tile["active_voxels"] for tile in volume["tiles"])
            self.assertIn(active, (None, total))
            active = total
        self.assertGreater(len(index["volumes"][0]["tiles"]), 3)

    def test_can_be_built_one_at_a_time(self):
        self.write("cave.vug", SCENE.replace(" smallest_piece 50cm", ""))
        self.build("-o", "all", "--tiles=64")
        tile = self.index("all")["volumes"][0]["tiles"][1]
        name = ",".join(str(i) for i in tile["tile"])
        said = self.build("-o", "one", "--tiles=64", f"--tile={name}", "--threads", "1").out
        self.assertEqual(len(said.splitlines()), 2)
        for line in said.splitlines():
            path = self.folder / line
            self.assertEqual(digest(path), digest(self.tiles("all") / path.name))
        self.assertFalse((self.tiles("one") / "index.json").exists())

    def test_an_interrupted_run_continues(self):
        self.build("-o", "all", "--tiles=64")
        files = sorted(p.name for p in self.tiles("all").iterdir())
        self.assertEqual([name for name in files if name.startswith(".")], [])
        run = Running(self.folder, "build", "cave.vug", "-o", "cut", "--tiles=64", "--threads", "1")
        records = []
        while run.process.poll() is None and len(records) < 3:
            records = sorted(self.tiles("cut").glob(".cave_*.tile"))
            time.sleep(0.01)
        run.stop(signal.SIGKILL)
        self.assertFalse((self.tiles("cut") / "index.json").exists(), "the run ended before it was killed")
        # A damaged record, and one whose file is incomplete, do not count.
        kept, damaged, incomplete = records[:3]
        damaged.write_text(damaged.read_text()[:40])
        file = self.tiles("cut") / next(iter(json.loads(incomplete.read_text())["files"]))
        file.write_bytes(file.read_bytes()[:100])
        first = {file: (self.tiles("cut") / file).stat().st_mtime_ns for file in json.loads(kept.read_text())["files"]}
        said = self.build("-o", "cut", "--tiles=64").out
        self.assertEqual(len(said.splitlines()), len(files))
        self.assertEqual(sorted(p.name for p in self.tiles("cut").iterdir()), files)
        for name in files:
            self.assertEqual(digest(self.tiles("cut") / name), digest(self.tiles("all") / name), name)
        for file, modified in first.items():
            if "vdb" in file:
                self.assertEqual((self.tiles("cut") / file).stat().st_mtime_ns, modified)

    def test_can_be_rebuilt_from_a_tile(self):
        self.write("cave.vug", SCENE.replace(" smallest_piece 50cm", ""))
        self.build("-o", "all", "--tiles=64")
        tile = self.index("all")["volumes"][0]["tiles"][0]
        source = self.tiles("all") / tile["file"]
        self.write("again/cave.vug", self.expect(0, "recipe", source).out)
        name = ",".join(str(i) for i in tile["tile"])
        self.expect(0, "build", "again/cave.vug", "-o", "again", "--tiles=64", f"--tile={name}")
        self.assertEqual(digest(source), digest(self.tiles("again") / tile["file"]))

    def test_warn_of_what_they_lack(self):
        self.write("cave.vug", SCENE.replace("smallest_piece 50cm", "adaptivity 0.5 paint (1, 0, 0)")
                   + "mesh frond { of leaf(length: 70cm, width: 16cm) }\n")
        said = self.build("-o", "out", "--tiles=512")
        self.assertIn("keep all polygons", said.err)
        self.assertIn("have no colours", said.err)
        names = {mesh["name"]: mesh for mesh in self.index("out")["meshes"]}
        self.assertTrue((self.tiles("out") / names["frond"]["file"]).exists())
        self.assertEqual(len(names["cave"]["tiles"]), 8)

    def test_errors(self):
        for edge in ("63", "100", "0", "-64", "100000"):
            self.assertRegex(self.build("-o", "out", f"--tiles={edge}", code=2).err, "multiple of 8|error")
        self.assertRegex(self.build("-o", "out", "--tiles=64", "--tile", "0,0", code=2).err, "does not name a tile")
        self.assertRegex(self.build("-o", "out", "--tiles=64", "--tile", "0,0,0", code=2).err, "smallest_piece 0")
        self.build("-o", "out", "--tile", "0,0,0", code=2)
        self.write("cave.vug", SCENE.replace(" smallest_piece 50cm", ""))
        self.assertRegex(self.build("-o", "out", "--tiles=64", "--tile", "90,0,0", code=2).err, "does not cross")
        self.write("cave.vug", SCENE.replace("smallest_piece 50cm", "smallest_piece 50cm format stl"))
        self.assertRegex(self.build("-o", "out", "--tiles", code=2).err, "format ply")
        self.write("cave.vug", SCENE.replace("voxel: 5cm", "voxel: 5cm, distance: exact"))
        self.assertRegex(self.build("-o", "out", "--tiles", code=2).err, "exact distances")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
