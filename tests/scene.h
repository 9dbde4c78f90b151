// SPDX-License-Identifier: MIT
// Figures, controllers and documents that tests share. Scenes are the files of examples/, so that they are
// written only once.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::test {

/// The content of a file, by its path in the repository.
std::string ReadFile(const std::string& path);

/// A figure of examples/figures, e.g. "mr-star-man".
Figure ShippedFigure(const std::string& name);

/// The names of all figures of rods in examples/figures, sorted; of springs; of both.
std::vector<std::string> ShippedFigureFiles();
std::vector<std::string> ShippedSpringFiles();
std::vector<std::string> AllShippedFigureFiles();

/// One rod of 1.3 m and 0.7 kg, lying flat.
Figure LyingRod();

/// A figure with random limbs: 2 to 8 rods, lengths 0.3 to 1.2 m, masses 0.2 to 2 kg, any rest angles.
Figure RandomFigure(std::uint64_t seed);

/// A controller with one rule that ignores all senses, so it drives every joint to one pose for ever.
Controller HoldPose(const Figure& figure, const std::vector<float>& target_rad, float tau_s);

/// A random bank of ten rules.
Controller RandomController(const Figure& figure, const SenseSpec& senses, std::uint64_t seed);

/// Simulates with the first model. See Script.
Motion MotionOf(const Figure& figure, const Environment& environment, const StartState& start,
                std::span<const Push> pushes, std::span<const Controller> controllers,
                std::span<const Clip> clips, int steps, float step_s = kStep);

/// The terms of a whole motion.
Terms AtEnd(const Motion&);

/// The names of all golden documents of tests/golden/motions, sorted.
std::vector<std::string> GoldenMotions();
/// The same for joints of limited strength, model 2.
std::vector<std::string> GoldenLimitedMotions();
/// The same for figures of springs, model 3.
std::vector<std::string> GoldenSpringMotions();

/// The documents of examples/, of its gallery and of its lessons, each sorted by name.
std::vector<std::string> ShippedDocuments();
/// Only the documents of the gallery.
std::vector<std::string> GalleryDocuments();
/// Only the documents of the lessons.
std::vector<std::string> LessonDocuments();

/// Problem and search settings of Mr. Star-Man's travel.
Document StarManTravel(SenseKind senses);

/// Mr. Star-Man with two random controllers of physical senses: 2.3 s, then 3 s.
Document TwoClips();

}  // namespace gaitsmith::test
