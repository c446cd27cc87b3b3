# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Options, signatures, stubs and descriptions."""
import inspect
import json
import pathlib

import isomatch
import make_stubs


def test_options_have_the_names_and_defaults_of_the_program(files, program, tmp_path):
    """The program's report lists every option; its names have dashes."""
    pair = files / "source.off", files / "target.ply"
    parameters = inspect.signature(isomatch.match).parameters
    found = set()
    for method, flags in (("tracked", ["--no-refinement"]), ("paper", ["--levels", 1])):
        program("match", *pair, "-o", tmp_path / method, "--method", method, *flags)
        report = json.loads((tmp_path / method / "report.json").read_text())
        for name, value in report["options"].items():
            if name in ("method", "target-to-source", "refinement", "levels"):
                continue
            assert parameters[name.replace("-", "_")].default == value, name
            found.add(name)
    assert len(found) > 18
    assert parameters["levels"].default == 100 and parameters["refinement"].default is True


def test_every_parameter_is_described():
    description = isomatch.match.__doc__
    for name, parameter in inspect.signature(isomatch.match).parameters.items():
        heading = f"\n    {name} = {parameter.default!r}\n", f"\n{name}\n", f"\nsource, {name}\n"
        assert any(text in description for text in heading) or name == "source", name


def test_everything_public_is_described():
    for name in isomatch.__all__:
        assert len(inspect.getdoc(getattr(isomatch, name))) > 40, name


def test_stubs_are_those_of_the_package():
    stub = pathlib.Path(isomatch.__file__).with_name("__init__.pyi")
    assert stub.read_text() == make_stubs.stubs()


def test_stubs_are_python():
    compile(make_stubs.stubs(), "__init__.pyi", "exec")


def test_version_is_that_of_the_program(program):
    assert program("--version") == f"isomatch {isomatch.__version__}\n"
