# SPDX-License-Identifier: Apache-2.0
"""`vug survey` reports, draws and converts cave surveys."""
import json
import struct
import unittest
import xml.etree.ElementTree

from vug import VugTest

SURVEY = """*title "Two loops"
*begin cave
*entrance 1
*fix 1 100 200 300
1 2 12 80 5
2 3 15 10 -10
3 4 11 275 2
4 1 16.5 187 4
3 5 4 90 -30
3 .. 2 100 10
*data passage station left right up down
1 1 2 3 4
2 1 - 3 4
*end cave
"""


SCENE = """network plan = graph(
  names: ["mouth", "fork", "hall", "sump"],
  at: [(0, 0, 0), (9, -1, 2), (18, -2, 0), (14, -4, 11)],
  paths: ["mouth fork hall", "fork sump"],
  widths: [3m, 4m, 5m, 2m],
  heights: [2m, 3m, 4m, 2m])
volume cave = level_set(box(size: (60, 30, 60)) - passages(of: plan), voxel: 50cm)
volume mist = fog(sphere(5m), voxel: 50cm)
"""


def scraps_of(data):
    """Points and triangles of the scraps in a .lox file: chunks of records and data."""
    scraps, at = [], 0
    while at < len(data):
        kind, size, count, extra = struct.unpack_from("<4I", data, at)
        start = at + 16 + size
        for i in range(count if kind == 4 else 0):
            _, _, points, first, _, triangles, second, _ = struct.unpack_from("<8I", data, at + 16 + 32 * i)
            scraps.append(([struct.unpack_from("<3d", data, start + first + 24 * k) for k in range(points)],
                           [struct.unpack_from("<3I", data, start + second + 12 * k) for k in range(triangles)]))
        at = start + extra
    return scraps


