// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/group_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "isomatch/io/atomic_file.h"
#include "results/csv.h"

namespace isomatch::results {

void write_point_table(const std::string& path, const GroupOutput& output) {
  AtomicFile file(path);
  file.write("shape,point,x,y,z,present\n");
  for (std::size_t i = 0; i < output.names.size(); ++i) {
    const std::string name = csv_field(output.names[i]);
    for (std::size_t p = 0; p < output.template_vertices.size(); ++p) {
      const Point& x = output.points.points[i][p];
      file.write(output.points.has(i, p)
                     ? fmt::format("{},{},{},{},{},1\n", name, p, x[0], x[1], x[2])
                     : fmt::format("{},{},,,,0\n", name, p));
    }
  }
  file.commit();
}

void write_score_table(const std::string& path, const GroupOutput& output) {
  const ShapeModel& model = output.model;
  std::string head = "shape,points";
  for (Eigen::Index k = 1; k <= model.scores.cols(); ++k) head += fmt::format(",mode_{}", k);
  for (const ShapeColumn& column : output.columns) head += ',' + csv_field(column.name);
  AtomicFile file(path);
  file.write(head + '\n');
  for (std::size_t i = 0; i < output.names.size(); ++i) {
    int num_points = 0;
    for (std::size_t p = 0; p < model.mean.size(); ++p) num_points += output.points.has(i, p);
    std::string line = fmt::format("{},{}", csv_field(output.names[i]), num_points);
    for (Eigen::Index k = 0; k < model.scores.cols(); ++k)
      line += fmt::format(
          ",{:.6g}", model.scores(static_cast<Eigen::Index>(i), k) / std::sqrt(model.variances[k]));
    for (const ShapeColumn& column : output.columns) line += ',' + csv_field(column.values[i]);
    file.write(line + '\n');
  }
  file.commit();
}

}  // namespace isomatch::results
