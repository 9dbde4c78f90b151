// SPDX-License-Identifier: MIT
// A lesson of docs/lessons for its tests: its text, documents and goal. Also the measurements that lessons
// mention.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

struct Lesson {
  std::map<std::string, std::string> fields;               // of the front matter
  std::string text;                                        // outside of fences, white space collapsed
  std::string whole;                                       // including the text in fences
  std::vector<std::string> links;                          // to documents, as paths in the repository
  std::map<std::string, std::vector<std::string>> fences;  // by the word after the fence
  int words = 0;
};

/// @param name of its file, without the extension
Lesson LessonOf(const std::string& name);

/// Checks that the lesson contains a sentence, or part of one, which the next checks are about.
void Says(const Lesson& lesson, const std::string& words);

/// A document of examples/, e.g. "lessons/2-stuck-horse".
Document Shipped(const std::string& path);

Terms TermsOf(const Document& document);

/// A condition of a goal, as web/page/goal_conditions.js reads it.
struct Condition {
  std::string name, relation, wanted;
};
std::vector<Condition> ConditionsOf(const std::string& goal);
bool Compare(double has, const Condition& condition);

/// Whether the whole motion meets those conditions of a goal that a motion alone can meet. The others, such
/// as "controller = new", are those of lesson_goals_test.cpp.
bool Reaches(const std::string& goal, const Document& document);

struct Found {
  Document document;  // with the found controller as its only clip
  Outcome outcome;
};

/// The result of the page's search with the document's settings and these.
Found FindWith(Document document, Algorithm algorithm, std::uint32_t seed, int evaluations);

/// The first time at which the root rod leans by more than one radian, or the end of the motion [s].
double ToppledAt(const Motion& motion);

bool StaysUp(const Document& document);

/// Rounded to a number of decimals, as in a lesson.
double Rounded(float value, int decimals);

}  // namespace gaitsmith::test
