"""The reference of the Python package in the book, written from the docstrings.

usage: python tests/python/package/reference.py     writes docs/src/python-reference.md anew
"""

import ast
import inspect
import re
import textwrap

import judder
from common import ROOT

PAGE = ROOT / "docs" / "src" / "python-reference.md"
MODULES = ["judder", "judder.oscillator", "judder.contact", "judder.sliding", "judder.sweep", "judder.distributed", "judder.plot", "judder.models"]
HEAD = """# Reference of the Python package

Every public name, from its docstring, as `help` shows it. The keys of cases that [`judder.models`](#juddermodels) takes are in [Case files](case-files.md).
"""
SECTIONS = {"Args": "Arguments", "Returns": "Returns", "Raises": "Raises"}
_ROLE = re.compile(r":\w+:`~?([^`]+)`")
_ENTRY = re.compile(r"^(\s{4,})((?:\w+(?:, )?)+): (.*)$")


def text():
    """The page."""
    return "\n".join([HEAD, *(part for name in MODULES for part in of_module(name))]).rstrip() + "\n"


def of_module(name):
    module = judder
    for step in name.split(".")[1:]:
        module = getattr(module, step)
    yield f"## {name}\n"
    yield markdown(inspect.getdoc(module) or "")
    for own in module.__all__:
        item = getattr(module, own)
        if name == "judder" and inspect.ismodule(item) or own.startswith("__"):
            continue
        if inspect.isclass(item):
            yield from of_class(f"{name}.{own}", item, with_members=name != "judder.models")
        elif inspect.isroutine(item):
            yield from of_function(f"{name}.{own}", item, "###")


def of_function(name, function, heading):
    yield f"{heading} {name}\n"
    yield f"```text\n{signature(name.rpartition('.')[2], function)}\n```\n"
    yield markdown(inspect.getdoc(function) or "")


def of_class(name, kind, *, with_members):
    yield f"### {name}\n"
    if issubclass(kind, BaseException):
        yield f"Of {', '.join(f'`{base.__name__}`' for base in kind.__bases__)}.\n"
    words = inspect.getdoc(kind) or ""
    yield markdown(words if with_members else words.partition("\n\n")[0])
    if not with_members:
        return
    fields = dict(documented_fields(kind))
    if fields:
        yield "".join(f"- `{field}`: {one_line(words)}\n" for field, words in fields.items())
    members = vars(kind).items()
    # compiled classes have their members in any order
    for own, value in members if is_written(kind) else sorted(members):
        if own.startswith("_") or own in fields:
            continue
        words = inspect.getdoc(getattr(kind, own)) or ""
        if inspect.isroutine(value) or isinstance(value, staticmethod | classmethod):
            yield f"`{signature(own, getattr(kind, own))}`\n"
            yield markdown(words)
        elif words and words != inspect.getdoc(type(value)):
            yield f"- `{own}`: {one_line(words)}\n"


def is_written(kind):
    """Whether a class is written in Python."""
    try:
        return bool(inspect.getsource(kind))
    except (OSError, TypeError):
        return False


def documented_fields(kind):
    """The fields of a class with the words that stand below them."""
    try:
        (tree,) = ast.parse(textwrap.dedent(inspect.getsource(kind))).body
    except (OSError, TypeError):
        return
    for field, words in zip(tree.body, tree.body[1:]):
        if isinstance(field, ast.AnnAssign) and isinstance(words, ast.Expr) and isinstance(words.value, ast.Constant) and isinstance(field.target, ast.Name):
            if not field.target.id.startswith("_"):
                yield field.target.id, inspect.cleandoc(words.value.value)


def signature(name, function):
    try:
        found = inspect.signature(function)
    except (TypeError, ValueError):
        return f"{name}(…)"
    parameters = [own for own in found.parameters.values() if own.name != "self"]
    return re.sub(r"'([^']*)'(?=[,)]| =|$)", r"\1", f"{name}{found.replace(parameters=parameters)}")


def one_line(words):
    return inline(" ".join(words.split()))


def inline(words):
    plain = _ROLE.sub(lambda role: f"`{role[1]}`", words)
    return re.sub(r"``([^`]+)``", r"`\1`", plain).replace("<", "&lt;") if "`<" not in plain else re.sub(r"``([^`]+)``", r"`\1`", plain)


def markdown(words):
    """A docstring: its sections as lists, its examples as blocks."""
    parts, lines = [], words.splitlines()
    while lines:
        line = lines.pop(0)
        if line.strip().startswith(">>>"):
            block = [line]
            while lines and lines[0].strip():
                block.append(lines.pop(0))
            parts += ["```text", *(textwrap.dedent("\n".join(block)).splitlines()), "```"]
        elif line.rstrip().endswith("::"):
            parts += [inline(line.rstrip()[:-1]), "", "```text"]
            while lines and (not lines[0].strip() or lines[0].startswith("    ")):
                parts.append(lines.pop(0).removeprefix("    "))
            while not parts[-1].strip():
                parts.pop()
            parts += ["```", ""]
        elif line.rstrip(":") in SECTIONS and line.endswith(":"):
            parts += [f"*{SECTIONS[line[:-1]]}*", ""]
            entry = []
            while lines and (not lines[0].strip() or lines[0].startswith("    ")):
                own = lines.pop(0)
                found = _ENTRY.match(own)
                if found and len(found[1]) == 4:
                    entry.append(f"- `{found[2]}`: {found[3]}")
                elif entry and own.strip():
                    entry[-1] += f" {own.strip()}"
                elif own.strip():
                    entry.append(f"- {own.strip()}" if not entry else own.strip())
            parts += [*map(inline, entry), ""]
        else:
            parts.append(inline(line))
    return "\n".join(parts).rstrip() + "\n"


if __name__ == "__main__":
    PAGE.write_text(text(), "utf-8")
    print(PAGE.relative_to(ROOT))
