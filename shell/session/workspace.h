// SPDX-License-Identifier: MIT
// The open document and what is done at it: its validity, its edits, its history, its playback and the
// selected clip. The parts of a session work on it through this interface alone, and know each other only in
// one direction.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/document/document.h"
#include "shell/session/arrangement.h"
#include "shell/session/history.h"
#include "shell/session/host.h"
#include "shell/session/playback.h"

namespace gaitsmith::shell {

class Workspace {
 public:
  using Edit = std::function<void(Document&)>;

  explicit Workspace(Host& host) : host_(host) {}
  // The parts of a session refer to it.
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// What follows the document, called after each change of it and before the host is.
  struct Followers {
    std::function<void(bool opened)> motion;  // opened: another document took its place
    std::function<void()> settings;           // also: another clip is selected
  };
  void SetFollowers(Followers followers) { followers_ = std::move(followers); }

  [[nodiscard]] Host& TheHost() const { return host_; }
  /// Valid. Its hash is as its maker saw it, until something that the motion depends on changes.
  [[nodiscard]] const Document& Doc() const { return document_; }
  /// With the present motion's hash.
  [[nodiscard]] Document WithHash() const;
  [[nodiscard]] bool DiffersFromMaker() const { return differs_from_maker_; }
  [[nodiscard]] Playback& Player() { return player_; }
  [[nodiscard]] const Playback& Player() const { return player_; }
  [[nodiscard]] Arrangement& Layout() { return layout_; }

  /// One clip is selected: its controller is shown, and a search replaces it.
  [[nodiscard]] int SelectedClip() const { return selected_clip_; }
  /// @param clip any number: the nearest clip is selected
  void SelectClip(int clip);
  /// Null: there is no motion.
  [[nodiscard]] const Controller* ShownController() const;

  /// As Session has them.
  bool Change(const Edit&);
  bool Set(const Edit&);
  void SetView(const std::function<void(View&)>&);
  /// The present document after an edit, or nothing and a sentence when that is invalid.
  [[nodiscard]] std::optional<Document> Edited(const Edit&);
  /// Locks that do not let a document take the place of the present one. Says so.
  [[nodiscard]] bool Refuses(const Arrangement& locks, const Document& next);
  /// Another document, simulated anew. What history keeps is the caller's concern.
  /// @param opened  playback starts over, and the world of this document is what a reset goes back to
  void Show(Document, bool opened);

  /// What the next changes belong to, for Undo: a person's next gesture, or all that one search finds.
  void BeginGesture() { gesture_ = NewOccasion(); }
  [[nodiscard]] int NewOccasion() { return ++occasions_; }
  /// Keeps the present document for Undo, once on each occasion.
  void Remember() { Remember(gesture_); }
  void Remember(int occasion) { history_.Keep(document_, occasion); }
  [[nodiscard]] bool CanUndo() const { return history_.CanUndo(document_); }
  [[nodiscard]] bool CanRedo() const { return history_.CanRedo(); }
  /// The document one step back or forward, which is then shown by the caller.
  [[nodiscard]] std::optional<Document> TakeBack() { return history_.Back(document_); }
  [[nodiscard]] std::optional<Document> TakeForward() { return history_.Forward(document_); }
  void ForgetPast() { history_.Clear(); }

  /// A sentence for the reader, in the status line and on the panel.
  void Say(std::string sentence);
  /// The last one, or empty.
  [[nodiscard]] std::string& Notice() { return notice_; }
  /// Another picture, though of the same document.
  void Redraw() { host_.DocumentChanged(document_.title); }

 private:
  Host& host_;
  Followers followers_;
  Document document_;
  bool differs_from_maker_ = false;
  int selected_clip_ = 0;
  Arrangement layout_;
  Playback player_;
  History history_;
  int occasions_ = 1;  // so far
  int gesture_ = 1;
  std::string notice_;
};

}  // namespace gaitsmith::shell
