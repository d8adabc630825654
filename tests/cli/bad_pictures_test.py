# SPDX-License-Identifier: Apache-2.0
"""Unusable pictures, textures and light profiles: an error that names the file, and exit code 2."""
import math
import random
import struct
import unittest

from pictures import write_hdr, write_png
from vug import VugTest

ROOM = """
volume rock = level_set(sphere(1m), voxel: 20cm)
mesh skin on rock {}
camera main { eye (0, 0, 4)  target (0, 0, 0)  fov 30deg }
render main { size 16x12  spp 4 }
"""


def write_pfm(path, rows):
    """A PFM file; its rows start at the bottom."""
    body = b"".join(struct.pack("<3f", *pixel) for row in reversed(rows) for pixel in row)
    path.write_bytes(f"PF\n{len(rows[0])} {len(rows)}\n-1.0\n".encode() + body)


class BadPictures(VugTest):
    def textured(self, file, more=""):
        self.write("room.vug", ROOM + f'object ball on skin {{ material surface(color: picture(file: "{file}"{more})) }}\n')

    def refused(self, *said, verb="render"):
        end = ["-o", "room.exr"] if verb == "render" else []
        error = self.expect(2, verb, "room.vug", *end).err
        for text in said:
            self.assertIn(text, error)
        self.assertNotIn("room.exr", self.files())

    def test_a_texture_that_is_not_finite(self):
        rows = [[(0.5, 0.5, 0.5)] * 4 for _ in range(3)]
        for bad in (math.nan, math.inf):
            rows[1][2] = (0.5, bad, 0.5)
            write_pfm(self.folder / "bad.pfm", rows)
            self.textured("bad.pfm")
            self.refused("'bad.pfm' contains a number that is not finite", "pixel (2, 1)")
        rows[1][2] = (0.5, 0.5, 0.5)
        write_pfm(self.folder / "bad.pfm", rows)
        self.expect(0, "render", "room.vug", "-o", "room.exr")

    def test_a_sky_that_is_not_finite(self):
        rows = [[(1.0, 1.0, 1.0)] * 4 for _ in range(2)]
        rows[0][1] = (1.0, math.nan, 1.0)
        write_pfm(self.folder / "sky.pfm", rows)
        self.write("room.vug", ROOM + 'light day = sky_image(file: "sky.pfm")\n')
        self.refused("sky.pfm", "not finite")

    def test_a_missing_texture_is_reported_or_shown(self):
        self.textured("gone.png")
        self.refused("room.vug:6:47: error: the picture 'gone.png' does not exist", "missing: show")
        self.textured("gone.png", ", missing: show")
        self.write("room.vug", (self.folder / "room.vug").read_text() + "light even = sky()\n")
        self.expect(0, "render", "room.vug", "-o", "shown.exr", "--float")
        self.write("magenta.vug", ROOM + "object ball on skin { material surface(color: (1, 0, 1)) }\nlight even = sky()\n")
        self.expect(0, "render", "magenta.vug", "-o", "magenta.exr", "--float")
        self.expect(0, "diff", "shown.exr", "magenta.exr", "--max", "max=0")
        self.write("grey.vug", ROOM + "object ball on skin { material surface() }\nlight even = sky()\n")
        self.expect(0, "render", "grey.vug", "-o", "grey.exr", "--float")
        self.expect(1, "diff", "shown.exr", "grey.exr", "--max", "max=0.1")

    def test_a_file_that_is_not_a_picture(self):
        noise = random.Random(5).randbytes(2000)
        self.expect(2, "info", self.write("noise.exr", noise).name)
        for content in (noise, b"", b"\x76\x2f\x31\x01" + noise):
            self.write("noise.exr", content)
            self.textured("noise.exr")
            self.refused("noise.exr")
            self.write("room.vug", ROOM + 'light day = sky_image(file: "noise.exr")\n')
            self.refused("noise.exr")
            write_png(self.folder / "fine.png", [[(9, 9, 9)] * 3] * 2)
            for pair in (("fine.png", "noise.exr"), ("noise.exr", "fine.png")):
                self.assertIn("noise.exr", self.expect(2, "diff", *pair).err)
            self.assertIn("noise.exr", self.expect(2, "merge", "noise.exr", "-o", "out.exr").err)

    def test_library_errors_have_messages_of_vug(self):
        """Messages of libraries do not reach the user unchanged."""
        write_png(self.folder / "fine.png", [[(i, j, 7) for i in range(30)] for j in range(20)])
        self.textured("fine.png")
        self.expect(0, "render", "room.vug", "-o", "a.exr", "--size", "64x64")
        png, picture = ((self.folder / name).read_bytes() for name in ("fine.png", "a.exr"))

        def changed(data, at):
            return data[:at] + bytes(b ^ 0x5a for b in data[at:at + 200]) + data[at + 200:]
        damaged, cut, pixels = "its content is damaged", "it is truncated", "its pixels are damaged or truncated"
        start = "or its beginning is damaged"
        for name, content, said in [
                ("b.png", changed(png, len(png) // 2), damaged), ("c.png", png[:len(png) // 2], cut),
                ("d.png", png[:20], cut), ("e.png", changed(png, 18), damaged), ("f.png", png[:-12], cut),
                ("g.png", b"no picture at all", "it is not a .png image, " + start),
                ("h.exr", picture[:len(picture) * 2 // 3], pixels), ("i.exr", changed(picture, len(picture) // 2), pixels),
                ("j.jpg", b"\xff\xd8\xff\xe0" + bytes(99), start), ("k.tif", b"II*\0" + b"\7" * 99, start),
                ("l.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 40 +X 40\nabc", pixels),
                ("m.gif", b"GIF89a" + b"\7" * 99, "damaged"), ("n.xyz", b"hello", "no image format has the extension .xyz"),
                ("o", b"hello", "its name does not have the extension of an image format")]:
            self.write(name, content)
            with self.subTest(name=name):
                error = self.expect(2, "info", name).err
                self.assertRegex(error, rf"^error: cannot read picture '{name}': [^\n]*{said}\nhint: [^\n]*\n$")
                self.assertEqual(self.expect(2, "diff", name, "a.exr").err.replace(name, ""),
                                 error.replace(name, ""))
        self.textured("b.png")
        error = self.expect(2, "check", "room.vug").err
        self.assertIn(damaged, error)
        self.assertNotIn("libpng", error)

    def test_pictures_of_different_size(self):
        write_hdr(self.folder / "a.hdr", [[(1, 1, 1)] * 4] * 3)
        write_hdr(self.folder / "b.hdr", [[(1, 1, 1)] * 3] * 4)
        error = self.expect(2, "diff", "a.hdr", "b.hdr").err
        for text in ("a.hdr", "b.hdr", "4", "3"):
            self.assertIn(text, error)
        write_hdr(self.folder / "mask.hdr", [[(1, 1, 1)] * 5] * 3)
        write_hdr(self.folder / "c.hdr", [[(1, 1, 1)] * 4] * 3)
        self.expect(2, "diff", "a.hdr", "c.hdr", "--mask", "mask.hdr")
        self.expect(0, "diff", "a.hdr", "c.hdr")

    def test_lights_without_area(self):
        for lamp in ("rect(width: 0, height: 1)", "disk(radius: 0)", "sphere(radius: 0)",
                     "spot(radius: 0)", "portal(width: 0, height: 1)", "rect(normal: (0, 0, 0))"):
            self.write("room.vug", ROOM + f"light lamp = {lamp}\n")
            with self.subTest(lamp=lamp):
                self.refused("room.vug:6:")
                self.refused("room.vug:6:", verb="check")

    def test_an_emissive_mesh_without_area(self):
        """Degenerate triangles emit nothing and do not affect their neighbours."""
        flat = "v -1 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 0\nf 1 2 3\n"
        self.write("flat.obj", flat + "f 3 4 3\n")
        self.write("room.vug", 'volume rock = level_set(mesh(file: "flat.obj"), voxel: 10cm)\n')
        self.expect(2, "check", "room.vug")

    def test_a_camera_in_rock_is_refused(self):
        self.write("room.vug", ROOM.replace("eye (0, 0, 4)", "eye (0, 0, 0.5)"))
        said = self.expect(2, "render", "room.vug", "-o", "room.exr").err
        self.assertIn("error: the camera 'main' at (0, 0, 0.5) is in rock, 0.50 m inside 'skin'", said)
        self.assertFalse((self.folder / "room.exr").exists())
        self.expect(0, "render", "room.vug", "-o", "room.exr", "--anyway")


if __name__ == "__main__":
    unittest.main()
