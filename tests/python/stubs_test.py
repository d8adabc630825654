# SPDX-License-Identifier: Apache-2.0
"""The type stubs agree with the module, and everything is documented."""
import ast
import inspect
import pathlib
import unittest

import vug
from vug import _vug
from case import Case

STUB = pathlib.Path(_vug.__file__).with_name("_vug.pyi")


class Stubs(Case):
    def setUp(self):
        super().setUp()
        self.tree = ast.parse(STUB.read_text())
        self.classes = {n.name: n for n in self.tree.body if isinstance(n, ast.ClassDef)}
        self.functions = {n.name: n for n in self.tree.body if isinstance(n, ast.FunctionDef)}

    def test_every_name_exists(self):
        for name, member in vars(_vug).items():
            if inspect.isclass(member) and not issubclass(member, (Exception, tuple)):
                told = {getattr(n, "name", None) or n.target.id for n in self.classes[name].body
                        if not isinstance(n, ast.Expr)}
                there = {n for n in vars(member) if not n.startswith("_")}
                self.assertEqual(there, {n for n in told if not n.startswith("_")}, name)
            elif inspect.isbuiltin(member):
                self.assertIn(name, self.functions)

    def test_signatures_can_be_called(self):
        load = self.functions["load"].args
        self.assertEqual([a.arg for a in load.args], ["file", "params"])
        self.assertEqual([a.arg for a in load.kwonlyargs], ["seed", "frame", "variant"])
        self.assertEqual(load.kwarg.arg, "kwargs")
        self.assertEqual(ast.unparse(load.args[0].annotation), "Union[str, os.PathLike]")
        [build] = [n for n in self.classes["Scene"].body if getattr(n, "name", "") == "build"]
        [progress] = [each for each in build.args.args if each.arg == "progress"]
        self.assertEqual(ast.unparse(progress.annotation), "Optional[Callable[[float, str], Any]]")
        for node in ast.walk(self.tree):  # no C++ types remain in the signatures
            if isinstance(node, ast.Name):
                self.assertNotIn(node.id, ("handle", "object", "function", "array_t", "std"))

    def test_the_package_has_all_declared_names(self):
        for name in vug.__all__:
            self.assertTrue(hasattr(vug, name), name)
            self.assertTrue(inspect.getdoc(getattr(vug, name)), name)
        self.assertTrue(STUB.with_name("py.typed").exists())

    def test_docs_are_written(self):
        for name, node in {**self.classes, **self.functions}.items():
            self.assertTrue(ast.get_docstring(node), name)
        for name, node in self.classes.items():
            for member in node.body:
                if isinstance(member, ast.FunctionDef) and not member.decorator_list \
                        and not member.name.startswith("_"):
                    self.assertTrue(ast.get_docstring(member), f"{name}.{member.name}")


if __name__ == "__main__":
    unittest.main()
