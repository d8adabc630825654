# SPDX-License-Identifier: Apache-2.0
"""Exit codes of every verb: 0 done, 1 the answer is no, 2 unusable input, 3 failure."""
import json
import resource
import signal
import subprocess
import unittest

from vug import BALL, VugTest

CAVE = """
grammar cave {
  axiom Room*2
  Room -> + sphere(1m) label +X
}
volume rock = level_set(cave, voxel: 20cm)
mesh wall on rock {}
camera main { eye (0, 0, 8) }
render main { size 8x6  spp 1 }
"""
OPEN_MESH = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n"


class Done(VugTest):
    def test_every_verb(self):
        self.write("cave.vug", CAVE)
        self.expect(0, "check", "cave.vug")
        built = self.expect(0, "build", "cave.vug", "-o", "out")
        self.assertEqual(built.out.split(), ["out/cave.vdb", "out/cave.ply"])
        shot = self.expect(0, "render", "cave.vug", "-o", "cave.exr")
        self.assertEqual(shot.out.split(), ["cave.exr", "cave.png"])
        for file in built.out.split() + shot.out.split():
            self.expect(0, "info", file)
        for thing in ["cave.vug", "out/cave.vdb", "out/cave.ply"]:
            self.expect(0, "measure", thing)
        self.expect(0, "tree", "cave.vug")
        self.expect(0, "list")
        self.expect(0, "format", "cave.vug")
        self.expect(0, "--help")
        self.expect(0, "--version")
        self.expect(0, "build", "--help")

    def test_results_and_diagnostics_do_not_mix(self):
        self.write("warned.vug", CAVE.replace("axiom", "Hall -> + box()\n  axiom"))
        result = self.expect(0, "measure", "warned.vug", "--json")
        self.assertIn("warned.vug:3:3: warning: the production 'Hall -> +' is unreachable", result.err)
        json.loads(result.out)

    def test_warnings_about_likely_mistakes(self):
        self.write("odd.vug", "param N = 0\ngrammar cave {\n  axiom Room*N\n  Room -> + sphere(1m)\n}\n"
                              "volume none = level_set(cave, voxel: 20cm)\n"
                              "volume rock = level_set(box(size: (2, 2, 2)), voxel: 20cm)\n"
                              "camera main { eye (0.5, 0, 0) }\nrender main { size 4x3  spp 1 }\n")
        grammar = "odd.vug:2:9: warning: the grammar 'cave' produces nothing\ngrammar cave {\n"
        volume = "odd.vug:6:8: warning: the volume 'none' is empty\nvolume none = "
        camera = "odd.vug:8:8: warning: the camera is inside the solid of 'rock'\ncamera main {"
        self.assertIn(grammar, self.expect(2, "check", "odd.vug").err)
        for quiet in ([], ["--quiet"]):
            built = self.expect(0, "build", "odd.vug", "-o", "out", *quiet).err
            self.assertIn(grammar, built)
            self.assertEqual(built.count(volume), 1)
            self.assertNotIn(camera, built)
            shot = self.expect(0, "render", "odd.vug", "-o", "odd.exr", "--products", "out", "--anyway", *quiet).err
            self.assertIn(grammar, shot)
            self.assertEqual((shot.count(volume), shot.count(camera)), (1, 1))
            self.assertIn("hint: move its eye out of the solid\n", shot)

    def test_a_nearly_black_picture_suggests_an_exposure(self):
        self.write("dim.vug", BALL + "\nlight sky = sky(radiance: (1e-4, 1e-4, 1e-4))\nrender main { size 8x6  spp 1  exposure 0 }\n")
        dim = self.expect(0, "render", "dim.vug", "-o", "dim.exr").err
        self.assertIn("warning: the picture will be black\n", dim)
        stops = dim.split("hint: --exposure ")[1].split()[0]
        self.assertEqual(self.expect(0, "render", "dim.vug", "-o", "dim.exr", "--exposure", stops, "-q").err, "")

        self.assertEqual(self.expect(0, "render", "dim.vug", "-o", "dim.exr", "--exposure", "auto", "-q").err, "")

    def test_a_visible_light_on_black_is_not_too_bright(self):
        text = "light lamp = sphere(radius: %s, radiance: (900, 900, 900))\ncamera main { eye (0, 0, 4) }\nrender main { size 16x12  spp 4  exposure 0 }\n"
        self.write("lamp.vug", text % "50cm")
        self.assertEqual(self.expect(0, "render", "lamp.vug", "-o", "lamp.exr", "-q").err, "")
        self.write("lamp.vug", text % "3m")
        self.assertIn("the picture is very bright\n", self.expect(0, "render", "lamp.vug", "-o", "lamp.exr").err)

    def test_extensions_in_capitals(self):
        self.write("ball.vug", BALL)
        self.expect(0, "build", "ball.vug", "-o", ".")
        (self.folder / "ball.vdb").rename(self.folder / "BALL.VDB")
        (self.folder / "ball.vug").rename(self.folder / "BALL.VUG")
        for args in [("measure", "BALL.VDB"), ("measure", "BALL.VUG"), ("check", "BALL.VUG"),
                     ("info", "BALL.VDB"), ("render", "BALL.VUG", "-o", "A.EXR", "--size", "4x4")]:
            with self.subTest(args=args):
                self.expect(0, *args)

    def test_quiet(self):
        self.write("ball.vug", BALL)
        for verb in [("check",), ("build", "-o", "out"), ("render", "-o", "a.exr", "--size", "4x4")]:
            result = self.expect(0, verb[0], "ball.vug", *verb[1:], "--quiet")
            self.assertEqual(result.err, "")
        self.assertEqual(self.expect(0, "check", "ball.vug", "-q").out, "")


