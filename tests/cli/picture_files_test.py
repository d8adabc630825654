# SPDX-License-Identifier: Apache-2.0
"""Picture files as read by other programs: those of OpenImageIO and OpenEXR, and readers written
from the specifications alone."""
import ctypes
import ctypes.util
import json
import re
import shutil
import struct
import subprocess
import unittest

import exr
from vug import SOURCE, VugTest

SCENE = """seed 5
volume rock = level_set(box(size: (6, 4, 6)) - sphere(1.8m), voxel: 20cm)
volume stone = level_set(sphere(50cm).translate((0.6, -1, 0)), voxel: 10cm)
mesh wall on rock { paint gradient(mask: height(from: -2m, to: 2m), colors: [(0.2, 0.4, 0.6), (0.9, 0.8, 0.7)]) }
mesh pebble on stone {}
material chalk = lambert(albedo: (0.7, 0.7, 0.6))
object cave on wall { material chalk }
object "a_stone" on pebble {}
camera main { eye (-1.2, 0.3, 0.4)  target (1, 0, 0)  fov 70deg }
light lamp = sphere(center: (0.5, 0.6, 0.3), radius: 10cm, radiance: (90, 60, 30))
render main { size 70x40  spp 16 }
""".replace('"a_stone"', "a_stone")


def murmur3(text):
    """MurmurHash3_x86_32 with seed 0."""
    data, mask, h = text.encode(), 0xffffffff, 0

    def mixed(k):
        k = k * 0xcc9e2d51 & mask
        k = (k << 15 | k >> 17) & mask
        return k * 0x1b873593 & mask
    whole = len(data) // 4 * 4
    for i in range(0, whole, 4):
        h ^= mixed(int.from_bytes(data[i:i + 4], "little"))
        h = ((h << 13 | h >> 19) * 5 + 0xe6546b64) & mask
    if len(data) > whole:
        h ^= mixed(int.from_bytes(data[whole:], "little"))
    h ^= len(data)
    for shift, factor in ((16, 0x85ebca6b), (13, 0xc2b2ae35)):
        h = (h ^ h >> shift) * factor & mask
    return h ^ h >> 16


def bits(value):
    return struct.unpack("<I", struct.pack("<f", value))[0]


FORMS = {"plain": (), "tiled": ("--tiled",), "parts": ("--multi-part",),
         "both": ("--multi-part", "--tiled"), "crop": ("--crop", "10,5,50,35"), "full": ("--float",),
         "smooth": ("--denoise",), "deep": ("--deep", "--crop", "10,5,50,35", "--float"),
         "half": ("--deep", "--working-space", "acescg")}
# Files written in addition to the pictures.
DEEP = {"deep": "deep.deep", "half": "half.deep"}


# Sends one layer of a file through Blender's compositor.
BLENDER = """
import bpy
scene = bpy.context.scene
scene.use_nodes = True
tree = scene.node_tree
tree.nodes.clear()
image = tree.nodes.new("CompositorNodeImage")
image.image = bpy.data.images.load("{file}")
result = tree.nodes.new("CompositorNodeComposite")
tree.links.new(image.outputs["{layer}"], result.inputs[0])
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 70, 40, 100
settings = scene.render.image_settings
settings.file_format, settings.color_depth, settings.exr_codec = "OPEN_EXR", "32", "ZIP"
scene.render.filepath = "{out}"
scene.frame_start = scene.frame_end = 1
scene.camera = None
bpy.ops.render.render(animation=True)
"""


def exrcheck():
    """The check of the program exrcheck, called in its library because not every package of OpenEXR has the
    program: a function that returns whether a file is bad, or None if the library is missing."""
    for minor in range(1, 10):
        library = ctypes.util.find_library(f"OpenEXRUtil-3_{minor}")
        if library:
            check = getattr(ctypes.CDLL(library), f"_ZN7Imf_3_{minor}16checkOpenEXRFileEPKcbbb")
            check.restype, check.argtypes = ctypes.c_bool, [ctypes.c_char_p] + [ctypes.c_bool] * 3
            return lambda path: any(check(str(path).encode(), False, False, core) for core in (False, True))
    return None


