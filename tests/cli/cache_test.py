# SPDX-License-Identifier: Apache-2.0
"""The store of products: the same bytes with and without it, and the verb `vug cache`."""
import contextlib
import functools
import http.server
import json
import os
import pathlib
import threading
import unittest

from vug import VugTest

# With one thread, this takes long enough to be stored.
SCENE = """
param lamp = 3
let rough = displace(union([sphere(1m), sphere(60cm).translate((0.5, 0.8, 0))], blend: smooth(20cm)),
  noise: fbm(scale: 40cm, octaves: 16), amount: 10cm)
volume rock = level_set(rough, voxel: 2cm)
mesh skin on rock {}
object thing on skin { material lambert(albedo: (0.5, 0.4, 0.3)) }
light key = sphere(center: (lamp, 3, 3), radius: 30cm, radiance: (50, 50, 50))
camera main { eye (0, 1, 5)  target (0, 0, 0) }
render main { size 32x24  spp 1 }
"""


class FileHandler(http.server.SimpleHTTPRequestHandler):
    """Keeps the bodies of PUT requests as files of the folder that it serves."""

    def do_PUT(self):
        path = pathlib.Path(self.translate_path(self.path))
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(201)
        self.end_headers()

    def log_message(self, *_):
        pass


class Cache(VugTest):
    def setUp(self):
        super().setUp()
        self.write("scene.vug", SCENE)
        self.store = self.folder / "store"

    def run_vug(self, code, *arguments, store=None):
        if arguments[0] in ("build", "render"):
            arguments += ("--threads", 1)
        return self.expect(code, *arguments, env={**os.environ, "VUG_CACHE": store or str(self.store)})

    @contextlib.contextmanager
    def server(self):
        """The address of a server with an empty folder."""
        folder = self.folder / "server"
        folder.mkdir()
        handler = functools.partial(FileHandler, directory=folder)
        with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
            threading.Thread(target=server.serve_forever).start()
            yield f"http://127.0.0.1:{server.server_port}"
            server.shutdown()

    def products(self, folder):
        return {path.name: path.read_bytes() for path in (self.folder / folder).iterdir()}

    def test_reused_products_have_the_same_bytes(self):
        self.run_vug(0, "build", "scene.vug", "-o", "plain", "--no-cache")
        self.assertFalse(self.store.exists(), "--no-cache leaves no trace")
        first = self.run_vug(0, "build", "scene.vug", "-o", "first", "--explain").err
        self.assertRegex(first, r"level_set 'rock': built in [\d.]+ s; it was not built before")
        second = self.run_vug(0, "build", "scene.vug", "-o", "second", "--explain").err
        self.assertRegex(second, r"level_set 'rock': reused, saves [\d.]+ s")
        self.assertIn("mesh 'skin': reused", second)
        self.assertEqual(self.products("first"), self.products("plain"))
        self.assertEqual(self.products("second"), self.products("plain"))

    def test_machines_share_a_server(self):
        self.run_vug(0, "build", "scene.vug", "-o", "plain", "--no-cache")
        with self.server() as address:
            for machine in ("first", "second"):
                environment = {**os.environ, "VUG_CACHE": str(self.folder / f"store_{machine}"),
                               "VUG_CACHE_REMOTE": address}
                said = self.expect(0, "build", "scene.vug", "-o", machine, "--explain", "--threads", 1,
                                   env=environment).err
                self.assertRegex(said, "level_set 'rock': " + ("reused" if machine == "second" else "built"))
                self.assertEqual(self.products(machine), self.products("plain"))

    def test_addresses_of_servers_are_checked(self):
        environment = {**os.environ, "VUG_CACHE": str(self.store), "VUG_CACHE_REMOTE": "builds:8080"}
        said = self.expect(2, "build", "scene.vug", "-o", "plain", env=environment).err
        self.assertIn("'builds:8080' is not the address of a store", said)

    def test_pictures_have_the_same_bytes(self):
        pictures = []
        for options in (["--no-cache"], [], []):
            self.run_vug(0, "render", "scene.vug", "-o", "a.exr", *options)
            pictures.append((self.folder / "a.exr").read_bytes())
        self.assertEqual(pictures[1], pictures[0])
        self.assertEqual(pictures[2], pictures[0])

    def test_a_change_of_a_lamp_builds_nothing(self):
        self.run_vug(0, "render", "scene.vug", "-o", "a.exr")
        why = self.run_vug(0, "cache", "why", "scene.vug", "-D", "lamp=2").out
        self.assertIn("level_set 'rock': reused", why)
        self.assertIn("mesh 'skin': reused", why)
        self.write("scene.vug", SCENE.replace("amount: 10cm", "amount: 9cm"))
        why = self.run_vug(0, "cache", "why", "scene.vug").out
        self.assertIn("level_set 'rock': not in the store; changed: field", why)

    def statistics(self):
        return json.loads(self.run_vug(0, "cache", "stats", "--json").out)

    def test_statistics_trim_and_verify(self):
        self.run_vug(0, "build", "scene.vug", "-o", "out")
        kinds = self.statistics()["kinds"]
        self.assertEqual((kinds["level_set"]["products"], kinds["mesh"]["products"]), (1, 1))
        self.assertGreater(kinds["level_set"]["seconds_to_make"], 0.2)
        self.run_vug(0, "cache", "verify")
        damaged = next(self.store.glob("objects/*/*.mesh"))
        damaged.write_bytes(damaged.read_bytes()[:-1])
        self.assertIn("removed_damaged_files: 1", self.run_vug(1, "cache", "verify").out)
        self.run_vug(0, "cache", "trim", "--size", "1K")
        left = self.statistics()
        self.assertEqual((left["files"], left["kinds"]), (0, {}))

    def test_a_store_that_is_off(self):
        self.run_vug(0, "build", "scene.vug", "-o", "out", store="off")
        self.assertFalse(self.store.exists())
        self.assertIn("set VUG_CACHE to a folder", self.run_vug(2, "cache", "stats", store="off").err)


if __name__ == "__main__":
    unittest.main()
