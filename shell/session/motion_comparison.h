// SPDX-License-Identifier: MIT
// What the shown motion is compared with, behind it as a ghost or beside it: a second motion in the same
// world, with the same pushes, but for the one in the world as it was opened.
#pragma once

#include <optional>
#include <string>

#include "shell/session/ghost.h"
#include "shell/session/queue_run.h"
#include "shell/session/result_store.h"
#include "shell/session/search_run.h"
#include "shell/session/workspace.h"
#include "shell/session/world_editor.h"

namespace gaitsmith::shell {

class MotionComparison {
 public:
  MotionComparison(Workspace& workspace, const WorldEditor& world, const SearchRun& search, QueueRun& queue,
                   const ResultStore& results)
      : workspace_(workspace), world_(world), search_(search), queue_(queue), results_(results) {}

  /// The other motion, if there is one.
  [[nodiscard]] const Ghost& Other() const { return ghost_; }
  /// Empty: there is none.
  [[nodiscard]] std::string Words() const { return ghost_.Words(workspace_.Doc()); }

  /// @param kind  not kFound
  /// @param controller  of the document, for Ghost::Kind::kController
  void Choose(Ghost::Kind kind, int controller = -1);
  /// @return false: there is no such motion, or its figure is another tree of rods
  bool ChooseFound(const std::string& id);
  void PutBeside(bool beside);
  void Stop();

  /// Beside the shown motion the best one that was found in the other control mode, for the same figure and
  /// task. When there is none, a search for one begins, or waits in the queue.
  void CompareControlModes();
  /// The search that CompareControlModes has ordered runs or waits.
  [[nodiscard]] bool Awaits() const;
  /// Puts a found motion beside the shown one, if it is what CompareControlModes has ordered.
  /// @param id  among the results, or empty
  void ShowIfOrdered(const std::string& id);

  /// The other motion goes to the moment that is shown.
  void KeepInTime() { ghost_.Seek(workspace_.Player().TimeS()); }
  /// After each new motion.
  void Follow() { ghost_.Load(Documents()); }
  /// The controller that stands alone beside the shown motion; nothing: something else does.
  [[nodiscard]] std::optional<Controller> ComparedController() const;
  /// The controller may have moved up in the document's list.
  void FindAgain(const Controller&);

 private:
  [[nodiscard]] Ghost::Documents Documents() const {
    return {.shown = workspace_.Doc(), .earlier = search_.Before(), .as_opened = world_.AsOpened()};
  }

  Workspace& workspace_;
  const WorldEditor& world_;
  const SearchRun& search_;
  QueueRun& queue_;
  const ResultStore& results_;
  Ghost ghost_;
  std::optional<Document> ordered_;  // the search whose motion is to stand beside
};

}  // namespace gaitsmith::shell
