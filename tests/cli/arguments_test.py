# SPDX-License-Identifier: Apache-2.0
"""Values of options: parsed as in scenes, and rejected with a specific message."""
import unittest

from vug import BALL, VugTest

RENDER = ("render", "ball.vug", "-o", "a.exr", "--size", "8x8")


class Arguments(VugTest):
    def setUp(self):
        super().setUp()
        self.write("ball.vug", BALL)

    def refused(self, said, *args):
        error = self.expect(2, *args).err
        self.assertIn(said, error)
        return error

    def same(self, *ways):
        pictures = set()
        for way in ways:
            self.expect(0, *RENDER, "--sample-seed", "3", *way)
            pictures.add((self.folder / "a.exr").read_bytes())
        self.assertEqual(len(pictures), 1)

    def test_units_as_in_scenes(self):
        self.same(("--noise", "30%"), ("--noise", "0.3"), ("--noise", ".3"), ("--noise", "3e-1"))
        self.same(("--exposure", "-1"), ("--exposure", "-1.0"))
        self.expect(0, *RENDER, "--checkpoint", "c", "--checkpoint-every", "90s")
        self.refused("--checkpoint-every: invalid value '90m': expected a number from 0 to 1e+06s", *RENDER,
                     "--checkpoint", "c", "--checkpoint-every", "90m")
        self.expect(0, *RENDER)
        self.expect(0, "diff", "a.exr", "a.exr", "--max", "rmse=1%", "--alarm", "1%")
        self.refused("invalid limit '--max rmse=1m'", "diff", "a.exr", "a.exr", "--max", "rmse=1m")

    def test_limits_that_are_unreachable_or_repeated(self):
        self.expect(0, *RENDER)
        diff = ("diff", "a.exr", "a.exr")
        self.refused("no image can meet the limit -1 of rmse", *diff, "--max", "rmse=-1")
        self.refused("equal images have 1", *diff, "--min", "ssim=2")
        self.expect(0, *diff, "--max", "rmse=0", "--max", "albedo.rmse=0", "--min", "psnr=-1")
        self.refused("duplicate limit for rmse\n", *diff, "--max", "rmse=1", "--max", "rmse=2")
        self.refused("duplicate limit for albedo.rmse\n", *diff, "--max", "albedo.rmse=1", "--max", "rmse=2",
                     "--max", "albedo.rmse=1")

    def test_errors_of_options_are_not_attributed_to_the_text(self):
        self.write("s.vug", BALL + "camera main { eye (0, 0, 4) }\nrender main { size 8x8  spp 1 }\n")
        render = ("render", "s.vug", "-o", "s.exr")
        for option, said in ((["--layers", "beauty,nope"], "--layers: unknown layer 'nope'"),
                             (["--view", "nope"], "--view: unknown view 'nope'"),
                             (["--display", "nope"], "--display: unknown display 'nope'"),
                             (["--eye", "left"], "--eye: the camera is not a stereo camera")):
            error = self.refused("error: " + said, *render, *option)
            self.assertNotIn("s.vug", error)
        self.assertEqual(self.refused("", *render, "--view", "nope").count("filmic"), 1)
        self.assertIn("did you mean 'filmic'? known: ", self.refused("", *render, "--view", "filmc"))

    def test_options_with_too_many_values_or_none(self):
        error = self.refused("error: '--json' has no value\n", "diff", "--json")
        self.assertIn("hint: write the value after the option", error)
        error = self.refused("error: '--size' is given several times\n", *RENDER, "--size", "4x4")
        self.assertIn("hint: it takes one value\n", error)

    def test_a_missing_verb_lists_the_verbs(self):
        error = self.refused("error: no verb given\n")
        for verb in ("build", "check", "render"):
            self.assertRegex(error, rf"hint: .*\b{verb}\b")
        self.refused("error: no verb given\n", "")

    def test_unknown_options(self):
        for args, said in (((*RENDER, "--sppp", "3"), "'--sppp'\nhint: did you mean '--spp'?\n"),
                           ((*RENDER, "--max-memry=3G"), "'--max-memry'\nhint: did you mean '--max-memory'?\n"),
                           ((*RENDER, "--unheard-of"), "'--unheard-of'\nhint: 'vug render --help' lists its options\n"),
                           (("facade", "model", "--gramar", "x"), "'--gramar'\nhint: did you mean '--grammar'?\n")):
            self.refused("error: unknown option " + said, *args)
        self.refused("error: unknown option '--vesion'\nhint: did you mean '--version'?\n", "--vesion")
        self.refused("error: unknown verb 'rendr'\nhint: did you mean 'render'?\n", "--plugin", "p.so", "rendr", "ball.vug")
        self.refused("error: no verb given\nhint: write vug VERB, where VERB is one of build, ", "--plugin", "p.so")
        self.refused("error: unexpected argument: 'extra'\nhint: 'vug render --help'", *RENDER, "extra")
        self.refused("error: unexpected arguments: 'x', '8'\n", "render", "ball.vug", "-o", "a.exr", "--size", "8", "x", "8")

    def test_invalid_numbers(self):
        for noise in ("3cm", "nan", "inf", "", "3 %", "much", "0x1p-3", "1x2"):
            self.refused("--noise: ", *RENDER, "--noise", noise)
        self.refused("--noise: invalid value '3cm': expected a number from 0 to 100%", *RENDER, "--noise", "3cm")
        self.refused("--noise: value 3 is out of range: expected a number from 0 to 100%", *RENDER, "--noise", "3")
        self.refused("--exposure: invalid value '10%': expected a number from -30 to 30", *RENDER, "--exposure", "10%")

    def test_whole_numbers(self):
        for spp in ("4.5", "0", "many", "99999999999"):
            self.refused(f"--spp: invalid value '{spp}': expected an integer from 1 to 1048576", *RENDER, "--spp", spp)
        self.refused("--threads: invalid value '1.5': expected an integer from 0 to 1024", *RENDER, "--threads", "1.5")
        self.refused("--sample-seed: invalid seed '-1': expected an integer of at least 0", *RENDER, "--sample-seed", "-1")

    def test_names_of_pictures(self):
        for name in (".exr", "out/.exr"):
            self.refused(f"'{name}' has no name before its extension\nhint: write, for instance, picture.exr",
                         "render", "ball.vug", "-o", name)
        self.refused("'a' does not end in .exr", "render", "ball.vug", "-o", "a")
        self.refused("'.png' has no name before its extension", *RENDER, "--preview", ".png")
        self.refused("'.exr' has no name before its extension", "merge", "ball.vug", "-o", ".exr")
        self.assertEqual(self.files(), ["ball.vug"])

    def test_params_that_the_scene_does_not_declare(self):
        self.refused("the scene has no param 'R'\nhint: it declares no parameters", "check", "ball.vug", "-D", "R=1")
        self.write("two.vug", "param RADIUS = 1m\nparam VOXEL = 10cm\nvolume a = level_set(sphere(RADIUS), voxel: VOXEL)\n")
        self.refused("hint: did you mean 'RADIUS'? its params: RADIUS, VOXEL\n", "check", "two.vug", "-D", "RADUIS=1")
        self.refused("hint: its params: RADIUS, VOXEL\n", "check", "two.vug", "-D", "LD=1")


if __name__ == "__main__":
    unittest.main()
