# SPDX-License-Identifier: Apache-2.0
"""vug build --tiles: the tiles have what the whole has, whatever their size; errors."""
import json
import random
import re
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


class TilesTest(VugTest):
    def setUp(self):
        super().setUp()
        self.write("cave.vug", SCENE)

    def build(self, *args, code=0):
        return self.expect(code, "build", "cave.vug", *args)

    def tiles(self, folder):
        return self.folder / folder / "cave.tiles"

    def index(self, folder):
        return json.loads((self.tiles(folder) / "index.json").read_text())


class Tiles(TilesTest):
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

    def test_binary_usd_has_the_same_names(self):
        self.build("-o", "text", "--tiles=64", "--lods", "1")
        self.build("-o", "binary", "--tiles=64", "--lods", "1", "--usd-format", "usdc")
        text, binary = ({path.name for path in self.tiles(folder).iterdir()} for folder in ("text", "binary"))
        renamed = {re.sub(r"usda$", "usdc", name) for name in text}
        self.assertEqual(renamed, binary)
        self.assertIn("assembly.usdc", renamed)
        index = (self.tiles("text") / "index.json").read_text().replace(".usda", ".usdc")
        self.assertEqual(index, (self.tiles("binary") / "index.json").read_text())
        first = self.index("binary")["meshes"][0]["tiles"][0]
        self.assertEqual((self.tiles("binary") / first["usd"]).read_bytes()[:8], b"PXR-USDC")
        self.build("-o", "x", "--tiles=64", "--usd-format", "usdc", code=2)  # needs --lods

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


