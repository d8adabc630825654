# SPDX-License-Identifier: Apache-2.0
"""Objects that are traced without a mesh: the same picture in less memory, and their restrictions."""
import re
import unittest

import exr
from vug import VugTest, digest

SCENE = """
param direct = true
volume rock   = level_set(displace(sphere(1m), noise: fbm(scale: 1m, octaves: 1), amount: 30cm), voxel: 5cm)
volume ground = level_set(box(size: (8, 0.4, 8)).translate((0, -1.2, 0)), voxel: 10cm)
mesh skin on rock { smallest_piece 20cm  paint layer(under: (0.6, 0.3, 0.1), over: (0.1, 0.4, 0.1), mask: slope(from: 70deg, to: 20deg)) }
mesh floor on ground {}
material stone_of = surface(color: layer(under: vertex_color(), over: (0.1, 0.1, 0.3), mask: cavity(radius: 20cm)), roughness: 0.6)
object stone on skin { direct direct  material stone_of }
object earth on floor { direct direct }
place three { of stone  at [(0, 0, 0), pose(position: (2.2, -0.2, 0), yaw: 40deg, scale: 0.7), pose(position: keys(1: (-2.4, -0.2, 0), 2: (-2.1, -0.2, 0)), stretch: (0.7, 0.8, -0.7))]  apart true }
camera main { eye (0, 2, 6)  target (0, -0.2, 0)  fov 50deg  shutter 0.5 }
light lamp = sphere(center: (2, 4, 3), radius: 40cm, radiance: (30, 28, 25), except: ["three/2"])
light even = sky(radiance: (0.2, 0.25, 0.3))
render main { size 64x40  spp 64  layers ["beauty", "Z", "N", "albedo", "variance", "motion", "CryptoObject"] }
"""


class Direct(VugTest):
    def prepare(self):
        self.write("s.vug", SCENE)
        self.expect(0, "render", "s.vug", "-o", "direct.exr", "--float")
        self.expect(0, "render", "s.vug", "-o", "mesh.exr", "--float", "-D", "direct=false", "--seed", 2)

    def test_the_picture_is_that_of_the_mesh(self):
        """The significance test attributes all differences to noise; the other layers have no noise."""
        self.expect(0, "diff", "mesh.exr", "direct.exr")
        mesh, direct = (exr.read(self.folder / f"{name}.exr")[0] for name in ("mesh", "direct"))
        self.assertEqual(mesh.attributes["cryptomatte/" + self.key(mesh) + "/manifest"],
                         direct.attributes["cryptomatte/" + self.key(direct) + "/manifest"])
        for name, close in [("Z", 0.05), ("N.X", 0.05), ("N.Y", 0.05), ("albedo.G", 0.02), ("motion.X", 0.05),
                            ("CryptoObject00.G", 0.05)]:
            with self.subTest(layer=name):
                apart = sorted(abs(a - b) for a, b in zip(mesh.pixels[name], direct.pixels[name]))
                # All pixels except silhouettes, where the mesh and the level set may cover different samples.
                self.assertLess(apart[len(apart) * 8 // 10], close)

    def key(self, part):
        return next(re.match(r"cryptomatte/(\w+)/", name)[1] for name in part.attributes
                    if name.startswith("cryptomatte/"))

    def test_same_bytes_for_any_number_of_threads(self):
        for threads in (1, 2, 5, 8):
            self.expect(0, "render", "s.vug", "-o", "again.exr", "--float", "--threads", threads)
            self.assertEqual(digest(self.folder / "again.exr"), digest(self.folder / "direct.exr"), threads)

    def test_it_needs_less_memory_and_estimates_less(self):
        self.write("large.vug", "volume rock = level_set(sphere(3m), voxel: 1cm)\nmesh skin on rock {}\n"
                                "param direct = true\nobject ball on skin { direct direct }\n"
                                "camera main { eye (0, 0, 30) }\nrender main { size 8x6  spp 1 }\n")
        limit = ("--max-memory", "300M")
        error = self.expect(2, "render", "large.vug", "-o", "a.exr", "-D", "direct=false", *limit).err
        self.assertIn("while making the mesh 'skin'", error)
        self.expect(0, "render", "large.vug", "-o", "a.exr", *limit)
        error = self.expect(2, "render", "large.vug", "-o", "b.exr", "--max-memory", "100M").err
        self.assertIn("while making the surface of 'skin'", error)
        self.assertNotIn("b.exr", self.files())

    def test_emissive_objects_need_a_mesh(self):
        start = "volume v = level_set(sphere(1m), voxel: 20cm)\nmesh m on v {}\n"
        for shines in ("emission (1, 1, 1)", "material surface(emission_radiance: 2)"):
            self.write("lamp.vug", start + f"object lamp on m {{ direct true  {shines} }}\n")
            error = self.expect(2, "check", "lamp.vug").err
            self.assertIn("'lamp' is emissive, for which it needs a mesh", error)
            self.assertIn("lamp.vug:3:", error)

    def test_objects_with_holes_need_a_mesh(self):
        """Opacity cuts holes into meshes only; the tracer of level sets does not evaluate it."""
        self.write("holes.vug", "volume v = level_set(sphere(1m), voxel: 20cm)\nmesh skin on v {}\n"
                                "object sieve on skin { direct true  material surface(opacity: 0.5) }\n"
                                "camera main { eye (0, 0, 4) }\nrender main { size 8x6  spp 1 }\n")
        for args in (("check", "holes.vug"), ("render", "holes.vug", "-o", "holes.exr")):
            self.assertIn("holes.vug:3:8: error: 'sieve' has a material with an opacity mask, for which it needs a mesh",
                          self.expect(2, *args).err)
        self.write("holes.vug", (self.folder / "holes.vug").read_text().replace("direct true", "emission (1, 1, 1)"))
        self.assertIn("holes.vug:3:8: error: 'sieve' is emissive and its material has an opacity mask", self.expect(2, "check", "holes.vug").err)
        self.assertNotIn("holes.exr", self.files())

    def test_only_level_sets_are_traced_directly(self):
        self.write("twig.vug", "grammar twig: lsystem { axiom F(1, 1cm) }\n"
                               "mesh bark { of stems(of: twig) }\nobject rod on bark { direct true }\n")
        self.assertIn("twig.vug:3:8: error: 'rod' has 'direct', but 'bark' is not a mesh of a level set",
                      self.expect(2, "check", "twig.vug").err)


if __name__ == "__main__":
    unittest.main()
