# SPDX-License-Identifier: Apache-2.0
"""Each archetype of data/caves gives a sound cave with each seed: no warning, a closed mesh in one piece, and a way for a
person through all of it. VUG_ARCHETYPE_SEEDS sets the number of seeds; without it there is one, whose mesh is not measured.
VUG_ARCHETYPES sets the names of the archetypes (all)."""
import json
import os
import unittest

from vug import SOURCE, VugTest

SEEDS = range(1, 1 + int(os.environ.get("VUG_ARCHETYPE_SEEDS", "1")))
COARSE = "detail=40cm"
# The last station within the rock, where the plan continues outside.
ENDS = {"glacier_cave": "portal", "sea_cave": "gate"}


def archetypes():
    chosen = os.environ.get("VUG_ARCHETYPES", "").split()
    files = sorted((SOURCE / "data/caves").glob("*.vug"))
    return [file.stem for file in files
            if "\ncamera " in file.read_text() and (not chosen or file.stem in chosen)]


class Archetypes(VugTest):
    def test_each_seed_gives_a_cave_that_a_person_can_walk_through(self):
        faults = []
        for name in archetypes():
            self.write(f"{name}.vug", f'include "caves/{name}.vug"\nrender main {{}}\n')
            for seed in SEEDS:
                faults += [f"{name}, seed {seed}: {fault}" for fault in self.faults(name, seed)]
        self.assertEqual(faults, [])

    def faults(self, name, seed):
        scene = (f"{name}.vug", "--seed", str(seed), "-D", COARSE)
        found = []
        check = self.vug("check", *scene, "--strict")
        if check.code:
            found.append(check.err.strip())
        if "VUG_ARCHETYPE_SEEDS" in os.environ:
            found += self.faults_of_mesh(scene)
        end = ("--to", ENDS[name]) if name in ENDS else ()
        way = json.loads(self.vug("measure", *scene, "--clearance", "--json", *end).out or "{}")
        if not way.get("passes"):
            found.append(f"no person passes from {way.get('from')} to {way.get('to')}")
        return found

    def faults_of_mesh(self, scene):
        """A closed cave has two surfaces: that of the air and the outer one of the rock; an open cave has one."""
        report = json.loads(self.vug("measure", *scene, "--json", "--max-invalid", "1").out or "{}")
        return [f"{key} of the mesh: {report.get(key)}"
                for key, good in (("components", (1, 2)), ("boundary_edges", (0,)), ("nonmanifold_edges", (0,)))
                if report.get(key) not in good]


if __name__ == "__main__":
    unittest.main()
