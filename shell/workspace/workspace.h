// SPDX-License-Identifier: MIT
// The open document: its validity, edits, history, playback and selected clip. The parts of a session share
// the document only through this interface.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/document/document.h"
#include "core/document/parts.h"
#include "shell/workspace/arrangement.h"
#include "shell/workspace/history.h"
#include "shell/workspace/host.h"
#include "shell/workspace/playback.h"

namespace gaitsmith::shell {

class Workspace {
 public:
  using Edit = std::function<void(Document&)>;

  explicit Workspace(Host& host) : host_(host) {}
  // The parts of a session hold references to it.
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// Called after each change of the document, before the host.
  struct Followers {
    std::function<void(bool opened)> motion;    // @param opened another document replaced the present one
    std::function<void()> settings;             // also called when another clip is selected
    std::function<void(Parts changed)> edited;  // after an edit by Change or Set
  };
  void SetFollowers(Followers followers) { followers_ = std::move(followers); }

  [[nodiscard]] Host& TheHost() const { return host_; }
  /// The document, always valid. It keeps its maker's hash until an edit changes the motion.
  [[nodiscard]] const Document& Doc() const { return document_; }
  /// The document with the hash of its own motion, not of a preview's.
  [[nodiscard]] Document WithHash() const;
  [[nodiscard]] bool DiffersFromMaker() const { return differs_from_maker_; }
  [[nodiscard]] Playback& Player() { return player_; }
  [[nodiscard]] const Playback& Player() const { return player_; }
  [[nodiscard]] Arrangement& Layout() { return layout_; }
  [[nodiscard]] const Arrangement& Layout() const { return layout_; }

  /// The selected clip. Its controller is shown, and a search replaces it.
  [[nodiscard]] int SelectedClip() const { return selected_clip_; }
  /// @param clip any number: the nearest clip is selected
  void SelectClip(int clip);
  /// Null if there is no motion.
  [[nodiscard]] const Controller* ShownController() const;

  /// See Session. Both clear the status line. Callers that have something to say do so afterwards.
  bool Change(const Edit&);
  bool Set(const Edit&);
  void SetView(const std::function<void(View&)>&);
  /// The document after an edit; nothing, and a sentence for the reader, if it would be invalid.
  [[nodiscard]] std::optional<Document> Edited(const Edit&);
  /// Whether a lock forbids replacing the document by `next`. If so, shows a sentence.
  [[nodiscard]] bool Refuses(const Arrangement& locks, const Document& next);
  /// Replaces the document and simulates it. The caller updates the history.
  /// @param opened  playback starts over, and resetting the world returns to this document's world
  void Show(Document, bool opened);

  /// Plays the document's motion with these genes of the shown controller. The document keeps its own. Until
  /// EndPreview, and until another document is opened. @return false: they do not fit
  bool Preview(Genome genes);
  void EndPreview();
  [[nodiscard]] bool Previews() const { return !previewed_.empty(); }
  /// The genes of the preview; empty: there is none.
  [[nodiscard]] const Genome& Previewed() const { return previewed_; }

  /// Starts a new occasion for Undo: a person's next gesture, or all improvements of one search.
  void BeginGesture() { gesture_ = NewOccasion(); }
  [[nodiscard]] int NewOccasion() { return ++occasions_; }
  [[nodiscard]] int Gesture() const { return gesture_; }
  /// Saves the present document for Undo, once per occasion.
  void Remember() { Remember(gesture_); }
  void Remember(int occasion) { history_.Keep(document_, occasion); }
  [[nodiscard]] bool CanUndo() const { return history_.CanUndo(document_); }
  [[nodiscard]] bool CanRedo() const { return history_.CanRedo(); }
  /// The document one step back or forward. The caller shows it.
  [[nodiscard]] std::optional<Document> TakeBack() { return history_.Back(document_); }
  [[nodiscard]] std::optional<Document> TakeForward() { return history_.Forward(document_); }
  void ForgetPast() { history_.Clear(); }
  [[nodiscard]] History& Past() { return history_; }
  [[nodiscard]] const History& Past() const { return history_; }

  /// Shows a sentence in the status line and on the panel.
  void Say(std::string sentence);
  /// Shows a sentence in the status line only: what has just happened. Empty: clears both, so that no
  /// sentence of an earlier action stays.
  void Report(const std::string& sentence);
  /// Clears a sentence of an earlier gesture. For changes that also happen without one, as at the end of a
  /// search.
  void ClearEarlier() {
    if (said_ != gesture_) Report("");
  }
  /// The last sentence of Say, or empty.
  [[nodiscard]] std::string& Notice() { return notice_; }
  /// Requests a new picture of the unchanged document.
  void Redraw() { host_.DocumentChanged(document_.title); }

 private:
  /// The document whose motion is played.
  [[nodiscard]] Document Played() const;

  Host& host_;
  Followers followers_;
  Document document_;
  Genome previewed_;
  bool differs_from_maker_ = false;
  int selected_clip_ = 0;
  Arrangement layout_;
  Playback player_;
  History history_;
  int occasions_ = 1;  // number of the last occasion
  int gesture_ = 1;
  std::string notice_;
  int said_ = 0;  // gesture of the last sentence
};

}  // namespace gaitsmith::shell
