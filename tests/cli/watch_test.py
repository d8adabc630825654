# SPDX-License-Identifier: Apache-2.0
"""vug watch: a saved change is rendered and builds only what it affects; errors; the page; the end."""
import http.client
import json
import os
import re
import signal
import subprocess
import time
import unittest
import urllib.parse

from vug import PROGRAM, VugTest, digest

SCENE = """volume ball = level_set(sphere(50cm), voxel: 5cm)
mesh ball on ball { }
object ball on ball { }
light lamp = sphere(center: (0, 2, 1), radius: 20cm)
camera main { eye (0, 1, 4) target (0, 0, 0) }
render main { size 64x36 spp 8 }
"""


class Watch(VugTest):
    def setUp(self):
        super().setUp()
        self.write("ball.vug", SCENE)
        self.process = None
        self.said = ""

    def tearDown(self):
        self.kill()
        super().tearDown()

    def kill(self):
        if self.process:
            self.process.kill()
            self.process.wait()
            self.process.stderr.close()

    def start(self, *args):
        self.kill()
        self.said = ""
        self.process = subprocess.Popen([PROGRAM, "watch", "ball.vug", *args], cwd=self.folder,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.PIPE)

    def wait_for(self, pattern):
        """The next text on stderr that the pattern matches; what came before it is forgotten."""
        while True:
            found = re.search(pattern, self.said)
            if found:
                self.said = self.said[found.end():]
                return found
            text = os.read(self.process.stderr.fileno(), 4096).decode()
            self.assertTrue(text, f"the program ended before it printed '{pattern}'")
            self.said += text

    def picture(self):
        """The work for the next complete picture: what was built, and what was kept."""
        return self.wait_for(r"(?<!unfinished )picture after .*: built (.*); kept (.*); rendered (.*)\n")

    def save(self, text):
        """As many editors save: under another name, then by rename."""
        self.write("new.txt", text)
        os.replace(self.folder / "new.txt", self.folder / "ball.vug")

    def test_a_saved_change_is_rendered(self):
        self.start("-o", "a.exr")
        self.assertRegex(self.picture().group(1), "level set.*mesh.*tree")
        self.save(SCENE.replace("radius: 20cm", "radius: 40cm"))
        lamp = self.picture()
        self.assertEqual(lamp.group(1), "nothing")
        self.assertIn("tree", lamp.group(2))
        self.expect(0, "render", "ball.vug", "-o", "b.exr")
        self.assertEqual(digest(self.folder / "a.exr"), digest(self.folder / "b.exr"))
        self.assertEqual(digest(self.folder / "a.png"), digest(self.folder / "b.png"))

        self.save("# a comment\n" + SCENE.replace("radius: 20cm", "radius: 40cm"))
        comment = self.picture()
        self.assertEqual((comment.group(1), comment.group(3)), ("nothing", "nothing"))
        self.expect(0, "render", "ball.vug", "-o", "b.exr")
        self.assertEqual(digest(self.folder / "a.exr"), digest(self.folder / "b.exr"))

    def test_errors_keep_the_last_picture(self):
        self.start()
        self.picture()
        before = digest(self.folder / "ball.png")
        self.save(SCENE.replace("object ball on ball", "object ball on bal"))
        self.wait_for(r"ball\.vug:3:16: error: .*")
        self.assertEqual(digest(self.folder / "ball.png"), before)
        self.save(SCENE)
        self.assertEqual(self.picture().group(3), "nothing")

    def test_included_files_are_watched(self):
        self.write("part.vug", "let size = 50cm\n")
        self.write("ball.vug", 'include "part.vug"\n' + SCENE.replace("sphere(50cm)", "sphere(size)"))
        self.start("--polling")
        self.picture()
        self.write("part.vug", "let size = 60cm\n")
        self.assertRegex(self.picture().group(1), "level set")

    def test_a_change_cancels_the_picture(self):
        self.save(SCENE.replace("spp 8", "spp 262144"))
        self.start()
        self.wait_for("unfinished picture")
        self.save(SCENE)
        self.picture()

    def get(self, url, method="GET", **headers):
        """Status, headers and content of a response."""
        connection = http.client.HTTPConnection(url.hostname, url.port, timeout=60)
        connection.request(method, url.path, headers=headers)
        response = connection.getresponse()
        content = response.read()
        connection.close()
        return response.status, response.headers, content

    def test_the_page(self):
        self.start()
        page = urllib.parse.urlparse(self.wait_for(r"page: (\S+)\n").group(1))
        self.assertEqual(page.hostname, "127.0.0.1")
        self.picture()

        status, headers, content = self.get(page)
        self.assertEqual(status, 200)
        self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
        self.assertNotIn(b"://", content)
        for name in re.findall(r'(?:src|href)="([^"]+)"', content.decode()):
            self.assertEqual(self.get(page._replace(path=page.path + name))[0], 200, name)

        picture = page._replace(path=page.path + "picture.png")
        self.assertEqual(self.get(picture)[2], (self.folder / "ball.png").read_bytes())
        state = json.loads(self.get(page._replace(path=page.path + "state.json"))[2])
        self.assertTrue(state["complete"])
        self.assertEqual(state["problems"], [])

        # Events arrive without a new request.
        connection = http.client.HTTPConnection(page.hostname, page.port, timeout=60)
        connection.request("GET", page.path + "events")
        events = connection.getresponse()
        self.assertEqual(events.headers["Content-Type"], "text/event-stream")

        def event(wanted):
            """The next state that `wanted` accepts."""
            while True:
                line = events.readline().decode()
                self.assertTrue(line, "the events have ended")
                if line.startswith("data: ") and wanted(json.loads(line[6:])):
                    return json.loads(line[6:])

        event(lambda each: each["number"] == state["number"])
        self.save(SCENE.replace("object ball on ball", "object ball on bal"))
        problem = event(lambda each: each["problems"])["problems"][0]
        self.assertTrue(problem["error"])
        self.assertIn("ball.vug:3:16", problem["where"])
        self.save(SCENE.replace("radius: 20cm", "radius: 40cm"))
        self.assertIn("built nothing", event(
            lambda each: each["complete"] and each["number"] > state["number"])["work"])
        self.assertNotEqual(self.get(picture)[2], b"")

        # Looks from other eyes, also while the picture is being rendered.
        def look(**changes):
            at = {f"{name[0]}{axis}": x for name in ("eye", "target") for axis, x in zip("xyz", state[name])}
            query = urllib.parse.urlencode({**at, "fov": state["fov"], "w": 64, "h": 36, **changes})
            connection = http.client.HTTPConnection(page.hostname, page.port, timeout=60)
            connection.request("GET", f"{page.path}look.png?{query}")
            response = connection.getresponse()
            content = response.read()
            connection.close()
            return response.status, content

        self.assertEqual((state["camera"], state["eye"]), ("main", [0, 1, 4]))
        status, own = look()
        self.assertEqual((status, own[:4]), (200, b"\x89PNG"))
        self.assertNotEqual(look(ex=2)[1], own)
        self.assertEqual(look(clay=1)[0], 200)
        for wrong in ({"ex": "nan"}, {"ex": ""}, {"fov": 4}, {"w": 100000}, {"ex": "1e9"}, {"ex": "1;2"},
                      {f"t{axis}": x for axis, x in zip("xyz", state["eye"])}):
            self.assertEqual(look(**wrong)[0], 404, wrong)
        before = self.get(page._replace(path=page.path + "state.json"))[2]
        self.save(SCENE.replace("spp 8", "spp 1024"))
        event(lambda each: each["number"] > json.loads(before)["number"] and not each["complete"])
        self.assertEqual(look(ex=1)[0], 200)
        event(lambda each: each["complete"])

        # Other tokens, host names, methods and files are refused.
        token = page.path.strip("/")
        for path, code in [("/", 404), ("/" + "0" * len(token) + "/", 404), ("/picture.png", 404),
                           (page.path + "ball.vug", 404), (page.path + "../ball.vug", 404),
                           ("/" + token, 404)]:
            self.assertEqual(self.get(page._replace(path=path))[0], code, path)
        for host in ("evil.example", f"evil.example:{page.port}", "127.0.0.1"):
            self.assertEqual(self.get(page, Host=host)[0], 403, host)
        self.assertEqual(self.get(page, Host=f"localhost:{page.port}")[0], 200)
        for method in ("POST", "PUT", "DELETE", "HEAD", "OPTIONS"):
            self.assertEqual(self.get(page, method)[0], 403, method)

        begin = time.monotonic()  # the end, while a browser listens
        self.process.send_signal(signal.SIGINT)
        self.process.stderr.read()
        self.assertEqual(self.process.wait(), 0)
        self.assertLess(time.monotonic() - begin, 10)
        events.close()
        connection.close()

    def test_a_port_in_use(self):
        self.start()
        page = urllib.parse.urlparse(self.wait_for(r"page: (\S+)\n").group(1))
        self.expect(3, "watch", "ball.vug", "--port", page.port)

    def test_the_end(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            for scene in (SCENE, SCENE.replace("spp 8", "spp 262144")):
                with self.subTest(how=how.name):
                    self.save(scene)
                    self.start()
                    self.wait_for("picture after")
                    begin = time.monotonic()
                    self.process.send_signal(how)
                    self.process.stderr.read()
                    self.assertEqual(self.process.wait(), 0)
                    self.assertLess(time.monotonic() - begin, 10)

    def test_once(self):
        self.expect(0, "watch", "ball.vug", "--once", "-o", "once.png")
        self.assertTrue((self.folder / "once.png").exists())
        self.write("ball.vug", SCENE.replace("object ball on ball", "object ball on bal"))
        self.expect(2, "watch", "ball.vug", "--once")
        self.write("ball.vug", SCENE)
        self.expect(2, "watch", "ball.vug", "--once", "-o", "once.jpg")
        self.expect(2, "watch", "none.vug", "--once")


if __name__ == "__main__":
    unittest.main()