class AnswerIsNo(VugTest):
    def test_a_broken_mesh(self):
        self.write("open.obj", OPEN_MESH)
        table = self.expect(1, "measure", "open.obj")
        self.assertRegex(table.out, r"boundary_edges +3\n")
        self.assertEqual(json.loads(self.expect(1, "measure", "open.obj", "--json").out)
                         ["boundary_edges"], 3)

    def test_a_mesh_that_intersects_itself(self):
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        moved = [(x + 0.2, y + 0.2, z + 0.1) for x, y, z in corners]
        faces = [(1, 3, 2), (1, 2, 4), (1, 4, 3), (2, 3, 4)]
        self.write("two.obj", "".join(f"v {x} {y} {z}\n" for x, y, z in corners + moved) +
                   "".join(f"f {a + k} {b + k} {c + k}\n" for k in (0, 4) for a, b, c in faces))
        report = json.loads(self.expect(1, "measure", "two.obj", "--json").out)
        self.assertGreater(report["self_intersections"], 0)
        place, = report["invalid_places"]
        self.assertEqual(place["count"], report["self_intersections"])
        for at in place["center"]:
            self.assertTrue(0 < at < 1)
        self.assertIn(" at (", self.expect(1, "measure", "two.obj", "--max-invalid", "0.1").out)
        self.expect(0, "measure", "two.obj", "--max-invalid", "1")

    def test_an_unformatted_text(self):
        self.write("ball.vug", BALL.replace(" = ", "="))
        result = self.expect(1, "format", "--check", "ball.vug")
        self.assertEqual(result.out, "ball.vug: not formatted\n")


