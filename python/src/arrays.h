// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/mesh.h"

/// Between numpy arrays and the library's types. Arrays go out without a copy: they own the memory
/// of the vector that they were made of. What comes in is copied, because the library keeps it.
namespace isomatch::python {

/// An array of `shape` and type `Scalar` over the memory of `values`, which it owns.
template <class Scalar, class Element>
pybind11::array_t<Scalar> adopt(std::vector<Element> values, std::vector<pybind11::ssize_t> shape) {
  auto* owner = new std::vector<Element>(std::move(values));
  const pybind11::capsule capsule(
      owner, [](void* vector) { delete static_cast<std::vector<Element>*>(vector); });
  return pybind11::array_t<Scalar>(std::move(shape), reinterpret_cast<const Scalar*>(owner->data()),
                                   capsule);
}

template <class Scalar>
pybind11::array_t<Scalar> adopt(std::vector<Scalar> values) {
  const auto size = static_cast<pybind11::ssize_t>(values.size());
  return adopt<Scalar, Scalar>(std::move(values), {size});
}

using Doubles = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// (N, 3) coordinates.
pybind11::array_t<double> to_array(std::vector<Point> points);
/// (M, 3) vertices.
pybind11::array_t<int> to_array(std::vector<Face> faces);
/// (K, 2) source and target vertices.
pybind11::array_t<int> to_array(Correspondence matches);
/// (N) faces, -1 where there is none, and (N, 3) weights.
std::pair<pybind11::array_t<int>, pybind11::array_t<double>> to_arrays(SurfaceMap map);
/// Points on a mesh: `triangles` and `barycentric` as above, and the nearest `vertices`.
pybind11::dict to_dict(const Mesh& mesh, SurfaceMap points);

/// Integers of any width, or floats that are whole, of shape (N) or, if `columns` is given, (N,
/// columns), row by row. Throws `InvalidInput` that begins with `name` for another shape, another
/// type, or a number beyond int.
std::vector<int> to_integers(const pybind11::array& array, std::string_view name, int columns = 0);

/// Numbers of any type and shape (N, columns), or with any number of columns if it is not given.
/// Throws `InvalidInput` that begins with `name` for another shape or type.
Doubles to_doubles(const pybind11::array& array, std::string_view name,
                   std::optional<int> columns = {});
/// (N, 3) coordinates.
std::vector<Point> to_points(const pybind11::array& array, std::string_view name);

/// Mesh of (N, 3) coordinates and (M, 3) vertices, validated.
Mesh to_mesh(const pybind11::array& vertices, const pybind11::array& faces);
/// (K, 2) vertices, in their order.
std::vector<Match> to_matches(const pybind11::array& pairs, std::string_view name);
/// Faces and weights as `to_arrays` gives them. Weights must be in [0, 1] and sum to 1 where there
/// is a face, within 1e-6.
SurfaceMap to_surface_map(const pybind11::array& faces, const pybind11::array& weights);

}  // namespace isomatch::python
