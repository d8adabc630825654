# SPDX-License-Identifier: Apache-2.0
"""The networks of the add-on for Blender without Blender: written and read surveys, compared with those of vug."""
import importlib
import json
import math
import sys
import types
import unittest

from external_tools import HERE, VugTest

# The package without its __init__.py, which needs Blender.
package = types.ModuleType("vug_addon")
package.__path__ = [str(HERE.parents[1] / "plugins/blender/vug_addon")]
sys.modules["vug_addon"] = package
networks, svx_reader, svx_writer = (importlib.import_module(f"vug_addon.{name}")
                                    for name in ("networks", "svx_reader", "svx_writer"))


def ring_with_an_arm():
    """A ring of six stations far from the origin, an arm, and a separate leg."""
    out = networks.Network(title='A "ring"')
    for i in range(6):
        angle = i * math.pi / 3
        place = (450000 + 10 * math.cos(angle), 5050000 + 10 * math.sin(angle), 612.3456789 - i)
        out.stations.append(networks.Station(f"ring.{i}", place, (1.5, 2, 1, 0.5) if i % 2 else None, i == 0))
    out.stations.append(networks.Station("arm", (450020, 5050000, 600), (1, 1, 1, 1)))
    out.stations += [networks.Station("far.a", (450100, 5050000, 650)), networks.Station("far.b", (450109, 5050001, 650))]
    out.legs = [(i, (i + 1) % 6) for i in range(6)] + [(0, 6), (7, 8)]
    return out


class Networks(VugTest):
    def near(self, a, b, most):
        self.assertLess(max(abs(x - y) for x, y in zip(a, b)), most, f"{a} in place of {b}")

    def stations_of(self, file):
        """The places of the stations as vug computes them."""
        stations = json.loads(self.expect(0, "survey", file, "--stations", "--json").out)
        return {each["name"]: (each["east"], each["north"], each["up"]) for each in stations}

    def test_a_network_survives_a_survey(self):
        network = ring_with_an_arm()
        self.write("ring.svx", svx_writer.svx_text(network))
        again = svx_reader.parse((self.folder / "ring.svx").read_text())
        self.assertEqual(again.title, "A ring")
        named = {station.name: station for station in again.stations}
        self.assertEqual(sorted(named), sorted(station.name for station in network.stations))
        for station in network.stations:
            self.near(named[station.name].position, station.position, 1e-6)
            self.assertEqual((named[station.name].walls, named[station.name].entrance), (station.walls, station.entrance))

        def legs(of):
            return sorted(tuple(sorted(of.stations[end].name for end in leg)) for leg in of.legs)
        self.assertEqual(legs(again), legs(network))
        ours = self.stations_of("ring.svx")
        for station in network.stations:
            self.near(ours[station.name], station.position, 0.006)  # rounded to cm
        report = json.loads(self.expect(0, "survey", "ring.svx", "--json").out)
        self.assertEqual((report["legs"], report["loops"], report["cross_sections"]), (8, 1, 4))

    def test_it_reads_what_vug_writes(self):
        text = HERE.parents[1] / "data/scenes/teaching/creek.svx"
        self.expect(0, "survey", text, "-o", "creek.svx")
        network = svx_reader.parse((self.folder / "creek.svx").read_text())
        wanted = self.stations_of("creek.svx")
        report = json.loads(self.expect(0, "survey", "creek.svx", "--json").out)
        length = sum(math.dist(network.stations[a].position, network.stations[b].position) for a, b in network.legs)
        self.assertAlmostEqual(length, report["length"]["adjusted"], delta=0.05)
        for station in network.stations:
            self.near(station.position, wanted[station.name], 0.01)
        self.assertTrue(any(station.entrance for station in network.stations))
        measured = [station for station in network.stations if station.walls]
        self.assertGreater(len(measured), 10)
        self.write("again.svx", svx_writer.svx_text(network))
        again = json.loads(self.expect(0, "survey", "again.svx", "--json").out)
        self.assertAlmostEqual(again["length"]["adjusted"], report["length"]["adjusted"], delta=0.05)
        self.assertEqual(again["loops"], report["loops"])

    def test_splays_and_surface_legs_are_not_passages(self):
        network = svx_reader.parse("*begin a\n1 2 10 90 UP\n2 .. 3 0 0\n*flags surface\n2 3 5 180 0\n*flags not surface\n"
                                   "3 4 2 - -V ; a shaft\n*end a\n*equate a.4 b\n*data nosurvey from to\na.1 b\n")
        self.assertEqual([(network.stations[a].name, network.stations[b].name) for a, b in network.legs],
                         [("a.1", "a.2"), ("a.3", "a.4"), ("a.1", "a.4")])
        places = {station.name: station.position for station in network.stations}
        self.near(places["a.2"], (0, 0, 10), 1e-9)
        self.near(places["a.4"], (0, -5, 8), 1e-9)

    def test_chains_lead_from_junction_to_junction(self):
        network = ring_with_an_arm()
        lengths = sorted(len(chain) for chain in networks.chains(network))
        self.assertEqual(lengths, [2, 2, 7])
        network.legs = network.legs[:6]  # the ring alone
        self.assertEqual([(len(chain), chain[0] == chain[-1]) for chain in networks.chains(network)], [(7, True)])
        network.legs = []
        self.assertEqual(networks.chains(network), [])

    def test_names(self):
        used = set()
        names = [networks.unique_name(text, used) for text in ("Curve.001.1", "Curve.001.1", "Große Höhle", "..", "a b")]
        self.assertEqual(names, ["Curve.001.1", "Curve.001.1_2", "Gro_e_H_hle", "s", "a_b"])

    def test_faults_state_the_line(self):
        for text, fault in (("1 2 3\n", "a.svx:1: 5 values are expected"), ("\n*include x\n", "a.svx:2: *include is not"),
                            ("*data diving from to\n", "a.svx:1: *data diving"), ("1 2 x 0 0\n", "a.svx:1: could not"),
                            ("1 2 nan 0 0\n", "a.svx:1: 'nan' is not"), ("*end\n", "a.svx:1: *end without"),
                            ("*fix\n", "a.svx:1: values are missing"), ("", "a.svx: the survey has no legs"),
                            ("!a b 1 0 0\n", "a.svx:1: '!a' is not a name"), ("*\n", "a.svx:1: * is not")):
            with self.assertRaises(ValueError) as caught:
                svx_reader.parse(text, "a.svx")
            self.assertTrue(str(caught.exception).startswith(fault), f"{caught.exception} for {text!r}")
        with self.assertRaisesRegex(ValueError, "no legs"):
            svx_writer.svx_text(networks.Network())
        lost = networks.Network([networks.Station("a", (0, 0, math.nan)), networks.Station("b", (0, 0, 0))], [(0, 1)])
        with self.assertRaisesRegex(ValueError, "'a' is not within"):
            svx_writer.svx_text(lost)


if __name__ == "__main__":
    unittest.main()
