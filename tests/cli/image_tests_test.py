# SPDX-License-Identifier: Apache-2.0
"""vug test: cases, updates of references, runs with other seeds, reports."""
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree

from diff_test import ROOM, Page
from pictures import scene, shown, write_png
from vug import PROGRAM, VugTest

SCENE = {"scene": "../room.vug", "render": {"size": "24x16", "spp": 16}}


class ImageTests(VugTest):
    def case(self, name, content):
        self.write(f"looks/{name}/case.json", content if isinstance(content, str) else json.dumps(content))

    def prepare(self):
        self.write("looks/room.vug", ROOM)
        self.case("lamp", SCENE)
        self.expect(0, "test", "looks", "--update", "--reason", "first light")

    def test_a_missing_reference_is_never_created_implicitly(self):
        self.case("new", SCENE)
        result = self.vug("test", "looks")
        self.assertEqual(result.code, 2, result.out)
        self.assertRegex(result.out, r"(?s)unusable +new  its reference 'reference.exr' is missing\n"
                                     r".*\nnew:\n  hint: [^\n]*--update --reason")
        self.assertRegex(result.out, r"same +lamp  identical")
        self.assertFalse((self.folder / "looks/new/reference.exr").exists())
        self.case("lost", {"scene": "gone.vug"})
        lost = self.vug("test", "looks", "--filter", "lost")
        self.assertEqual(lost.code, 2)
        self.assertRegex(lost.out, r"unusable +lost  its scene 'gone.vug' cannot be read: no such file\n")
        self.case("low", {**SCENE, "limits": {"albedo.rmse": -0.1}})
        self.assertIn("no image can meet the limit -0.1 of albedo.rmse", self.vug("test", "looks", "--filter", "low").out)
        kept = self.vug("test", "looks", "--filter", "new", "--output", "kept")
        self.assertEqual(kept.code, 2)
        self.assertRegex(kept.out, r"hint: look at \S*kept/new/test\.png, then")
        self.assertTrue((self.folder / "kept/new/test.exr").exists())
        self.assertIn('href="new/test.png"', (self.folder / "kept/index.html").read_text())

    def test_updates_need_a_reason_and_record_it(self):
        history = self.folder / "looks/lamp/reference.history"
        self.assertRegex(history.read_text(), r"^vug \S+ [0-9a-f]{32} first light\n$")
        for args in (["--update"], ["--update", "--reason", " "], ["--reason", "none"],
                     ["--update", "--reason", "x", "--flaky", "2"]):
            self.expect(2, "test", "looks", *args)
        self.expect(0, "test", "looks", "--update", "--reason", "nothing changed")
        self.assertEqual(len(history.read_text().splitlines()), 1, "the same picture stays")
        self.write("looks/room.vug", ROOM.replace("LIGHT = 9", "LIGHT = 5"))
        self.assertEqual(self.vug("test", "looks").code, 1)
        self.expect(0, "test", "looks", "--update", "--reason", "a weaker lamp")
        self.assertRegex(history.read_text().splitlines()[1], "^vug .* a weaker lamp$")
        self.expect(0, "test", "looks")

    def test_an_unrecorded_reference(self):
        reference = self.folder / "looks/lamp/reference.exr"
        self.expect(0, "render", "looks/room.vug", "-o", "other.exr", "--spp", "4")
        reference.write_bytes((self.folder / "other.exr").read_bytes())
        self.assertIn("does not match the last entry of its history", self.vug("test", "looks").out)

    def test_references_contain_only_compared_layers(self):
        channels = json.loads(self.expect(0, "info", "looks/lamp/reference.exr", "--json").out)["channels"]
        self.assertEqual({channel.split()[0] for channel in channels},
                         {"R", "G", "B", "variance.R", "variance.G", "variance.B", "samples"})

    def test_both_views_of_a_picture_for_stereo_are_guarded(self):
        both = ROOM.replace("camera main {", "camera main { interaxial 20cm ")
        self.assertNotEqual(both, ROOM)
        self.write("looks/both.vug", both)
        self.case("both", {**SCENE, "scene": "../both.vug"})
        only = ("test", "looks", "--filter", "both")
        self.expect(0, *only, "--update", "--reason", "two eyes")
        channels = json.loads(self.expect(0, "info", "looks/both/reference.exr", "--json").out)["channels"]
        self.assertEqual({channel.split()[0] for channel in channels},
                         {view + name for view in ("", "right.")
                          for name in ("R", "G", "B", "variance.R", "variance.G", "variance.B", "samples")})
        self.expect(0, *only)
        self.expect(0, *only, "--flaky", "2")
        # Both views differ, and both are reported.
        self.write("looks/both.vug", both.replace("interaxial 20cm", "interaxial 60cm"))
        self.assertIn("right: ", self.vug(*only).out)

    def test_reports(self):
        self.write("looks/room.vug", ROOM.replace("LIGHT = 9", "LIGHT = 5"))
        self.case("broken", {"scene": "no.vug"})
        (self.folder / "looks/broken/reference.exr").write_bytes(
            (self.folder / "looks/lamp/reference.exr").read_bytes())
        pages = []
        for out in ("one", "two"):
            result = self.vug("test", "looks", "-o", out, "--junit", f"{out}/junit.xml", "-j", "1" if out == "one" else "4")
            self.assertEqual(result.code, 2)
            self.assertIn("error: some cases are unusable", result.err)
            pages.append([(self.folder / out / page).read_text() for page in
                          ("index.html", "lamp/report.html", "lamp/report.json")])
            root = xml.etree.ElementTree.parse(self.folder / out / "junit.xml").getroot()
            suite = root.find("testsuite")
            self.assertEqual([suite.get(k) for k in ("name", "tests", "failures", "errors")],
                             ["looks", "2", "1", "1"])
            self.assertIn("no such file", suite.find("testcase[@name='broken']/error").get("message"))
            self.assertIn("different", suite.find("testcase[@name='lamp']/failure").get("type"))
        self.assertEqual(*pages)
        index = pages[0][0]
        self.assertIn('href="lamp/report.html"', index)
        self.assertEqual(len(Page(pages[0][1]).pictures), 4)
        self.assertFalse(json.loads(pages[0][2])["same"])
        self.assertIn("no such file", (self.folder / "one/broken/log.txt").read_text())

    def test_filter(self):
        self.case("deep/down/dark", SCENE)
        self.assertRegex(self.vug("test", "looks", "--filter", "dark").out, "^unusable +deep/down/dark ")
        self.expect(0, "test", "looks", "--filter", "lamp")
        self.expect(0, "test", "looks/lamp")
        self.assertIn("no case", self.expect(2, "test", "looks", "--filter", "none").err)

    def test_commands_and_reseeding(self):
        # A program whose picture depends on its seed: odd seeds give darker pictures.
        write_png(self.folder / "even.png", shown(scene(20, 14, 1)))
        write_png(self.folder / "odd.png", shown(scene(20, 14, 1, dark=0.5)))
        self.write("draw.sh", f"cd {self.folder}\nif [ $(($2 % 2)) = 1 ]; then cp odd.png $1; else cp even.png $1; fi\n")
        draw = ["sh", str(self.folder / "draw.sh"), "{output}", "{seed}"]
        self.case("drawn", {"command": draw, "reference": "drawn.png"})
        self.expect(0, "test", "looks", "--filter", "drawn", "--update", "--reason", "drawn")
        self.expect(0, "test", "looks", "--filter", "drawn")
        flaky = self.vug("test", "looks", "--filter", "drawn", "--flaky", "3")
        self.assertEqual(flaky.code, 1)
        self.assertRegex(flaky.out, r"flaky +drawn  identical; 2 of 4 seeds pass")
        steady = self.expect(0, "test", "looks", "--filter", "lamp", "--flaky", "3")
        self.assertIn("4 of 4 seeds pass", steady.out)

    def test_unusable_cases(self):
        for content, said in [("{", "invalid JSON"), ("[]", "a case must be a JSON object"),
                              ({}, "no scene and no command"), ({**SCENE, "command": ["x"]}, "a scene and a command"),
                              ({**SCENE, "limit": {}}, "did you mean 'limits'?"),
                              ({**SCENE, "limits": {"rsme": 1}}, "did you mean 'rmse'?"),
                              ({**SCENE, "limits": 3}, "JSON object"), ({**SCENE, "scene": 3}, "not a string"),
                              ({**SCENE, "alarm": 3}, "alarm"), ({"command": ["true"]}, "does not contain {output}"),
                              ({"command": ["no_such_program", "{output}"]}, "cannot run 'no_such_program'"),
                              ({"command": ["true", "{output}"]}, "did not write a picture"),
                              ({"command": ["false", "{output}"]}, "exit code 1"),
                              ({"command": ["sh", "-c", "sleep 20", "{output}"], "timeout": 0.2}, "did not finish within 0.2 seconds"),
                              ({**SCENE, "mask": "none.png"}, "none.png"),
                              ({**SCENE, "layers": ["N"]}, "no layer 'N'"),
                              ({**SCENE, "render": {"size": "8x8", "spp": 1}}, "8 x 8")]:
            with self.subTest(content=content):
                self.case("lamp", content)
                result = self.vug("test", "looks", "--filter", "lamp")
                self.assertEqual(result.code, 2, result.out)
                self.assertIn(said, result.out)
        self.assertIn("is not a folder", self.expect(2, "test", "nowhere").err)
        pathlib.Path(self.folder / "empty").mkdir()
        self.assertIn("contains no case", self.expect(2, "test", "empty").err)

    def test_a_summary_ends_the_list(self):
        self.case("new", SCENE)
        out = self.vug("test", "looks").out.splitlines()
        self.assertRegex(out[-1], r"^2 cases in [0-9.]+ s: 1 same, 1 unusable$")
        quiet = self.expect(0, "test", "looks", "--filter", "lamp", "--quiet")
        self.assertEqual(quiet.out + quiet.err, "")

    def test_cancellation_leaves_no_files(self):
        self.case("long", {"command": ["sh", "-c", "echo started >&2; exec sleep 60", "{output}"]})
        (self.folder / "looks/long/reference.exr").write_bytes(
            (self.folder / "looks/lamp/reference.exr").read_bytes())
        self.write("looks/long/reference.history", (self.folder / "looks/lamp/reference.history").read_text())
        (self.folder / "temp").mkdir()
        for how in (signal.SIGINT, signal.SIGTERM):
            running = subprocess.Popen([PROGRAM, "test", "looks", "--filter", "long"], cwd=self.folder,
                                       env={**os.environ, "TMPDIR": str(self.folder / "temp")},
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            end = time.monotonic() + 60
            logs = []
            while not any(log.read_text() for log in logs) and time.monotonic() < end:
                logs = list((self.folder / "temp").rglob("log.txt"))
                time.sleep(0.02)
            self.assertTrue(logs, "it never began")
            running.send_signal(how)
            out, said = running.communicate(timeout=30)
            self.assertEqual(running.returncode, 3, said)
            self.assertIn("error: stopped on request", said)
            self.assertEqual(out, "")
            self.assertEqual(list((self.folder / "temp").iterdir()), [])

    def test_measures_are_listed(self):
        listed = self.expect(0, "list", "measure").out
        for name in ("flip", "flip_hdr", "rmse", "ssim", "psnr"):
            self.assertRegex(listed, rf"(?m)^  {name} ")


if __name__ == "__main__":
    unittest.main()
