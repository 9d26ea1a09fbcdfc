#!/usr/bin/env python3
"""Writes python/stanok/methods.py from the table of operator methods.

usage: generate_python_methods.py (with PYTHONPATH=build/release/python). A test compares the file with the table.
"""
import json
import keyword
import textwrap
from pathlib import Path

FILE = Path(__file__).resolve().parents[1] / "python" / "stanok" / "methods.py"
TYPES = {"integer": "int", "number": "float", "string": "str"}

HEAD = '''"""The methods of the operator protocol, a class for each noun.

Written by tools/generate_python_methods.py from the table of methods (protocol/contract/method_table.h); see
docs/reference/protocol.md for the members of the results.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Literal

Call = Callable[[str, dict[str, Any]], dict[str, Any]]

%SETS%def _given(**params: Any) -> dict[str, Any]:
    """Parameters without those that are left out; a name that Python has taken ends in _ here."""
    return {name.removesuffix("_"): value for name, value in params.items() if value is not None}
'''


def python_name(name):
    return f"{name}_" if keyword.iskeyword(name) else name


def type_of(schema):
    if schema.get("type") == "array":
        return f"Sequence[{type_of(schema['items'])}]"
    if "enum" in schema:
        return "Literal[" + ", ".join(f'"{choice}"' for choice in schema["enum"]) + "]"
    return TYPES[schema["type"]]


def number(value):
    return f"{value:g}" if abs(value) < 1e6 else f"{int(value)}"


def parameter_text(parameter):
    schema = parameter["schema"]
    text = f"{python_name(parameter['name'])}: {parameter.get('description', '')}"
    unit = parameter.get("x-unit", "")
    if "minimum" in schema and schema.get("maximum", 1e300) < 1e12:
        text += f"; {number(schema['minimum'])} to {number(schema['maximum'])}"
    return f"{text} {unit}".rstrip() + "."


def method_text(method, name):
    parameters = method["params"]
    required = [one for one in parameters if one["required"]]
    optional = [one for one in parameters if not one["required"]]
    arguments = ["self"] + [f"{python_name(one['name'])}: {type_of(one['schema'])}" for one in required]
    if optional:
        arguments.append("*")
        arguments += [f"{python_name(one['name'])}: {type_of(one['schema'])} | None = None" for one in optional]
    signature = f"def {python_name(name)}({', '.join(arguments)}) -> dict[str, Any]:"
    if len(signature) > 110:
        inner = textwrap.indent(",\n".join(map(wrapped_choices, arguments)), "    ")
        signature = f"def {python_name(name)}(\n{inner},\n) -> dict[str, Any]:"
    summary = method["summary"]
    documentation = summary[0].upper() + summary[1:] + "."
    lines = textwrap.wrap(documentation, 104)
    lines.append("")
    lines.append(f"``{method['name']}``, for the role {method['x-role']}.")
    if parameters:
        lines += ["", "Args:"]
        for one in parameters:
            lines += textwrap.wrap(parameter_text(one), 100, initial_indent="    ", subsequent_indent="        ")
    body = '"""' + "\n".join(lines) + ('\n"""' if len(lines) > 1 else '"""')
    given = ", ".join(f"{python_name(one['name'])}={python_name(one['name'])}" for one in parameters)
    call = f'return self._call("{method["name"]}", _given({given}))'
    if len(call) > 110:
        lines = textwrap.fill(given, 100, initial_indent="    ", subsequent_indent="    ")
        call = f'return self._call("{method["name"]}", _given(\n{lines}))'
    return textwrap.indent(signature, "    ") + "\n" + textwrap.indent(body + "\n" + call, "        ") + "\n"


def wrapped_choices(argument):
    if len(argument) <= 110:
        return argument
    return textwrap.fill(argument, 104, subsequent_indent="    ", break_long_words=False)


def named_set(name, effect, methods):
    listed = ", ".join(f'"{method["name"]}"' for method in methods if method["x-effect"] == effect)
    lines = textwrap.fill(listed, 104, initial_indent="    ", subsequent_indent="    ", break_on_hyphens=False)
    return f"{name} = frozenset({{\n{lines},\n}})\n" + ("\n\n" if name == "MOVES" else "")


def class_name(noun):
    return "".join(part.capitalize() for part in noun.split("_")) + "Methods"


def text_of(methods):
    nouns, alone = {}, []
    for method in methods:
        noun, _, verb = method["name"].partition(".")
        if verb:
            nouns.setdefault(noun, []).append((verb, method))
        else:
            alone.append(method)
    text = HEAD.replace("%SETS%", named_set("STOPS", "stops", methods) + named_set("MOVES", "begins_motion", methods))
    for noun, verbs in nouns.items():
        text += f'\n\nclass {class_name(noun)}:\n    """Methods ``{noun}.*``."""\n\n'
        text += "    def __init__(self, call: Call) -> None:\n        self._call = call\n"
        for verb, method in verbs:
            text += "\n" + method_text(method, verb)
    text += '\n\nclass Methods:\n    """Every method of the protocol: nouns as attributes, verbs as their methods."""\n'
    text += "\n"
    text += "    def __init__(self, call: Call) -> None:\n        self._call = call\n"
    for noun in nouns:
        text += f"        self.{noun} = {class_name(noun)}(call)\n"
    for method in alone:
        text += "\n" + method_text(method, method["name"])
    return text


def generated():
    from stanok import _native
    return text_of(json.loads(_native.discovery())["methods"])


if __name__ == "__main__":
    FILE.write_text(generated(), encoding="utf-8")
