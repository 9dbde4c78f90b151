// SPDX-License-Identifier: MIT
// A visit to a lesson: its document is open in a session, and a reader, or the lesson's buttons and links, do
// one thing after another. tests/examples/lesson_goals.json lists visits.
#pragma once

#include <string>

#include "core/document/json_value.h"
#include "tests/lesson.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::test {

class LessonVisit {
 public:
  explicit LessonVisit(const Lesson& lesson);

  /// @param step  an object with one member: what is done, and with what
  void Do(const JsonValue& step);
  /// Whether the page would show the goal as reached (web/page/goal_conditions.js).
  [[nodiscard]] bool Meets(const std::string& goal) const;
  [[nodiscard]] const Document& Doc() const { return session_.Doc(); }

 private:
  void Open(const std::string& path);
  /// Runs the search that the session has just started, to its end.
  void EndSearch();
  void Snap(int expected_step);
  /// Breeds generations. The two children that turn over most become the next parents, and the best of the
  /// last generation is watched.
  void Breed(int generations);

  shell::test::QuietHost host_;
  shell::Session session_;
};

}  // namespace gaitsmith::test
