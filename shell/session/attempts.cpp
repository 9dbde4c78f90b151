// SPDX-License-Identifier: MIT
#include "shell/session/attempts.h"

#include <algorithm>

namespace gaitsmith::shell {
namespace {

constexpr double kEveryS = 0.12;  // shortest time between two attempts
constexpr double kStayS = 3.0;    // after the end of the search
constexpr double kFadeS = 0.8;

}  // namespace

void Attempts::Begin(const Document& searched) {
  shown_.clear();
  searched_ = searched;
  searched_.timeline = {{.controller = 0, .start_step = 0}};
  searched_.duration_steps = searched.task.duration_steps;
  added_s_ = ended_s_ = 0.0;
  strength_ = 1.0f;
}

void Attempts::Add(const Genome& genes, double now_s) {
  if (genes.empty() || now_s - added_s_ < kEveryS) return;
  added_s_ = now_s;
  Document tried = searched_;
  tried.controllers = {TakeFound(searched_, genes, tried)};
  if (!Validate(tried)) return;  // a report that does not fit the search
  if (shown_.size() == kMost) shown_.pop_front();
  shown_.emplace_back().Load(tried, true);
  if (shown_.back().Shown().TermsAt(shown_.back().Shown().Frames() - 1).broke_physics) shown_.pop_back();
}

void Attempts::End(double now_s) {
  if (ended_s_ == 0.0) ended_s_ = now_s;
}

void Attempts::Follow(double time_s, double now_s) {
  if (ended_s_ > 0.0) {
    strength_ = static_cast<float>(std::clamp((ended_s_ + kStayS - now_s) / kFadeS, 0.0, 1.0));
    if (strength_ <= 0.0f) shown_.clear();
  }
  for (Playback& one : shown_) one.Seek(time_s);
}

}  // namespace gaitsmith::shell
