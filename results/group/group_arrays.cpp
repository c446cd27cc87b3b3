// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/group_arrays.h"

#include <limits>
#include <map>

#include "isomatch/io/array_file.h"

namespace isomatch::results {
namespace {

using Arrays = std::map<std::string, NumpyArray>;

NumpyArray list_array(const std::vector<double>& values) { return {{std::ssize(values)}, values}; }

NumpyArray matrix_array(const Eigen::MatrixXd& values, std::vector<std::int64_t> shape) {
  std::vector<double> list;
  list.reserve(values.size());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    for (Eigen::Index k = 0; k < values.cols(); ++k) list.push_back(values(i, k));
  return {std::move(shape), list};
}

/// Rows of x y z of each point in turn.
NumpyArray rows_of_points(const Eigen::MatrixXd& rows) {
  return matrix_array(rows, {rows.rows(), rows.cols() / 3, 3});
}

void add_names_and_faces(Arrays& arrays, const GroupOutput& output) {
  arrays["names"] = {{std::ssize(output.names)}, output.names};
  if (output.faces.empty()) return;
  std::vector<std::int32_t> corners;
  for (const Face& face : output.faces) corners.insert(corners.end(), face.begin(), face.end());
  arrays["template_faces"] = {{std::ssize(output.faces), 3}, corners};
}

}  // namespace

void write_point_arrays(const std::string& path, const GroupOutput& output) {
  const std::int64_t num_shapes = std::ssize(output.names);
  const std::int64_t num_points = std::ssize(output.template_vertices);
  std::vector<double> coordinates;
  std::vector<bool> present;
  for (std::size_t i = 0; i < output.names.size(); ++i)
    for (std::size_t p = 0; p < output.template_vertices.size(); ++p) {
      present.push_back(output.points.has(i, p));
      for (const double x : output.points.points[i][p])
        coordinates.push_back(present.back() ? x : std::numeric_limits<double>::quiet_NaN());
    }
  const std::vector<std::int32_t> vertices(output.template_vertices.begin(),
                                           output.template_vertices.end());
  Arrays arrays{{"points", {{num_shapes, num_points, 3}, coordinates}},
                {"present", {{num_shapes, num_points}, present}},
                {"template_vertices", {{num_points}, vertices}}};
  add_names_and_faces(arrays, output);
  write_arrays(path, arrays);
}

void write_mode_arrays(const std::string& path, const GroupOutput& output) {
  const ShapeModel& model = output.model;
  std::vector<double> mean;
  for (const Point& point : model.mean) mean.insert(mean.end(), point.begin(), point.end());
  Arrays arrays{{"mean", {{std::ssize(model.mean), 3}, mean}},
                {"modes", rows_of_points(model.modes)},
                {"aligned", rows_of_points(model.aligned)},
                {"variances", matrix_array(model.variances, {model.variances.size()})},
                {"scores", matrix_array(model.scores, {model.scores.rows(), model.scores.cols()})},
                {"compactness", list_array(output.quality.compactness)},
                {"generalisation", list_array(output.quality.generalisation)},
                {"specificity", list_array(output.quality.specificity)}};
  add_names_and_faces(arrays, output);
  write_arrays(path, arrays);
}

}  // namespace isomatch::results