class Unusable(VugTest):
    """Exit 2: the text, the file or an argument."""

    def refused(self, *args):
        return self.expect(2, *args).err

    def test_arguments(self):
        self.write("ball.vug", BALL)
        for args in [(), ("biuld",), ("build",), ("build", "ball.vug"), ("check",), ("measure",),
                     ("check", "ball.vug", "other.vug"), ("info",), ("format",),
                     ("build", "ball.vug", "-o", "out", "--threads", "many"),
                     ("build", "ball.vug", "-o", "out", "--threads", "-1"),
                     ("build", "ball.vug", "-o", "out", "--max-memory", "lots"),
                     ("build", "ball.vug", "-o", "out", "--max-memory", "-1G"),
                     ("build", "ball.vug", "-o", "out", "-D", "R"),
                     ("build", "ball.vug", "-o", "out", "-D", "R=2"),
                     ("render", "ball.vug", "-o", "ball.png"),
                     ("render", "ball.vug", "-o", "ball.exr", "--size", "0x10"),
                     ("render", "ball.vug", "-o", "ball.exr", "--size", "10"),
                     ("render", "ball.vug", "-o", "ball.exr", "--size", "10x-3"),
                     ("render", "ball.vug", "-o", "ball.exr", "--spp", "0"),
                     ("render", "ball.vug", "-o", "ball.exr", "--seed", "-1"),
                     ("render", "ball.vug", "-o", "ball.exr", "--camera", "main"),
                     ("render", "ball.vug", "-o", "ball.exr", "--render", "main"),
                     ("render", "ball.vug", "-o", "ball.exr", "--exposure", "nan"),
                     ("render", "ball.vug", "-o", "ball.exr", "--noise", "nan"),
                     ("render", "ball.vug", "-o", "ball.exr", "--crop", "0,0,0,0"),
                     ("measure", "ball.vug", "--mesh", "wall"),
                     ("tree", "ball.vug"), ("tree", "ball.vug", "--json", "--svg"),
                     ("list", "torsu"), ("sweep", "ball.vug", "-p", "R", "-v", "1,2")]:
            with self.subTest(args=args):
                self.refused(*args)
        self.assertEqual(self.files(), ["ball.vug"])

    def test_words_of_options_and_scenes_as_products(self):
        self.write("ball.vug", BALL)
        for args, message in [
                (("render", "ball.vug", "-o", "a.exr", "--eye", "middle"),
                 "--eye: invalid value 'middle': expected left, right"),
                (("info", "ball.vug"), "'ball.vug' is a scene, not a file built from one\nhint: 'vug check'"),
                (("recipe", "ball.vug"), "'ball.vug' is a scene")]:
            with self.subTest(args=args):
                self.assertIn(message, self.refused(*args))

    def test_a_sweep_checks_all_values_first(self):
        self.write("ball.vug", "param R = 1 in 0..2\nvolume rock = level_set(sphere(R), voxel: 20cm)\n"
                               "mesh wall on rock {}\n")
        result = self.expect(2, "sweep", "ball.vug", "-p", "R", "-v", "1,9")
        self.assertIn("while checking R = 9", result.err)
        self.assertEqual(result.out, "")

    def test_empty_values(self):
        """Empty arguments, as produced by an unset variable of a script."""
        self.write("ball.vug", BALL)
        build = ("build", "ball.vug", "-o", "out")
        render = ("render", "ball.vug", "-o", "a.exr")
        for args in [("build", "ball.vug", "-o", ""), (*build, "--threads", ""), (*build, "-D", ""),
                     (*render, "--size", ""), (*render, "--camera", ""), ("check", ""), ("list", ""),
                     ("sweep", "ball.vug", "-p", "R", "-v", "")]:
            with self.subTest(args=args):
                self.assertIn("the value is empty\n", self.refused(*args))
        self.assertIn("error: --max-memory: the value is empty\n",
                      self.refused(*build, "--max-memory", ""))
        self.refused(*build, "--max-memory=")
        self.assertIn("'=a.exr' begins with '='", self.refused("render", "ball.vug", "-o=a.exr"))
        self.assertIn("error: --seed: invalid seed '-1': expected an integer of at least 0\n",
                      self.refused(*build, "--seed", "-1"))
        self.assertEqual(self.files(), ["ball.vug"])

    def test_a_faulty_override_is_one_fault(self):
        self.write("ball.vug", "param R = 1m\n" + BALL.replace("1m", "R"))
        self.assertEqual(self.refused("check", "ball.vug", "-D", "R=1e999"),
                         "-D R: error: the number 1e999 is too large\n1e999\n^~~~~\n")

    def test_errors_suggest_a_remedy(self):
        self.write("ball.vug", BALL + "camera front { eye (0, 0, 5) }\n")
        self.assertIn("did you mean 'front'?",
                      self.refused("render", "ball.vug", "-o", "a.exr", "--camera", "frnt"))
        self.assertIn("write --size 1920x1080",
                      self.refused("render", "ball.vug", "-o", "a.exr", "--size", "big"))
        self.assertIn("did you mean 'rock'?", self.refused("measure", "ball.vug", "--mesh", "rok"))
        self.assertIn("did you mean 'torus'?", self.refused("list", "torsu"))
        self.assertTrue(self.refused("list", "bogus").endswith("\nhint: 'vug list' lists all of them\n"))

    def test_an_unknown_verb_is_named(self):
        self.assertEqual(self.refused("biuld", "ball.vug"),
                         "error: unknown verb 'biuld'\nhint: did you mean 'build'?\n")
        self.assertIn("error: unknown verb 'bogus'\nhint: known: ", self.refused("bogus"))

    def test_arguments_without_effect(self):
        self.write("ball.vug", "param R = 1m\n" + BALL.replace("1m", "R"))
        self.write("open.obj", OPEN_MESH)
        for args, said in [
                (("measure", "open.obj", "-D", "X=1"), "-D requires a scene, but 'open.obj' is not a .vug file"),
                (("measure", "open.obj", "--mesh", "foo"), "--mesh requires a scene"),
                (("measure", "open.obj", "--seed", "4"), "--seed requires a scene"),
                (("check", "ball.vug", "-D", "R=1", "-D", "R=2"), "'R' is set twice"),
                (("sweep", "ball.vug", "-p", "seed", "-v", "1", "--seed", "2"), "remove --seed"),
                (("check", "ball.vug", "--seed", "18446744073709551616"), "expected an integer")]:
            with self.subTest(args=args):
                self.assertIn(said, self.refused(*args))

    def test_errors_as_json(self):
        for args in [("no.vug",), ("no.vug", "-D", "R")]:
            result = self.vug("check", *args, "--json")
            self.assertEqual((result.code, result.err), (2, ""))
            report = json.loads(result.out)
            self.assertFalse(report["fine"])
            self.assertEqual(len(report["diagnostics"]), 1)
        self.assertIn("cannot read 'no.vug'", json.loads(
            self.vug("check", "no.vug", "--json").out)["diagnostics"][0]["message"])

    def test_missing_files(self):
        for args in [("check", "no.vug"), ("build", "no.vug", "-o", "out"), ("tree", "no.vug"),
                     ("render", "no.vug", "-o", "no.exr"), ("measure", "no.vug"),
                     ("measure", "no.ply"), ("measure", "no.vdb"), ("info", "no.vdb"),
                     ("info", "no.exr"), ("info", "no.stl"), ("format", "no.vug"),
                     ("sweep", "no.vug", "-p", "R", "-v", "1")]:
            with self.subTest(args=args):
                self.assertIn(args[1], self.refused(*args))
        self.assertEqual(self.files(), [])

    def test_a_folder_is_not_a_file(self):
        (self.folder / "folder.vug").mkdir()
        (self.folder / "folder.vdb").mkdir()
        for args in [("check", "folder.vug"), ("measure", "folder.vdb"), ("info", "folder.vdb"),
                     ("info", "."), ("measure", ".")]:
            with self.subTest(args=args):
                self.refused(*args)

    def test_errors_of_a_text(self):
        self.write("ball.vug", "volume rock = level_set(sphre(1m), voxel: 10cm)\n")
        said = ("ball.vug:1:25: error: unknown function 'sphre'\n"
                "volume rock = level_set(sphre(1m), voxel: 10cm)\n"
                "                        ^~~~~\n"
                "hint: did you mean 'sphere'?\n")
        for args in [("check", "ball.vug"), ("build", "ball.vug", "-o", "out"), ("tree", "ball.vug"),
                     ("measure", "ball.vug"), ("render", "ball.vug", "-o", "ball.exr"),
                     ("check", "ball.vug", "--quiet")]:
            self.assertEqual(self.refused(*args), said)

    def test_nothing_to_build(self):
        self.write("empty.vug", "let a = 1\n")
        self.assertIn("declares nothing to build", self.refused("build", "empty.vug", "-o", "out"))
        self.assertIn("nothing to show", self.refused("render", "empty.vug", "-o", "empty.exr"))
        self.assertEqual(self.files(), ["empty.vug"])

    def test_an_enormous_voxel(self):
        for voxel in ["1e30", "1e299"]:
            self.write("vast.vug", f"volume rock = level_set(sphere(2m), voxel: {voxel}m)\n")
            self.assertIn("are larger than", self.refused("build", "vast.vug", "-o", "out"))

    def test_a_solid_of_too_many_steps(self):
        for word, where in [("let", "5001:13"), ("field", "10102:8")]:
            steps = "".join(f"{word} a{i} = a{i - 1}.offset(1mm)\n" for i in range(1, 10101))
            self.write("deep.vug", f"{word} a0 = sphere(1)\n" + steps +
                       "volume rock = level_set(a10100, voxel: 1m)\n")
            said = self.refused("build", "deep.vug", "-o", "out")
            self.assertIn(f"deep.vug:{where}: error: ", said)  # a slow machine prints a stage before it
            self.assertIn("nested", said)

    def test_a_solid_that_doubles_endlessly(self):
        lets = "".join(f"let a{i} = a{i - 1} + a{i - 1}.translate((1, 0, 0))\n"
                       for i in range(1, 61))
        self.write("many.vug", "let a0 = sphere(1)\n" + lets +
                   "volume rock = level_set(a60, voxel: 1m)\n")
        self.assertIn("operands, more than", self.refused("build", "many.vug", "-o", "out"))


