# SPDX-License-Identifier: Apache-2.0
"""Every example of docs/guides/python.md runs, in the order of the page, as one session."""
import doctest
import os
import re
import unittest

from case import SOURCE, Case

PAGE = SOURCE / "docs" / "guides" / "python.md"


class Docs(Case):
    def test_examples(self):
        os.symlink(SOURCE / "data", self.folder / "data")
        text = PAGE.read_text()
        blocks = [(m.group(1), text.count("\n", 0, m.start()) + 1)
                  for m in re.finditer(r"^```python\n(.*?)^```", text, flags=re.M | re.S)]
        self.assertGreater(len(blocks), 5)
        names = {}
        said = []
        runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
        for block, line in blocks:
            if block.startswith(">>>"):
                test = doctest.DocTestParser().get_doctest(block, names, "python.md", str(PAGE), line)
                test.globs = names  # not a copy: later blocks use these variables
                runner.run(test, out=said.append, clear_globs=False)
            else:
                exec(compile("\n" * line + block, str(PAGE), "exec"), names)
        self.assertEqual(runner.summarize(verbose=False).failed, 0, "".join(said))


if __name__ == "__main__":
    unittest.main()
