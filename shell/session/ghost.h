// SPDX-License-Identifier: MIT
// A second motion of the figure, which the shown one is compared with: behind it or beside it, in time with
// it.
#pragma once

#include <optional>
#include <string>

#include "core/document/document.h"
#include "shell/session/playback.h"

namespace gaitsmith::shell {

class Ghost {
 public:
  enum class Kind {
    kNone,
    kEarlier,     // as it was before the last search
    kAsOpened,    // without what was done to the world
    kController,  // another controller of the document, alone
    kFound,       // a found motion, by its controllers
  };
  /// What it may be the motion of.
  struct Documents {
    const Document& shown;
    const Document& earlier;
    const Document& as_opened;
  };
  /// Simulates it in the shown world, but for kAsOpened. Where its rods hang on another tree, or there is no
  /// such controller, it stands for nothing.
  /// @param kind  not kFound
  /// @param controller  of the document, for kController
  void StandFor(Kind kind, int controller, const Documents&);
  /// @param id  among the found motions, which may lose it: this keeps it
  void StandFor(const std::string& id, const Document& found, const Documents&);
  /// The same once more, after any of the documents has changed.
  void Load(const Documents&);

  [[nodiscard]] Kind StandsFor() const { return kind_; }
  [[nodiscard]] std::optional<int> ControllerIndex() const;
  /// Empty unless it is a found motion.
  [[nodiscard]] std::string FoundId() const { return kind_ == Kind::kFound ? found_id_ : std::string(); }
  /// "without your changes", "timer 3.00 s". @param shown  the open document
  [[nodiscard]] std::string Words(const Document& shown) const;
  /// Null: it stands for nothing.
  [[nodiscard]] const Playback* Player() const { return kind_ == Kind::kNone ? nullptr : &player_; }
  void Seek(double time_s);

  /// Where it is drawn, when there is one.
  void PutBeside(bool beside) { beside_ = beside; }
  [[nodiscard]] bool Beside() const { return beside_ && kind_ != Kind::kNone; }

 private:
  [[nodiscard]] bool Fits(const Documents&) const;

  Kind kind_ = Kind::kNone;
  int controller_ = -1;
  std::string found_id_;
  Document found_;
  Playback player_;
  bool beside_ = false;
};

}  // namespace gaitsmith::shell
