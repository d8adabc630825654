# SPDX-License-Identifier: Apache-2.0
"""The same bytes for any number of threads and for two runs: grids, meshes, pictures, trees."""
import unittest

from vug import VugTest, digest

# Everything that could depend on the order of threads: random choices of grammars, morphs, smooth unions,
# displacement, repair, polishing, paint, media, coats and portals.
SCENE = """seed 11
grammar cave {
  axiom Room*4 Melt
  blend smooth(20cm)
  Room @3 -> + ellipsoid(radii: (0.8..1.4, 0.6..1, 0.7..1.2)) label +X
  Room @1 -> - torus(radius: 0.8, tube: 0.25)                 label random
  Melt    -> ~ 40% cylinder(radius: 0.9, height: 2m)          label +X
}
let rough = displace(strata(-cave), noise: fbm(scale: 0.7), amount: 8cm)

volume rock = level_set(rough, voxel: 12cm, from: (-2, -2, -2), to: (5, 2, 2))
volume mist = fog(cave, voxel: 15cm, half: true)
mesh wall on rock { adaptivity 0.1  paint layer(under: (0.5, 0.4, 0.3), over: (0.2, 0.2, 0.2), mask: slope()) }

material wet = coated(albedo: (0.5, 0.4, 0.3), roughness: 30%)
object cave_wall on wall { material wet }
camera main { eye (-1, 0.2, 0)  target (4, 0, 0)  fov 70deg }
light day  = sky(radiance: (3, 4, 5))
light hole = portal(center: (4.9, 0, 0), normal: (-1, 0, 0), width: 2, height: 2)
light lamp = sphere(center: (0.5, 0.3, 0.2), radius: 5cm, radiance: (90, 60, 30))
medium dust = haze(extinction: 5%/m)
render main { size 24x16  spp 4 }
"""


class SameBytes(VugTest):
    def products(self, name, *args):
        out = f"{name}/out"
        self.expect(0, "build", "scene.vug", "-o", out, *args)
        self.expect(0, "render", "scene.vug", "-o", f"{out}/scene.exr", *args)
        files = sorted((self.folder / out).iterdir())
        self.assertEqual([f.name for f in files],
                         ["scene.exr", "scene.ply", "scene.png", "scene.vdb"])
        return {f.name: digest(f) for f in files}

    def test_threads_and_runs(self):
        self.write("scene.vug", SCENE)
        first = self.products("one", "--threads", "1")
        for name, threads in [("again", 1), ("two", 2), ("five", 5), ("eight", 8)]:
            self.assertEqual(self.products(name, "--threads", str(threads)), first, name)

    def test_the_seed_changes_everything(self):
        self.write("scene.vug", SCENE)
        first, other = (self.products(f"s{s}", "--seed", str(s)) for s in (11, 12))
        for name in first:
            self.assertNotEqual(first[name], other[name], name)

    def test_numbers_of_a_report(self):
        self.write("scene.vug", SCENE)
        reports = []
        for threads in "158":
            lines = self.expect(0, "measure", "scene.vug", "--threads", threads).out.splitlines()
            reports.append([line for line in lines if not line.startswith("build_seconds")])
        self.assertEqual(reports[1:], reports[:1] * 2)


if __name__ == "__main__":
    unittest.main()
