# SPDX-License-Identifier: Apache-2.0
"""tools/dev/packages is well formed, and the installer does nothing if all packages are installed."""
import pathlib
import re
import subprocess
import sys
import unittest

DEV = pathlib.Path(__file__).resolve().parents[2] / "tools/dev"


class PackagesTest(unittest.TestCase):
    def test_one_package_a_line_in_a_known_section(self):
        seen, section = set(), None
        for line in (DEV / "packages").read_text().splitlines():
            if not line or line.startswith("#"):
                continue
            if line.startswith("["):
                section = line
                self.assertIn(section, ("[build]", "[test]", "[docs]", "[studio]"))
                continue
            self.assertIsNotNone(section, f"{line} precedes the first section")
            self.assertRegex(line, r"^[a-z0-9][a-z0-9.+-]+( *# .+)?$")
            name = re.match(r"[^ ]+", line).group(0)
            self.assertNotIn(name, seen, f"{name} is listed twice")
            seen.add(name)
        self.assertGreater(len(seen), 10)

    def test_installer(self):
        again = subprocess.run([DEV / "install_packages"], capture_output=True, text=True)
        self.assertEqual((again.returncode, again.stdout), (0, ""), again.stderr)
        unknown = subprocess.run([DEV / "install_packages", "games"], capture_output=True, text=True)
        self.assertEqual(unknown.returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
