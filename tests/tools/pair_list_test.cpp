// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/pair_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "isomatch/error.h"
#include "support/temporary_folder.h"

namespace isomatch::results {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class PairList : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  std::vector<ListedPair> read(const std::string& content) const {
    folder_.write("pairs.csv", content);
    return read_pairs(path("pairs.csv"));
  }

  std::string refusal(const std::string& content) const {
    try {
      read(content);
    } catch (const BadFile& error) {
      return error.what();
    }
    return "nothing refused";
  }

  static std::vector<std::string> names(const std::vector<ListedPair>& pairs) {
    std::vector<std::string> names;
    for (const ListedPair& pair : pairs) names.push_back(pair.name);
    return names;
  }

  /// Files that have the names of meshes, and one that has not.
  void make_meshes() const {
    for (const char* name : {"b.off", "a.ply", "c.OBJ", "notes.txt", "._a.off"})
      folder_.write(name, "");
  }

  test::TemporaryFolder folder_;
};

TEST_F(PairList, TakesSeparatorsBlanksNamesQuotesAndComments) {
  const auto pairs = read(
      "source,target,name\n"
      "a.off, b.off\n"
      "\n"
      "# all of these are pairs\n"
      "a.off;c.off;first # the name\n"
      "a.off  d.off\r\n"
      "\"one, two.off\",b.off,quoted\n"
      "\"my a#1.off\" \"my \"\"b.off\"\n"
      "x.off,\ty.off\n");
  EXPECT_THAT(names(pairs),
              ElementsAre("a__b", "first", "a__d", "quoted", "my a#1__my \"b", "x__y"));
  EXPECT_EQ(pairs[0].source, path("a.off"));
  EXPECT_EQ(pairs[1].target, path("c.off"));
  EXPECT_EQ(pairs[3].source, path("one, two.off"));
}

TEST_F(PairList, TellsTheLineOfWhatIsWrong) {
  EXPECT_THAT(refusal("a b\na\n"), HasSubstr("line 2: expected source, target"));
  EXPECT_THAT(refusal("a,b,c,d\n"), HasSubstr("line 1: expected source, target"));
  EXPECT_THAT(refusal("a,,c\n"), HasSubstr("line 1: expected source, target"));
  EXPECT_THAT(refusal("a,b,../c\n"), HasSubstr("line 1: '../c' cannot be the name of a result"));
  EXPECT_THAT(refusal("a,b,pairs.csv\n"), HasSubstr("'pairs.csv' cannot be the name"));
  EXPECT_THAT(refusal("a,b," + std::string(151, 'x')), HasSubstr("cannot be the name"));
  EXPECT_THAT(refusal("\"a,b\n"), HasSubstr("line 1: a quote is not closed"));
  EXPECT_THAT(refusal("a,b\nc,d\nx/a,y/b\n"),
              HasSubstr("line 3: the name a__b is that of line 1 as well: a list gives them"));
  EXPECT_THAT(refusal("# nothing\n"), HasSubstr("there is no pair in it"));
  EXPECT_THROW(read_pairs(path("none.csv")), BadFile);
  EXPECT_THROW(read_pairs(path("")), BadFile);
}

TEST_F(PairList, TakesWhatSpreadsheetsWrite) {
  EXPECT_THAT(names(read("\xEF\xBB\xBFSource;Target\r\na.off;b.off\r\n")), ElementsAre("a__b"));
  EXPECT_THAT(names(read("# pairs\nsource target\na b\n")), ElementsAre("a__b"));
}

TEST_F(PairList, OfAFolderIsEveryPairAStarOrAChainByNames) {
  make_meshes();
  EXPECT_THAT(names(all_pairs(path(""))),
              ElementsAre("a__b", "a__c", "b__a", "b__c", "c__a", "c__b"));
  EXPECT_THAT(names(star_of_pairs(path("b.off"), path(""))), ElementsAre("b__a", "b__c"));
  EXPECT_THAT(names(chain_of_pairs(path(""))), ElementsAre("a__b", "b__c"));
}

TEST_F(PairList, OfAFolderWithoutTwoMeshesIsRefused) {
  EXPECT_THROW(all_pairs(path("")), BadFile);
  EXPECT_THROW(chain_of_pairs(path("")), BadFile);
  EXPECT_THROW(all_pairs(path("none")), BadFile);
  EXPECT_THROW(star_of_pairs(path("none.off"), path("")), BadFile);
}

}  // namespace
}  // namespace isomatch::results
