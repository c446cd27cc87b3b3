// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/group_run_page.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "isomatch/io/atomic_file.h"
#include "results/files/written_files.h"
#include "results/page/group_page.h"

namespace isomatch::results {

std::string group_run_page(const GroupRun& run, const GroupOutput& output) {
  GroupPageData page;
  page.title = fmt::format("{} shapes", run.collection.names.size());
  page.command = run.words;
  for (const int v : output.template_vertices)
    page.template_mesh.vertices.push_back(run.template_mesh().vertices[v]);
  page.template_mesh.faces = output.faces;
  page.template_shape = run.result.template_shape;
  const std::vector<double> errors = cycle_errors(run);
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const GroupMember& member = run.result.members[k];
    std::vector<float> spread;
    for (const int v : output.template_vertices) spread.push_back(member.spread[v]);
    page.members.push_back({run.collection.names[k], member.fit.grade, member.fit.reasons,
                            errors[k], output.points.points[k], output.points.present[k],
                            std::move(spread)});
  }
  page.pairs = run.result.pairs;
  page.model = GroupPageModel{output.model, output.quality};
  return group_page(page);
}

void write_group_page(const std::string& folder, const Json& report, const GroupRun& run,
                      const GroupOutput& output) {
  AtomicFile file((std::filesystem::path(folder) / kGroupPage).string());
  file.write(group_run_page(run, output));
  file.commit();
  list_in_report(folder, report, kGroupPage);
}

}  // namespace isomatch::results
