# SPDX-License-Identifier: Apache-2.0
"""`vug check` reports, without building, all errors of the text that `vug render` would report later."""
import json
import os
import re
import unittest

from vug import SLOW, VugTest

SCENE = """volume rock = level_set(sphere(1m), voxel: 20cm)
mesh skin on rock {}
object ball on skin {}
object pebble on skin {}
place heap { of pebble at [(3, 0, 0), (5, 0, 0)]  apart true }
camera main { eye (0, 0, 4) }
light lamp = sphere(center: (0, 3, 0), group: "key", {link})
render main { size 16x12  spp 1  {render} }
"""


class Check(VugTest):
    def both(self, said, code=2, **parts):
        """Runs `vug check` and `vug render`, which must give the same errors; returns stderr."""
        text = SCENE
        for name in ("link", "render"):
            text = text.replace("{%s}" % name, parts.get(name, ""))
        self.write("s.vug", text.replace(", )", ")"))
        for verb in (("check", "s.vug"), ("render", "s.vug", "-o", "s.exr")):
            error = self.expect(code, *verb).err
            self.assertIn(said, error)
        return error

    def test_a_scene_without_products(self):
        for text, empty in (("seed 1\n", True), ("field f = sphere(1m)\n", True),
                            ("volume rock = level_set(sphere(1m), voxel: 20cm)\n", False)):
            self.write("s.vug", text)
            self.assertEqual("declares nothing to build or to render" in self.expect(0, "check", "s.vug").err,
                             empty, text)

    def test_a_volume_that_needs_too_much_memory(self):
        text = "param v = 0.1mm\nvolume rock = level_set(sphere(1km), voxel: v)\n"
        self.write("s.vug", text)
        self.assertRegex(self.expect(0, "check", "s.vug").err,
                         r"s.vug:2:8: warning: the volume 'rock' needs about \S+ \w+ of memory")
        self.assertEqual(self.expect(0, "check", "s.vug", "-D", "v=100m").messages, "")

    def test_a_voxel_that_fits(self):
        """The hint names a voxel with which the volume needs little less than the available memory."""
        text = "param v = 0.1mm\nvolume rock = level_set(sphere(1km), voxel: v)\n"
        self.write("s.vug", text)
        error = self.expect(0, "check", "s.vug").err
        voxel = re.search(r"hint: use voxels of at least (\S+) m or a smaller region", error).group(1)
        self.assertEqual(self.expect(0, "check", "s.vug", "-D", f"v={voxel}m").messages, "")
        self.assertIn("warning", self.expect(0, "check", "s.vug", "-D", f"v={0.5 * float(voxel)}m").err)

    def test_unused_names(self):
        unused = "param X = 1\nlet pebble = sphere(1cm)\nvolume rock = level_set(sphere(1m), voxel: 20cm)\n"
        self.write("s.vug", unused)
        both = ("s.vug:1:7: {0}: param 'X' is never used\nparam X = 1\n      ^\n"
                "hint: use it in an expression or remove it\n"
                "s.vug:2:5: {0}: let 'pebble' is never used\nlet pebble = sphere(1cm)\n    ^~~~~~\n"
                "hint: use it in an expression or remove it\n")
        for verb in (("check", "s.vug"), ("build", "s.vug", "-o", "out")):
            self.assertEqual(self.expect(0, *verb).messages, both.format("warning"), verb)
            self.assertEqual(self.expect(2, *verb, "--strict").messages, both.format("error"), verb)
        report = json.loads(self.vug("check", "s.vug", "--strict", "--json").out)
        self.assertEqual([d["severity"] for d in report["diagnostics"]], ["error", "error"])
        self.write("s.vug", "let red = (1, 0, 0)\nmaterial stone = lambert()\n")  # a text for inclusion
        self.assertNotIn("never used", self.expect(0, "check", "s.vug").err)
        self.write("main.vug", 'include "s.vug"\nvolume rock = level_set(sphere(1m), voxel: 20cm)\n')
        self.assertEqual(self.expect(0, "check", "main.vug", "--strict").messages, "")
        self.write("s.vug", unused + "mesh skin on rok {}\n")  # the error may be the reason
        self.assertNotIn("never used", self.expect(2, "check", "s.vug").err)

    def test_an_include_in_a_subfolder(self):
        self.write("s.vug", 'include "limestone.vug"\nvolume rock = level_set(sphere(1m), voxel: 20cm)\n')
        self.assertEqual(self.expect(0, "check", "s.vug").messages, "")
        self.write("s.vug", 'include "rocks/limestone.vug"\n')
        self.assertIn("s.vug:1:9: error: cannot find the file 'rocks/limestone.vug'\n"
                      'include "rocks/limestone.vug"\n        ^~~~~~~~~~~~~~~~~~~~~\n'
                      "hint: did you mean 'materials/limestone.vug'?\n", self.expect(2, "check", "s.vug").err)
        self.write("s.vug", 'include "no/limeston.vug"\n')
        self.assertIn("hint: looked in ", self.expect(2, "check", "s.vug").err)

    ROOM = ("volume rock = level_set(box(size: (8, 8, 8)) - box(size: (4, 4, 4)), voxel: 20cm)\nmesh wall on rock {}\n"
            "object walls on wall {}\nrender main { size 4x3  spp 1 }\n")

    def test_a_camera_and_a_light_in_rock(self):
        camera = ("s.vug:5:8: error: the camera 'main' at (0, 2.5, 0) is in rock, 0.50 m inside 'walls'\n"
                  "camera main { eye (0, 2.5, 0)  target (5, 0, 0) }\n       ^~~~\nhint: the nearest air is 0.50 m below: eye (0, 1.9, 0)\n")
        light = ("s.vug:6:1: error: the light 'lamp' at (2.5, 0, 0) is in rock, 0.50 m inside 'walls'\n"
                 "light lamp = sphere(center: (2.5, 0, 0), radius: 10cm)\n" + "^" + "~" * 53 + "\n"
                 "hint: the nearest air is 0.50 m towards -x: center: (1.9, 0, 0)\n")
        self.write("s.vug", self.ROOM + "camera main { eye (0, 2.5, 0)  target (5, 0, 0) }\n"
                   "light lamp = sphere(center: (2.5, 0, 0), radius: 10cm)\n")
        checked = self.expect(2, "check", "s.vug").messages
        self.assertIn(camera, checked)
        self.assertIn(light, checked)
        refused = self.expect(2, "render", "s.vug", "-o", "s.exr").messages
        self.assertEqual(refused, checked + "the render was not started; --anyway renders the scene as it is\n")
        self.assertEqual(self.files(), ["s.vug"])
        self.assertNotIn("error", self.expect(0, "render", "s.vug", "-o", "s.exr", "--anyway").err)
        self.assertIn("s.exr", self.files())
        report = json.loads(self.vug("check", "s.vug", "--json").out)
        self.assertEqual([(d["severity"], d["line"]) for d in report["diagnostics"]], [("error", 5), ("error", 6)])

    def test_the_camera_of_the_picture_is_checked(self):
        self.write("s.vug", self.ROOM + "camera main { eye (0, 0, 0)  target (5, 0, 0) }\ncamera other { eye (0, 3, 0)  target (5, 0, 0) }\n")
        self.expect(2, "check", "s.vug")
        self.expect(0, "render", "s.vug", "-o", "s.exr")
        self.assertIn("'other'", self.expect(2, "render", "s.vug", "-o", "s.exr", "--camera", "other").err)

    def test_a_flight_into_rock_is_refused_before_its_first_frame(self):
        self.write("s.vug", self.ROOM + "camera main { eye keys(1: (0, 0, 0), 3: (0, 3, 0))  target (5, 0, 0) }\n")
        self.expect(0, "render", "s.vug", "-o", "s.####.exr", "--frames", "1..2")
        self.assertIn("the camera 'main' at (0, 3, 0)",
                      self.expect(2, "render", "s.vug", "-o", "t.####.exr", "--frames", "1..3").err)
        self.assertEqual([name for name in self.files() if name.startswith("t.")], [])

    def test_a_floating_prop_and_a_filled_void(self):
        prop = ("volume c = level_set(box(size: (0.4, 0.4, 0.4)), voxel: 5cm)\nmesh cube on c {}\nobject chest on cube {}\n"
                "place chests { of chest  at (0, 0, 0) }\n")
        self.write("s.vug", self.ROOM + prop)
        self.assertIn("s.vug:8:7: error: 'chests' floats 1.80 m above 'walls': its foot is at (0, -0.2, 0)\n",
                      self.expect(2, "check", "s.vug").err)
        self.expect(2, "render", "s.vug", "-o", "s.exr")
        self.write("s.vug", self.ROOM + prop.replace("(0, 0, 0)", "(0, -1.8, 0)"))
        self.expect(0, "check", "s.vug")
        self.write("s.vug", "let hall = sphere(1m)\nvolume rock = level_set(box(size: (4, 4, 4)) - hall + sphere(1.5m), voxel: 10cm)\n"
                   "render main { size 4x3  spp 1 }\n")
        error = self.expect(2, "check", "s.vug").err
        self.assertIn("s.vug:1:12: error: this void is filled: 'rock' has rock in all of it\n"
                      "let hall = sphere(1m)\n           ^~~~~~~~~~\n", error)
        self.expect(2, "render", "s.vug", "-o", "s.exr")
        self.expect(0, "render", "s.vug", "-o", "s.exr", "--anyway")

    def test_nothing_is_computed(self):
        """Two nested dripstones would take half a minute; a typo is reported as quickly."""
        text = ("field hall = box(size: (30m, 12m, 30m)) - displace(ellipsoid(radii: (12, 4, 12)), amount: 50cm)\n"
                "field one = dripstone(hall, from: (-12, -5, -12), to: (12, 5, 12), spacing: 30cm)\n"
                "field two = dripstone(one, from: (-12, -5, -12), to: (12, 5, 12), spacing: 30cm, seed: 2)\n"
                "volume cave = level_set(two, voxel: 5cm)\nmesh skin on cave {}\nobject walls on skin {}\n"
                "camera main { eye (0, 1, 0)  target (5, 0, 0) }\nlight lamp = sphere(center: (1, 1, 0), radius: 10cm)\n")
        for more, code in (("", 0), ("mesh more on cavee {}\n", 2), ("light low = sphere(center: (0, 5.5, 0))\n", 2)):
            self.write("s.vug", text + more)
            before = os.times().children_user
            self.expect(code, "check", "s.vug")
            self.assertLess(os.times().children_user - before, 1 if not SLOW else 60, more)

    def test_a_light_linked_to_nothing(self):
        for link in ("only: [\"bal\"]", "except: [\"bal\"]"):
            self.both("s.vug:7:7: error: the light is linked to 'bal', but no shown object has "
                  "that name\nlight lamp", link=link)
        self.assertIn("did you mean 'ball'?", self.both("'bal'", link="only: [\"bal\"]"))
        self.assertIn("has the name of its place: 'heap'", self.both("'pebble'", link="only: [\"pebble\"]"))
        self.both("", 0, link="only: [\"ball\", \"heap\"]")
        self.both("", 0, link='except: ["heap/2"]')
        self.both("'heap/a'", link='only: ["heap/a"]')
        self.both("'heap/1/stone'", link='only: ["heap/1/stone"]')
        self.write("s.vug", SCENE.replace("apart true", "").replace("{link}", 'only: ["heap/2"]').replace("{render}", ""))
        self.assertIn("write 'apart true' in the place 'heap'", self.expect(2, "check", "s.vug").err)

    def test_a_portal_without_a_sky(self):
        text = "volume rock = level_set(sphere(1m), voxel: 20cm)\nlight mouth = portal(center: (0, 3, 0))\n%srender main { size 8x8  spp 1 }\n"
        dark = "s.vug:2:7: warning: no light comes through the portal 'mouth': the scene has no sky\nlight mouth"
        for more, warned in (("", True), ("light day = sun()\n", True), ("light lamp = sphere(center: (0, 3, 0))\n", True),
                             ("light day = sky()\n", False), ("light day = daylight()\n", False)):
            self.write("s.vug", text % more)
            for verb in (("check", "s.vug"), ("render", "s.vug", "-o", "s.exr")):
                self.assertEqual(dark in self.expect(0, *verb).err, warned, (more, verb))

    def test_an_emissive_object_has_a_light_layer(self):
        glow = SCENE.replace(", {link}", "").replace("ball on skin {}", 'ball on skin { emission (1, 1, 1)  light_group "glow" }')
        self.write("s.vug", glow.replace("{render}", 'layers ["beauty", "light_glow"]'))
        self.expect(0, "check", "s.vug")
        self.expect(0, "render", "s.vug", "-o", "s.exr")
        self.assertIn("light_glow.R half", json.loads(self.expect(0, "info", "s.exr", "--json").out)["channels"])
        self.write("s.vug", glow.replace("{render}", 'layers ["beauty", "light_glwo"]'))
        self.assertIn("'light_glow'", self.expect(2, "check", "s.vug").err)

    def test_light_beyond_the_range_of_numbers(self):
        glow = SCENE.replace(", {link}", "").replace("{render}", "")
        for made, place in (("object ball on skin { emission (1, %s, 1) }", "3:23"),
                            ("material hot = surface(emission_radiance: %s)", "3:24")):
            for radiance, code in (("1e30", 0), ("2e30", 2)):
                self.write("s.vug", glow.replace("object ball on skin {}", made % radiance))
                error = self.expect(code, "check", "s.vug").err
                self.assertEqual(f"s.vug:{place}: error: " in error, code == 2, error)

    def test_emissive_objects_that_move(self):
        """Errors that depend on the evaluation of `at` and are found only by rendering."""
        text = ("volume rock = level_set(sphere(1m), voxel: 20cm)\nmesh skin on rock {}\n"
                "object ball on skin { emission (1, 1, 1) }\nplace fall { of ball at [pose(position: keys(1: (0, 0, 0), 2: (0, 1, 0)))] }\n"
                "camera main { eye (0, 0, 4)  shutter %s }\nrender main { size 8x8  spp 1 }\n")
        self.write("s.vug", text % "0.5")
        self.assertIn("s.vug:4:7: error: object 'fall' is emissive and moves, which is not supported",
                      self.expect(2, "render", "s.vug", "-o", "s.exr").err)
        self.write("s.vug", text % "0")
        self.expect(0, "render", "s.vug", "-o", "s.exr")

    def test_counted_names(self):
        self.write("s.vug", SCENE.replace(", {link}", "").replace("{render}", ""))
        self.assertEqual(self.expect(0, "check", "s.vug").out,
                         "s.vug: fine; 1 volume, 1 mesh, 2 objects, 1 place, 1 light, 1 camera, 1 render\n")

    def test_links_into_placed_scenes(self):
        self.write("part.vug", SCENE.replace(", {link}", "").replace("{render}", ""))
        text = ('light lamp = sphere(center: (0, 3, 0), only: ["%s"])\nvolume a = level_set(sphere(1m), voxel: 20cm)\n'
                'place rooms { of scene("part.vug") at (0, 0, 0) }\nrender main { size 4x4  spp 1 }\n')
        for name, code in (("rooms", 0), ("rooms/ball", 0), ("rooms/heap", 0), ("rooms/bal", 2)):
            self.write("s.vug", text % name)
            self.expect(code, "check", "s.vug")
            self.expect(code, "render", "s.vug", "-o", "s.exr")

    def test_a_link_to_a_faulty_declaration_is_not_another_error(self):
        self.write("s.vug", SCENE.replace("{render}", "").replace("{link}", "only: [\"ball\"]").replace("ball on skin {}", "ball on skn {}"))
        self.assertEqual(self.expect(2, "check", "s.vug").err.count("error: "), 1)

    def test_impossible_pictures(self):
        self.both("s.vug:8:34: error: unknown layer 'light_kye'", render='layers ["beauty", "light_kye"]')
        self.both("", 0, render='layers ["beauty", "light_key"]')
        self.both("unknown layer 'light_kye'", render='layers ["light_kye"]')
        self.both("a picture needs the layer 'beauty'", render='layers ["Z"]')
        self.both("outside the picture of 16 x 12", render="crop [0, 0, 17, 4]")
        self.both("", 0, render="crop [0, 0, 16, 4]")
        self.both("", 0, render="deep true  noise 5%")

    def test_a_missing_view(self):
        self.write("s.vug", "volume rock = level_set(sphere(1m), voxel: 20cm)\n"
                            'render main { size 4x4  spp 1  view "flimic" }\n')
        self.assertIn("s.vug:2:8: warning: unknown view 'flimic'", self.expect(0, "check", "s.vug").err)
        report = json.loads(self.expect(0, "check", "s.vug", "--json").out)
        self.assertEqual([d["severity"] for d in report["diagnostics"]], ["warning"])
        self.expect(2, "render", "s.vug", "-o", "s.exr")

    def test_repeated_errors_are_counted(self):
        self.write("s.vug", "- a list, not a scene\n" * 300)
        error = self.expect(2, "check", "s.vug").err
        self.assertEqual(error.count("error: "), 20)
        self.assertTrue(error.endswith("... and at least 80 more\n"), error[-200:])
        self.write("s.vug", "- a list, not a scene\n" * 30)
        self.assertTrue(self.expect(2, "check", "s.vug").err.endswith("... and 10 more\n"))

    def test_provenance_through_an_include(self):
        self.write("lamps.vug", "light lamp = sphere(\n  center: (0, 3, 0))\n")
        self.write("s.vug", 'include "lamps.vug"\ncamera main {}\n'
                   "def slab(at) =\n  sphere(1m)\n  .translate(at)\n"
                   "grammar cave {\n  axiom Room\n  Room -> + sphere(1m)\n}\n")
        lines = self.expect(0, "check", "s.vug", "--provenance").out.splitlines()
        self.assertEqual(lines[1:], ["camera main: s.vug:2:1-2:15", "def slab: s.vug:3:1-5:17",
                                     "grammar cave: s.vug:6:1-9:2", "rule cave/Room: s.vug:8:3-8:23",
                                     "light lamp: lamps.vug:1:1-2:21, included from s.vug:1:9"])

    def test_a_picture_of_nothing(self):
        self.write("s.vug", "camera main {}\nrender main { size 4x4 }\n")
        self.assertIn("s.vug:2:8: warning: the scene has nothing to show", self.expect(0, "check", "s.vug").err)


if __name__ == "__main__":
    unittest.main()
