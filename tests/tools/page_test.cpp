// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/page.h"

#include <gtest/gtest.h>

#include "isomatch/error.h"

namespace isomatch::results {
namespace {

constexpr std::string_view kTemplate =
    R"(<p></p><script type="application/json" id="isomatch-manifest"></script>)"
    R"(<script type="text/plain" id="isomatch-arrays"></script><i></i>)";

TEST(Page, DataGoesIntoItsElements) {
  const std::string page = filled_page(kTemplate, {Json{{"format", 1}}, "QUJD"});
  EXPECT_EQ(page,
            R"(<p></p><script type="application/json" id="isomatch-manifest">{"format":1}</script>)"
            R"(<script type="text/plain" id="isomatch-arrays">QUJD</script><i></i>)");
}

TEST(Page, NoNameOfAFileEndsTheElement) {
  const Json manifest{{"file", "a</script><script>alert(1)</script>.off"}};
  const std::string page = filled_page(kTemplate, {manifest, ""});
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_NE(page.find("a\\u003c/script>"), std::string::npos);
}

TEST(Page, NamesThatAreNotUtf8DoNoHarm) {
  EXPECT_NO_THROW(filled_page(kTemplate, {Json{{"file", "caf\xe9.off"}}, ""}));
}

TEST(Page, ATemplateWithoutElementsIsAnError) {
  EXPECT_THROW(filled_page("<p></p>", {Json{}, ""}), InternalError);
}

}  // namespace
}  // namespace isomatch::results