class Survey(VugTest):
    def setUp(self):
        super().setUp()
        (self.folder / "cave.svx").write_text(SURVEY)

    def test_report(self):
        report = json.loads(self.expect(0, "survey", "cave.svx", "--json").out)
        self.assertEqual(report["title"], "Two loops")
        self.assertEqual((report["stations"], report["legs"], report["loops"], report["splays"]), (6, 6, 1, 1))
        self.assertEqual(report["as_survex_counts"], {"components": 1, "loops": 1})
        self.assertEqual(report["cross_sections"], 2)
        self.assertAlmostEqual(report["length"]["measured"], 58.5)
        self.assertEqual(report["altitude"]["low_station"], "cave.5")
        self.assertEqual(report["misclosures"][0]["from"], "cave.1")
        text = self.expect(0, "survey", "cave.svx").out
        self.assertIn("stations: 6\nlegs: 6\n", text)

    def test_stations(self):
        lines = self.expect(0, "survey", "cave.svx", "--stations").out.splitlines()
        self.assertEqual(lines[0].split(), ["east", "north", "up", "name"])
        self.assertEqual(lines[1].split(), ["100.00", "200.00", "300.00", "cave.1", "entrance", "fixed"])
        self.assertEqual(len(lines), 6)  # the end of the splay has no name
        listed = json.loads(self.expect(0, "survey", "cave.svx", "--stations", "--json").out)
        self.assertEqual([each["name"] for each in listed], [f"cave.{i}" for i in (1, 2, 3, 4, 5)])
        self.assertEqual(listed[0], {"name": "cave.1", "east": 100, "north": 200, "up": 300, "flags": ["entrance", "fixed"]})

    def test_stations_of_a_scene(self):
        (self.folder / "two.vug").write_text(SCENE + 'network real = survey(file: "cave.svx", origin: (90, 200, 280))\n')
        lines = self.expect(0, "survey", "two.vug", "--stations").out.splitlines()
        self.assertEqual(lines[0].split(), ["x", "y", "z", "name"])
        self.assertEqual(lines[2].split(), ["9.00", "-1.00", "2.00", "fork"])
        self.assertEqual(len(lines), 5)
        listed = json.loads(self.expect(0, "survey", "two.vug", "--stations", "--network", "real", "--json").out)
        self.assertEqual(listed[0], {"name": "cave.1", "equated": [], "position": [10, 20, 0], "flags": ["entrance"]})
        self.assertIn("'none'", self.expect(2, "survey", "two.vug", "--stations", "--network", "none").err)

    def test_the_network_of_a_scene_is_a_survey(self):
        (self.folder / "two.vug").write_text("param far = 18m\n" + SCENE.replace("(18,", "(far,") +
                                             'network real = survey(file: "cave.svx")\n')
        self.expect(0, "survey", "two.vug", "-D", "far=28m", "--plan", "plan.svg", "--elevation", "side.svg", "-o", "a.svx")
        for name in ("plan", "side"):
            root = xml.etree.ElementTree.parse(self.folder / f"{name}.svg").getroot()
            self.assertGreaterEqual(len(root.findall("{http://www.w3.org/2000/svg}line")), 3)
        self.expect(0, "survey", "two.vug", "--network", "plan", "-o", "b.3d")
        for file, length in (("a.svx", 39.12), ("b.3d", 29.27)):
            report = json.loads(self.expect(0, "survey", file, "--json").out)
            self.assertEqual((report["title"], report["stations"], report["legs"]), ("plan of two", 4, 3))
            self.assertGreaterEqual(report["cross_sections"], 4)
            self.assertAlmostEqual(report["length"]["measured"], length, delta=0.05)
        real = json.loads(self.expect(0, "survey", "two.vug", "--network", "real", "--json").out)
        self.assertEqual((real["title"], real["legs"], real["loops"]), ("real of two", 6, 1))
        self.assertIn("--network requires a scene", self.expect(2, "survey", "cave.svx", "--network", "plan").err)
        self.assertIn("-D requires a scene", self.expect(2, "survey", "cave.svx", "-D", "a=1").err)

    def test_drawings(self):
        self.expect(0, "survey", "cave.svx", "--plan", "out/plan.svg", "--elevation", "out/side.svg")
        for name, lines in (("plan", 6 + 2 + 1), ("side", 5 + 1)):
            root = xml.etree.ElementTree.parse(self.folder / f"out/{name}.svg").getroot()
            found = root.findall("{http://www.w3.org/2000/svg}line")
            self.assertEqual(len(found), lines)

    def test_conversion(self):
        self.expect(0, "survey", "cave.svx", "-o", "cave.3d")
        again = json.loads(self.expect(0, "survey", "cave.3d", "--json").out)
        self.assertEqual((again["title"], again["stations"], again["loops"]), ("Two loops", 6, 1))
        self.expect(0, "survey", "cave.3d", "-o", "again.svx")
        report = json.loads(self.expect(0, "survey", "again.svx", "--json").out)
        self.assertEqual((report["title"], report["stations"], report["loops"]), ("Two loops", 6, 1))
        self.assertEqual((report["splays"], report["cross_sections"]), (1, 2))
        self.assertEqual(report["altitude"]["low_station"], "cave.5")
        for name in ("x.th", "x.xyz"):
            error = self.expect(2, "survey", "cave.svx", "-o", name).err
            self.assertIn("files that can be written: .lox, .3d, .svx", error)

    def test_a_failing_conversion_writes_nothing(self):
        (self.folder / "far.svx").write_text("*fix 1 30000000 0 0\n1 2 3 4 5\n")
        error = self.expect(2, "survey", "far.svx", "-o", "far.3d", "--plan", "far.svg").err
        self.assertIn("far.svx:1:6: error: the value 30000000 of the station '1'", error)
        self.assertFalse((self.folder / "far.svg").exists() or (self.folder / "far.3d").exists())

    def test_the_origin_can_be_copied(self):
        (self.folder / "cave.svx").write_text(SURVEY.replace("*fix 1 100 200 300", "*fix 1 398378 5674300 300"))
        report = json.loads(self.expect(0, "survey", "cave.svx", "--json").out)
        origin = report["origin"]
        self.assertIn(f"origin: ({origin[0]}, {origin[1]}, {origin[2]})\n", self.expect(0, "survey", "cave.svx").out)
        scene = self.folder / "far.vug"
        scene.write_text('network cave = survey(file: "cave.svx", recenter: false)\n')
        error = self.expect(2, "check", "far.vug").err
        self.assertIn("far.vug:1:16: error: the station 'cave.1' is 5688 km from the origin", error)
        self.assertIn("'origin: ({}, {}, {})'".format(*origin), error)
        scene.write_text('network cave = survey(file: "cave.svx", origin: ({}, {}, {}))\n'.format(*origin) +
                         'volume walls = level_set(passages(of: cave), voxel: 50cm)\n')
        self.expect(0, "check", "far.vug")

    def test_warnings_of_a_survey_reach_the_scene(self):
        (self.folder / "loose.svx").write_text("*fix 1 0 0 0\n1 2 3 4 5\n7 8 3 4 5\n")
        (self.folder / "loose.vug").write_text('network cave = survey(file: "loose.svx")\n'
                                               'volume walls = level_set(passages(of: cave), voxel: 50cm)\n')
        self.assertIn("loose.svx:3:1: warning: the station '7'", self.expect(0, "check", "loose.vug").err)

    def test_errors_name_the_line(self):
        (self.folder / "bad.svx").write_text("*begin a\n1 2 3 x 5\n*end a\n")
        error = self.expect(2, "survey", "bad.svx").err
        self.assertIn("bad.svx:2:7: error: expected a number, found 'x'\n", error)
        (self.folder / "loose.svx").write_text("*fix 1 0 0 0\n1 2 3 4 5\n7 8 3 4 5\n")
        self.assertIn("loose.svx:3:1: warning: the station '7'", self.expect(0, "survey", "loose.svx").err)
        self.assertIn("SVG", self.expect(2, "survey", "cave.svx", "--plan", "plan.png").err)
        self.expect(2, "survey", "cave.svx", "-o", "cave.svx")
        self.expect(2, "survey", "missing.svx")
        self.assertIn("is a folder, not the file of a survey", self.expect(2, "survey", ".").err)
        self.assertIn("'cave.svx' is a survey, not a scene\n", self.expect(2, "check", "cave.svx").err)
        self.assertIn("'cave.svx' is a survey, not a scene\n", self.expect(2, "render", "cave.svx", "-o", "a.exr").err)
        (self.folder / "empty.svx").write_text("*begin a\n*end a\n")
        (self.folder / "empty.th").write_text("survey a\nendsurvey\n")
        (self.folder / "empty.srv").write_text("\n")
        for name, leg in (("svx", "tape, compass, clino"), ("th", "in a centreline"), ("srv", "azimuth, inclination")):
            error = self.expect(2, "survey", f"empty.{name}").err
            self.assertIn(f"empty.{name}:1:1: error: the survey has no stations\n", error)
            self.assertIn(leg, error)

    def test_a_scene_names_the_line_of_its_survey(self):
        (self.folder / "bad.svx").write_text("*begin a\n1 2 3 x 5\n*end a\n")
        (self.folder / "bad.vug").write_text('network cave = survey(file: "bad.svx")\n')
        self.assertIn("bad.vug:1:16: error: bad.svx:2:7: expected a number, found 'x'\n",
                      self.expect(2, "check", "bad.vug").err)

    def test_files_outside_of_the_folder(self):
        (self.folder / "below").mkdir()
        (self.folder / "below/all.svx").write_text("*include ../cave\n")
        self.assertIn("outside of the survey's folder", self.expect(2, "survey", "below/all.svx").err)
        self.expect(0, "survey", "below/all.svx", "--allow-outside")

    def test_a_survey_of_a_volume_elsewhere_is_refused(self):
        (self.folder / "far.vug").write_text(
            'network plan = graph(names: ["a", "b"], at: [(900, 0, 0), (910, 0, 0)], paths: ["a b"])\n'
            'volume ball = level_set(sphere(3m), voxel: 20cm)\n')
        error = self.expect(2, "survey", "--shoot", "far.vug").err
        self.assertIn("no wall of 'ball' is within 100 m of 3 of the 3 stations of 'plan'", error)
        self.assertIn("--volume", error)

    def shoot(self, *args):
        return json.loads(self.expect(0, "survey", "--shoot", "plan.vug", *args, "--json").out)

    def test_surveys_of_scenes(self):
        (self.folder / "plan.vug").write_text(SCENE)
        report = self.shoot("--along", "plan", "--longest-leg", "4m", "--splays", "12", "-o", "plan.3d")
        self.assertEqual(report["title"], "plan of plan")
        self.assertEqual(report["cross_sections"], report["stations"] - report["splays"])
        self.assertEqual(report["splays"], 12 * report["cross_sections"])
        self.assertAlmostEqual(report["length"]["measured"], report["length"]["adjusted"], places=2)
        again = json.loads(self.expect(0, "survey", "plan.3d", "--json").out)
        for key in ("title", "stations", "splays", "cross_sections", "loops"):
            self.assertEqual(again[key], report[key])
        first = (self.folder / "plan.3d").read_bytes()
        self.shoot("--longest-leg", "4m", "--splays", "12", "-o", "again.3d")
        self.assertEqual((self.folder / "again.3d").read_bytes(), first)
        self.shoot("--longest-leg", "4m", "--splays", "12", "--seed", "5", "-o", "other.3d")
        self.assertNotEqual((self.folder / "other.3d").read_bytes(), first)

    def test_walls_in_lox_files(self):
        """The walls of the passages without the faces of the block of rock around them."""
        (self.folder / "plan.vug").write_text(SCENE)
        self.shoot("--splays", "6", "-o", "plan.lox")
        scraps = scraps_of((self.folder / "plan.lox").read_bytes())
        self.assertEqual(len(scraps), 1)
        points, triangles = scraps[0]
        for axis, (low, high) in enumerate(((-3, 22), (-16, 5), (-8, 4))):
            self.assertTrue(all(low < point[axis] < high for point in points))
        edges = {}
        for a, b, c in triangles:
            for edge in ((a, b), (b, c), (c, a)):
                edges[edge] = edges.get(edge, 0) + 1
        self.assertTrue(all(uses == 1 and (b, a) in edges for (a, b), uses in edges.items()))
        self.expect(0, "survey", "plan.lox", "-o", "again.lox")
        self.assertEqual(scraps_of((self.folder / "again.lox").read_bytes()), scraps)

    def test_errors_of_surveys_of_scenes(self):
        (self.folder / "plan.vug").write_text(SCENE)
        shoot = ("survey", "--shoot", "plan.vug")
        self.assertIn("the scene has no network 'x'", self.expect(2, *shoot, "--along", "x").err)
        self.assertIn("the scene has no volume 'x'", self.expect(2, *shoot, "--volume", "x").err)
        self.assertIn("'mist' is a fog", self.expect(2, *shoot, "--volume", "mist").err)
        self.assertIn("--shoot requires a scene", self.expect(2, "survey", "--shoot", "cave.svx").err)
        self.assertIn("the survey is missing", self.expect(2, "survey").err)
        self.expect(2, "survey", "cave.svx", "--shoot", "plan.vug")
        self.expect(2, "survey", "cave.svx", "--along", "plan")
        self.expect(2, *shoot, "--splays", "-1")
        self.expect(2, *shoot, "-o", "plan.vug")


if __name__ == "__main__":
    unittest.main()
