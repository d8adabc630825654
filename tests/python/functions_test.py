# SPDX-License-Identifier: Apache-2.0
"""Functions of scenes, values of expressions and appended statements."""
import math
import pathlib
import unittest

import numpy
import vug
from case import Case

TEXT = """include "kit.vug" as rocks
param R = 1m  in 50cm..2m
def ring(count "number of points", radius = 2m) "Points on a circle." =
    [for i in 1..count: (radius * cos(i * 360deg / count), 0, radius * sin(i * 360deg / count))]
def ball(at, turn = 0deg) = sphere(R).rotate(angle: turn).translate(at)
let spots = ring(6)
volume rock = level_set(ball(spots[0]) + rocks.block(spots[1]), voxel: 20cm)
light lamp[p in spots] = sphere(center: p, radius: 5cm, lumen: 300)"""
KIT = "def block(at) = box(size: _size(2)).translate(at)\ndef _size(n) = n * (1m, 1m, 1m)\n"


class Functions(Case):
    def setUp(self):
        super().setUp()
        self.write("kit.vug", KIT)
        self.scene = vug.loads(TEXT, base=self.folder)

    def test_they_are_listed(self):
        functions = self.scene.functions
        self.assertEqual(sorted(functions), ["ball", "ring", "rocks.block"])
        ring = functions["ring"]
        self.assertEqual((ring.name, ring.doc), ("ring", "Points on a circle."))
        self.assertEqual(ring.parameters["count"], vug.FunctionParam("count", "number of points", True))
        self.assertEqual(ring.parameters["radius"], vug.FunctionParam("radius", "", False))
        self.assertIn("ring(count, radius): Points on a circle.\n  count ", str(ring))

    def test_a_call_is_its_text(self):
        ball, ring = self.scene.functions["ball"], self.scene.functions["ring"]
        self.assertEqual(ball((0, 1.5, 0), turn="20deg"), "ball((0, 1.5, 0), turn: 20deg)")
        self.assertEqual(ball(at=numpy.ones(3)), "ball(at: (1.0, 1.0, 1.0))")
        self.assertEqual(ball([1, True, (1, 2, 3)]), "ball([1, true, (1, 2, 3)])")
        self.assertEqual(ball([1, 2, 3]), "ball([1, 2, 3])")
        self.assertEqual(ball(numpy.zeros((1, 3))), "ball([(0.0, 0.0, 0.0)])")
        self.assertEqual(ball(pathlib.Path("a b.ply")), 'ball("a b.ply")')
        self.assertEqual(len(self.scene.evaluate(ring(numpy.int64(4), radius=3))), 4)
        for arguments, named, words in [
                ((), {}, "'ball' needs 'at'"), ((1, 2, 3), {}, "takes 2 arguments, not 3"),
                ((1,), {"at": 2}, "'at' is given twice"), ((1,), {"turns": 2}, "did you mean 'turn'"),
                (({},), {}, "'at' is a dict")]:
            with self.assertRaisesRegex(TypeError, words):
                ball(*arguments, **named)
        endless = []
        endless.append(endless)
        with self.assertRaisesRegex(ValueError, "'at' has more than 100 nested lists"):
            ball(endless)
        with self.assertRaisesRegex(ValueError, "must be finite"):
            ball(math.inf)

    def test_arrays_of_three_numbers_are_vectors_of_parameters_too(self):
        scene = vug.loads("param C = (1, 0, 0)\nlight sky = sky(radiance: C)\n", C=numpy.array([1, 2, 3]))
        self.assertEqual(scene.params["C"].value, (1, 2, 3))

    def test_expressions(self):
        evaluate = self.scene.evaluate
        self.assertEqual(evaluate("len(spots)"), 6)
        self.assertEqual(evaluate("R + 25cm"), 1.25)
        self.assertEqual(self.scene.with_(R=2).evaluate("R"), 2)
        self.assertEqual(evaluate("[(1, 2, 3), true, 90deg, \"a\", +X]"),
                         [(1, 2, 3), True, math.pi / 2, "a", "+X"])
        self.assertEqual(evaluate("frame"), 1)
        self.assertEqual(vug.loads("let a = 1", frame=7).evaluate("frame"), 7)
        self.assertEqual(evaluate("0..1"), evaluate("0..1"))
        for objects in ("ball((0, 0, 0))", "[rocks.block((0, 0, 0))]", "rock", "lamp"):
            with self.assertRaisesRegex(TypeError, r"Python cannot represent: use it in a statement"):
                evaluate(objects)
        with self.assertRaises(ValueError):
            evaluate(" ")
        for text, message, column in [("sposts", "unknown name 'sposts'", 1), ("1 + ", "expected", 4),
                                      ("len(1)", "'len' takes", 1), ("rocks._size(1)", "private", 7)]:
            with self.assertRaisesRegex(vug.Error, message) as caught:
                evaluate(text)
            self.assertEqual((caught.exception.file, caught.exception.line), ("expression", 1), text)
            self.assertIn(text, str(caught.exception))

    def test_appended_statements(self):
        ball = self.scene.functions["ball"]
        more = self.scene.with_text(f"volume two = level_set({ball((0, 0, 0))}, voxel: 10cm)")
        self.assertEqual((self.scene.volumes, more.volumes), (["rock"], ["rock", "two"]))
        self.assertGreater(more.build().level_set("two").active_voxels, 100)
        again = more.with_(R=0.5).with_text("let half = R / 2\nvolume small = level_set(sphere(half), voxel: 5cm)\n"
                                                "mesh skin on two {}")
        self.assertEqual((again.volumes, again.meshes), (["rock", "two", "small"], ["skin"]))
        self.assertEqual(again.evaluate("half"), 0.25)
        again.build().save("out")
        for scene in (vug.loads(again.text, base=self.folder, R=0.5), vug.scene_of("out/scene.vdb")):
            self.assertEqual(scene.volumes, ["rock", "two", "small"])
            self.assertTrue(numpy.array_equal(scene.build().mesh().positions, again.build().mesh().positions))
        self.assertEqual([path.name for path in more.files], ["kit.vug"])
        for scene, name in ((self.scene, "appended"), (more, "appended 2")):
            with self.assertRaisesRegex(vug.Error, "unknown function 'bal'") as caught:
                scene.with_text("\nlet b = bal(1)")
            error = caught.exception
            self.assertEqual((pathlib.Path(error.file).name, error.line, error.column), (name, 2, 9))
            self.assertIn("let b = bal(1)", str(error))
        with self.assertRaisesRegex(vug.Error, "'rock'"):
            self.scene.with_text("volume rock = level_set(sphere(1m), voxel: 20cm)")


if __name__ == "__main__":
    unittest.main()
