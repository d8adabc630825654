# SPDX-License-Identifier: Apache-2.0
"""Arrays share the memory of the objects that they view, keep them alive, and are read-only."""
import gc
import unittest

import numpy
import vug
from case import BALL, Case

SKIN = BALL + "cells skin on wall { spacing 20cm  run life(steps: 3) }\n"


def address(array):
    return array.__array_interface__["data"][0]


class Views(Case):
    def every_array(self, build):
        mesh, skin, image = build.mesh("skin"), build.cells("skin"), build.render(spp=1)
        yield from [mesh.positions, mesh.normals, mesh.triangles, *mesh.attributes.values()]
        yield from [skin.positions, skin.normals, skin.tangents, skin.areas, skin.objects, skin.states,
                    *skin.links, *skin.attributes.values()]
        yield from [image.pixels, *image.layers.values()]

    def test_no_copies(self):
        build = vug.loads(SKIN).build()
        mesh, again = build.mesh("skin"), build.mesh("skin")
        self.assertEqual(address(mesh.positions), address(again.positions))
        self.assertEqual(address(mesh.triangles), address(again.triangles))
        for name, values in mesh.attributes.items():
            self.assertEqual(address(values), address(again.attributes[name]), name)
        self.assertEqual(address(build.cells("skin").positions), address(build.cells("skin").positions))
        image = build.render(spp=1)
        channels = len(image.channels)
        for name, layer in image.layers.items():
            self.assertTrue(numpy.shares_memory(layer, image.pixels), name)
            self.assertEqual(layer.strides[:2], (4 * channels * image.width, 4 * channels))
        first = image.channels.index("albedo.R")
        self.assertEqual(address(image["albedo"]), address(image.pixels) + 4 * first)

    def test_arrays_are_read_only(self):
        for array in self.every_array(vug.loads(SKIN).build()):
            self.assertFalse(array.flags.writeable)
            with self.assertRaises(ValueError):
                array[...] = 0
            with self.assertRaises(ValueError):
                array.flags.writeable = True
            self.assertIsNotNone(array.base)

    def test_they_outlive_their_objects(self):
        arrays = list(self.every_array(vug.loads(SKIN).build()))
        copies = [array.copy() for array in arrays]
        gc.collect()
        ballast = [numpy.full(array.shape, 7, array.dtype) for array in arrays for _ in range(3)]
        for array, copy in zip(arrays, copies):
            self.assertTrue(numpy.array_equal(array, copy, equal_nan=array.dtype.kind == "f"))
        del ballast

    def test_a_build_keeps_its_scene(self):
        build = vug.loads(SKIN).build()
        tree = vug.loads("grammar g {\n axiom A\n A -> + sphere(1m)\n}\n"
                         "volume v = level_set(g, voxel: 1m)").derivations["g"]
        gc.collect()
        self.assertEqual(build.scene.name, "scene")
        self.assertIn("sphere", tree.text())
        self.assertGreater(len(build.mesh().positions), 100)

    def test_shapes_and_meaning(self):
        build = vug.loads(SKIN).build()
        mesh, skin = build.mesh("skin"), build.cells("skin")
        n = len(mesh.positions)
        self.assertEqual((mesh.positions.shape, mesh.positions.dtype), ((n, 3), numpy.float32))
        self.assertEqual(mesh.triangles.dtype, numpy.uint32)
        self.assertEqual(mesh.triangles.shape[1], 3)
        self.assertEqual(mesh.attributes["Cd"].shape, (n, 3))
        numpy.testing.assert_allclose(numpy.linalg.norm(mesh.positions, axis=1), 1, atol=0.02)
        numpy.testing.assert_allclose(mesh.normals, mesh.positions, atol=0.05)
        self.assertEqual(len(skin), len(skin.positions))
        numpy.testing.assert_allclose(numpy.linalg.norm(skin.positions, axis=1), 1, atol=0.03)
        self.assertAlmostEqual(skin.areas.sum(), 4 * numpy.pi, delta=0.2)
        begin, to = skin.links
        self.assertEqual((len(begin), begin[-1]), (len(skin) + 1, len(to)))
        self.assertLess(skin.states.max(), len(vug.Cells.state_names))
        self.assertEqual(len(build.mesh("wall").positions), n)  # the one below the cells
        self.assertNotEqual(address(build.mesh("wall").positions), address(mesh.positions))
        image = build.render(spp=1)
        self.assertEqual(image["beauty"].shape, (18, 32, 3))
        self.assertEqual(image["Z"].shape, (18, 32))
        with self.assertRaisesRegex(KeyError, "did you mean 'albedo'"):
            image["albdo"]


