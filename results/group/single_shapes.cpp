// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/single_shapes.h"

#include <fmt/format.h>

#include "isomatch/io/atomic_file.h"
#include "results/json.h"

namespace isomatch::results {
namespace {

void write_particles(const std::string& path, const std::vector<Point>& points) {
  AtomicFile file(path);
  for (const Point& x : points) file.write(fmt::format("{} {} {}\n", x[0], x[1], x[2]));
  file.commit();
}

Json control_points(const GroupOutput& output, std::size_t i) {
  Json list = Json::array();
  for (std::size_t p = 0; p < output.template_vertices.size(); ++p) {
    Json point{{"id", std::to_string(p + 1)}, {"label", std::to_string(p)}};
    const bool is_present = output.points.has(i, p);
    const Point& x = output.points.points[i][p];
    // Slicer takes a point without a position, but none whose position is no three numbers.
    if (is_present) point["position"] = {x[0], x[1], x[2]};
    point["positionStatus"] = is_present ? "defined" : "missing";
    list.push_back(std::move(point));
  }
  return list;
}

/// Mesh files of medical programs, Slicer's among them, are in the LPS system by default.
void write_landmarks(const std::string& path, Json points) {
  // The address is the name by which Slicer knows the format.
  const Json json{
      {"@schema",
       "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
       "Resources/Schema/markups-schema-v1.0.3.json#"},
      {"markups", Json::array({{{"type", "Fiducial"},
                                {"coordinateSystem", "LPS"},
                                {"controlPoints", std::move(points)}}})}};
  AtomicFile file(path);
  file.write(json.dump(1) + "\n");
  file.commit();
}

}  // namespace

std::string particles_name(const std::string& shape) { return "particles/" + shape + ".particles"; }

std::string landmarks_name(const std::string& shape) { return "landmarks/" + shape + ".mrk.json"; }

void write_single_shapes(ResultFolder& folder, const GroupOutput& output) {
  for (std::size_t i = 0; i < output.names.size(); ++i) {
    write_particles(folder.add(particles_name(output.names[i])),
                    completed_points(output.points, output.model, static_cast<int>(i)));
    if (std::ssize(output.template_vertices) <= kMostLandmarks)
      write_landmarks(folder.add(landmarks_name(output.names[i])), control_points(output, i));
  }
}

}  // namespace isomatch::results
