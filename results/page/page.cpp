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

constexpr std::string_view kManifestElement =
    R"(<script type="application/json" id="isomatch-manifest">)";
constexpr std::string_view kArraysElement = R"(<script type="text/plain" id="isomatch-arrays">)";

bool is_own_page(const std::filesystem::path& path, const std::string& folder) {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::absolute(path).parent_path();
  return path.filename() == kPage && std::filesystem::equivalent(parent, folder, error);
}

/// JSON in which no "</script>" or "<!--" can occur, which would end the element.
std::string embeddable(const Json& json) {
  std::string text;
  // Names of files need not be valid UTF-8.
  for (char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

std::size_t end_of(std::string_view page, std::string_view element) {
  const std::size_t place = page.find(element);
  if (place == std::string_view::npos)
    throw InternalError("the page's template has no element " + std::string(element));
  return place + element.size();
}

}  // namespace

void check_page_available() {
  if (page_template().empty())
    throw InvalidInput(
        "this isomatch was built without the report's page; install Node.js and npm, run "
        "scripts/build_viewer.sh and build again");
}

std::string filled_page(std::string_view page, const PageData& data) {
  const std::size_t manifest = end_of(page, kManifestElement),
                    arrays = end_of(page, kArraysElement);
  if (arrays < manifest) throw InternalError("the page's template has its elements out of order");
  std::string filled;
  filled += page.substr(0, manifest);
  filled += embeddable(data.manifest);
  filled += page.substr(manifest, arrays - manifest);
  filled += data.arrays;
  filled += page.substr(arrays);
  return filled;
}

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
