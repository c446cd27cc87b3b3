// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/filled_page.h"

#include "isomatch/error.h"
#include "results/page/template.h"

namespace isomatch::results {
namespace {

constexpr std::string_view kManifestElement =
    R"(<script type="application/json" id="isomatch-manifest">)";
constexpr std::string_view kArraysElement = R"(<script type="text/plain" id="isomatch-arrays">)";

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

}  // namespace isomatch::results