class PictureFiles(VugTest):
    def prepare(self):
        self.write("s.vug", SCENE)
        for name, form in FORMS.items():
            self.expect(0, "render", "s.vug", "-o", f"{name}.exr", "--layers", "all", *form)

    def tool(self, *args):
        """Output of an external program; skips the test if it is missing."""
        if not shutil.which(args[0]):
            self.skipTest(f"{args[0]} is not installed")
        run = subprocess.run(args, cwd=self.folder, text=True, capture_output=True)
        self.assertEqual(run.returncode, 0, f"{args}: {run.stdout} {run.stderr}")
        return run.stdout

    def channels(self, name):
        """Pixels of all channels of all parts."""
        found = {}
        for part in exr.read(self.folder / f"{name}.exr"):
            found.update(part.pixels)
        return found

    def test_external_programs_accept_them(self):
        for name in [*FORMS, *DEEP.values()]:
            for program in (["oiiotool", "--info", "-v", "--stats"], ["exrinfo", "-s", "-v"],
                            ["exrheader"]):
                if not shutil.which(program[0]):
                    continue
                run = subprocess.run([*program, f"{name}.exr"], cwd=self.folder, text=True,
                                     capture_output=True)
                self.assertEqual(run.returncode, 0, f"{program} {name}: {run.stderr}")
                self.assertNotIn("error", run.stderr.lower(), f"{program} {name}")
                if program[0] == "oiiotool" and name in FORMS:
                    self.assertIn("NanCount: 0 0 0", run.stdout)

    def test_channels_are_those_of_another_program(self):
        for name in FORMS:
            with self.subTest(name=name):
                listed = re.search("channel list: (.*)", self.tool("oiiotool", "--info", "-v", f"{name}.exr")).group(1)
                found = json.loads(self.expect(0, "info", f"{name}.exr", "--json").out)["channels"]
                first = [re.sub(r" \(.*", "", channel) for channel in listed.split(", ")]
                self.assertEqual([channel.split()[0] for channel in found][:len(first)], first)

    def test_pngs_of_another_program_have_its_values(self):
        """Grey and colour, 8 and 16 bits, interlaced, with alpha or an offset: as converted to TIFF by the same program."""
        ramp = ["--pattern", "fill:topleft=0,0.1,0.9:topright=1,0.3,0:bottomleft=0.5,1,0.2:bottomright=0,0,1", "61x47", "3"]
        forms = {"colour8": ["-d", "uint8"], "colour16": ["-d", "uint16"], "grey8": ["--ch", "R", "-d", "uint8"],
                 "grey16": ["--ch", "R", "-d", "uint16"], "alpha8": ["--ch", "R,G,B,A=0.5", "-d", "uint8"],
                 "offset8": ["--origin", "+3+4", "-d", "uint8"]}
        for name, options in forms.items():
            with self.subTest(name=name):
                self.tool("oiiotool", *ramp, *options, "-o", f"{name}.png")
                self.tool("oiiotool", f"{name}.png", "-o", f"{name}.tif")
                self.expect(0, "diff", f"{name}.png", f"{name}.tif", "--max", "max=0")

    def test_exrcheck_finds_nothing(self):
        is_bad = exrcheck()
        if not is_bad:
            self.skipTest("OpenEXRUtil is not installed")
        for name in [*FORMS, *DEEP.values()]:
            self.assertFalse(is_bad(self.folder / f"{name}.exr"), name)
        whole = (self.folder / "plain.exr").read_bytes()
        self.write("cut.exr", whole[:len(whole) // 2])
        self.assertTrue(is_bad(self.folder / "cut.exr"))

    def test_every_form_holds_the_same_pixels(self):
        plain = self.channels("plain")
        for name in ("tiled", "parts", "both"):
            self.assertEqual(self.channels(name), plain, name)
        crop = self.channels("crop")
        self.assertEqual(crop.keys(), plain.keys())
        for channel, values in crop.items():
            for y in range(30):
                self.assertEqual(values[40 * y:40 * y + 40],
                                 plain[channel][70 * (y + 5) + 10:70 * (y + 5) + 50], channel)

    def test_the_denoised_layer_replaces_nothing(self):
        plain, smooth = self.channels("plain"), self.channels("smooth")
        self.assertEqual(smooth.keys() - plain.keys(), {"denoised.R", "denoised.G", "denoised.B"})
        for channel, values in plain.items():
            self.assertEqual(smooth[channel], values)
        self.assertNotEqual(smooth["denoised.G"], plain["G"])

    def test_denoising_adds_the_layers_that_it_needs(self):
        self.expect(0, "render", "s.vug", "-o", "few.exr", "--denoise", "--layers", "beauty,Z")
        few, smooth = self.channels("few"), self.channels("smooth")
        self.assertEqual({name.split(".")[0] for name in few},
                         {"R", "G", "B", "Z", "N", "albedo", "variance", "denoised"})
        for channel, values in few.items():
            self.assertEqual(smooth[channel], values)

    def test_deep_pictures_composite_to_the_beauty(self):
        for name, tolerance in (("deep", 1e-5), ("half", 2e-3)):
            self.tool("oiiotool", f"{name}.deep.exr", "--flatten", "-d", "float", "-o", "flat.exr")
            flat, = exr.read(self.folder / "flat.exr")
            plain = self.channels(name)
            for channel in "RGBA":
                for ours, theirs in zip(plain[channel], flat.pixels[channel]):
                    self.assertAlmostEqual(ours, theirs, delta=tolerance * (1 + abs(ours)))
            deep, = exr.read(self.folder / f"{name}.deep.exr")
            self.assertEqual(deep.text("type"), "deepscanline")
            self.assertEqual({c for c, _ in deep.channels}, {"R", "G", "B", "A", "Z", "ZBack"})
            for i in range(deep.width * deep.height):
                near, far = deep.pixels["Z"][i], deep.pixels["ZBack"][i]
                self.assertTrue(0 < len(near) <= 16)
                self.assertTrue(all(a <= b for a, b in zip(near, far)))
                self.assertTrue(all(b < a for b, a in zip(far, near[1:])))
                light, hidden = 0, 0
                for colour, alpha in zip(deep.pixels["G"][i], deep.pixels["A"][i]):
                    light, hidden = light + (1 - hidden) * colour, hidden + (1 - hidden) * alpha
                self.assertAlmostEqual(light, plain["G"][i], delta=tolerance * (1 + abs(light)))
            told = self.tool("oiiotool", "--info", "-v", "--stats", f"{name}.deep.exr")
            self.assertIn("6 channel, deep", told)
            self.assertIn("vug:recipe", told)
            self.assertIn("worldToCamera", told)

    def test_deep_pictures_are_the_same_however_they_are_rendered(self):
        deep = lambda name: (self.folder / f"{name}.deep.exr").read_bytes()
        form = ("--layers", "all", *FORMS["deep"])
        self.expect(0, "render", "s.vug", "-o", "again.exr", *form, "--preview", "p.png", "--checkpoint", "c")
        self.assertEqual(deep("again"), deep("deep"))
        for number, args in enumerate((["--tile", "2/2"], ["--tile", "1/2", "--samples", "9..16"],
                                       ["--tile", "1/2", "--samples", "0..9"])):
            self.expect(0, "render", "s.vug", "--part", f"part{number}", *form, *args)
        said = self.expect(0, "merge", "part0", "part1", "part2", "-o", "merged.exr").out
        self.assertEqual(said.split(), ["merged.exr", "merged.png", "merged.deep.exr"])
        self.assertEqual(deep("merged"), deep("deep"))
        self.expect(0, "render", "s.vug", "-o", "noisy.exr", "--deep", "--noise", "0.1")
        said = self.expect(2, "render", "s.vug", "--part", "no.part", "--deep", "--spp", "65536",
                           "--max-memory", "1G").err
        self.assertIn("use a smaller --size", said)
        self.assertFalse(any(name.startswith("no.") for name in self.files()))

    def test_a_deep_picture_is_not_a_flat_image(self):
        self.assertIn("not a flat image", self.expect(2, "diff", "deep.deep.exr", "deep.deep.exr").err)

    def test_info_prints_the_lens_data_of_photographs(self):
        photo = SOURCE / "tests/data/pictures/photo_with_lens_data.jpg"
        data = json.loads(self.expect(0, "info", photo, "--json").out)["metadata"]
        self.assertEqual((data["Exif:FocalLength"], data["Exif:FocalLengthIn35mmFilm"]), ("16", "24"))

    def test_info_describes_a_deep_picture(self):
        flat = json.loads(self.expect(0, "info", "deep.exr", "--json").out)
        told = json.loads(self.expect(0, "info", "deep.deep.exr", "--json").out)
        self.assertEqual((flat["type"], told["type"]), ("picture", "deep picture"))
        self.assertEqual((told["width"], told["height"]), (flat["width"], flat["height"]))
        self.assertEqual([c.split()[0] for c in told["channels"]], ["R", "G", "B", "A", "Z", "ZBack"])
        self.assertEqual(told["metadata"]["vug:recipe"], flat["metadata"]["vug:recipe"])
        part, = exr.read(self.folder / "deep.deep.exr")
        self.assertEqual(told["samples"], sum(len(z) for z in part.pixels["Z"]))
        whole = (self.folder / "deep.deep.exr").read_bytes()
        self.write("cut.exr", whole[:len(whole) // 2])
        self.expect(2, "info", "cut.exr")

    def test_stereo_is_two_parts_that_name_their_view(self):
        self.write("two.vug", SCENE.replace("fov 70deg", "fov 70deg  interaxial 20cm  convergence 1m"))
        two = lambda *args, code=0: self.expect(code, "render", "two.vug", *args)
        for name, form, count in (("pair", (), 2), ("split", ("--multi-part",), 12)):
            two("-o", f"{name}.exr", *form)
            parts = exr.read(self.folder / f"{name}.exr")
            self.assertEqual(len(parts), count)
            for part in parts:
                self.assertIn(part.text("view"), ("left", "right"))
                self.assertTrue(part.text("name").startswith(part.text("view")))
            for program in (["oiiotool", "--info", "-v", "-a"], ["exrinfo", "-s", "-v"], ["exrheader"]):
                run = subprocess.run([*program, f"{name}.exr"], cwd=self.folder, text=True,
                                     capture_output=True)
                self.assertEqual(run.returncode, 0, run.stderr)
        left, right = exr.read(self.folder / "pair.exr")
        for side, part in (("left", left), ("right", right)):
            two("-o", "one.exr", "--eye", side)
            one, = exr.read(self.folder / "one.exr")
            self.assertEqual(one.pixels, part.pixels)
            self.assertEqual(one.attributes["worldToNDC"], part.attributes["worldToNDC"])
        self.assertNotEqual(left.pixels["Z"], right.pixels["Z"])
        self.assertNotEqual(left.attributes["worldToCamera"], right.attributes["worldToCamera"])
        self.expect(0, "diff", "pair.exr", "pair.exr")
        self.assertIn("--eye", two("-o", "x.exr", "--checkpoint", "c", code=2).err)
        self.assertIn("interaxial", self.expect(2, "render", "s.vug", "-o", "x.exr", "--eye",
                                                "left").err)

    def test_a_deep_picture_of_two_views_has_both(self):
        """The scene's `deep true` and --deep are equivalent."""
        two = SCENE.replace("fov 70deg", "fov 70deg  interaxial 20cm  convergence 1m")
        self.write("two.vug", two)
        self.write("deep.vug", two.replace("spp 16", "spp 16  deep true"))
        said = self.expect(0, "render", "deep.vug", "-o", "pair.exr", "--float").out
        self.assertEqual(said.split(), ["pair.exr", "pair.png", "pair.deep.exr"])
        self.expect(0, "render", "two.vug", "-o", "flag.exr", "--float", "--deep")
        flat, deep, flag = (exr.read(self.folder / name)
                            for name in ("pair.exr", "pair.deep.exr", "flag.deep.exr"))
        self.assertEqual([part.pixels for part in deep], [part.pixels for part in flag])
        self.assertEqual([part.text("view") for part in deep], ["left", "right"])
        self.assertEqual([part.text("name") for part in deep], ["left", "right"])
        self.assertNotEqual(deep[0].pixels["Z"], deep[1].pixels["Z"])
        for whole, part in zip(flat, deep):
            self.assertEqual(part.attributes["worldToCamera"], whole.attributes["worldToCamera"])
            for i, (colours, alphas) in enumerate(zip(part.pixels["G"], part.pixels["A"])):
                light, hidden = 0, 0
                for colour, alpha in zip(colours, alphas):
                    light, hidden = light + (1 - hidden) * colour, hidden + (1 - hidden) * alpha
                self.assertAlmostEqual(light, whole.pixels["G"][i], delta=1e-5 * (1 + light))
        told = self.tool("oiiotool", "--info", "-v", "-a", "pair.deep.exr")
        self.assertIn("6 channel, deep", told)
        self.assertEqual(told.count("worldToCamera"), 2)

    def test_parts_are_layers(self):
        names = [part.text("name") for part in exr.read(self.folder / "parts.exr")]
        self.assertEqual(len(names), len(set(names)))
        for name in ("beauty", "Z", "N", "diffuse_direct", "CryptoObject", "attribute_Cd"):
            self.assertIn(name, names)

    @unittest.skipUnless(shutil.which("blender"), "Blender is not installed")
    def test_blender_reads_every_layer_of_a_multi_part_file(self):
        for layer, channels in (("Combined", "RGB"), ("albedo", ["albedo.R", "albedo.G", "albedo.B"]),
                                ("diffuse_direct", [f"diffuse_direct.{c}" for c in "RGB"])):
            script = self.write("show.py", BLENDER.format(file=self.folder / "parts.exr", layer=layer,
                                                          out=self.folder / f"{layer}_"))
            run = subprocess.run(["blender", "--background", "--factory-startup", "--python",
                                  script], text=True, capture_output=True)
            self.assertNotIn("Error", run.stdout + run.stderr)
            shown = {}
            for part in exr.read(self.folder / f"{layer}_0001.exr"):
                shown.update(part.pixels)
            plain = self.channels("plain")
            for ours, theirs in zip(channels, "RGB"):
                for a, b in zip(plain[ours], shown[theirs]):
                    self.assertAlmostEqual(a, b, delta=1e-3 * abs(a) + 1e-6)

    def test_headers_contain_metadata(self):
        part, = exr.read(self.folder / "crop.exr")
        self.assertEqual(part.window, (10, 5, 49, 34))
        self.assertEqual(part.display, (0, 0, 69, 39))
        self.assertEqual(part.text("vug:seed"), "5")
        self.assertEqual(part.text("vug:spp"), "16")
        self.assertIn("sphere(1.8m)", part.text("vug:recipe"))
        self.assertRegex(part.text("vug:version"), r"\d+\.\d+")
        self.assertEqual(part.attributes["chromaticities"][0], "chromaticities")
        whole, = exr.read(self.folder / "full.exr")
        ndc = struct.unpack("<16f", whole.attributes["worldToNDC"][1])
        self.assertEqual(whole.attributes["worldToCamera"][0], "m44f")
        # Positions of the P layer, averaged over a pixel, land in that pixel.
        for x, y in ((5, 5), (35, 20), (64, 33)):
            at = 70 * y + x
            p = [whole.pixels[f"P.{axis}"][at] for axis in "XYZ"] + [1]
            u, v, _, w = (sum(p[r] * ndc[4 * r + c] for r in range(4)) for c in range(4))
            self.assertAlmostEqual(u / w * 70, x + 0.5, delta=0.6)
            self.assertAlmostEqual(v / w * 40, y + 0.5, delta=0.6)

    def test_biased_settings_are_in_the_header(self):
        ball = ("volume rock = level_set(sphere(1m), voxel: 20cm)\ncamera main { eye (0, 0, 4) }\n"
                "render main { size 8x6  spp 1  integrator path(INEXACT) }\n")
        for options, said in (("regularize: 0.5", "regularize 0.5"), ("clamp: 3", "clamp 3"), ("max_bounces: 4", None)):
            self.write("ball.vug", ball.replace("INEXACT", options))
            self.expect(0, "render", "ball.vug", "-o", "ball.exr")
            part, = exr.read(self.folder / "ball.exr")
            if said:
                self.assertEqual(part.text("vug:inexact"), said)
            else:
                self.assertNotIn("vug:inexact", part.attributes)

    def test_fire_of_a_file_of_grids(self):
        fire = SOURCE / "tests" / "data" / "volumes" / "fire.vdb"
        self.write("fire.vug", f'medium fire = cloud(file: "{fire}", extinction: 1/m, temperature_grid: "temperature", '
                               'temperature: 1, emission_grid: "flame", color_grid: "Cd")\n'
                               "light none = sky(radiance: (0, 0, 0))\n"
                               "camera main { eye (0, 0, 5) }\nrender main { size 8x6  spp 16 }\n")
        self.expect(0, "render", "fire.vug", "-o", "fire.exr")
        part, = exr.read(self.folder / "fire.exr")
        middle = 8 * 3 + 4
        self.assertGreater(part.pixels["R"][middle], part.pixels["G"][middle])
        self.assertGreater(part.pixels["G"][middle], 0)
        self.write("fire.vug", (self.folder / "fire.vug").read_text().replace('"flame"', '"flames"'))
        error = self.expect(2, "render", "fire.vug", "-o", "fire.exr").err
        self.assertIn("fire.vug:1:", error)
        self.assertIn("has no grid named 'flames'", error)

    def test_cryptomatte_decodes(self):
        for name in ("plain", "parts"):
            parts = exr.read(self.folder / f"{name}.exr")
            for layer, names in (("CryptoObject", {"cave", "a_stone"}),
                                 ("CryptoMaterial", {"chalk", "default"})):
                part = next(p for p in parts if f"{layer}00.R" in p.pixels)
                key = f"cryptomatte/{murmur3(layer):08x}"[:19]
                self.assertEqual(part.text(f"{key}/name"), layer)
                self.assertEqual(part.text(f"{key}/hash"), "MurmurHash3_32")
                self.assertEqual(part.text(f"{key}/conversion"), "uint32_to_float32")
                manifest = json.loads(part.text(f"{key}/manifest"))
                self.assertEqual(set(manifest), names)
                for known, hexadecimal in manifest.items():
                    self.assertEqual(int(hexadecimal, 16), murmur3(known))
                alpha = next(p for p in parts if "A" in p.pixels).pixels["A"]
                ids = {int(h, 16): n for n, h in manifest.items()}
                covered = dict.fromkeys(manifest, 0.0)
                for i, a in enumerate(alpha):
                    total, before = 0, 2
                    for rank in range(6):
                        at, share = ("RG", "BA")[rank % 2]
                        identity = part.pixels[f"{layer}{rank // 2:02}.{at}"][i]
                        coverage = part.pixels[f"{layer}{rank // 2:02}.{share}"][i]
                        self.assertLessEqual(coverage, before)
                        before = coverage
                        if coverage > 0:
                            covered[ids[bits(identity)]] += coverage
                            total += coverage
                    self.assertAlmostEqual(total, 1, delta=0.01 + abs(1 - a))
                self.assertTrue(all(share > 10 for share in covered.values()), covered)


if __name__ == "__main__":
    unittest.main()
