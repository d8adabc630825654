# SPDX-License-Identifier: Apache-2.0
"""`vug measure --score` compares networks with real caves."""
import json
import unittest
import xml.etree.ElementTree

from vug import VugTest

SCENE = """network plan = graph(
  names: ["mouth", "fork", "hall", "sump", "loft"],
  at: [(0, 0, 0), (8, -1, 2), (15, -2, 0), (14, -4, 9), (20, 1, 4)],
  paths: ["mouth fork hall", "fork sump", "hall loft"])
network sized = with_sections(of: plan, like: peak)
"""
SVG = "{http://www.w3.org/2000/svg}"


class Score(VugTest):
    def setUp(self):
        super().setUp()
        (self.folder / "cave.vug").write_text(SCENE)
        (self.folder / "cave.svx").write_text("1 2 10 0 0\n2 3 10 20 0\n3 4 12 40 -5\n2 5 6 90 0\n")

    def measure(self, *args):
        return json.loads(self.expect(0, "measure", *args, "--score", "--json").out)

    def test_networks_of_scenes(self):
        report = self.measure("cave.vug")
        self.assertEqual((report["name"], report["legs"], report["cross_sections"]), ("plan", 4, 0))
        self.assertEqual(len(report["network"]), 10)
        self.assertEqual(report["sections"], [])
        report = self.measure("cave.vug", "--network", "sized")
        self.assertEqual((report["name"], report["cross_sections"]), ("sized", 5))
        self.assertEqual(len(report["sections"]), 10)
        self.assertTrue(0 <= report["overall"] <= 100)

    def test_files(self):
        report = self.measure("cave.svx")
        self.assertEqual((report["name"], report["stations"], report["edges"]), ("cave.svx", 5, 3))
        self.assertAlmostEqual(report["length"], 38, places=2)
        (self.folder / "a_nodes.dat").write_text("0 0 0\n10 0 0\n20 5 0\n")
        (self.folder / "a_links.dat").write_text("1 2\n2 3\n")
        self.assertEqual(self.measure("a_nodes.dat")["legs"], 2)
        self.assertEqual(self.measure("a_links.dat")["legs"], 2)

    def test_equated_stations_are_one(self):
        (self.folder / "equated.svx").write_text("1 2 10 0 0\n2 3 10 120 0\n4 1 10 240 0\n*equate 3 4\n")
        report = self.measure("equated.svx")
        self.assertEqual((report["stations"], report["edges"]), (3, 3))

    def test_table_and_advice(self):
        text = self.expect(0, "measure", "cave.svx", "--score").out
        self.assertIn("realism", text)
        self.assertRegex(text, r"\ntortuosity +1\.0\d +0 % +1\.27 +1\.18 to 1\.4")
        self.assertIn("\nThe network has fewer than 10 branches", text)
        self.assertNotIn("too straight", text)
        # A straight passage with twelve straight branches.
        legs = "".join(f"{i} {i + 1} 20 90 0\n{i} b{i} {15 + i} {10 * i} 0\n" for i in range(12))
        (self.folder / "comb.svx").write_text(legs)
        self.assertRegex(self.expect(0, "measure", "comb.svx", "--score").out,
                         r"\nthe legs are too straight: tortuosity 1\.0\d; real caves have 1\.18 to 1\.4")

    def test_plot(self):
        self.expect(0, "measure", "cave.vug", "--score", "--network", "sized", "--plot", "out/score.svg")
        root = xml.etree.ElementTree.parse(self.folder / "out/score.svg").getroot()
        medians = [each for each in root.iter(SVG + "rect") if each.get("class") == "median"]
        self.assertEqual(len(medians), 21)  # Ten of the network, ten of passages and the legend.
        self.assertIn("SVG", self.expect(2, "measure", "cave.vug", "--score", "--plot", "score.png").err)

    def test_errors(self):
        error = self.expect(2, "measure", "cave.vug", "--score", "--network", "plam").err
        self.assertIn("the scene has no network 'plam'", error)
        self.assertIn("plan", error)
        (self.folder / "empty.vug").write_text("volume rock = level_set(sphere(1m), voxel: 10cm)\n")
        self.assertIn("the scene has no network", self.expect(2, "measure", "empty.vug", "--score").err)
        (self.folder / "lone.svx").write_text("*fix 1 0 0 0\n*entrance 1\n")
        self.assertIn("no legs underground", self.expect(2, "measure", "lone.svx", "--score").err)
        self.assertIn("add --score", self.expect(2, "measure", "cave.svx").err)
        self.assertIn("--network requires a scene",
                      self.expect(2, "measure", "cave.svx", "--score", "--network", "plan").err)
        self.assertIn("--variant requires a scene",
                      self.expect(2, "measure", "cave.svx", "--score", "--variant", "wet").err)
        self.expect(2, "measure", "missing.svx", "--score")
        self.expect(2, "measure", "cave.vug", "--network", "plan")
        self.expect(2, "measure", "cave.vug", "--score", "--mesh", "wall")
        self.expect(2, "measure", "cave.svx", "--score", "--plot", "missing/../cave.svx")


if __name__ == "__main__":
    unittest.main()
