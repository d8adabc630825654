# SPDX-License-Identifier: Apache-2.0
"""`vug drips` prints, saves and edits the drips of a scene."""
import json
import unittest

from vug import VugTest

SCENE = """let room = complement(box(size: (6, 3, 6)))
drips water = seepage(room, from: (-3, -2, -3), to: (3, 2, 3), spacing: 40cm, EDITS
  joints: [fractures(azimuth: 35deg, spacing: 1.5m)])
"""


class Drips(VugTest):
    def drips(self, *args, edits="", code=0):
        (self.folder / "cave.vug").write_text(SCENE.replace("EDITS", edits))
        result = self.expect(code, "drips", "cave.vug", *args)
        return result.err if code else result.out

    def graph(self, *args, edits=""):
        return json.loads(self.drips("--json", *args, edits=edits))

    def test_text_explains_forms(self):
        text = self.drips(edits="edits: [add_drip(at: (0, 0, 0), interval: 55, age: 9000)],")
        first, *forms = text.splitlines()
        self.assertRegex(first, r"\d+ seeps, \d+ drops, \d+ landings, \d+ pools; \d+ speleothems")
        self.assertTrue(any(": drip -1" in form and ", 55 s a drop, 9,000 years" in form for form in forms))
        self.assertTrue(any(" on joint " in form for form in forms))

    def test_json_is_the_graph(self):
        graph = self.graph("--threads", "1")
        self.assertEqual(graph, self.graph("--threads", "7"))
        nodes = graph["nodes"]
        sources = {node["drip"] for node in nodes if node["kind"] in ("seep", "drop")}
        self.assertTrue({"stalactite", "flowstone"} <= {form["kind"] for form in graph["forms"]})
        self.assertTrue(all(form["drip"] in sources for form in graph["forms"]))
        for edge in graph["edges"]:
            for end, point in (("from", edge["path"][0]), ("to", edge["path"][-1])):
                for a, b in zip(nodes[edge[end]]["position"], point):
                    self.assertAlmostEqual(a, b, delta=0.06)

    def test_edits(self):
        drip = self.graph()["forms"][0]["drip"]
        after = self.graph(edits=f"edits: [remove_drip(drip: {drip})],")
        self.assertNotIn(drip, {node["drip"] for node in after["nodes"] if node["kind"] != "pool"})
        few = self.graph(edits="budget: 3,")
        self.assertEqual(sum(node["kind"] == "seep" for node in few["nodes"]), 3)

    def test_frames_compares_a_sequence(self):
        edits = "tip: 2cm, age: keys(1: 200, 20: 4000), final_age: 4000, edits: [add_drip(at: (1, 0, 0), age: 3000)],"
        text = self.drips("--frames", "1..20", edits=edits)
        self.assertIn("20 frames, ", text)
        self.assertRegex(text, r"greatest step between two frames: [\d.]+ cm, \w+ of drip -?\d+ at frame \d+")
        self.assertIn("speleothems that disappear: 0", text)
        # A key of the density is not growth: drips disappear, and the answer is no.
        self.drips("--frames", "1..2", edits="density: keys(1: 100%, 2: 10%),", code=1)
        self.assertIn("--json excludes --frames", self.drips("--frames", "1..2", "--json", code=2))

    def test_frames_without_growth(self):
        still = self.drips("--frames", "1..3", edits="tip: 2cm,")
        self.assertRegex(still, r"are the same in all 3 frames, because nothing .* has keys")
        self.assertNotIn("greatest", still)
        back = self.drips("--frames", "1..4", edits="age: keys(1: 5000, 4: 2000), final_age: 5000,", code=2)
        self.assertIn("decreases from 5000 years at frame 1 to 4000 at frame 2", back)
        self.assertIn("in ascending order", back)

    def test_drips_without_effect_are_warnings(self):
        at = "add_drip(at: (0.5, 0, 0.2))"
        for verb in ("drips", "check"):
            (self.folder / "cave.vug").write_text(SCENE.replace("EDITS", f"density: 0, edits: [\n{at},\n{at}],"))
            error = self.expect(0, verb, "cave.vug").err
            self.assertRegex(error, r"cave.vug:[34]:1: warning: the added drip -[12] has no place of its own: its water joins that of drip -[12]")
            self.expect(2, verb, "cave.vug", "--strict")
            (self.folder / "cave.vug").write_text(SCENE.replace("EDITS", f"density: 0, edits: [{at}],"))
            self.assertNotIn("no place of its own", self.expect(0, verb, "cave.vug").err)

    def test_contradictory_ages(self):
        error = self.drips(edits="age: 5000, final_age: 4000,", code=2)
        self.assertIn("the final age must be at least the age", error)

    def test_points(self):
        nodes = self.graph("--points", "drips.vdb")["nodes"]
        grid = json.loads(self.expect(0, "info", "drips.vdb", "--json").out)["grids"][0]
        self.assertEqual((grid["name"], grid["points"]["count"]), ("drips", len(nodes)))
        groups = {group["name"]: group["points"] for group in grid["points"]["groups"]}
        self.assertEqual(groups["drop"], sum(node["kind"] == "drop" for node in nodes))

    def test_too_many_forms_are_refused(self):
        # 2.25 million places, with up to 4 kB each.
        self.drips("--max-memory", "500M", edits="density: 100%,")
        (self.folder / "cave.vug").write_text(SCENE.replace("EDITS", "").replace("spacing: 40cm", "spacing: 4mm, density: 100%"))
        error = self.expect(2, "drips", "cave.vug", "--max-memory", "500M").err
        self.assertRegex(error, r"the graph of the drips would take about [\d.]+ GiB of memory, more than the limit of 500 MiB")
        self.assertIn("raise --max-memory", error)
        (self.folder / "cave.vug").write_text(SCENE.replace("EDITS", "").replace("spacing: 40cm", "spacing: 1mm"))
        error = self.expect(2, "drips", "cave.vug").err
        self.assertRegex(error, r"there would be millions of drips, at [\de.+]+ places, and at most 4e\+06 are possible; use a spacing of")

    def test_faults(self):
        error = self.drips(edits="edits: [remove_drip(drip: 99999)],", code=2)
        self.assertIn("drip 99999 is removed, but the roof has no such drip", error)
        self.assertIn("hint: ", error)
        # A check finds a drip in rock, too, and reports the line of the drips.
        (self.folder / "cave.vug").write_text(SCENE.replace("EDITS", "edits: [add_drip(at: (0, 1.8, 0))],"))
        error = self.expect(2, "check", "cave.vug").err
        self.assertRegex(error, r"cave.vug:\d+:\d+: error: a drip at \(0, 1.8, 0\) is in solid rock")
        self.assertIn("written as .vdb", self.drips("--points", "drips.ply", code=2))
        self.assertIn("the graph of the drips is empty, so it has no points", self.drips("--points", "drips.vdb", edits="density: 0,", code=2))
        self.assertFalse((self.folder / "drips.vdb").exists())
        (self.folder / "stone.vug").write_text("let a = sphere(1m)\n")
        self.assertIn("drips", self.expect(2, "drips", "stone.vug").err)


if __name__ == "__main__":
    unittest.main()
