// SPDX-License-Identifier: MIT
// A lesson of docs/lessons as its tests read it: what it says, what it opens, its goal; and what lessons
// measure of motions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

struct Lesson {
  std::map<std::string, std::string> fields;               // of the front matter
  std::string text;                                        // outside of fences, blanks made one
  std::string whole;                                       // with what stands in them
  std::vector<std::string> links;                          // to documents, as paths of the repository
  std::map<std::string, std::vector<std::string>> fences;  // by their word
  int words = 0;
};

/// @param name of its file, without the ending
Lesson LessonOf(const std::string& name);

/// The lesson has this sentence, or part of one, which the next checks are about.
void Says(const Lesson& lesson, const std::string& words);

/// A document of examples/, e.g. "lessons/2-stuck-horse".
Document Shipped(const std::string& path);

Terms TermsOf(const Document& document);

/// What the playground ticks (web/page/goal_conditions.js), for the whole motion.
bool Meets(const std::string& goal, const Document& document);

struct Found {
  Document document;  // with the controller found as its one clip
  Outcome outcome;
};

/// What the page finds with the document's settings and these.
Found FindWith(Document document, Algorithm algorithm, std::uint32_t seed, int evaluations);

/// The first moment at which the root rod leans by more than a radian, or the end of the motion [s].
double ToppledAt(const Motion& motion);

bool StaysUp(const Document& document);

/// As it is written in a lesson: rounded, with so many decimals.
double Rounded(float value, int decimals);

}  // namespace gaitsmith::test
