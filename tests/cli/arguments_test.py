"""Values of options: read as scenes read them, and refused with a sentence that fits."""
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
        self.refused("--checkpoint-every: '90m' is no number from 0 to 1e+06s", *RENDER,
                     "--checkpoint", "c", "--checkpoint-every", "90m")
        self.expect(0, *RENDER)
        self.expect(0, "diff", "a.exr", "a.exr", "--max", "rmse=1%", "--alarm", "1%")
        self.refused("sets no limit", "diff", "a.exr", "a.exr", "--max", "rmse=1m")

    def test_limits_that_nothing_keeps_or_that_are_told_twice(self):
        self.expect(0, *RENDER)
        diff = ("diff", "a.exr", "a.exr")
        self.refused("no image can meet the limit -1 of rmse", *diff, "--max", "rmse=-1")
        self.refused("equal pictures have 1", *diff, "--min", "ssim=2")
        self.expect(0, *diff, "--max", "rmse=0", "--max", "albedo.rmse=0", "--min", "psnr=-1")
        self.refused("there are two limits of rmse\n", *diff, "--max", "rmse=1", "--max", "rmse=2")
        self.refused("there are two limits of albedo.rmse\n", *diff, "--max", "albedo.rmse=1", "--max", "rmse=2",
                     "--max", "albedo.rmse=1")

    def test_faults_of_options_are_not_those_of_the_text(self):
        self.write("s.vug", BALL + "camera main { eye (0, 0, 4) }\nrender main { size 8x8  spp 1 }\n")
        render = ("render", "s.vug", "-o", "s.exr")
        for option, said in ((["--layers", "beauty,nope"], "--layers: unknown layer 'nope'"),
                             (["--view", "nope"], "--view: unknown view 'nope'"),
                             (["--display", "nope"], "--display: unknown display 'nope'"),
                             (["--eye", "left"], "--eye: the camera has no views"),
                             (["--denoise", "--layers", "beauty"], "--denoise: an image without the layer 'variance'"),
                             (["--deep", "--noise", "5%"], "--deep: a deep picture takes all samples")):
            error = self.refused("error: " + said, *render, *option)
            self.assertNotIn("s.vug", error)
        self.assertEqual(self.refused("", *render, "--view", "nope").count("filmic"), 1)
        self.assertIn("did you mean 'filmic'? known: ", self.refused("", *render, "--view", "filmc"))

    def test_without_a_verb_the_verbs_are_told(self):
        error = self.refused("error: there is no verb\n")
        for verb in ("build", "check", "render"):
            self.assertRegex(error, rf"hint: .*\b{verb}\b")
        self.refused("error: there is no verb\n", "")

    def test_options_that_there_are_none_of(self):
        for args, said in (((*RENDER, "--sppp", "3"), "no option '--sppp'\nhint: did you mean '--spp'?\n"),
                           ((*RENDER, "--max-memry=3G"), "no option '--max-memry'\nhint: did you mean '--max-memory'?\n"),
                           ((*RENDER, "--unheard-of"), "no option '--unheard-of'\nhint: 'vug render --help' tells what it takes\n"),
                           (("facade", "model", "--gramar", "x"), "no option '--gramar'\nhint: did you mean '--grammar'?\n")):
            self.refused("error: there is " + said, *args)
        self.refused("error: there is no option '--vesion'\nhint: did you mean '--version'?\n", "--vesion")
        self.refused("error: there is no verb 'rendr'\nhint: did you mean 'render'?\n", "--plugin", "p.so", "rendr", "ball.vug")
        self.refused("error: there is no verb\nhint: say what to do: vug build, ", "--plugin", "p.so")
        self.refused("error: there is one argument too many: 'extra'\nhint: 'vug render --help'", *RENDER, "extra")
        self.refused("error: there are arguments too many: 'x', '8'\n", "render", "ball.vug", "-o", "a.exr", "--size", "8", "x", "8")

    def test_numbers_that_are_none(self):
        for noise in ("3cm", "nan", "inf", "", "3 %", "much", "0x1p-3", "1x2"):
            self.refused("--noise: ", *RENDER, "--noise", noise)
        self.refused("--noise: '3cm' is no number from 0 to 100%", *RENDER, "--noise", "3cm")
        self.refused("--noise: 3 is not from 0 to 100%", *RENDER, "--noise", "3")
        self.refused("--exposure: '10%' is no number from -30 to 30", *RENDER, "--exposure", "10%")

    def test_whole_numbers(self):
        for spp in ("4.5", "0", "many", "99999999999"):
            self.refused(f"--spp: '{spp}' is no whole number from 1 to 1048576", *RENDER, "--spp", spp)
        self.refused("--threads: '1.5' is no whole number from 0 to 1024", *RENDER, "--threads", "1.5")
        self.refused("--sample-seed: '-1' is no whole number from 0 on", *RENDER, "--sample-seed", "-1")

    def test_names_of_pictures(self):
        for name in (".exr", "out/.exr"):
            self.refused(f"'{name}' has no name before its ending\nhint: write for instance picture.exr",
                         "render", "ball.vug", "-o", name)
        self.refused("'a' does not end in .exr", "render", "ball.vug", "-o", "a")
        self.refused("'.png' has no name before its ending", *RENDER, "--preview", ".png")
        self.refused("'.exr' has no name before its ending", "merge", "ball.vug", "-o", ".exr")
        self.assertEqual(self.files(), ["ball.vug"])

    def test_params_that_the_scene_has_not(self):
        self.refused("the scene has no param 'R'\nhint: it declares none", "check", "ball.vug", "-D", "R=1")
        self.write("two.vug", "param RADIUS = 1m\nparam VOXEL = 10cm\nvolume a = level_set(sphere(RADIUS), voxel: VOXEL)\n")
        self.refused("hint: did you mean 'RADIUS'? its params: RADIUS, VOXEL\n", "check", "two.vug", "-D", "RADUIS=1")
        self.refused("hint: its params: RADIUS, VOXEL\n", "check", "two.vug", "-D", "LD=1")


if __name__ == "__main__":
    unittest.main()
