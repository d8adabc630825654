# SPDX-License-Identifier: Apache-2.0
"""Errors as exceptions with source locations; invalid arguments; warnings."""
import pickle
import unittest
import warnings

import numpy
import vug
from case import BALL, Case


class Faults(Case):
    def test_several_errors_of_a_text(self):
        self.write("bad.vug", "volume rock = level_set(spere(1m), voxel: 10cm)\n"
                              "mesh wall on rok {}\n")
        with self.assertRaises(vug.Error) as caught:
            vug.load("bad.vug")
        error = caught.exception
        self.assertEqual((error.code, error.file, error.line, error.column), ("bad_input", "bad.vug", 1, 25))
        self.assertEqual(error.message, "unknown function 'spere'")
        self.assertEqual(error.hint, "did you mean 'sphere'?")
        self.assertEqual([(d.severity, d.line) for d in error.diagnostics], [("error", 1), ("error", 2)])
        self.assertIn("bad.vug:2:14: error:", str(error))
        self.assertIn("^~~~~\nhint: did you mean 'sphere'?", str(error))

    def test_they_survive_pickling(self):
        with self.assertRaises(vug.Error) as caught:
            vug.loads("volume = 3\n")
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual(vars(again), vars(caught.exception))
        self.assertEqual(str(again), str(caught.exception))

    def test_missing_names(self):
        scene = vug.loads(BALL)
        build = scene.build()
        for ask in (lambda: build.mesh("wal"), lambda: build.measure("wal"), lambda: scene.measure("wal")):
            with self.assertRaisesRegex(vug.Error, "the scene has no mesh 'wal'\nhint: did you mean 'wall'"):
                ask()
        with self.assertRaisesRegex(vug.Error, "no volume 'rok'\nhint: did you mean 'rock'"):
            build.level_set("rok")
        with self.assertRaisesRegex(vug.Error, "no cells"):
            build.cells()
        with self.assertRaisesRegex(vug.Error, "no camera 'man'\nhint: did you mean 'main'"):
            scene.render(camera="man")
        with self.assertRaisesRegex(vug.Error, "no render 'mian'"):
            scene.render("mian")

    def test_overrides(self):
        with self.assertRaisesRegex(vug.Error, "param 'R' is 9m, outside 0.5m..2m"):
            vug.loads(BALL, R=9)
        with self.assertRaisesRegex(vug.Error, "'RR'"):
            vug.loads(BALL, RR=1)
        for value in (numpy.nan, -numpy.inf):
            with self.assertRaisesRegex(ValueError, "'R' is .*must be finite"):
                vug.loads(BALL, R=value)
        for value in (None, {}, [1, 2], (1, 2, "3"), object(), b"1m"):
            with self.assertRaisesRegex(TypeError, "'R' is a "):
                vug.loads(BALL, R=value)
        with self.assertRaises(ValueError):
            vug.loads(BALL, frame=float("nan"))
        with self.assertRaises(TypeError):
            vug.loads(BALL, seed=-1)
        with self.assertRaises(TypeError):
            vug.loads(BALL, {1: 2})

    def test_options_of_a_picture(self):
        scene = vug.loads(BALL)
        for options, kind, words in [
                ({"sp": 3}, TypeError, "render: unknown option 'sp'; did you mean 'spp'"),
                ({"spp": 0}, ValueError, "spp must be at least 1"),
                ({"spp": "many"}, TypeError, "spp must be an integer"),
                ({"size": (0, 4)}, ValueError, "size"),
                ({"size": 4}, TypeError, "size must be two integers"),
                ({"crop": (4, 4, 2, 2)}, ValueError, "crop"),
                ({"noise": numpy.nan}, ValueError, "noise must be from 0 to 1"),
                ({"exposure": 99}, ValueError, "exposure"),
                ({"eye": "middle"}, ValueError, "eye"),
                ({"eye": "left"}, vug.Error, "not a stereo camera"),
                ({"working_space": "rec70"}, ValueError, "did you mean 'rec709'"),
                ({"layers": ["albdo"]}, vug.Error, "albdo"),
                ({"layers": 3}, TypeError, "layers"),
                ({"denoise": 3}, TypeError, "denoise must be True or False"),
                ({"crop": (0, 0, 999, 999)}, vug.Error, "crop")]:
            with self.assertRaisesRegex(kind, words, msg=options):
                scene.render(**options)

    def test_files(self):
        with self.assertRaisesRegex(vug.Error, "no such file"):
            vug.load("nowhere.vug")
        with self.assertRaises(vug.Error):
            vug.read_mesh("nowhere.ply")
        build = vug.loads(BALL).build()
        mesh, image = build.mesh(), build.render(spp=1)
        self.write("file", "")
        for save in (mesh.save, image.save, build.level_set().save):
            with self.assertRaises(vug.Error, msg=save):
                save("a.doc")
        with self.assertRaises(vug.Error) as caught:
            mesh.save("file/a.ply")
        self.assertEqual(caught.exception.code, "io")
        with self.assertRaisesRegex(vug.Error, "has no deep image"):
            image.save("a.deep.exr")
        self.write("scene.vug", BALL)
        with self.assertRaises(vug.Error):
            vug.loads("let a = 1\n").build().save("out")


class Placement(Case):
    def test_a_camera_in_rock(self):
        scene = vug.loads(BALL.replace("(0, 0, 4)", "(0, 0, 0.5)"))
        with self.assertRaises(vug.Error) as caught:
            scene.render(spp=1)
        error = caught.exception
        self.assertEqual(error.message, "the camera 'main' at (0, 0, 0.5) is in rock, 0.50 m inside 'wall'")
        self.assertEqual((error.line, error.code), (5, "bad_input"))
        self.assertEqual(error.hint, "the nearest air is 0.50 m towards +z: eye (0, 0, 1.1)")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertEqual(scene.render(spp=1, anyway=True)["beauty"].shape[:2], (18, 32))


class Warnings(Case):
    def test_they_name_the_calling_line(self):
        text = BALL.replace("sphere(R)", "sphere(R).translate((9, 0, 0))").replace(
            "voxel: 10cm", "voxel: 10cm, from: (-1, -1, -1), to: (1, 1, 1)")
        with warnings.catch_warnings(record=True) as seen:
            warnings.simplefilter("always")
            vug.loads(text).build().level_set()
        self.assertEqual([w.category for w in seen], [vug.SceneWarning])
        self.assertIn("the volume 'rock' is empty", str(seen[0].message))
        self.assertIn("scene.vug:2:8: warning:", str(seen[0].message))
        self.assertEqual(seen[0].filename, __file__)

    def test_unused_names(self):
        with self.assertWarnsRegex(vug.SceneWarning, r"scene.vug:1:7: warning: param 'X' is never used"):
            vug.loads("param X = 1\n" + BALL)
        with self.assertRaisesRegex(vug.SceneWarning, "let 'x' is never used"):  # as with --strict
            vug.loads("let x = 1\n" + BALL)

    def test_as_errors_they_stop_the_work(self):
        dark = BALL.replace("radiance: (1, 1, 1)", "radiance: (0, 0, 0)")
        with self.assertRaisesRegex(vug.SceneWarning, "no light reaches the picture"):
            vug.loads(dark).render(spp=1)


if __name__ == "__main__":
    unittest.main()
