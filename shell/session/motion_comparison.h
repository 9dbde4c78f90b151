// SPDX-License-Identifier: MIT
// The motion that the shown one is compared with, as a ghost behind it or beside it. It has the same world
// and pushes, except for the comparison with the world as it was opened.
#pragma once

#include <optional>
#include <string>

#include "shell/results/queue_run.h"
#include "shell/results/result_store.h"
#include "shell/results/search_run.h"
#include "shell/session/ghost.h"
#include "shell/session/world_editor.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class MotionComparison {
 public:
  MotionComparison(Workspace& workspace, const WorldEditor& world, const SearchRun& search, QueueRun& queue,
                   const ResultStore& results)
      : workspace_(workspace), world_(world), search_(search), queue_(queue), results_(results) {}

  /// The other motion, if there is one.
  [[nodiscard]] const Ghost& Other() const { return ghost_; }
  /// Empty if there is no other motion.
  [[nodiscard]] std::string Words() const { return ghost_.Words(workspace_.Doc()); }

  /// @param kind  not kFound
  /// @param controller  of the document, for Ghost::Kind::kController
  void Choose(Ghost::Kind kind, int controller = -1);
  /// @return false: there is no such motion, or its figure has another skeleton
  bool ChooseFound(const std::string& id);
  void ShowBeside(bool beside);
  /// Shows the motion of another document of the figure beside this one, with this one's world and pushes.
  void ShowBeside(const Document& other);
  /// Shows a planned motion behind this one, or beside it if another one is. @param planned with a solved
  /// plan
  void ShowPlanned(const Document& planned);
  void Stop();

  /// Compares the shown motion with the best one found in the other control mode for the same figure and
  /// task. If there is no such motion, starts or queues a search for it.
  void CompareControlModes();
  /// Whether the search that CompareControlModes requested is running or queued.
  [[nodiscard]] bool Awaits() const;
  /// Compares the shown motion with a found motion if CompareControlModes requested it.
  /// @param id  among the results, or empty
  void ShowIfRequested(const std::string& id);

  /// Moves the other motion to the shown moment.
  void KeepInTime() { ghost_.Seek(workspace_.Player().TimeS()); }
  /// Call after each new motion.
  void Follow() { ghost_.Load(Documents()); }
  /// The controller whose motion is compared; nothing unless the ghost is a controller of the document.
  [[nodiscard]] std::optional<Controller> ComparedController() const;
  /// Finds the compared controller again after the document's list has changed.
  void FindAgain(const Controller&);

  /// The planned motion if it is the other one, otherwise the shown motion.
  [[nodiscard]] const Playback& PlannedOrShown() const {
    return ghost_.Source() == Ghost::Kind::kPlanned ? *ghost_.Player() : workspace_.Player();
  }

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
  std::optional<Document> requested_;  // the requested search
};

}  // namespace gaitsmith::shell
