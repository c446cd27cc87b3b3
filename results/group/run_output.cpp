// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/run_output.h"

#include <fmt/format.h>

#include <utility>

#include "results/folder/report.h"
#include "results/option_names.h"

namespace isomatch::results {

GroupOutput group_output(const GroupRun& run, std::vector<int> vertices,
                         const ShapeModelOptions& options) {
  GroupOutput output;
  output.names = run.collection.names;
  output.points = points_of(run, vertices);
  output.faces = faces_between(run.template_mesh(), vertices);
  output.template_vertices = std::move(vertices);
  output.model = shape_model(output.points, options);
  output.quality = model_quality(output.model);
  ShapeColumn fit{"fit", {}}, cycle{"cycle_error", {}};
  const std::vector<double> errors = cycle_errors(run);
  for (std::size_t k = 0; k < errors.size(); ++k) {
    fit.values.emplace_back(to_string(run.result.members[k].fit.grade));
    cycle.values.push_back(fmt::format("{:.6g}", errors[k]));
  }
  output.columns = {std::move(fit), std::move(cycle)};
  return output;
}

Json group_options_json(const GroupOptions& group, const std::string& template_name, int points,
                        const ShapeModelOptions& model) {
  Json json = options_json("group");
  add_options(json, group.matching);
  set_path(json, "template", template_name);
  json["neighbours"] = group.neighbours;
  json["points"] = points;
  json["modes"] = model.modes;
  json["keep-size"] = model.keep_size;
  return json;
}

}  // namespace isomatch::results
