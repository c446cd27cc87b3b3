// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/group/shape_model.h"

#include <fmt/format.h>

#include <utility>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/error.h"
#include "run.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

using Booleans = py::array_t<bool, py::array::c_style | py::array::forcecast>;

CorrespondingPoints to_corresponding(const Doubles& points, const Booleans& present) {
  if (points.ndim() != 3 || points.shape(2) != 3)
    throw InvalidInput("points: expected shape (N, P, 3)");
  if (present.ndim() != 2 || present.shape(0) != points.shape(0) ||
      present.shape(1) != points.shape(1))
    throw InvalidInput(
        fmt::format("present: expected shape ({}, {})", points.shape(0), points.shape(1)));
  CorrespondingPoints result;
  for (py::ssize_t i = 0; i < points.shape(0); ++i) {
    result.points.emplace_back();
    result.present.emplace_back();
    for (py::ssize_t p = 0; p < points.shape(1); ++p) {
      result.points.back().emplace_back(points.at(i, p, 0), points.at(i, p, 1), points.at(i, p, 2));
      result.present.back().push_back(present.at(i, p));
    }
  }
  return result;
}

/// (rows, columns), or, of points, (rows, columns / 3, 3).
py::array_t<double> rows_of(const Eigen::MatrixXd& matrix, bool of_points) {
  std::vector<double> values;
  values.reserve(matrix.size());
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      values.push_back(matrix(row, column));
  if (of_points) return adopt<double>(std::move(values), {matrix.rows(), matrix.cols() / 3, 3});
  return adopt<double>(std::move(values), {matrix.rows(), matrix.cols()});
}

/// (N, 4, 4) matrices of homogeneous coordinates.
py::array_t<double> matrices_of(const std::vector<Similarity>& alignments) {
  std::vector<double> values;
  for (const auto& [scale, rotation, translation] : alignments) {
    Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix =
        Eigen::Matrix<double, 4, 4, Eigen::RowMajor>::Identity();
    matrix.topLeftCorner<3, 3>() = scale * rotation;
    matrix.topRightCorner<3, 1>() = translation;
    values.insert(values.end(), matrix.data(), matrix.data() + matrix.size());
  }
  return adopt<double>(std::move(values), {std::ssize(alignments), 4, 4});
}

py::array_t<double> completed(const CorrespondingPoints& shapes, const ShapeModel& model) {
  std::vector<Point> all;
  for (int shape = 0; std::cmp_less(shape, shapes.points.size()); ++shape) {
    const std::vector<Point> points = completed_points(shapes, model, shape);
    all.insert(all.end(), points.begin(), points.end());
  }
  return adopt<double>(std::move(all),
                       {std::ssize(shapes.points), std::ssize(shapes.points.front()), 3});
}

py::dict model_of(const Doubles& points, const Booleans& present, bool keep_size, int modes) {
  const CorrespondingPoints shapes = to_corresponding(points, present);
  auto [model, quality] = run({py::none(), py::none()}, [&](const Context&) {
    ShapeModel fitted = shape_model(shapes, {keep_size, modes});
    ModelQuality measured = model_quality(fitted);
    return std::pair(std::move(fitted), std::move(measured));
  });
  py::dict result;
  result["completed"] = completed(shapes, model);
  result["mean"] = to_array(std::move(model.mean));
  result["modes"] = rows_of(model.modes, true);
  result["variances"] = adopt(std::vector<double>(model.variances.begin(), model.variances.end()));
  result["scores"] = rows_of(model.scores, false);
  result["aligned"] = rows_of(model.aligned, true);
  result["alignments"] = matrices_of(model.alignments);
  result["compactness"] = adopt(std::move(quality.compactness));
  result["generalisation"] = adopt(std::move(quality.generalisation));
  result["specificity"] = adopt(std::move(quality.specificity));
  return result;
}

}  // namespace

void bind_shape_model(py::module_& module) { module.def("shape_model", model_of); }

}  // namespace isomatch::python
