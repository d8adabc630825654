# SPDX-License-Identifier: Apache-2.0
"""The documentation site builds strictly: every link leads somewhere, and every page is in the navigation.

    docs_test.py BUILD    the build folder whose vug command the generated pages come from
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = None


def missing():
    """The reason why the site cannot be built here, or nothing."""
    if not shutil.which("mkdocs") or not pathlib.Path("/usr/share/mkdocs/themes/material").is_dir():
        return "mkdocs-material is missing: tools/dev/install_packages docs"
    if not (BUILD / "bin/vug").is_file():
        return f"there is no {BUILD / 'bin/vug'}"
    return None


class DocsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if missing():
            print("SKIPPED:", missing())
            raise unittest.SkipTest(missing())
        cls.folder = tempfile.TemporaryDirectory()
        cls.site = pathlib.Path(cls.folder.name, "site")
        options = [] if shutil.which("doxygen") else ["--no-api"]
        cls.done = subprocess.run(
            [ROOT / "tools/docs", *options, "--vug", BUILD / "bin/vug", "--out", cls.site],
            capture_output=True, text=True, env={**os.environ, "TMPDIR": cls.folder.name})

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_strict_build(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout + self.done.stderr)

    def test_every_page_and_every_kind_is_there(self):
        for page in (ROOT / "docs").rglob("*.md"):
            name = page.relative_to(ROOT / "docs").with_suffix(".html").as_posix()
            name = re.sub(r"README\.html$", "index.html", name)
            self.assertTrue((self.site / name).is_file(), name)
        self.assertIn('id="torus"', (self.site / "reference/kinds/primitive.html").read_text())
        self.assertIn('id="vug-render"', (self.site / "reference/commands.html").read_text())
        self.assertIn("torus", (self.site / "search/search_index.json").read_text())

    def test_local_links_lead_to_files(self):
        for page in self.site.rglob("*.html"):
            if page.name == "404.html" or "api" in page.relative_to(self.site).parts:
                continue
            for target in re.findall(r'<(?:a|img|script|link)\b[^>]*?\b(?:href|src)="([^"#]+)', page.read_text()):
                if re.match(r"\w+:|/|\.$", target) or "api/cpp" in target:
                    continue
                self.assertTrue((page.parent / target).resolve().exists(), f"{page}: {target}")


class SourcesTest(unittest.TestCase):
    def test_user_pages_name_no_sources(self):
        """Tutorials, guides and reference pages contain neither paths of sources nor names of tests."""
        for folder in ("tutorials", "guides", "reference"):
            for page in (ROOT / "docs" / folder).glob("*.md"):
                for number, line in enumerate(page.read_text().splitlines(), 1):
                    found = re.search(r"\b(?:lib/vug|tests/(?:unit|cli|dcc|bench|python))/|`\w+/\w+\.(?:h|cpp)`", line)
                    self.assertFalse(found, f"{page.name}:{number}: {found and found.group(0)}")

    def test_terms_of_the_glossary_occur(self):
        """Every term of the glossary occurs on another page; of several in one row, each does."""
        pages = (page for page in (ROOT / "docs").rglob("*.md") if page.name != "glossary.md")
        text = re.sub(r"\s+", " ", " ".join(page.read_text() for page in pages)).lower()
        rows = re.findall(r"^\| ([^|]+) \| ([^|]+) \| ([^|]+) \|$", (ROOT / "docs/glossary.md").read_text(), re.M)[1:]
        self.assertGreater(len(rows), 50)
        for terms, _, _ in rows:
            for term in re.sub(r" \(.*?\)", "", terms.lower()).split(", "):
                with self.subTest(term):
                    self.assertTrue(re.search(rf"\b{re.escape(term.strip())}(?:s|es)?\b", text))


if __name__ == "__main__":
    BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(argv=sys.argv[:1])