class Voxels(Case):
    def test_dense_blocks(self):
        rock = vug.loads(BALL).build().level_set("rock")
        values, first = rock.dense()
        self.assertEqual((values.dtype, rock.kind), (numpy.float32, "level set"))
        self.assertEqual(rock.active_voxels, numpy.count_nonzero(abs(values) < rock.background))
        index = numpy.argwhere(numpy.ones_like(values)) + first
        points = numpy.array(rock.origin) + rock.voxel * index
        numpy.testing.assert_allclose(rock.values(points), values.ravel(), atol=1e-6)
        band = abs(values.ravel()) < rock.background
        exact = numpy.linalg.norm(points, axis=1) - 1
        numpy.testing.assert_allclose(values.ravel()[band], exact[band], atol=1e-5)
        numpy.testing.assert_allclose(rock.bounds[1], points[band].max(axis=0))
        far, at = rock.dense((100, 0, 0), (101, 1, 2))
        self.assertEqual((far.shape, at), ((2, 2, 3), (100, 0, 0)))
        numpy.testing.assert_allclose(far, rock.background)
        self.assertEqual(rock.dense((0, 0, 0), (-1, 5, 5))[0].size, 0)

    def test_fogs(self):
        scene = vug.loads("volume mist = fog(sphere(1m), voxel: 20cm)\n")
        mist = scene.build().volume("mist")
        self.assertIsInstance(mist, vug.Grid)
        self.assertNotIsInstance(mist, vug.LevelSet)
        self.assertEqual(mist.dense()[0].max(), 1)
        self.assertIsInstance(scene.build().level_set("mist"), vug.LevelSet)

    def test_rejected_input(self):
        rock = vug.loads(BALL).build().level_set()
        for bad in ([[0, 0]], [[0, numpy.nan, 0]], [[0, numpy.inf, 0]], [0, 0, 0], [[[0, 0, 0]]]):
            with self.assertRaises(ValueError, msg=bad):
                rock.values(bad)
        for bad in ([["a", "b", "c"]], [[1j, 0, 0]], None, [[None, 0, 0]]):
            with self.assertRaises(TypeError, msg=bad):
                rock.values(bad)
        with self.assertRaises(TypeError):
            rock.dense((0.5, 0, 0), (1, 1, 1))
        with self.assertRaises(ValueError):
            rock.dense((0, 0), (1, 1, 1))
        with self.assertRaisesRegex(vug.Error, "the array of voxels") as caught:
            rock.dense((-2**20,) * 3, (2**20,) * 3)
        self.assertEqual(caught.exception.code, "too_large")


class Meshes(Case):
    CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]

    def test_from_arrays(self):
        mesh = vug.Mesh(self.CORNERS, self.FACES, attributes={"Cd": numpy.eye(4)[:, :3], "wet": [0, 1, 2, 3]})
        report = mesh.measure()
        self.assertAlmostEqual(report["volume"], 1 / 6)
        self.assertEqual(report["boundary_edges"], 0)
        mesh.save("tetra.ply")
        again = vug.read_mesh("tetra.ply")
        numpy.testing.assert_array_equal(again.positions, mesh.positions)
        numpy.testing.assert_array_equal(again.triangles, self.FACES)
        numpy.testing.assert_array_equal(again.attributes["wet"], [0, 1, 2, 3])
        self.assertIsNone(mesh.normals)
        numpy.testing.assert_array_equal(mesh.bounds, [(0, 0, 0), (1, 1, 1)])

    def test_unusual_but_valid(self):
        for kind in (numpy.float16, numpy.float64, numpy.int8, ">f4"):
            mesh = vug.Mesh(numpy.array(self.CORNERS, kind), numpy.array(self.FACES, numpy.uint8))
            numpy.testing.assert_array_equal(mesh.positions, self.CORNERS)
        wide = numpy.zeros((8, 6))
        wide[::2, ::2] = self.CORNERS
        mesh = vug.Mesh(wide[::2, ::2], numpy.asfortranarray(self.FACES))
        numpy.testing.assert_array_equal(mesh.positions, self.CORNERS)
        numpy.testing.assert_array_equal(mesh.triangles, self.FACES)
        empty = vug.Mesh([], [])
        self.assertEqual((empty.positions.shape, empty.triangles.shape, empty.bounds), ((0, 3), (0, 3), None))
        self.assertEqual(empty.measure()["area"], 0)

    def test_rejected_input(self):
        fine, faces = numpy.array(self.CORNERS, float), self.FACES
        broken = fine.copy()
        broken[2, 1] = numpy.nan
        huge = fine * 1e300
        for args, kwargs, kind, words in [
                ((broken, faces), {}, ValueError, "finite|number"),
                ((huge, faces), {}, ValueError, "finite|number"),
                ((fine[:, :2], faces), {}, ValueError, r"positions must have the shape \(n, 3\), not \(4, 2\)"),
                ((fine.ravel(), faces), {}, ValueError, "shape"),
                ((fine, [(0, 1, 4)]), {}, ValueError, "triangle 0 refers to vertex 4, but the mesh has 4 vertices"),
                ((fine, [(0, 1, -1)]), {}, ValueError, "vertex -1"),
                ((fine, [(0, 1, 2**40)]), {}, ValueError, "vertex"),
                ((fine, [(0, 1)]), {}, ValueError, "triangles must have the shape"),
                ((fine, [(0.0, 1.0, 2.0)]), {}, TypeError, "triangles must be integers, not float64"),
                (("abc", faces), {}, TypeError, "positions must be real numbers"),
                ((fine, faces), {"normals": fine[:3]}, ValueError, r"normals must have the shape \(4, 3\)"),
                ((fine, faces), {"attributes": {"a": [1, 2]}}, ValueError, "attribute 'a'"),
                ((fine, faces), {"attributes": {"a": ["x"] * 4}}, TypeError, "attribute 'a'"),
                ((fine, faces), {"attributes": {"a": numpy.full(4, numpy.inf)}}, ValueError, "finite|number"),
                ((fine, faces), {"attributes": {3: [1, 2, 3, 4]}}, TypeError, "names"),
                ((fine, faces), {"attributes": {"a": numpy.zeros((4, 0))}}, ValueError, ""),
                ((fine, faces), {"attributes": [1]}, TypeError, "")]:
            with self.assertRaisesRegex(kind, words, msg=(args, kwargs)):
                vug.Mesh(*args, **kwargs)


if __name__ == "__main__":
    unittest.main()
