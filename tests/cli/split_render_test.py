# SPDX-License-Identifier: Apache-2.0
"""Long renders: merged partial renders and resumed renders are identical to uninterrupted ones."""
import json
import random
import signal
import subprocess
import time
import unittest

from vug import PROGRAM, SLOW, VugTest, digest

SCENE = """seed 5
volume rock = level_set(box(size: (6, 4, 6)) - sphere(1.8m), voxel: 20cm)
camera main { eye (-1.2, 0.3, 0.4)  target (1, 0, 0)  fov 70deg }
light lamp = sphere(center: (0.5, 0.6, 0.3), radius: 10cm, radiance: (90, 60, 30))
medium dust = haze(extinction: 5%/m)
render main { size 64x40  spp 48 }
"""


class Farm(VugTest):
    def prepare(self):
        self.write("s.vug", SCENE)
        self.expect(0, "render", "s.vug", "-o", "whole.exr")

    def expect_whole(self, name, whole="whole"):
        for end in ("exr", "png"):
            self.assertEqual(digest(self.folder / f"{name}.{end}"),
                             digest(self.folder / f"{whole}.{end}"), f"{name}.{end}")

    def part(self, name, *args, code=0):
        return self.expect(code, "render", "s.vug", "--part", name, *args)

    def test_tiles(self):
        for i in (3, 1, 2):
            self.part(f"t{i}", "--tile", f"{i}/3", "--threads", i)
        self.expect(0, "merge", "t2", "t1", "t3", "-o", "tiles.exr")
        self.expect_whole("tiles")

    def test_samples_and_tiles(self):
        self.part("a", "--samples", "0..7", "--tile", "1/2")
        self.part("b", "--samples", "7..48", "--tile", "1/2")
        self.part("c", "--tile", "2/2")
        self.expect(0, "merge", "c", "b", "a", "-o", "both.exr")
        self.expect_whole("both")

    def test_all_layers_and_a_crop(self):
        args = ("--layers", "all", "--crop", "10,5,50,35", "--exposure", "1.5", "--float",
                "--denoise")
        self.expect(0, "render", "s.vug", "-o", "crop.exr", *args)
        for i in (1, 2):
            self.part(f"c{i}", "--tile", f"{i}/2", *args)
        self.expect(0, "merge", "c1", "c2", "-o", "joint.exr")
        self.expect_whole("joint", "crop")

    def test_parts_share_what_was_learned(self):
        args = ("--guiding", "light.vugguide")
        learned = self.expect(0, "render", "s.vug", *args)
        self.assertEqual(learned.out, "light.vugguide\n")
        before = digest(self.folder / "light.vugguide")
        for i in (1, 2, 3):
            shown = self.part(f"t{i}", "--tile", f"{i}/3", *args, "--progress").err
            self.assertNotIn("learning", shown)
            self.assertNotIn("share it", shown)
        self.expect(0, "merge", "t1", "t2", "t3", "-o", "tiles.exr")
        self.expect_whole("tiles")
        self.expect(0, "render", "s.vug", "-o", "again.exr", *args)
        self.expect_whole("again")
        self.assertEqual(digest(self.folder / "light.vugguide"), before)
        info = json.loads(self.expect(0, "info", "light.vugguide", "--json").out)
        self.assertEqual((info["type"], info["width"], info["spp"]), ("learned light of a picture", 64, 48))

    def test_the_first_part_writes_what_it_learns(self):
        shown = self.part("t1", "--tile", "1/2", "--guiding", "new.vugguide", "--progress").err
        self.assertIn("learning", shown)
        self.assertNotIn("share it", shown)
        alone = self.part("alone", "--tile", "1/2").err
        self.assertIn("this part learned the light of the whole picture for itself", alone)
        self.assertIn("--guiding FILE share it", alone)
        self.part("t2", "--tile", "2/2", "--guiding", "new.vugguide", "--threads", "1")
        self.expect(0, "merge", "t1", "t2", "-o", "tiles.exr")
        self.expect_whole("tiles")
        self.expect(0, "render", "s.vug", "--guiding", "same.vugguide", "--threads", "3")
        self.assertEqual(digest(self.folder / "same.vugguide"), digest(self.folder / "new.vugguide"))

    def test_guiding_files_of_other_pictures_are_refused(self):
        self.expect(0, "render", "s.vug", "--guiding", "g")
        for args, what in [(("--spp", "32"), "samples per pixel"), (("--seed", "6"), "seeds"), (("--size", "32x20"), "sizes")]:
            said = self.expect(2, "render", "s.vug", "-o", "no.exr", "--guiding", "g", *args).err
            self.assertIn(f"the guiding file 'g' belongs to another picture: different {what}", said)
        data = (self.folder / "g").read_bytes()
        changed = bytearray(data)
        changed[len(data) // 2] ^= 1
        for name, content, why in [("cut", data[:-9], "cut short"), ("flip", bytes(changed), "content was changed"),
                                   ("text", b"not a guiding file at all", "it is not a guiding file"), ("few", b"x", "cut short")]:
            self.write(name, content)
            self.assertIn(why, self.expect(2, "render", "s.vug", "-o", "no.exr", "--guiding", name).err)
        self.assertIn("--guiding", self.expect(2, "render", "s.vug").err)

    def test_parts_that_do_not_form_a_picture(self):
        self.part("a", "--tile", "1/2")
        self.part("b", "--tile", "2/2")
        self.part("b_seed", "--tile", "2/2", "--seed", "6")
        self.part("b_half", "--tile", "2/2", "--samples", "0..24")
        self.write("other.vug", SCENE.replace("(90, 60, 30)", "(90, 60, 31)"))
        self.expect(0, "render", "other.vug", "--part", "b_scene", "--tile", "2/2")
        self.write("text", "this is not a part")
        for parts, sentence in [(["a"], "the samples 0..48 of the pixels x 0..63, y 20..39 are missing"),
                                (["a", "b", "a"], "'a' and 'a' both have the samples 0..48"),
                                (["a", "b_half"], "samples 24..48 of the pixels x 0..63, y 20..39 are missing"),
                                (["a", "b_seed"], "'a' and 'b_seed' have different seeds, 5 and 6"),
                                (["a", "b_scene"], "'a' and 'b_scene' have different scenes"),
                                (["a", "text"], "'text': it is not a part of a picture"),
                                (["a", "none"], "'none': no such file")]:
            self.assertIn(sentence, self.expect(2, "merge", *parts, "-o", "m.exr").err)
        self.assertFalse((self.folder / "m.exr").exists())

    def test_included_texts_are_part_of_the_scene(self):
        for radiance in (90, 91):
            self.write("lamps.vug", f"light more = sphere(center: (0.5, 0.6, 0.3), radius: 10cm, "
                                    f"radiance: ({radiance}, 60, 30))\n")
            self.write("with.vug", 'include "lamps.vug"\n' + SCENE)
            self.expect(0, "render", "with.vug", "--part", f"p{radiance}", "--tile",
                        f"{radiance - 89}/2")
        self.assertIn("different scenes", self.expect(2, "merge", "p90", "p91", "-o", "m.exr").err)

    def test_names_that_equal_the_default_choice(self):
        self.part("a", "--tile", "1/2")
        self.part("b", "--tile", "2/2", "--render", "main", "--camera", "main")
        self.expect(0, "merge", "a", "b", "-o", "m.exr")

    def test_invalid_parts(self):
        for args in [("--tile", "0/2"), ("--tile", "3/2"), ("--tile", "2"), ("--tile", "1/41"),
                     ("--samples", "0..49"), ("--samples", "7..7"), ("--samples", "7-9"),
                     ("--crop", "0,0,65,10"), ("--crop", "5,5,5,9"),
                     ("--noise", "0.1", "--tile", "1/2"), ("-o", "a.exr")]:
            self.part("p", *args, code=2)
        self.expect(2, "render", "s.vug", "-o", "a.exr", "--tile", "1/2")
        self.expect(2, "render", "s.vug", "-o", "a.exr", "--resume")
        self.expect(2, "render", "s.vug")
        self.assertIn("did you mean 'albedo'", self.expect(
            2, "render", "s.vug", "-o", "a.exr", "--layers", "beauty,albdo").err)

    def killed(self, delay, *args):
        """Runs the command and kills it after that time; returns whether it had ended before."""
        process = subprocess.Popen([PROGRAM, *args], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        try:
            process.communicate(timeout=delay)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.communicate()
            return False
        self.assertEqual(process.returncode, 0)
        return True

    def kill_and_resume(self, name, whole, *args):
        started = time.monotonic()
        self.expect(0, "render", "s.vug", "-o", f"{whole}.exr", *args)
        duration = time.monotonic() - started
        options = ("-o", f"{name}.exr", "--checkpoint", "state", "--checkpoint-every", "0.02",
                   "--preview", "so_far.png", "--resume", *args)
        moments = random.Random(7)
        for _ in range(10):
            self.killed(moments.uniform(0.1, 1.1) * duration, "render", "s.vug", *options)
            # A run that is killed after its last write leaves the files of a complete run; before that, no picture.
            picture = self.folder / f"{name}.exr"
            if picture.exists():
                self.assertEqual(digest(picture), digest(self.folder / f"{whole}.exr"))
                picture.unlink()
        self.expect(0, "render", "s.vug", *options)
        self.expect_whole(name, whole)
        self.assertFalse((self.folder / "state").exists())
        self.assertEqual(digest(self.folder / "so_far.png"), digest(self.folder / f"{whole}.png"))

    def test_killed_ten_times(self):
        self.kill_and_resume("killed", "whole2", *(() if SLOW else ("--spp", "96")))

    def test_killed_while_sampling_down_to_a_noise(self):
        self.write("s.vug", SCENE + "render noisy { size 64x40  spp 256  noise 20%  camera main }\n")
        self.kill_and_resume("noisy", "whole_noisy", "--render", "noisy")

    def test_a_checkpoint_is_not_lost_or_mistaken(self):
        process = subprocess.Popen([PROGRAM, "render", "s.vug", "-o", "a.exr", "--spp", "4096",
                                    "--checkpoint", "state", "--checkpoint-every", "0"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL)
        while not (self.folder / "state").exists() and process.poll() is None:
            time.sleep(0.02)
        process.send_signal(signal.SIGKILL)
        process.wait()
        kept = digest(self.folder / "state")
        args = ("render", "s.vug", "-o", "a.exr", "--checkpoint", "state")
        self.assertIn("already exists", self.expect(2, *args, "--spp", "4096").err)
        self.assertIn("different seeds, 5 and 9",
                      self.expect(2, *args, "--spp", "4096", "--resume", "--seed", "9").err)
        self.assertIn("is only", self.expect(2, "merge", "state", "-o", "a.exr").err)
        self.assertEqual(json.loads(self.expect(0, "info", "state", "--json").out)["type"], "checkpoint")
        self.assertEqual(digest(self.folder / "state"), kept)
        whole = (self.folder / "state").read_bytes()
        self.write("state", whole[:len(whole) // 2])
        self.assertEqual(self.expect(2, *args, "--spp", "4096", "--resume").messages,
                         "error: cannot read the checkpoint 'state': it is cut short\n"
                         "hint: remove it to start again\n")
        self.write("none.vugpart", b"")
        self.assertIn("it is cut short", self.expect(2, "info", "none.vugpart").err)

    def test_ctrl_c_saves(self):
        process = subprocess.Popen([PROGRAM, "render", "s.vug", "-o", "c.exr", "--spp", "100000",
                                    "--checkpoint", "state", "--progress"], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        said = b""
        while b"rendering     " not in said and process.poll() is None:  # the bar's stage
            said += process.stderr.read(1)
        process.send_signal(signal.SIGINT)
        said = process.communicate()[1].decode()
        self.assertEqual(process.returncode, 3)
        self.assertTrue((self.folder / "state").exists())
        self.assertRegex(said, r"error: stopped on request\nhint: 'state' contains the work so far, [\d.]+ %; "
                               r"the same command with --resume continues from it\n")
        held = json.loads(self.expect(0, "info", "state", "--json").out)
        self.assertEqual(held["holds"]["samples"], [0, 100000])
        self.assertEqual(held["holds"]["pixels"], [0, 0, 64, 40])
        self.assertLessEqual(held["holds"]["samples_left"], 64 * 40 * 100000)
        self.assertLess(0, held["holds"]["samples_left"])

    def test_info_describes_a_partial_render(self):
        self.part("a", "--tile", "2/4", "--samples", "16..48", "--crop", "0,8,64,40", "--layers", "beauty,Z")
        told = json.loads(self.expect(0, "info", "a", "--json").out)
        self.assertEqual((told["type"], told["width"], told["height"], told["spp"], told["seed"]),
                         ("part of a picture", 64, 40, 48, 5))
        self.assertEqual(told["bytes"], (self.folder / "a").stat().st_size)
        self.assertEqual(told["crop"], [0, 8, 64, 40])
        self.assertEqual(told["layers"], ["beauty", "Z"])
        self.assertEqual(told["holds"], {"pixels": [0, 16, 64, 24], "samples": [16, 48],
                                         "done": "100.0 %", "samples_left": 0})
        self.assertIn("sphere(1.8m)", told["metadata"]["vug:recipe"])
        self.part("b", "--tile", "1/4", "--samples", "16..48", "--crop", "0,8,64,40", "--layers", "beauty,Z")
        self.assertEqual(told["scene"], json.loads(self.expect(0, "info", "b", "--json").out)["scene"])
        self.assertIn("\n  samples: [16,48]\n", self.expect(0, "info", "a").out)
        whole = (self.folder / "a").read_bytes()
        for broken in (whole[:-100], whole[:60], whole[:-100] + b"?" + whole[-99:], whole + b"more"):
            self.write("a", broken)
            self.assertRegex(self.expect(2, "info", "a").err, "'a': (it is cut short|its content was changed)")


if __name__ == "__main__":
    unittest.main()
