// SPDX-License-Identifier: MIT
#include "shell/study/study.h"

#include <span>

#include "core/document/binary.h"
#include "core/physics/constants.h"

namespace gaitsmith::shell {

namespace {

/// FNV-1a [Fowler Noll Vo 1991] over fields with unambiguous limits.
class Fingerprint {
 public:
  void Add(std::span<const std::uint8_t> bytes) {
    AddNumber(bytes.size());
    for (const std::uint8_t byte : bytes) AddByte(byte);
  }
  void Add(std::string_view text) {
    AddNumber(text.size());
    for (const char c : text) AddByte(static_cast<std::uint8_t>(c));
  }
  void AddNumber(std::uint64_t number) {
    for (int i = 0; i < 8; ++i, number >>= 8) AddByte(static_cast<std::uint8_t>(number & 255u));
  }
  [[nodiscard]] std::string Text() const { return HashText(hash_); }

 private:
  void AddByte(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x00000100000001b3ULL; }
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace

Document OnlyProblem(const Document& given) {
  Document document;
  document.model = given.model;
  document.figure = given.figure;
  document.figure.name.clear();
  document.drawn = given.drawn;
  document.environment = given.environment;
  document.start = given.start;
  document.pushes = given.pushes;
  document.task = given.task;
  document.senses = given.senses;
  document.kind = given.kind;
  document.rules = given.rules;
  if (given.search.start >= 0) {
    document.controllers = {given.controllers[static_cast<std::size_t>(given.search.start)]};
    document.controllers[0].name.clear();
    document.search.start = 0;
  }
  return document;
}

Document TrialDocument(const Study& study, std::size_t problem, std::size_t search, std::uint32_t seed) {
  Document document = study.problems[problem];
  const int start = document.search.start;
  document.search = study.searches[search];
  document.search.start = start;
  document.search.seed = seed;
  return document;
}

std::string FingerprintOfSwitches(std::span<const std::string> labels, std::span<const Document> documents,
                                  int times, int length) {
  Fingerprint print;
  print.Add("gaitsmith switches 1");  // change the number if the meaning of rows changes
  for (const int number : {times, length}) print.AddNumber(static_cast<std::uint64_t>(number));
  print.AddNumber(documents.size());
  for (std::size_t i = 0; i < documents.size(); ++i) {
    print.Add(labels[i]);
    print.Add(EncodeBinary(documents[i]));
  }
  return print.Text();
}

std::string FingerprintOf(const Study& study) {
  const StudyPlan& plan = study.plan;
  Fingerprint print;
  print.Add("gaitsmith study 1");  // change the number if the meaning of rows changes
  // The first number was the model's, before the documents held theirs. It stays, and so do fingerprints.
  for (const int number : {1, plan.trials, plan.points}) {
    print.AddNumber(static_cast<std::uint64_t>(number));
  }
  print.AddNumber(study.problems.size());
  for (std::size_t p = 0; p < study.problems.size(); ++p) {
    print.Add(plan.problems[p]);
    for (std::size_t s = 0; s < study.searches.size(); ++s) {
      print.Add(plan.searches[s]);
      print.Add(EncodeBinary(TrialDocument(study, p, s, plan.first_seed)));
    }
  }
  return print.Text();
}

}  // namespace gaitsmith::shell
