#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Writes the package's type stubs, __init__.pyi, from the package itself, options included.

Run with a built package on PYTHONPATH: python/stubs/make_stubs.py > python/isomatch/__init__.pyi
"""

import dataclasses
import functools
import inspect
import typing

import isomatch

HEADER = '''\
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
# Made by python/stubs/make_stubs.py; a test compares.
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._types import (
    ArrayLike,
    Geodesics,
    MapLike,
    MeshLike,
    Method,
    PathLike,
    Progress,
    TrueMapLike,
    TruthLike,
)

__version__: str
'''


#: What users call by a notation of Python's.
_PUBLIC_SPECIAL = ("__call__", "__getitem__", "__iter__", "__len__")


def type_name(annotation):
    if isinstance(annotation, typing.ForwardRef):
        return annotation.__forward_arg__
    return annotation if isinstance(annotation, str) else annotation.__name__


def parameter_text(parameter):
    text = parameter.name
    if parameter.annotation is not parameter.empty:
        text += f": {type_name(parameter.annotation)}"
    if parameter.default is not parameter.empty:
        text += f" = {parameter.default!r}"
    return text


def function_text(name, function, indent=""):
    signature = inspect.signature(function)
    lines, keywords = [], False
    for parameter in signature.parameters.values():
        if parameter.kind is parameter.KEYWORD_ONLY and not keywords:
            lines.append("*")
            keywords = True
        lines.append(parameter_text(parameter))
    result = type_name(signature.return_annotation)
    inner = "".join(f"\n{indent}    {line}," for line in lines)
    if lines == ["self"]:
        return f"{indent}def {name}(self) -> {result}: ...\n"
    return f"{indent}def {name}({inner}\n{indent}) -> {result}: ...\n"


def attributes_text(annotations):
    return "".join(f"    {name}: {type_name(kind)}\n" for name, kind in annotations.items())


def property_text(name, getter):
    kind = type_name(inspect.signature(getter).return_annotation)
    return f"    @property\n    def {name}(self) -> {kind}: ...\n"


def member_text(name, member):
    if isinstance(member, functools.cached_property):
        return property_text(name, member.func)
    if isinstance(member, property):
        return property_text(name, member.fget)
    return function_text(name, member, "    ")


def is_public(name, member, owner):
    if name == "__init__":
        return "return" in member.__annotations__ and not dataclasses.is_dataclass(owner)
    return (name in _PUBLIC_SPECIAL or not name.startswith("_")) and (
        inspect.isfunction(member) or isinstance(member, (property, functools.cached_property))
    )


def class_text(name, owner):
    attributes = attributes_text(owner.__dict__.get("__annotations__", {}))
    if issubclass(owner, tuple):
        return f"class {name}(NamedTuple):\n{attributes}"
    base = owner.__bases__[0]
    bases = "" if base is object else f"({base.__name__})"
    members = "".join(
        member_text(key, member)
        for key, member in vars(owner).items()
        if is_public(key, member, owner)
    )
    body = attributes + members or "    ...\n"
    return f"class {name}{bases}:\n{body}"


def stubs():
    classes = {n: getattr(isomatch, n) for n in isomatch.__all__}
    ordered = sorted(classes, key=lambda n: (not inspect.isclass(classes[n]), n))
    # A class comes after its base.
    ordered.sort(key=lambda n: len(classes[n].__mro__) if inspect.isclass(classes[n]) else 99)
    parts = [
        class_text(n, classes[n]) if inspect.isclass(classes[n]) else function_text(n, classes[n])
        for n in ordered
    ]
    return HEADER + "\n" + "\n".join(parts)


if __name__ == "__main__":
    print(stubs(), end="")
