// SPDX-License-Identifier: MIT
// A second motion of the figure for comparison, behind or beside the shown motion and in time with it.
#pragma once

#include <optional>
#include <string>

#include "core/document/document.h"
#include "shell/workspace/playback.h"

namespace gaitsmith::shell {

class Ghost {
 public:
  enum class Kind {
    kNone,
    kEarlier,     // as it was before the last search
    kAsOpened,    // the motion without the edits of the world
    kController,  // another controller of the document, alone
    kFound,       // the controllers of a found motion
    kPlanned,     // as it is planned between keyframes
  };
  /// The documents that the ghost can take its motion from.
  struct Documents {
    const Document& shown;
    const Document& earlier;
    const Document& as_opened;
  };
  /// Simulates the motion in the shown world; kAsOpened uses its own world. The ghost is empty if the
  /// skeletons differ or the controller does not exist.
  /// @param kind  not kFound or kPlanned
  /// @param controller  of the document, for kController
  void SetSource(Kind kind, int controller, const Documents&);
  /// @param id  of a found motion; the ghost keeps a copy, so the motion may be removed from the results
  void SetSource(const std::string& id, const Document& found, const Documents&);
  /// @param planned  with a solved plan
  void SetPlanned(const Document& planned, const Documents&);
  /// Simulates the same motion again, after a change of any of the documents.
  void Load(const Documents&);

  [[nodiscard]] Kind Source() const { return kind_; }
  [[nodiscard]] std::optional<int> ControllerIndex() const;
  /// Empty unless the ghost is a found motion.
  [[nodiscard]] std::string FoundId() const { return kind_ == Kind::kFound ? found_id_ : std::string(); }
  /// "without your changes", "timer 3.00 s". @param shown  the open document
  [[nodiscard]] std::string Words(const Document& shown) const;
  /// Null if there is no second motion.
  [[nodiscard]] const Playback* Player() const { return kind_ == Kind::kNone ? nullptr : &player_; }
  void Seek(double time_s);

  /// Whether it is drawn beside the shown motion.
  void ShowBeside(bool beside) { beside_ = beside; }
  [[nodiscard]] bool Beside() const { return beside_ && kind_ != Kind::kNone; }

 private:
  [[nodiscard]] bool Fits(const Documents&) const;

  Kind kind_ = Kind::kNone;
  int controller_ = -1;
  std::string found_id_;
  Document found_;
  Document planned_;
  Playback player_;
  bool beside_ = false;
};

}  // namespace gaitsmith::shell
