# SPDX-License-Identifier: Apache-2.0
"""`vug facade train`: pixel classifiers from synthetic labelled pictures."""
import json
import struct
import unittest
import zlib

from vug import VugTest

CLASSES = {"0": "wall", "1": "window", "2": "shop"}
COLOURS = [(200, 180, 150), (60, 80, 110), (120, 30, 30)]


def png(width, height, rows, colour):
    """An 8-bit PNG, grey or RGB."""

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", width, height, 8, 2 if colour else 0, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))) + chunk(b"IEND", b""))


def label(x, y, width, height, pitch):
    if y >= height * 4 // 5:
        return 2
    return 1 if x % pitch > pitch // 3 and y % 20 > 8 else 0


def values(path):
    """The pixels of an 8-bit grey PNG."""
    data = path.read_bytes()
    width, height, _, kind = struct.unpack(">IIBB", data[16:26])
    assert kind == 0, f"colour type {kind} instead of grey"
    packed, at = b"", 8
    while at < len(data):
        length = struct.unpack(">I", data[at:at + 4])[0]
        packed += data[at + 8:at + 8 + length] if data[at + 4:at + 8] == b"IDAT" else b""
        at += length + 12
    raw, above, out = zlib.decompress(packed), [0] * width, []
    for y in range(height):
        start = y * (width + 1)
        row = []
        for x, byte in enumerate(raw[start + 1:start + 1 + width]):
            left, corner = (row[x - 1], above[x - 1]) if x >= 1 else (0, 0)
            guess = left + above[x] - corner
            nearest = min((left, above[x], corner), key=lambda near: abs(guess - near))
            row.append((byte + (0, left, above[x], (left + above[x]) // 2, nearest)[raw[start]]) % 256)
        above = row
        out += row
    return out


class FacadeTrain(VugTest):
    def prepare(self):
        for folder in ("set/images", "set/labels"):
            (self.folder / folder).mkdir(parents=True)
        for number in range(4):
            width, height, pitch = 60 + 4 * number, 100, 14 + number
            marks = [[label(x, y, width, height, pitch) for x in range(width)] for y in range(height)]
            noise = [[[c + (x * 7 + y * 13 + number) % 9 for c in COLOURS[mark]] for x, mark in enumerate(row)]
                     for y, row in enumerate(marks)]
            photo = [[value for pixel in row for value in pixel] for row in noise]
            (self.folder / f"set/images/f{number}.png").write_bytes(png(width, height, photo, True))
            (self.folder / f"set/labels/f{number}.png").write_bytes(png(width, height, marks, False))
        (self.folder / "classes.json").write_text(json.dumps(CLASSES))

    def train(self, *more, code=0):
        return self.expect(code, "facade", "train", "set", "--classes", "classes.json", "--trees", 4, *more)

    def test_reports_its_accuracy(self):
        said = self.train("--folds", 2).out
        self.assertGreater(float(said.split("pixel accuracy")[1].split()[0]), 0.95, said)
        self.assertGreater(float(said.split("window overlap")[1].split()[0]), 0.9, said)
        for name in CLASSES.values():
            self.assertIn(f"\n{name}", said)

    def test_same_bytes_for_any_threads(self):
        for threads in (1, 2, 5, 8):
            self.train("-o", f"looks{threads}.json", "--threads", threads)
        first = (self.folder / "looks1.json").read_bytes()
        self.assertEqual(json.loads(first)["classes"], CLASSES)
        for threads in (2, 5, 8):
            self.assertEqual((self.folder / f"looks{threads}.json").read_bytes(), first)

    def test_fits_a_facade_with_the_classifier(self):
        self.train("-o", "looks.json")
        self.expect(0, "facade", "fit", "set/images/f2.png", "--looks", "looks.json", "-o", "out", "--steps", 5000,
                    "--no-carving")
        found, true = (values(self.folder / path) for path in ("out/f2.labels.png", "set/labels/f2.png"))
        self.assertEqual(len(found), len(true))
        self.assertGreater(sum(a == b for a, b in zip(found, true)), 0.95 * len(true))
        tree = json.loads((self.folder / "out/f2.json").read_text())
        self.assertEqual(sum(one["kind"] == "window" for one in tree["elements"]), 16)

    def test_the_help_names_the_required_input(self):
        said = " ".join(self.expect(0, "facade", "train", "--help").out.split())
        self.assertIn("this or --folds is required", said)
        self.assertIn("this or -o is required", said)

    def test_impossible_training_is_reported(self):
        def told(part, *more):
            said = self.train(*more, code=2)
            self.assertIn(part, said.err)
            self.assertFalse((self.folder / "looks.json").exists())

        told("neither -o nor --folds given")
        told("cannot cross-validate 4 pictures with 5 folds", "--folds", 5)
        told("a .json", "-o", "looks.txt")
        told("more than the limit", "-o", "looks.json", "--max-memory", "1K")
        (self.folder / "set/labels/f2.png").write_bytes(png(3, 2, [[0, 0, 0]] * 2, False))
        told("its labels have 3 x 2", "-o", "looks.json")
        (self.folder / "set/labels/f2.png").unlink()
        told("has no labels", "-o", "looks.json")
        (self.folder / "classes.json").write_text("{\n]")
        told("classes.json:2", "-o", "looks.json")
        self.assertNotIn("while while", self.train("-o", "looks.json", code=2).err)


if __name__ == "__main__":
    unittest.main()
