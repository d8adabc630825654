# SPDX-License-Identifier: Apache-2.0
"""Working spaces in files, and PNGs through views by name and through OpenColorIO configurations."""
import os
import pathlib
import struct
import unittest

import exr
from vug import VugTest, digest

SCENE = """volume rock = level_set(box(size: (6, 4, 6)) - sphere(1.8m), voxel: 20cm)
mesh wall on rock {}
material ochre = lambert(albedo: (0.7, 0.35, 0.1))
object cave on wall { material ochre }
camera main { eye (-1.2, 0.3, 0.4)  target (1, 0, 0)  fov 70deg }
light lamp = sphere(center: (0.5, 0.6, 0.3), radius: 10cm, radiance: (60, 60, 60))
render main { size 32x20  spp 4  integrator path(roulette: off) }
"""

STUDIO = """ocio_profile_version: 2
roles: {scene_linear: lin, default: lin, aces_interchange: aces}
file_rules: [!<Rule> {name: Default, colorspace: lin}]
displays:
  Wall: [!<View> {name: Dim, colorspace: dim}, !<View> {name: Raw, colorspace: lin}]
active_displays: [Wall]
colorspaces:
  - !<ColorSpace> {name: aces}
  - !<ColorSpace>
    name: lin
    aliases: [lin_rec709]
  - !<ColorSpace>
    name: dim
    from_scene_reference: !<CDLTransform> {slope: [0.5, 0.5, 0.5]}
"""

BLENDER = pathlib.Path("/usr/share/blender/datafiles/colormanagement/config.ocio")


class Colour(VugTest):
    def prepare(self):
        self.write("s.vug", SCENE)
        self.write("studio.ocio", STUDIO)
        self.expect(0, "render", "s.vug", "-o", "plain.exr", "--layers", "all", "--float")
        self.expect(0, "render", "s.vug", "-o", "aces.exr", "--layers", "all", "--float",
                    "--working-space", "acescg", "--multi-part")

    def png(self, *args, **environment):
        for name in ("OCIO",):
            environment.setdefault(name, "")
        self.expect(0, "render", "s.vug", "-o", "view.exr", "--layers", "all", "--float", *args,
                    env={**os.environ, **environment})
        return digest(self.folder / "view.png")

    def test_files_contain_their_primaries(self):
        for name, known, red in (("plain", "lin_rec709_scene", 0.64), ("aces", "lin_ap1_scene", 0.713)):
            for part in exr.read(self.folder / f"{name}.exr"):
                primaries = struct.unpack("<8f", part.attributes["chromaticities"][1])
                self.assertAlmostEqual(primaries[0], red, places=6)
                self.assertEqual(part.text("colorInteropID"), known)

    def test_single_scattering_is_the_same_light_in_both(self):
        # ACEScg to linear Rec.709, as printed by the Academy's tools.
        matrix = ((1.70505, -0.62179, -0.08326), (-0.13026, 1.14080, -0.01055),
                  (-0.02400, -0.12897, 1.15297))
        plain, = exr.read(self.folder / "plain.exr")
        parts = {}
        for part in exr.read(self.folder / "aces.exr"):
            parts.update(part.pixels)
        for layer in ("diffuse_direct", "albedo", "emission"):
            ours = [parts[f"{layer}.{c}"] for c in "RGB"]
            most = max(max(plain.pixels[f"{layer}.{c}"]) for c in "RGB")
            for i, row in enumerate(matrix):
                expected = plain.pixels[f"{layer}.{'RGB'[i]}"]
                for p, value in enumerate(expected):
                    back = sum(m * channel[p] for m, channel in zip(row, ours))
                    self.assertAlmostEqual(back, value, delta=1e-4 * most, msg=(layer, i, p))

    def test_views_by_name(self):
        usual = self.png()
        self.assertEqual(usual, digest(self.folder / "plain.png"))
        self.assertEqual(usual, self.png("--view", "filmic"))
        others = {self.png("--view", view) for view in ("standard", "aces")}
        self.assertEqual(len(others | {usual}), 3)
        said = self.expect(2, "render", "s.vug", "-o", "no.exr", "--view", "acs").err
        self.assertIn("unknown view 'acs'", said)
        self.assertIn("aces, filmic, standard", said)
        self.write("bad.vug", SCENE.replace("spp 4 ", 'spp 4  view "filmik"'))
        self.assertIn("bad.vug:7:8: error: unknown view 'filmik'",
                      self.expect(2, "render", "bad.vug", "-o", "no.exr").err)

    def test_configurations(self):
        dim = self.png("--ocio", "studio.ocio")
        self.assertEqual(dim, self.png("--ocio", "studio.ocio", "--view", "Dim", "--display", "Wall"))
        self.assertEqual(dim, self.png(OCIO=str(self.folder / "studio.ocio")))
        self.assertNotEqual(dim, self.png("--ocio", "studio.ocio", "--view", "Raw"))
        self.assertEqual(self.png("--ocio", "studio.ocio", "--view", "filmic"),
                         digest(self.folder / "plain.png"))
        self.write("bad.ocio", STUDIO[:200])
        self.write("seen.vug", SCENE.replace("spp 4 ", 'spp 4  view "Dim"'))
        for scene in ("s.vug", "seen.vug"):  # the configuration is at fault, not the view that the scene names
            for name in ("nowhere.ocio", "bad.ocio"):
                cause = f"error: {{}}: the colour configuration '{name}' cannot be used: "
                said = self.expect(2, "render", scene, "-o", "no.exr", "--ocio", name).err
                self.assertTrue(said.startswith(cause.format("--ocio")), said)
                said = self.expect(2, "render", scene, "-o", "no.exr", env=dict(os.environ, OCIO=name)).err
                self.assertTrue(said.startswith(cause.format("$OCIO")), said)
        self.expect(0, "render", "seen.vug", "-o", "seen.exr", "--ocio", "studio.ocio")
        self.write("seen.vug", SCENE.replace("spp 4 ", 'spp 4  view "Dimm"'))
        self.assertIn("seen.vug:7:8: error: unknown view 'Dimm' in 'studio.ocio'",
                      self.expect(2, "render", "seen.vug", "-o", "no.exr", "--ocio", "studio.ocio").err)
        said = self.expect(2, "render", "s.vug", "-o", "no.exr", "--ocio", "studio.ocio", "--display",
                           "Screen").err
        self.assertIn("Wall", said)

    def test_parts_merge_to_the_same_view(self):
        args = ("--view", "aces", "--working-space", "acescg", "--exposure", "1")
        self.expect(0, "render", "s.vug", "-o", "whole.exr", *args)
        for i in (1, 2):
            self.expect(0, "render", "s.vug", "--part", f"p{i}", "--tile", f"{i}/2", *args)
        self.expect(0, "merge", "p1", "p2", "-o", "joint.exr")
        for end in ("exr", "png"):
            self.assertEqual(digest(self.folder / f"joint.{end}"), digest(self.folder / f"whole.{end}"))

    def test_pictures_of_two_spaces_are_not_compared(self):
        said = self.expect(2, "diff", "plain.exr", "aces.exr").err
        self.assertIn("acescg", said)
        self.expect(0, "diff", "aces.exr", "aces.exr")

    @unittest.skipUnless(BLENDER.exists(), "Blender's configuration is not installed")
    def test_blenders_configuration(self):
        views = {self.png("--ocio", BLENDER, "--view", view, *space)
                 for view in ("Filmic", "Standard", "Raw")
                 for space in ((), ("--working-space", "acescg"))}
        self.assertGreaterEqual(len(views), 3)


if __name__ == "__main__":
    unittest.main()
