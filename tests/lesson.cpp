// SPDX-License-Identifier: MIT
#include "tests/lesson.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <sstream>

#include "core/document/joints.h"
#include "core/document/json.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

std::string OneBlank(const std::string& text) {
  std::istringstream words(text);
  std::string all, word;
  while (words >> word) all += (all.empty() ? "" : " ") + word;
  return all;
}

}  // namespace

Lesson LessonOf(const std::string& name) {
  std::istringstream file(ReadFile("docs/lessons/" + name + ".md"));
  Lesson lesson;
  std::string line, prose, all, fence, content;
  REQUIRE(std::getline(file, line));
  REQUIRE(line == "---");
  while (std::getline(file, line) && line != "---") {
    const std::size_t colon = line.find(": ");
    REQUIRE(colon != std::string::npos);
    lesson.fields[line.substr(0, colon)] = line.substr(colon + 2);
  }
  while (std::getline(file, line)) {
    if (line.starts_with("```")) {
      if (fence.empty()) {
        fence = line.substr(3);
        content.clear();
      } else {
        lesson.fences[fence].push_back(content);
        fence.clear();
      }
      continue;
    }
    (fence.empty() ? prose : content) += line + "\n";
    all += line + "\n";
  }
  CHECK(fence.empty());
  lesson.text = OneBlank(prose);
  lesson.whole = OneBlank(all);
  lesson.words = static_cast<int>(std::ranges::count(lesson.text, ' ')) + 1;
  const std::string up = "../../";
  REQUIRE(lesson.fields["open"].starts_with(up));
  lesson.links = {lesson.fields["open"].substr(up.size())};
  for (std::size_t at = 0; (at = all.find("](" + up, at)) != std::string::npos; ++at) {
    const std::size_t begin = at + 2 + up.size();
    lesson.links.push_back(all.substr(begin, all.find_first_of(")?", begin) - begin));
  }
  return lesson;
}

void Says(const Lesson& lesson, const std::string& words) {
  INFO(words);
  CHECK(lesson.whole.find(OneBlank(words)) != std::string::npos);
}

Document Shipped(const std::string& path) {
  auto document = DecodeJson(ReadFile("examples/" + path + ".json"));
  REQUIRE(document);
  return *document;
}

Terms TermsOf(const Document& document) {
  const Motion motion = Simulate(document);
  return motion.TermsAt(motion.Frames() - 1);
}

std::vector<Condition> ConditionsOf(const std::string& goal) {
  std::istringstream parts(goal);
  std::vector<Condition> conditions;
  for (std::string part; std::getline(parts, part, ',');) {
    std::istringstream words(part);
    Condition condition;
    REQUIRE(words >> condition.name >> condition.relation >> condition.wanted);
    conditions.push_back(condition);
  }
  REQUIRE_FALSE(conditions.empty());
  return conditions;
}

bool Compare(double has, const Condition& condition) {
  const double wanted = std::stod(condition.wanted);
  if (condition.relation == "!=") return has != wanted;
  REQUIRE((condition.relation == ">=" || condition.relation == "<="));
  return condition.relation == ">=" ? has >= wanted : has <= wanted;
}

bool Reaches(const std::string& goal, const Document& document) {
  const Terms terms = TermsOf(document);
  const Controller& controller =
      document.controllers[static_cast<std::size_t>(document.timeline[0].controller)];
  bool all = !terms.broke_physics;
  for (const Condition& condition : ConditionsOf(goal)) {
    const std::string& name = condition.name;
    const auto term = std::ranges::find(kStyleTermNames, name);
    if (name == "sense") {
      const bool timer = controller.senses.kind == SenseKind::kTimer;
      const bool curves = controller.kind == ControllerKind::kTrajectory;
      all &= condition.wanted == (curves ? "trajectory" : timer ? "timer" : "physical");
    } else if (name == "travel") {
      all &= Compare(static_cast<double>(terms.travel_m), condition);
    } else if (name == "distance") {
      all &= Compare(std::abs(static_cast<double>(terms.travel_m)), condition);
    } else if (name == "rules") {
      all &= Compare(controller.rules, condition);
    } else if (name == "strength") {
      all &= HasLimitedJoints(document) && Compare(static_cast<double>(JointStrength(document)), condition);
    } else if (term != kStyleTermNames.end()) {
      all &= Compare(static_cast<double>(terms.Style(static_cast<StyleTerm>(term - kStyleTermNames.begin()))),
                     condition);
    }
  }
  return all;
}

Found FindWith(Document document, Algorithm algorithm, std::uint32_t seed, int evaluations) {
  document.search.algorithm = algorithm;
  document.search.seed = seed;
  document.search.evaluations = evaluations;
  Found found{.document = {}, .outcome = RunSearchOf(document)};
  document.controllers = {{"found", document.kind, document.senses, document.rules, found.outcome.best}};
  document.timeline = {{.controller = 0, .start_step = 0}};
  document.hash.reset();
  found.document = document;
  return found;
}

double ToppledAt(const Motion& motion) {
  for (int frame = 0; frame < motion.Frames(); ++frame) {
    if (std::abs(motion.At(frame).turn_rad - motion.At(0).turn_rad) > 1.0) return 0.01 * frame;
  }
  return 0.01 * motion.Frames();
}

bool StaysUp(const Document& document) { return TermsOf(document).upright > 0.8f; }

double Rounded(float value, int decimals) {
  const double unit = std::pow(10.0, decimals);
  return std::round(static_cast<double>(value) * unit) / unit;
}

}  // namespace gaitsmith::test
