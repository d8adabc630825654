# SPDX-License-Identifier: Apache-2.0
"""`vug survey` reports, draws and converts cave surveys."""
import json
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


class Survey(VugTest):
    def setUp(self):
        super().setUp()
        (self.folder / "cave.svx").write_text(SURVEY)

    def test_report(self):
        report = json.loads(self.expect(0, "survey", "cave.svx", "--json").out)
        self.assertEqual(report["title"], "Two loops")
        self.assertEqual((report["stations"], report["legs"], report["loops"], report["splays"]), (6, 6, 1, 1))
        self.assertEqual(report["cross_sections"], 2)
        self.assertAlmostEqual(report["length"]["measured"], 58.5)
        self.assertEqual(report["altitude"]["low_station"], "cave.5")
        self.assertEqual(report["misclosures"][0]["from"], "cave.1")
        text = self.expect(0, "survey", "cave.svx").out
        self.assertIn("stations: 6\nlegs: 6\n", text)

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
        self.assertIn("formats that can be written", self.expect(2, "survey", "cave.svx", "-o", "x.th").err)

    def test_errors_name_the_line(self):
        (self.folder / "bad.svx").write_text("*begin a\n1 2 3 x 5\n*end a\n")
        error = self.expect(2, "survey", "bad.svx").err
        self.assertIn("bad.svx:2:7: error: expected a number, found 'x'\n", error)
        (self.folder / "loose.svx").write_text("*fix 1 0 0 0\n1 2 3 4 5\n7 8 3 4 5\n")
        self.assertIn("loose.svx:3:1: warning: the station '7'", self.expect(0, "survey", "loose.svx").err)
        self.assertIn("SVG", self.expect(2, "survey", "cave.svx", "--plan", "plan.png").err)
        self.expect(2, "survey", "cave.svx", "-o", "cave.svx")
        self.expect(2, "survey", "missing.svx")

    def test_files_outside_of_the_folder(self):
        (self.folder / "below").mkdir()
        (self.folder / "below/all.svx").write_text("*include ../cave\n")
        self.assertIn("outside of the survey's folder", self.expect(2, "survey", "below/all.svx").err)
        self.expect(0, "survey", "below/all.svx", "--allow-outside")


if __name__ == "__main__":
    unittest.main()
