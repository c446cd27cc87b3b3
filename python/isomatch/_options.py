# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Keywords of the library's options, derived from its C++ structs."""

import inspect

from . import _core


def _parameter(name, default):
    kind = type(default).__name__
    return inspect.Parameter(
        name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=kind
    )


def _parameters(lists):
    """Parameter and meaning by name, in order; of a name in two lists the first counts."""
    parameters = {}
    for key in lists:
        for name, default, meaning in _core.options[key]:
            parameters.setdefault(name, (_parameter(name, default), meaning))
    return parameters


def _describe(parameters):
    return "".join(
        f"\n    {name} = {parameter.default!r}\n        {meaning}"
        for name, (parameter, meaning) in parameters.items()
    )


def takes_options(*lists):
    """Declares that a function's `**options` are those of the named lists of `_core.options`, in
    its signature and at the end of its description."""

    def decorate(function):
        parameters = _parameters(lists)
        signature = inspect.signature(function)
        own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        function.__signature__ = signature.replace(
            parameters=own + [parameter for parameter, _ in parameters.values()]
        )
        heading = "\n\nOptions and their defaults:\n"
        function.__doc__ = inspect.cleandoc(function.__doc__) + heading + _describe(parameters)
        return function

    return decorate


def check_options(options, *lists, function):
    """Raises TypeError for a keyword that none of the lists has."""
    known = _parameters(lists)
    for name in options:
        if name not in known:
            raise TypeError(
                f"{function}() got an unexpected keyword argument {name!r}; "
                f"its options are {', '.join(known)}"
            )


def select(options, key):
    """Those of `options` that belong to one list."""
    names = {name for name, _, _ in _core.options[key]}
    return {name: value for name, value in options.items() if name in names}
