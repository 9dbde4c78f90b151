// SPDX-License-Identifier: MIT
// What a study's files say about its shards.
#include "shell/study/study_progress.h"

#include <catch_amalgamated.hpp>

#include "shell/study/switch_file.h"

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

using Rows = std::map<std::size_t, StudyFile::Rows>;

Rows RowsOfTrials(std::initializer_list<std::size_t> trials) {
  Rows rows;
  for (const std::size_t trial : trials) rows[trial] = {};
  return rows;
}

/// The sentence of a study of these trials.
std::string SentenceOf(const StudyProgress& progress) {
  const StudyFile file{.plan = FourteenTrials(), .table = StudyTable::kResults};
  return progress.Sentence([&](std::size_t trial) { return file.NameOfTrial(trial); });
}

/// Three documents, so six pairs, at two times each. The third label has a blank.
SwitchFile SixPairs(const Shard& shard) {
  SwitchFile file{
      .fingerprint = "0123456789abcdef", .times = 2, .labels = {"walk", "jump", "a b"}, .shard = shard};
  for (std::size_t pair = 0; pair < file.Total(); ++pair) {
    if (!shard.Holds(pair)) continue;
    const auto [from, to] = file.At(pair);
    StudyFile::Rows& rows = file.trials[pair];
    for (const char* numbers : {",100,-1.5,2.25,0,0.5\n", ",300,nan,2.25,1,1e-05\n"}) {
      rows.text.append(file.labels[from]).append(",").append(file.labels[to]).append(numbers);
    }
  }
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
      CHECK(shard.Due(plan.Total()) == held);
      due += held;
    }
    CHECK(due == plan.Total());
  }
}

TEST_CASE("study plan: a heading keeps its shard, and the whole has none", "[study]") {
  const StudyPlan plan = FourteenTrials();
  for (const Shard& shard : {Shard{}, Shard{.first = 2, .of = 3}, Shard{.first = 0, .of = 1'000'000'000}}) {
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
  StudyProgress progress(FourteenTrials().Total(), "trials");

  progress.Add("one.csv", {.first = 0, .of = 3}, RowsOfTrials({0, 3, 6, 9, 12}));
  progress.Add("c,\"d\".csv", {.first = 1, .of = 3}, RowsOfTrials({1, 4}));
  progress.AddWithoutHeading("new.csv");
  CHECK(progress.Missing() == 7);
  CHECK(progress.Csv() ==
        "shard,of,done,due,state,file\n"
        "1,3,5,5,complete,one.csv\n"
        "2,3,2,5,unfinished,\"c,\"\"d\"\".csv\"\n"
        "3,3,0,4,missing,\n"
        ",,0,,unfinished,new.csv\n"
        "all,,7,14,unfinished,\n");
  CHECK(SentenceOf(progress) ==
        "7 of 14 trials are missing: shard 2/3 is not finished (c,\"d\".csv); shard 3/3 has no file");

  progress.Add("rest.csv", {}, RowsOfTrials({2, 5, 7, 8, 10, 11, 13}));
  CHECK(progress.Missing() == 0);
  CHECK(!progress.Csv().contains("missing"));
  CHECK(progress.Csv().ends_with("all,,14,14,complete,\n"));
}

TEST_CASE("study progress: without shards the first missing trial is named", "[study]") {
  StudyProgress progress(FourteenTrials().Total(), "trials");

  progress.Add("all.csv", {}, RowsOfTrials({0, 1, 2, 3, 4, 5, 6, 7, 9}));
  CHECK(SentenceOf(progress) ==
        "5 of 14 trials are missing, first that of walk with sphc:population=4 and seed 6");
}

TEST_CASE("study progress: a sentence stays short however many shards are lost", "[study]") {
  StudyProgress progress(FourteenTrials().Total(), "trials");

  progress.Add("one.csv", {.first = 0, .of = 1'000'000'000}, RowsOfTrials({0}));
  CHECK(SentenceOf(progress).ends_with("; shard 11/1000000000 has no file; and 3 more"));
}

TEST_CASE("switch file: shards are read back, and together are the whole", "[study]") {
  SwitchFile whole = SixPairs({});
  CHECK(whole.NameOfTrial(0) == "walk to jump");
  CHECK(whole.NameOfTrial(5) == "a b to jump");
  CHECK(whole.Text().starts_with("from,to,step,score,usual,success,distance\nwalk,jump,100,"));
  Rows together;
  for (std::size_t first = 0; first < 4; ++first) {
    const SwitchFile shard = SixPairs({.first = first, .of = 4});
    const auto read = SwitchFile::Parse(shard.Text(), "s.csv", Ending::kWhole);
    REQUIRE(read);
    CHECK(read->Text() == shard.Text());
    CHECK(read->trials.size() == shard.shard.Due(6));
    together.insert(read->trials.begin(), read->trials.end());
  }
  const std::string text = whole.Text();
  whole.trials = together;
  CHECK(whole.Text() == text);
}

TEST_CASE("switch file: what is damaged has a line", "[study]") {
  const std::string text = SixPairs({.first = 1, .of = 3}).Text();
  const auto fault = [](std::string damaged, std::string_view part, std::string_view with) {
    const std::size_t at = damaged.find(part);
    REQUIRE(at != std::string::npos);
    const auto read = SwitchFile::Parse(damaged.replace(at, part.size(), with), "s.csv", Ending::kTorn);
    return read ? "accepted" : read.error().Sentence();
  };
  CHECK(fault(text, "pairs 6", "pairs 7") == "s.csv:1: its heading is damaged");
  CHECK(fault(text, "shard 2/3", "shard 1/1") == "s.csv:1: its heading is damaged");
  CHECK(fault(text, "shard 2/3", "shard 1/3") == "s.csv:3: must be of walk to jump");
  CHECK(fault(text, "2.25", "2,25") == "s.csv:3: has 8 fields instead of 7");
  CHECK(fault(text, ",1e-05", ",1e-05x") == "s.csv:4: has a damaged number");
  CHECK(fault(text + "walk,jump,1,1,1,1,1\n", "walk", "walk") ==
        "s.csv:7: comes after the last pair of this shard");
  CHECK(fault("from,to\n", "from", "from") == "s.csv:1: is not a shard of gaitsmith switches");
  const std::string cut = text.substr(0, text.size() - 3);
  CHECK(SwitchFile::Parse(cut, "s.csv", Ending::kTorn)->trials.size() == 1);
  CHECK(SwitchFile::Parse(cut, "s.csv", Ending::kWhole).error().Sentence() ==
        "s.csv:6: the pair is cut short; run its command again");
}

}  // namespace gaitsmith::shell::test
