// SPDX-License-Identifier: MIT
// What a study's files say about its shards.
#include "shell/study/study_progress.h"

#include <catch_amalgamated.hpp>

namespace gaitsmith::shell::test {

namespace {

/// Two problems, one search, seven seeds: fourteen trials.
StudyPlan FourteenTrials() {
  return {.fingerprint = "0123456789abcdef",
          .first_seed = 5,
          .trials = 7,
          .evaluations = 90,
          .points = 3,
          .problems = {"hop", "walk"},
          .searches = {"sphc:population=4"}};
}

StudyFile FileWith(const Shard& shard, std::initializer_list<std::size_t> trials) {
  StudyFile file{.plan = FourteenTrials(), .table = StudyTable::kResults, .shard = shard};
  for (const std::size_t trial : trials) file.trials[trial] = {};
  return file;
}

}  // namespace

TEST_CASE("study plan: the shards of a study share out its trials", "[study]") {
  const StudyPlan plan = FourteenTrials();
  for (const std::size_t of : {1uz, 3uz, 14uz, 20uz}) {
    CAPTURE(of);
    std::size_t due = 0;
    for (std::size_t first = 0; first < of; ++first) {
      const Shard shard{.first = first, .of = of};
      std::size_t held = 0;
      for (std::size_t trial = 0; trial < plan.Total(); ++trial) held += shard.Holds(trial) ? 1 : 0;
      CHECK(shard.Due(plan) == held);
      due += held;
    }
    CHECK(due == plan.Total());
  }
}

TEST_CASE("study plan: a heading keeps its shard, and the whole has none", "[study]") {
  const StudyPlan plan = FourteenTrials();
  for (const Shard& shard : {Shard{}, Shard{.first = 2, .of = 3}, Shard{.first = 0, .of = 4'000'000'000}}) {
    const std::string heading = Heading(plan, StudyTable::kCurves, shard);
    CAPTURE(heading);
    CHECK(heading.contains(" shard ") == (shard.of > 1));
    const auto read = ParseHeading(heading);
    REQUIRE(read);
    CHECK(read->shard == shard);
    CHECK(read->plan.problems == plan.problems);
  }
  for (const char* wrong : {"1/1", "0/3", "4/3", "01/3", "1/3/", "1", "-1/3"}) {
    CAPTURE(wrong);
    std::string heading = Heading(plan, StudyTable::kCurves, {.first = 0, .of = 3});
    heading.replace(heading.find("1/3"), 3, wrong);
    CHECK(!ParseHeading(heading));
  }
}

TEST_CASE("study progress: a lost shard is named, one that others cover is not", "[study]") {
  StudyProgress progress(FourteenTrials());
  progress.Add("one.csv", FileWith({.first = 0, .of = 3}, {0, 3, 6, 9, 12}));
  progress.Add("c,\"d\".csv", FileWith({.first = 1, .of = 3}, {1, 4}));
  progress.AddWithoutHeading("new.csv");
  CHECK(progress.Missing() == 7);
  CHECK(progress.Csv() ==
        "shard,of,done,due,state,file\n"
        "1,3,5,5,complete,one.csv\n"
        "2,3,2,5,unfinished,\"c,\"\"d\"\".csv\"\n"
        "3,3,0,4,missing,\n"
        ",,0,,unfinished,new.csv\n"
        "all,,7,14,unfinished,\n");
  CHECK(progress.Sentence() ==
        "7 of 14 trials are missing: shard 2/3 is not finished (c,\"d\".csv); shard 3/3 has no file");

  progress.Add("rest.csv", FileWith({}, {2, 5, 7, 8, 10, 11, 13}));
  CHECK(progress.Missing() == 0);
  CHECK(!progress.Csv().contains("missing"));
  CHECK(progress.Csv().ends_with("all,,14,14,complete,\n"));
}

TEST_CASE("study progress: without shards the first missing trial is named", "[study]") {
  StudyProgress progress(FourteenTrials());
  progress.Add("all.csv", FileWith({}, {0, 1, 2, 3, 4, 5, 6, 7, 9}));
  CHECK(progress.Sentence() ==
        "5 of 14 trials are missing, first that of walk with sphc:population=4 and seed 6");
}

TEST_CASE("study progress: a sentence stays short however many shards are lost", "[study]") {
  StudyProgress progress(FourteenTrials());
  progress.Add("one.csv", FileWith({.first = 0, .of = 1'000'000'000}, {0}));
  CHECK(progress.Sentence().ends_with("; shard 11/1000000000 has no file; and 3 more"));
}

}  // namespace gaitsmith::shell::test
