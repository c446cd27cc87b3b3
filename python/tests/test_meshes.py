# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
from types import SimpleNamespace

import numpy as np
import pytest

import isomatch

TRIANGLE = (np.eye(3), np.array([[0, 1, 2]]))


@pytest.mark.parametrize("ending", ["off", "obj", "ply"])
def test_files_keep_order_and_coordinates(tmp_path, pose1, ending):
    path = tmp_path / f"mesh.{ending}"
    isomatch.write_mesh(path, pose1)
    vertices, faces = isomatch.read_mesh(path)
    assert np.array_equal(vertices, pose1.vertices)
    assert np.array_equal(faces, pose1.faces)
    assert vertices.dtype == np.float64 and faces.dtype == np.int32


def test_every_form_of_a_mesh_is_the_same_shape(tmp_path, sheet):
    path = tmp_path / "sheet.off"
    isomatch.write_mesh(path, sheet)
    vertices, faces = sheet
    forms = [
        path,
        str(path),
        sheet,
        (vertices.tolist(), faces.tolist()),
        (np.asfortranarray(vertices), faces.astype(np.uint32)),
        SimpleNamespace(vertices=vertices, faces=faces),
        SimpleNamespace(vertices=vertices, triangles=faces),
        SimpleNamespace(points=vertices, cells_dict={"triangle": faces}),
    ]
    for form in forms:
        shape = isomatch.Shape(form)
        assert shape.area == pytest.approx(1)
        assert np.array_equal(shape.vertices, vertices)
        assert np.array_equal(shape.faces, faces)
    assert isomatch.Shape(path).path == str(path)
    assert isomatch.Shape(sheet).path is None


def test_shape_measures(sheet):
    shape = isomatch.Shape(sheet)
    # From below to .5 %, and paths are up to that much too long.
    assert shape.max_geodesic == pytest.approx(np.sqrt(2), rel=5e-3)
    assert shape.on_surface.all()
    assert shape.diagnosis()["vertices"] == 441
    assert shape.diagnosis()["given"]["boundary_edges"] == 80


def test_vertices_off_the_surface(sheet):
    vertices, faces = sheet
    shape = isomatch.Shape((np.vstack([vertices, [[5, 5, 5]]]), faces))
    assert shape.on_surface.sum() == 441 and not shape.on_surface[-1]
    assert len(shape.warnings) > 0


@pytest.mark.parametrize(
    "vertices, faces, message",
    [
        (np.eye(3)[:, :2], [[0, 1, 2]], r"vertices: expected shape \(N, 3\), not \(3, 2\)"),
        (np.eye(3), [0, 1, 2], r"faces: expected shape \(N, 3\), not \(3\)"),
        (np.eye(3), [[0, 1, 3]], "3"),
        (np.eye(3), [[0, 1, 2**40]], "faces: 1099511627776 is out of range"),
        (np.eye(3), [[0.0, 1.0, 1.5]], "faces: expected integers"),
        (np.full((3, 3), np.nan), [[0, 1, 2]], "no face of positive area"),
        (np.array([["a"] * 3] * 3), [[0, 1, 2]], "vertices: expected numbers"),
        (np.zeros((3, 3)), [[0, 1, 2]], "area"),
    ],
)
def test_bad_arrays_are_value_errors(vertices, faces, message):
    with pytest.raises(ValueError, match=message):
        isomatch.Shape((vertices, np.asarray(faces)))


def test_bad_files_are_os_errors(tmp_path):
    with pytest.raises(OSError, match="absent.off"):
        isomatch.Shape(tmp_path / "absent.off")
    bad = tmp_path / "bad.off"
    bad.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n")
    with pytest.raises(OSError, match="bad.off: line 2"):
        isomatch.read_mesh(bad)
    with pytest.raises(OSError, match="no/such"):
        isomatch.write_mesh("no/such/folder.off", TRIANGLE)


def test_what_is_no_mesh_is_a_type_error():
    with pytest.raises(TypeError, match="not int"):
        isomatch.Shape(7)


def test_arrays_outlive_their_shape(sheet):
    vertices = isomatch.Shape(sheet).vertices
    assert np.array_equal(vertices + 0, sheet[0])
