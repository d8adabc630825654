# SPDX-License-Identifier: Apache-2.0
"""No function takes more than six positional arguments; more belong in a struct of options."""
import ast
import re

from .tree import Finding

MOST = 6
FOLDERS = ("lib/", "tools/", "plugins/")
PARAMETER = re.compile(r"""
    (?:\[\[\w+\]\]\s*)?(?:(?:const|typename|volatile|struct|unsigned|std::function<.*>)\b\s*)*
    (?P<type>[A-Za-z_][\w:]*(?:<.*>)?(?:::\w+)*)(?:\s+(?:const|int|long|char))*
    \s*(?:const\s*)?(?P<reference>[&*]*(?:\s*const)?(?:\s*\.\.\.)?|\(\s*[&*].*\)(?:\(.*\)|\[.*\]))\s*
    (?P<name>[A-Za-z_]\w*)?(?:\s*\[.*\])*\s*(?:=.*|\{.*\})?$""", re.X | re.S)
NOT_TYPES = {"return", "throw", "new", "delete", "case", "else", "co_return"}


def split(text):
    """The parts of a list between its commas outside of brackets."""
    parts, depth, start = [], 0, 0
    for at, c in enumerate(text):
        if c in "([{<":
            depth += 1
        elif c in ")]}" or (c == ">" and text[at - 1] != "-"):
            depth -= 1
        elif c == "," and depth == 0:
            parts.append(text[start:at])
            start = at + 1
    parts.append(text[start:])
    return [part.strip() for part in parts if part.strip()]


def is_parameter(text):
    """Whether the text declares a parameter, as opposed to an argument of a call."""
    match = PARAMETER.match(text)
    if not match or match["type"] in NOT_TYPES:
        return False
    return bool(match["name"] or match["reference"] or text.startswith("const "))


def parameter_lists(code):
    """(position, name, parameters) of each list in parentheses of which every part declares a parameter."""
    stack = []
    for at, c in enumerate(code):
        if c == "(":
            stack.append(at)
        elif c == ")" and stack:
            start = stack.pop()
            inside = code[start + 1:at]
            if inside.count(",") < MOST:
                continue
            before = re.search(r"([\w~]+|operator\S+|\])\s*(?:<[^<>()]*>)?$", code[max(0, start - 80):start])
            parts = split(inside)
            if before and len(parts) > MOST and all(map(is_parameter, parts)):
                yield start, before[1].replace("]", "a lambda"), parts


def python_functions(text):
    """(line, name, number of positional arguments) of each function."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            names = [each.arg for each in node.args.posonlyargs + node.args.args]
            yield node.lineno, node.name, len(names) - (names[:1] in (["self"], ["cls"]))


def check(tree):
    for name in tree.sources():
        if not name.startswith(FOLDERS):
            continue
        code = tree.code(name)
        for at, function, parts in parameter_lists(code):
            parts = [part for part in parts if "py::kwargs" not in part]
            if len(parts) <= MOST or re.search(rf"&{function}\b[^;]*py::kw_only\(\)", code):
                continue
            yield Finding(name, code.count("\n", 0, at) + 1,
                          f"{function} takes {len(parts)} arguments, at most {MOST} are allowed: "
                          "use a struct")
    for name in tree.select(".py"):
        if name.startswith(FOLDERS):
            for line, function, number in python_functions(tree.text(name)):
                if number > MOST:
                    yield Finding(name, line, f"{function} takes {number} positional arguments, at most "
                                  f"{MOST} are allowed: make the others keyword-only")
