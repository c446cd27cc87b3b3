// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/page.h"

#include <filesystem>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "results/files/outputs.h"
#include "results/files/written_files.h"
#include "results/page/template.h"

namespace isomatch::results {
namespace {

bool is_own_page(const std::filesystem::path& path, const std::string& folder) {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::absolute(path).parent_path();
  return path.filename() == kPage && std::filesystem::equivalent(parent, folder, error);
}

}  // namespace

void check_page_output(const std::string& path, const std::string& folder, const MeshPlaces& places,
                       const TruthFiles& truth) {
  check_page_available();
  check_ending(path, {".html", ".htm"});
  InputFiles inputs = result_inputs(folder, places);
  for (const std::string& file : {truth.source, truth.target, truth.symmetric_target})
    inputs.add(file);
  check_output(path, inputs);
  if (is_own_page(path, folder)) check_replaceable(folder, {kPage}, Listing::kOfMatch, inputs);
}

void write_page(const std::string& path, ShownMatch match, const PageOptions& options,
                const Context& context) {
  check_page_available();
  const std::string folder = match.result.folder;
  const Json report = match.result.report;
  const bool is_own = is_own_page(path, folder);
  // The page shows the report as it will be.
  if (is_own) match.result.report = with_file(report, kPage);
  const std::string page =
      filled_page(page_template(), page_data(std::move(match), options, context));
  AtomicFile file(path);
  file.write(page);
  file.commit();
  if (is_own) list_in_report(folder, report, kPage);
}

}  // namespace isomatch::results
