# SPDX-License-Identifier: Apache-2.0
"""vug-studio on a virtual screen (Xvfb) with a window manager (openbox): real focus, keys and mouse by xdotool."""
import json
import os
import shutil
import subprocess
import time
import unittest

from studio import PROGRAM, StudioTest, require_studio, skip


def let_windows_settle():
    """Waits as long as the window system may take on a machine with this load: xdotool sends keys to whatever has the focus."""
    time.sleep(max(1.0, os.getloadavg()[0] / (os.cpu_count() or 1)))


class Screen(StudioTest):
    def screen(self):
        """The number of a virtual screen that exists until the test ends."""
        there, told = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(told), "-screen", "0", "1280x900x24", "-nolisten", "tcp"],
                                  pass_fds=[told], stderr=subprocess.DEVNULL)
        os.close(told)
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        with os.fdopen(there) as said:
            return said.readline().strip()

    def start(self, *command):
        process = subprocess.Popen(command, env=self.x_environment, cwd=self.folder, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        return process

    def xdotool(self, *words):
        done = subprocess.run(["xdotool", *map(str, words)], capture_output=True, text=True, env=self.x_environment,
                              timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.strip()

    def palette(self, line, output):
        """Runs a command by the palette and waits for its file."""
        self.xdotool("key", "ctrl+shift+p")
        let_windows_settle()
        self.xdotool("type", "--delay", "15", line)
        self.xdotool("key", "Return")
        for _ in range(100):
            if output.exists():
                return json.loads(output.read_text())
            time.sleep(0.1)
        self.fail(f"the palette did not write {output}")

    def test_a_facade_by_real_keys_and_clicks(self):
        self.x_environment = self.environment(DISPLAY=f":{self.screen()}", QT_QPA_PLATFORM="xcb")
        self.start("openbox")
        studio = self.start(PROGRAM, "--theme", "light", str(self.photo))
        window = self.xdotool("search", "--sync", "--onlyvisible", "--name", "paris.jpg").splitlines()[-1]
        self.xdotool("windowactivate", "--sync", window)
        self.xdotool("windowsize", "--sync", window, 1200, 800)
        let_windows_settle()
        for key in ("1", "n", "8"):  # rows; the ground floor is open; its elements
            self.xdotool("key", key)
            let_windows_settle()
        # A click on the upper part of the canvas, then a regular grid.
        self.xdotool("mousemove", "--window", window, 760, 250, "click", 1)
        let_windows_settle()
        self.xdotool("key", "5")
        session = self.palette(f"save {self.folder}/made.json", self.folder / "made.json")
        self.assertEqual([(each["edit"], each["node"], each["rule"]) for each in session["edits"]],
                         [("act", "0", "rows(FacadeRow, PartFacade)"), ("act", "0.0", "repeat(FacadeElement)"),
                          ("act", "0.1", "RegularGrid")])
        let_windows_settle()
        self.xdotool("key", "ctrl+z")
        let_windows_settle()
        session = self.palette(f"save {self.folder}/undone.json", self.folder / "undone.json")
        self.assertEqual((len(session["edits"]), session["done"]), (3, 2))
        self.xdotool("key", "ctrl+q")
        self.assertEqual(studio.wait(timeout=30), 0)


if __name__ == "__main__":
    require_studio()
    for program in ("Xvfb", "openbox", "xdotool"):
        if not shutil.which(program):
            skip(f"{program} is missing (tools/dev/install_packages studio)")
    unittest.main()
