// SPDX-License-Identifier: MIT
#include "shell/session/commands.h"

#include <utility>

#include "core/document/joints.h"
#include "core/document/json.h"
#include "core/document/json_value.h"
#include "core/document/trial_worlds.h"
#include "shell/embedded/embedded.h"
#include "shell/words/ground_words.h"
#include "shell/words/language.h"
#include "shell/workspace/panels.h"

namespace gaitsmith::shell {
namespace {

// A lock is the first reason why a command is unavailable.
void Lock(std::vector<Command>& list, const Session& session, std::string_view ids, LockedPart part) {
  if (!session.Layout().Locks(part)) return;
  for (Command& command : list) {
    if (command.id.starts_with(ids)) command.why_not = Tr("Locked here: read only.");
  }
}

void AddHistory(std::vector<Command>& list, Session& session) {
  list.push_back({.id = "document/new", .group = TrLater("Document"), .title = Tr("New"), .run = [&session] {
                    session.New();
                  }});
  list.push_back(
      {.id = "document/undo",
       .group = TrLater("Document"),
       .title = Tr("Undo"),
       .keys = {"Ctrl+z"},
       .why_not = session.CanUndo() || (session.Search().Running() && !session.Search().RunsQueued())
                      ? ""
                      : Tr("Nothing to undo."),
       .repeats = true,
       .run = [&session] { session.Undo(); }});
  list.push_back({.id = "document/redo",
                  .group = TrLater("Document"),
                  .title = Tr("Redo"),
                  .keys = {"Ctrl+Shift+z", "Ctrl+y"},
                  .why_not = session.CanRedo() ? "" : Tr("Nothing to redo."),
                  .repeats = true,
                  .run = [&session] { session.Redo(); }});
}

void AddMotion(std::vector<Command>& list, Session& session) {
  Playback& player = session.Player();
  const auto add = [&](const std::string& id, const std::string& title, const std::vector<std::string>& keys,
                       bool repeats, auto run) {
    list.push_back({.id = "motion/" + id,
                    .group = TrLater("Motion"),
                    .title = title,
                    .keys = keys,
                    .repeats = repeats,
                    .run = run});
  };
  add("play", Tr("Play or pause"), {"Space"}, false, [&player] { player.Play(!player.Playing()); });
  add("forward", Tr("One step forward"), {".", "ArrowRight"}, true, [&player] { player.Step(1); });
  add("back", Tr("One step back"), {",", "ArrowLeft"}, true, [&player] { player.Step(-1); });
  add("start", Tr("To the start"), {"Home"}, false, [&player] { player.Seek(0.0); });
  add("end", Tr("To the end"), {"End"}, false, [&player] {
    player.Play(false);
    player.Seek(player.DurationS());
  });
}

void AddSearch(std::vector<Command>& list, Session& session) {
  const bool busy = session.Search().Running() || session.Lab().Running();
  list.push_back({.id = "search/synthesize",
                  .group = TrLater("Search"),
                  .title = Tr("Synthesize, or stop"),
                  .keys = session.Doc().timeline.empty() && !busy ? std::vector<std::string>{"s", "Enter"}
                                                                  : std::vector<std::string>{"s"},
                  .run = [&session, busy] { busy ? session.Stop() : session.Synthesize(); }});
  const bool paused = session.Search().Progress().state == SearchState::kPaused;
  list.push_back(
      {.id = "search/pause",
       .group = TrLater("Search"),
       .title = Tr("Pause or resume the search"),
       .keys = {"p"},
       .why_not = session.Search().Running() ? "" : Tr("No search is running."),
       .run = [&session, paused] { paused ? session.Search().Resume() : session.Search().Pause(); }});
  list.push_back({.id = "search/robust",
                  .group = TrLater("Search"),
                  .title = session.Doc().figure.HasSprings()
                               ? Tr("Make it robust: five worlds")
                               : Tr("Make it robust: limited joints, five worlds"),
                  .why_not = busy ? Tr("A search or the lab is running.") : "",
                  .run = [&session] {
                    if (session.Set([](Document& d) {
                          if (d.model == 1) LimitJoints(d);
                          d.search.worlds = kRobustWorlds;
                        }))
                      session.Synthesize();
                  }});
}

void AddQueue(std::vector<Command>& list, Session& session) {
  const bool none = session.Queue().List().Waiting().empty();
  const std::string full = session.Queue().List().Full() ? Tr("The queue is full.") : "";
  const bool busy = session.Search().Running() || session.Lab().Running();
  list.push_back({.id = "queue/add",
                  .group = TrLater("Search"),
                  .title = Tr("Add this search to the queue"),
                  .keys = {"q"},
                  .why_not = full,
                  .run = [&session] { session.Queue().Add(session.Doc()); }});
  list.push_back({.id = "queue/seeds",
                  .group = TrLater("Search"),
                  .title = Tr("Queue five seeds of this search"),
                  .why_not = full,
                  .run = [&session] { session.Queue().AddSeeds(kQueuedSeeds); }});
  list.push_back({.id = "queue/run",
                  .group = TrLater("Search"),
                  .title = Tr("Run the queue"),
                  .why_not = none   ? Tr("The queue is empty.")
                             : busy ? Tr("A search or the lab is running.")
                                    : "",
                  .run = [&session] { session.Queue().Run(); }});
  list.push_back({.id = "queue/clear",
                  .group = TrLater("Search"),
                  .title = Tr("Clear the queue"),
                  .why_not = none ? Tr("The queue is empty.") : "",
                  .run = [&session] { session.Queue().List().Clear(); }});
}

void AddFound(std::vector<Command>& list, Session& session) {
  list.push_back({.id = "found/keep",
                  .group = TrLater("Results"),
                  .title = Tr("Save this motion to the results"),
                  .keys = {"k"},
                  .why_not = session.Doc().timeline.empty() ? Tr("There is no motion yet.") : "",
                  .run = [&session] { session.Results().KeepShown(); }});
  const FoundMotions::Entry* best = session.Results().Motions().Best(session.Doc());
  list.push_back({.id = "found/best",
                  .group = TrLater("Results"),
                  .title = Tr("Show the best result for this figure and task"),
                  .why_not = best == nullptr ? Tr("There are no results yet.") : "",
                  .run = [&session, id = best == nullptr ? "" : best->id] { session.ShowFound(id); }});
  list.push_back(
      {.id = "found/bring-back",
       .group = TrLater("Results"),
       .title = Tr("Bring back the deleted result"),
       .why_not = session.Results().Motions().Removed() == nullptr ? Tr("No result was deleted.") : "",
       .run = [&session] { session.Results().Motions().BringBack(); }});
}

void AddTimeline(std::vector<Command>& list, Session& session) {
  const auto clips = static_cast<int>(session.Doc().timeline.size());
  const int selected = session.Timeline().Selected();
  const char* none = clips > 0 ? "" : Tr("There is no motion yet.");
  const char* one = clips > 1 ? "" : Tr("There is only one clip.");
  const auto add = [&](const char* id, const char* title, const std::vector<std::string>& keys,
                       const char* why_not, auto run) {
    list.push_back({.id = std::string("timeline/") + id,
                    .group = TrLater("Timeline"),
                    .title = title,
                    .keys = keys,
                    .why_not = why_not,
                    .run = run});
  };
  add("split", Tr("Split the clip at the moment shown"), {"b"}, none,
      [&session] { session.Timeline().SplitClip(); });
  add("duplicate", Tr("Duplicate the selected clip"), {"d"}, none,
      [&session] { session.Timeline().DuplicateClip(); });
  add("mirror", Tr("Mirror the selected clip: it goes the other way"), {"m"}, none,
      [&session] { session.Timeline().MirrorClip(); });
  add("add", Tr("Add the selected clip once more at the end"), {}, none,
      [&session] { session.Timeline().AddClip(); });
  add("earlier", Tr("Move the selected clip earlier"), {"["},
      clips > 1 && selected == 0 ? Tr("This clip is the first.") : one,
      [&session] { session.Timeline().ReorderClip(session.Timeline().Selected() - 1); });
  add("later", Tr("Move the selected clip later"), {"]"},
      clips > 1 && selected == clips - 1 ? Tr("This clip is the last.") : one,
      [&session] { session.Timeline().ReorderClip(session.Timeline().Selected() + 1); });
  add("loop", Tr("Repeat the whole timeline"), {}, none, [&session] { session.Timeline().Repeat(); });
  add("record", Tr("Record the motion as curves, and show both side by side"), {},
      session.Doc().figure.HasSprings() ? Tr("Recording as curves is for figures of rods.") : none,
      [&session] { session.RecordAsCurves(); });
  add("keyframes", Tr("Plan a motion between keyframes"), {}, session.Keyframes().WhyNot(),
      [&session] { session.OpenKeyframes(); });
  add("track", Tr("Track the planned motion by rules"), {},
      session.Doc().plan.solved.unknowns.empty() ? Tr("No motion is planned between keyframes.") : "",
      [&session] { session.TrackKeyframes(); });
  add("repair", Tr("Repair the selected clip: search from where it takes over"), {"r"},
      session.Timeline().CanRepair() ? "" : Tr("The first clip takes over from no other clip."),
      [&session] { session.Timeline().RepairClip(); });
  add("snap-to-best", Tr("Snap to best: move the switch to the nearest good moment"), {},
      session.Timeline().WhyNoSnap(), [&session] { session.Timeline().SnapToBest(); });
  add("remove", Tr("Remove the selected clip"), {}, one, [&session] { session.Timeline().RemoveClip(); });
}

void AddGround(std::vector<Command>& list, Session& session) {
  GroundEditor& ground = session.Ground();
  for (int i = 0; i < kGroundPresets; ++i) {
    const auto preset = static_cast<GroundPreset>(i);
    const bool rubble = preset == GroundPreset::kRubble;
    list.push_back({.id = "world/ground/" + std::string(kGroundPresetNames[static_cast<std::size_t>(i)]),
                    .group = TrLater("World"),
                    .title = rubble ? Tr("Ground: other rubble")
                                    : Tr("Ground: {1}", Tr(GroundNames()[static_cast<std::size_t>(i)])),
                    .run = [&ground, preset, rubble] {
                      rubble ? ground.ChooseOtherRubble() : ground.Choose(preset, 1);
                    }});
  }
  const bool drawing = ground.Drawing();
  list.push_back({.id = "world/ground/draw",
                  .group = TrLater("World"),
                  .title = Tr(drawing ? "End drawing the ground" : "Draw the ground on the stage"),
                  .run = [&ground, drawing] { ground.Draw(!drawing); }});
  if (!drawing) return;
  const auto chosen = ground.Chosen();
  list.push_back({.id = "world/ground/remove",
                  .group = TrLater("World"),
                  .title = Tr("Remove the chosen corner of the ground"),
                  .keys = {"Delete", "Backspace"},
                  .why_not = chosen ? "" : Tr("No corner is chosen."),
                  .run = [&ground, chosen] { ground.RemoveCorner(*chosen); }});
}

void AddPanels(std::vector<Command>& list, Session& session, bool phone) {
  for (int i = 0; i < static_cast<int>(kPanels.size()); ++i) {
    const PanelRow& panel = kPanels[static_cast<std::size_t>(i)];
    if (!(phone || panel.tab_on_desk) || !session.Layout().Shows(i)) continue;
    const char* name = panel.label;
    list.push_back({.id = std::string("panel/") + name,
                    .group = TrLater("Panels"),
                    .title = Tr("{1} panel", Tr(name)),
                    .keys = {std::to_string(i + 1)},
                    .run = [&session, number = panel.Number()] {
                      session.SetView([number](View& view) { view.panel = number; });
                    }});
  }
}

void AddView(std::vector<Command>& list, Session& session) {
  const auto add = [&](const std::string& id, const char* show, const char* hide, bool View::* shown) {
    const bool now = session.Doc().view.*shown;
    list.push_back({.id = "view/" + id,
                    .group = TrLater("View"),
                    .title = Tr(now ? hide : show),
                    .run = [&session, shown, now] {
                      session.SetView([shown, now](View& view) { view.*shown = !now; });
                    }});
  };
  add("poses", TrLater("Show past poses"), TrLater("Hide past poses"), &View::poses);
  add("trail", TrLater("Show the path of the centre of mass"), TrLater("Hide the path of the centre of mass"),
      &View::trail);
  add("forces", TrLater("Show contact forces"), TrLater("Hide contact forces"), &View::forces);
  if (HasLimitedJoints(session.Doc())) {
    add("torques", TrLater("Show the torques of the joints"), TrLater("Hide the torques of the joints"),
        &View::torques);
  }
  list.push_back({.id = "view/simple",
                  .group = TrLater("View"),
                  .title = Tr(session.Simple() ? "Show all settings" : "Show only goal, senses and effort"),
                  .run = [&session] { session.ShowAll(session.Simple()); }});
  const bool live = session.Following().On();
  list.push_back({.id = "view/live",
                  .group = TrLater("View"),
                  .title = Tr(live ? "Live: stop searching on as you change something"
                                   : "Live: search on as you change something"),
                  .run = [&session, live] { session.Following().Switch(!live); }});
  const bool beside = session.Comparison().Other().Beside();
  list.push_back(
      {.id = "view/compare",
       .group = TrLater("View"),
       .title = Tr(beside ? "Stop comparing side by side" : "Compare timer and senses side by side"),
       .why_not = session.Timeline().ShownController() == nullptr ? Tr("There is no motion yet.") : "",
       .run = [&session, beside] {
         beside ? session.Comparison().Stop() : session.Comparison().CompareControlModes();
       }});
}

}  // namespace

std::vector<Command> CommandsOf(Session& session, bool phone) {
  std::vector<Command> list;
  AddHistory(list, session);
  AddMotion(list, session);
  AddSearch(list, session);
  AddQueue(list, session);
  AddFound(list, session);
  AddTimeline(list, session);
  AddGround(list, session);
  AddPanels(list, session, phone);
  AddView(list, session);
  Lock(list, session, "timeline/", LockedPart::kTimeline);
  Lock(list, session, "world/", LockedPart::kWorld);
  for (const LockedPart part : {LockedPart::kWorld, LockedPart::kSearch})
    Lock(list, session, "search/robust", part);
  return list;
}

std::vector<Command> ShelfOf(Session& session) {
  std::vector<Command> list;
  for (const Example& example : ExampleDocuments()) {
    auto document = DecodeJson(example.json);
    if (!document) continue;
    list.push_back({.id = "example/" + std::string(example.name),
                    .group = TrLater("Examples"),
                    .title = Tr("Open example: {1}", TrTitle(document->title)),
                    .run = [&session, document = std::move(*document)] { session.ChooseExample(document); }});
  }
  int index = 0;
  for (const Document& problem : session.Shipped().Problems()) {
    list.push_back({.id = "task/" + std::to_string(index),
                    .group = TrLater("Tasks"),
                    .title = Tr("Choose task: {1}", TrTitle(problem.title)),
                    .run = [&session, index] { session.ChooseProblem(index); }});
    ++index;
  }
  index = 0;
  for (const Figure& figure : session.Shipped().Figures()) {
    list.push_back({.id = "figure/" + std::to_string(index),
                    .group = TrLater("Figures"),
                    .title = Tr("Choose figure: {1}", TrTitle(figure.name)),
                    .run = [&session, index] { session.ChooseFigure(index); }});
    ++index;
  }
  Lock(list, session, "task/", LockedPart::kStyle);
  Lock(list, session, "figure/", LockedPart::kFigure);
  return list;
}

std::string CommandsJson(const std::vector<Command>& commands) {
  std::string json = "[";
  for (const Command& command : commands) {
    if (json.size() > 1) json += ",\n";
    json += "{\"id\":" + QuoteJson(command.id) + ",\"group\":" + QuoteJson(command.group) +
            ",\"title\":" + QuoteJson(command.title) + ",\"whyNot\":" + QuoteJson(command.why_not) +
            ",\"keys\":[";
    for (std::size_t i = 0; i < command.keys.size(); ++i)
      json += (i > 0 ? "," : "") + QuoteJson(command.keys[i]);
    json += "]}";
  }
  return json + "]";
}

bool BelongsToControls(std::string_view key) {
  return key == "Space" || key == "Enter" || key == "Home" || key == "End" || key.starts_with("Arrow");
}

}  // namespace gaitsmith::shell