class Failed(VugTest):
    """Exit 3: system errors during the work."""

    def test_a_folder_that_cannot_be_created(self):
        self.write("ball.vug", BALL)
        self.write("file", "not a folder\n")
        for args in [("build", "ball.vug", "-o", "file/out"),
                     ("render", "ball.vug", "-o", "file/a.exr", "--size", "4x4", "--spp", "1")]:
            with self.subTest(args=args):
                self.assertIn("file", self.expect(3, *args).err)
        self.assertEqual(self.files(), ["ball.vug", "file"])

    def test_unwritable_outputs_are_reported_before_the_work(self):
        """The work would take hours."""
        self.write("vast.vug", "volume rock = level_set(sphere(1m), voxel: 5cm)\n"
                               "mesh wall on rock {}\nrender main { size 8000x8000  spp 100000 }\n"
                               "param R = 1\nlet used = R\n")
        self.write("file", "not a folder\n")
        (self.folder / "taken.png").mkdir()
        self.write("shut/vast.vdb/in", "a folder\n")
        before = sorted(str(p) for p in self.folder.rglob("*"))
        many = ("-p", "seed", "-v", "1..9999")
        for args in [("render", "vast.vug", "-o", "/proc/a.exr"),
                     ("render", "vast.vug", "-o", "new/a.exr", "--products", "file/out"),
                     ("sweep", "vast.vug", *many, "-o", "file/a"),
                     ("sweep", "vast.vug", *many, "-o", "/proc/a"),
                     ("build", "vast.vug", "-o", "/proc/out")]:
            with self.subTest(args=args):
                self.expect(3, *args)
        for args in [("render", "vast.vug", "-o", "taken.exr"),
                     ("render", "vast.vug", "-o", "new/a.exr", "--products", "shut")]:
            with self.subTest(args=args):
                self.assertIn("it is a folder\nhint: give the name of a file", self.expect(2, *args).err)
        self.assertEqual(sorted(str(p) for p in self.folder.rglob("*")), before)

    def test_a_full_disk(self):
        """A limit on the size of files makes writes fail in the middle, like a full disk."""
        self.write("ball.vug", BALL.replace("10cm", "5cm") + "mesh wall on rock {}\n")
        self.write("out/ball.vdb", "old\n")
        self.write("out/ball.ply", "old\n")

        def small_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        for args in [("build", "ball.vug", "-o", "out"),
                     ("render", "ball.vug", "-o", "a.exr", "--size", "64x64", "--spp", "1")]:
            with self.subTest(args=args):
                self.expect(3, *args, preexec_fn=small_files, restore_signals=False)
        self.assertEqual(self.files(), ["ball.vug", "out/ball.ply", "out/ball.vdb"])
        self.assertEqual((self.folder / "out/ball.vdb").read_text(), "old\n")

    def test_a_standard_output_that_is_full(self):
        self.write("ball.vug", BALL)
        for args in [("list",), ("list", "--json"), ("measure", "ball.vug"), ("check", "ball.vug"),
                     ("format", "ball.vug"), ("build", "ball.vug", "-o", "out")]:
            with self.subTest(args=args), open("/dev/full", "w") as full:
                result = self.vug(*args, stdout=full)
                self.assertEqual(result.code, 3, result.err)
                self.assertIn("standard output", result.err)


if __name__ == "__main__":
    unittest.main()