class Levels(TilesTest):
    """--lods N"""

    PLAIN = SCENE.replace(" smallest_piece 50cm", "")

    def prepare(self):
        self.write("cave.vug", self.PLAIN)
        self.said = self.build("-o", "all", "--tiles=64", "--lods", "2")
        self.write("said.txt", self.said.err)

    def setUp(self):
        super().setUp()
        self.write("cave.vug", self.PLAIN)

    def names(self, folder):
        return sorted(p.name for p in self.tiles(folder).iterdir())

    def assert_same_files(self, folder, other, names):
        for name in names:
            self.assertEqual(digest(self.tiles(folder) / name), digest(self.tiles(other) / name), name)

    def test_are_in_the_index_and_reported(self):
        index = self.index("all")
        self.assertEqual(index["levels"], 2)
        tiles = index["meshes"][0]["tiles"]
        self.assertEqual(len(tiles), 8)
        total = [0, 0, 0]
        for tile in tiles:
            self.assertNotIn("proxy", tile)
            self.assertGreaterEqual(len(tile["levels"]), 1)
            before, distance = tile["triangles"], 0
            total[0] += before
            for i, level in enumerate(tile["levels"], 1):
                self.assertEqual(level["file"], tile["file"].replace(".ply", f"_lod{i}.ply"))
                points, triangles = ply(self.tiles("all") / level["file"])
                self.assertEqual((len(points), len(triangles)), (level["vertices"], level["triangles"]))
                self.assertLessEqual(4 * level["triangles"], 3 * before)
                self.assertGreater(level["distance"], distance)
                before, distance = level["triangles"], level["distance"]
            for i in (1, 2):
                total[i] += tile["levels"][min(i, len(tile["levels"])) - 1]["triangles"]
        said = (self.folder / "said.txt").read_text()
        for i in (1, 2):
            self.assertRegex(said, rf"level {i} of 'cave': {total[i]} of {total[0]} triangles, at most [0-9.]+ ?\w+ off")

    def test_any_mix_is_closed(self):
        meshes = []  # Of each tile the levels, each as a list of triangles of three positions.
        for tile in self.index("all")["meshes"][0]["tiles"]:
            files = [tile["file"]] + [level["file"] for level in tile["levels"]]
            meshes.append([])
            for file in files:
                points, triangles = ply(self.tiles("all") / file)
                meshes[-1].append([tuple(points[i] for i in t) for t in triangles])
        choose = random.Random(3)
        for mix in range(12):
            uses = {}
            for levels in meshes:
                level = levels[-1] if mix == 0 else choose.choice(levels)
                for a, b, c in level:
                    for edge in ((a, b), (b, c), (c, a)):
                        uses[edge] = uses.get(edge, 0) + 1
            self.assertEqual({n for n in uses.values()}, {1})
            self.assertTrue(all((b, a) in uses for a, b in uses))

    def test_change_nothing_else(self):
        self.build("-o", "plain", "--tiles=64")
        names = self.names("plain")
        self.assert_same_files("plain", "all", [name for name in names if name != "index.json"])
        more = self.index("all")
        for tile in more["meshes"][0]["tiles"]:
            del tile["levels"], tile["usd"]
        del more["levels"], more["usd"]
        self.assertEqual(more, self.index("plain"))
        self.build("-o", "none", "--tiles=64", "--lods", "0")
        self.assertEqual(self.names("none"), names)
        self.assert_same_files("none", "plain", names)

    def test_have_the_same_bytes_for_any_number_of_threads(self):
        for threads in ("1", "2", "7"):
            self.build("-o", threads, "--tiles=64", "--lods", "2", "--threads", threads)
            self.assertEqual(self.names(threads), self.names("all"))
            self.assert_same_files(threads, "all", self.names("all"))

    def test_have_the_same_bytes_in_any_order(self):
        for tile in reversed(self.index("all")["meshes"][0]["tiles"]):
            name = ",".join(str(i) for i in tile["tile"])
            said = self.build("-o", "single", "--tiles=64", "--lods", "2", f"--tile={name}")
            self.assertIn("level 1 of 'cave'", said.err)
        names = [name for name in self.names("all") if name not in ("index.json", "assembly.usda")]
        self.assertEqual(self.names("single"), names)
        self.assert_same_files("single", "all", names)

    def test_an_interrupted_run_continues(self):
        run = Running(self.folder, "build", "cave.vug", "-o", "cut", "--tiles=64", "--lods", "2", "--threads", "1")
        records = []
        while run.process.poll() is None and len(records) < 2:
            records = sorted(self.tiles("cut").glob(".cave_*.tile"))
            time.sleep(0.01)
        run.stop(signal.SIGKILL)
        self.assertFalse((self.tiles("cut") / "index.json").exists(), "the run ended before it was killed")
        kept, lost = records[:2]
        # A tile without one of its levels is built again, another one is not.
        lost_level = [file for file in json.loads(lost.read_text())["files"] if "_lod1.usda" in file]
        (self.tiles("cut") / lost_level[0]).unlink()
        files = list(json.loads(kept.read_text())["files"])
        self.assertTrue(any("_lod1.ply" in file for file in files))
        first = {file: (self.tiles("cut") / file).stat().st_mtime_ns for file in files}
        said = self.build("-o", "cut", "--tiles=64", "--lods", "2")
        self.assertEqual(self.names("cut"), self.names("all"))
        self.assert_same_files("cut", "all", self.names("all"))
        self.assertEqual(sorted(said.out.split()), [f"cut/cave.tiles/{name}" for name in self.names("all")])
        for file, modified in first.items():
            self.assertEqual((self.tiles("cut") / file).stat().st_mtime_ns, modified, file)
        # Another number of levels makes other tiles.
        self.build("-o", "cut", "--tiles=64", "--lods", "1")
        self.assertEqual(self.index("cut")["levels"], 1)

    def test_lose_small_pieces(self):
        self.write("cave.vug", SCENE)
        said = self.build("-o", "pieces", "--tiles=64", "--lods", "2").out.split()
        self.assertEqual(sorted(said), [f"pieces/cave.tiles/{name}" for name in self.names("pieces")])
        changed = 0
        whole = {str(tile["tile"]): tile for tile in self.index("all")["meshes"][0]["tiles"]}
        for tile in self.index("pieces")["meshes"][0]["tiles"]:
            if tile["triangles"] == whole[str(tile["tile"])]["triangles"]:
                for level in tile["levels"]:
                    self.assertEqual(ply(self.tiles("pieces") / level["file"]), ply(self.tiles("all") / level["file"]))
                continue
            changed += 1
            # The crumb was between 2.38 m and 2.62 m.
            for level in [tile] + tile["levels"]:
                points, triangles = ply(self.tiles("pieces") / level["file"])
                self.assertEqual(len(triangles), level["triangles"])
                self.assertLess(max(struct.unpack("<3f", p)[1] for p in points), 2.3)
        self.assertGreater(changed, 0)

    def test_usd_shows_all_tiles(self):
        self.write("cave.vug", self.PLAIN + "mesh frond { of leaf(length: 70cm, width: 16cm) }\n")
        self.build("-o", "usd", "--tiles=64", "--lods", "2")
        text = (self.tiles("usd") / "assembly.usda").read_text()
        self.assertIn('defaultPrim = "cave"', text)
        index = self.index("usd")
        for tile in index["meshes"][0]["tiles"]:
            name = tile["usd"][:-len(".usda")].replace("-", "_")
            prim = text[text.index(f'def Xform "{name}"'):]
            prim = prim[:prim.index("\n    }\n")]
            payloads = re.findall(r"prepend payload = @\./(.*)@", prim)
            distances = [float(d) for d in re.findall(r"double vug:distance = (.*)", prim)]
            levels = (tile["levels"] * 2)[:2] if len(tile["levels"]) == 1 else tile["levels"]
            self.assertEqual(payloads, [tile["usd"]] + [level["usd"] for level in levels])
            self.assertEqual(distances, [level["distance"] for level in levels])
            self.assertEqual(re.findall(r'"(full|lod\d)" \(', prim), ["full", "lod1", "lod2"])
            hint = [float(n) for n in re.findall(r"-?\d[\d.e+-]*", re.search(r"extentsHint = (.*)", prim)[1])]
            self.assertEqual(len(hint), 18)
            self.assertEqual(hint[6:9] + hint[9:12], tile["bounds"]["min"] + tile["bounds"]["max"])
            for level in [tile] + tile["levels"]:
                points = [struct.unpack("<3f", p) for p in ply(self.tiles("usd") / level["file"])[0]]
                for axis in range(3):
                    self.assertGreaterEqual(min(p[axis] for p in points), hint[6 + axis])
                    self.assertLessEqual(max(p[axis] for p in points), hint[9 + axis])
                layer = (self.tiles("usd") / level["usd"]).read_text()
                self.assertIn('uniform token purpose = "render"', layer)
                self.assertNotIn("lattice_key", layer)
                self.assertEqual(layer.count("("), layer.count(")"))
                self.assertEqual(len(re.search(r"faceVertexCounts = \[(.*)\]", layer)[1].split(",")), level["triangles"])
            self.assertIn('def Mesh "proxy"', prim)
            self.assertIn('uniform token purpose = "proxy"', prim)
            proxy = re.search(r"faceVertexCounts = \[(.*)\]", prim)[1].split(",")
            self.assertLessEqual(len(proxy), 64)
        self.assertIn("prepend payload = @./frond_whole.usda@", text)
        self.assertTrue((self.tiles("usd") / "frond_whole.usda").exists())
        self.assertEqual(self.expect(0, "recipe", self.tiles("usd") / "assembly.usda").out,
                         self.expect(0, "recipe", self.tiles("usd") / index["meshes"][0]["tiles"][0]["usd"]).out)

    def test_errors(self):
        self.build("-o", "out", "--lods", "2", code=2)
        self.build("-o", "out", "--tiles=64", "--lods", "-1", code=2)
        self.write("cave.vug", "volume rock = level_set(sphere(1m), voxel: 10cm)\n")
        self.assertRegex(self.build("-o", "out", "--tiles=64", "--lods", "2", code=2).err, "mesh rock on rock")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
