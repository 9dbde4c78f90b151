// SPDX-License-Identifier: MIT
// The bridge between the canvas and the page.
//
// The page calls the gs_ functions below, and those of page_reports.cpp, page_hints.cpp and
// page_typeface.cpp. Text is UTF-8, and returned text is valid until the next call. The page provides, as
// Module.page, the functions that page_host.h declares and page.library.js forwards.
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/document/json.h"
#include "core/document/json_value.h"
#include "core/document/link.h"
#include "shell/app/app.h"
#include "shell/host/frame_pace.h"
#include "shell/host/page_host.h"
#include "shell/host/page_session.h"
#include "shell/host/script_answers.h"
#include "shell/host/script_options.h"
#include "shell/session/commands.h"
#include "shell/session/moment_words.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

// State with the lifetime of the page.
struct Page {
  std::unique_ptr<Window> window;
  WebHost host;
  std::unique_ptr<App> app;
  std::string reply;
  std::string mirrored;  // the last non-empty result of gs_mirror
  double before_ms = 0.0;
  FramePace pace;
  bool moved = false;  // since the last drawn frame
  double width = 0.0;
  double height = 0.0;
  double density = 0.0;
};

// A global, because the C functions that the page calls take no object.
Page& ThePage() {
  static Page page;
  return page;
}

}  // namespace

Session& TheSession() { return ThePage().app->State(); }
Window& TheWindow() { return *ThePage().window; }

namespace {

// Replies to a frequent query, without requesting a frame.
const char* QuietReply(std::string text) {
  ThePage().reply = std::move(text);
  return ThePage().reply.c_str();
}

const char* Reply(std::string text) {
  ThePage().window->RequestFrame();
  return QuietReply(std::move(text));
}

// Runs a script's action. Locks apply only to a person's edits.
template <class Deed>
void WithoutLocks(Deed deed) {
  Arrangement& locks = TheSession().Layout();
  const Arrangement kept = std::exchange(locks, {});
  deed();
  locks = kept;
}

// CSS sets the canvas's size, but SDL is only notified of size changes of the browser window.
void FollowCanvas(Page& page) {
  double width = 0.0;
  double height = 0.0;
  emscripten_get_element_css_size("#canvas", &width, &height);
  const double density = emscripten_get_device_pixel_ratio();
  if (width == page.width && height == page.height && density == page.density) return;
  page.width = width;
  page.height = height;
  page.density = density;
  page.window->SetSize(static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height)));
}

// @return 0: the widget is not on the canvas, or disabled
int Request(WidgetRequest request) {
  WidgetRegistry& registry = ThePage().window->Registry();
  const Widget* widget = registry.Find(request.id);
  const bool moves = request.kind != WidgetRequest::Kind::kFocus;
  if (widget == nullptr || (moves && widget->state.disabled)) return 0;
  registry.Requests().Add(std::move(request));
  ThePage().window->RequestFrame();
  return 1;
}

void Tick(void* argument) {
  Page& page = *static_cast<Page*>(argument);
  FollowCanvas(page);
  page.window->TakeEvents(0, [&page](const SDL_Event& event) { return page.app->Take(event); });
  const double now_ms = emscripten_get_now();
  page.moved |= page.app->Advance((now_ms - page.before_ms) / 1000.0);
  page.before_ms = now_ms;
  // A step this long has simulated a search's new best. Drawing in the same step would double the delay.
  constexpr double kLongMs = 6.0;
  if (emscripten_get_now() - now_ms > kLongMs) return;
  if (!page.moved && !page.window->NeedsFrame()) return;
  // A search must not delay the response to input.
  Session& session = page.app->State();
  const bool searching =
      (session.Search().Running() || session.Lab().Running()) && !page.window->OwesResponse();
  if (!page.pace.Due(now_ms, searching)) return;
  page.moved = false;
  page.window->Draw([&page] { page.app->Draw(); });
  page.pace.Drawn(now_ms);
}

}  // namespace
}  // namespace gaitsmith::shell

using namespace gaitsmith;         // NOLINT: the functions below have no namespace
using namespace gaitsmith::shell;  // NOLINT

extern "C" {

/// @return 0: WebGL is unavailable, and no other function may be called
EMSCRIPTEN_KEEPALIVE int gs_running() { return ThePage().app ? 1 : 0; }

/// Opens JSON, a link or the payload of a link. @param bred  from the open document
/// @return an empty text, or a sentence with the error and its location
EMSCRIPTEN_KEEPALIVE const char* gs_open(const char* text, int bytes, int bred) {
  const auto opened = TheSession().Open({text, static_cast<std::size_t>(bytes)},
                                        bred != 0 ? OpenedFrom::kBreeding : OpenedFrom::kOutside);
  return Reply(opened ? "" : TrError(opened.error()));
}

EMSCRIPTEN_KEEPALIVE const char* gs_document_json() { return Reply(EncodeJson(TheSession().WithHash())); }
/// The payload of a link, without an address.
EMSCRIPTEN_KEEPALIVE const char* gs_link() {
  // Uses the known hash, to avoid simulating the motion again.
  const Document& document = TheSession().Doc();
  return Reply(EncodeLink(document.hash ? document : TheSession().WithHash()));
}
/// The hash of the shown motion, 16 hexadecimal digits.
EMSCRIPTEN_KEEPALIVE const char* gs_hash() { return Reply(HashText(TheSession().Player().Shown().Hash())); }
EMSCRIPTEN_KEEPALIVE const char* gs_title() { return Reply(TrTitle(TheSession().Doc().title)); }

/// Every visible widget of the last frame, as a JSON list.
EMSCRIPTEN_KEEPALIVE const char* gs_widgets() { return QuietReply(ThePage().window->Registry().Json()); }

/// All widgets, including those out of view, as WidgetRegistry::MirrorJson; empty: unchanged since the last
/// call.
EMSCRIPTEN_KEEPALIVE const char* gs_mirror() {
  std::string now = ThePage().window->Registry().MirrorJson();
  if (now == ThePage().mirrored) return "";
  ThePage().mirrored = std::move(now);
  return ThePage().mirrored.c_str();
}

// Requests to widgets. The widget handles a request in the next frame.
// @return 0: the widget is not on the canvas, or disabled
// @param again  continues the last request, as a held key does, so that Undo takes both as one step
/// Activates a widget, as a click does.
EMSCRIPTEN_KEEPALIVE int gs_activate(const char* id) {
  return Request({.id = id, .kind = WidgetRequest::Kind::kPress});
}
/// Steps a widget's value, as arrow keys do.
EMSCRIPTEN_KEEPALIVE int gs_step(const char* id, int steps, int again) {
  return Request({.id = id,
                  .kind = WidgetRequest::Kind::kStep,
                  .number = static_cast<double>(steps),
                  .begins = again == 0});
}
/// @param value  in WidgetRange
EMSCRIPTEN_KEEPALIVE int gs_set_value(const char* id, double value, int again) {
  return Request({.id = id, .kind = WidgetRequest::Kind::kSet, .number = value, .begins = again == 0});
}
/// @param ring  show the focus ring
EMSCRIPTEN_KEEPALIVE int gs_focus(const char* id, int ring) {
  return Request({.id = id, .kind = WidgetRequest::Kind::kFocus, .ring = ring != 0, .begins = false});
}
/// The focus is elsewhere on the page: hides the focus ring on the canvas.
EMSCRIPTEN_KEEPALIVE void gs_unfocus() {
  ImGui::GetCurrentContext()->NavDisableHighlight = true;
  ThePage().window->RequestFrame();
}
/// Closes an open list, or ends drawing the ground. @return 0: there is nothing to end
EMSCRIPTEN_KEEPALIVE int gs_dismiss() {
  const bool list = ImGui::GetCurrentContext()->OpenPopupStack.Size > 0;
  if (list) ImGui::ClosePopupToLevel(0, true);
  if (!list && !ThePage().app->EndDrawing()) return 0;
  ThePage().window->RequestFrame();
  return 1;
}

/// Describes the shown moment in words, short or in full.
EMSCRIPTEN_KEEPALIVE const char* gs_moment() { return QuietReply(MomentWords(TheSession())); }
EMSCRIPTEN_KEEPALIVE const char* gs_description() { return QuietReply(DescriptionOf(TheSession())); }
EMSCRIPTEN_KEEPALIVE int gs_playing() { return TheSession().Player().Playing() ? 1 : 0; }

/// @param palette of kPaletteNames; another name keeps the present one @param scale of texts and controls
EMSCRIPTEN_KEEPALIVE void gs_set_theme(const char* palette, double scale) {
  Window& window = *ThePage().window;
  const auto name = std::ranges::find(kPaletteNames, std::string_view(palette));
  if (name != kPaletteNames.end()) window.SetPalette(static_cast<PaletteName>(name - kPaletteNames.begin()));
  window.SetScale(static_cast<float>(std::clamp(scale, 0.5, 4.0)));
}

/// Sets the language of all texts. @param table of shell/words/languages, as JSON; empty: English
/// @return 0: it is not such a table, and nothing has changed
EMSCRIPTEN_KEEPALIVE int gs_set_language(const char* table) {
  if (!SetLanguage(table)) return 0;
  Page& page = ThePage();
  if (!page.app) return 1;
  page.host.DocumentChanged(TheSession().Doc().title);
  page.window->RequestFrame();
  return 1;
}

/// Sets the greatest frame rate; 0: that of the display.
EMSCRIPTEN_KEEPALIVE void gs_set_frame_rate(double per_second) { ThePage().pace.Limit(per_second); }

EMSCRIPTEN_KEEPALIVE void gs_play(int playing) {
  TheSession().Player().Play(playing != 0);
  ThePage().window->RequestFrame();
}

EMSCRIPTEN_KEEPALIVE int gs_can_undo() { return TheSession().CanUndo() ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE void gs_undo() {
  TheSession().Undo();
  ThePage().window->RequestFrame();
}
EMSCRIPTEN_KEEPALIVE int gs_can_redo() { return TheSession().CanRedo() ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE void gs_redo() {
  TheSession().Redo();
  ThePage().window->RequestFrame();
}
/// Shows the first document of a visit: a shipped motion, or without a name a figure that cannot move yet.
/// Returns 0 if there is no such motion.
EMSCRIPTEN_KEEPALIVE int gs_begin(const char* example) { return TheSession().Begin(example) ? 1 : 0; }
/// Shows the open motion in the viewer, or leaves it for the workbench.
EMSCRIPTEN_KEEPALIVE void gs_set_viewing(int viewing) {
  viewing != 0 ? TheSession().EnterViewer() : TheSession().LeaveViewer();
  ThePage().window->RequestFrame();
}
EMSCRIPTEN_KEEPALIVE int gs_viewing() { return TheSession().Viewing() ? 1 : 0; }
/// Whether nothing moves unless a person plays it.
EMSCRIPTEN_KEEPALIVE void gs_set_calm(int calm) { TheSession().Player().SetCalm(calm != 0); }
/// Makes the open document the last one that Undo reaches.
EMSCRIPTEN_KEEPALIVE void gs_forget_past() { TheSession().ForgetPast(); }
/// Undo, Redo and the queue, as StoreVisit.
EMSCRIPTEN_KEEPALIVE const char* gs_store_visit() { return QuietReply(TheSession().StoreVisit()); }
/// @return 0: the text is damaged, and nothing has changed
EMSCRIPTEN_KEEPALIVE int gs_restore_visit(const char* text) {
  return TheSession().RestoreVisit(text) ? 1 : 0;
}

/// The commands, as CommandsJson.
EMSCRIPTEN_KEEPALIVE const char* gs_commands() { return Reply(CommandsJson(ThePage().app->Commands())); }
/// @return 0: there is no such command, or it is unavailable
EMSCRIPTEN_KEEPALIVE int gs_run(const char* id) { return ThePage().app->Run(id) ? 1 : 0; }
/// Handles a key press. @param name as in Command::keys. @return 1 if a command handled it
EMSCRIPTEN_KEEPALIVE int gs_key(const char* name, int on_canvas, int repeated) {
  return ThePage().app->Key(name, on_canvas != 0, repeated != 0) ? 1 : 0;
}

/// @param options JSON object or empty text. @return an empty text or a sentence
EMSCRIPTEN_KEEPALIVE const char* gs_synthesize(const char* options) {
  Session& session = TheSession();
  if (session.Lab().Running()) return Reply(Tr("The lab is running: stop it first, or let it end."));
  session.BeginGesture();
  int workers = session.Search().Workers();
  std::string fault;
  if (options != nullptr && *options != '\0') {
    const auto parsed = ParseJson(options);
    if (!parsed) return Reply(TrError(parsed.error()));
    Document changed = session.Doc();
    fault = ApplySearchOptions(*parsed, changed, workers);
    if (!fault.empty()) return Reply(fault);
    if (const auto valid = Validate(changed); !valid) return Reply(TrError(valid.error()));
    WithoutLocks([&] { session.Set([&](Document& d) { d = changed; }); });
  }
  session.Search().SetWorkers(workers);
  session.Search().SynthesizeForScript();
  return Reply("");
}

/// Adds a search to the queue. @param options JSON object, overrides the document's settings
/// @return an empty text or a sentence
EMSCRIPTEN_KEEPALIVE const char* gs_enqueue(const char* options) {
  Session& session = TheSession();
  const auto parsed = ParseJson(options);
  if (!parsed) return Reply(TrError(parsed.error()));
  Document wanted = session.Doc();
  int workers = session.Search().Workers();
  if (std::string fault = ApplySearchOptions(*parsed, wanted, workers); !fault.empty())
    return Reply(std::move(fault));
  if (const auto valid = Validate(wanted); !valid) return Reply(TrError(valid.error()));
  session.Search().SetWorkers(workers);
  return Reply(session.Queue().Add(wanted) ? "" : session.Notice());
}
/// The waiting searches, as QueueJson.
EMSCRIPTEN_KEEPALIVE const char* gs_queue() { return QuietReply(QueueJson(TheSession().Queue().List())); }
/// The results, newest first, as FoundJson.
EMSCRIPTEN_KEEPALIVE const char* gs_found() {
  return QuietReply(FoundJson(TheSession().Results().Motions()));
}
/// @return 0: there is no such result
EMSCRIPTEN_KEEPALIVE int gs_show_found(const char* id) {
  TheSession().BeginGesture();
  ThePage().window->RequestFrame();
  bool shown = false;
  WithoutLocks([&] { shown = TheSession().ShowFound(id); });
  return shown ? 1 : 0;
}
/// @param options JSON object: id, name. @return an empty text, or the error
EMSCRIPTEN_KEEPALIVE const char* gs_rename_found(const char* options) {
  const auto parsed = ParseJson(options);
  if (!parsed) return Reply(TrError(parsed.error()));
  const JsonValue* id = parsed->Find("id");
  const JsonValue* name = parsed->Find("name");
  const bool texts = id != nullptr && id->kind == JsonValue::Kind::kString && name != nullptr &&
                     name->kind == JsonValue::Kind::kString;
  return Reply(texts ? TheSession().Results().Motions().Rename(id->text, name->text)
                     : Tr("id and name must be texts"));
}
/// Restores a found motion of an earlier visit. @return its id; empty: the text is invalid
EMSCRIPTEN_KEEPALIVE const char* gs_restore_found(const char* text) {
  return Reply(TheSession().RestoreFound(text));
}

/// Sets the shown panels and the locks. @param options JSON object. @return an empty text, or a sentence
EMSCRIPTEN_KEEPALIVE const char* gs_arrange(const char* options) {
  const auto parsed = ParseJson(options);
  return Reply(parsed ? ApplyArrangement(*parsed, TheSession().Layout()) : TrError(parsed.error()));
}
/// The numbers of the shown motion, as MeasuresJson.
EMSCRIPTEN_KEEPALIVE const char* gs_measures() { return QuietReply(MeasuresJson(TheSession())); }

/// Starts the lab, after stopping a running one. @param options JSON object
/// @return an empty text, or a sentence, with nothing changed
EMSCRIPTEN_KEEPALIVE const char* gs_lab(const char* options) {
  const auto parsed = ParseJson(options);
  if (!parsed) return Reply(TrError(parsed.error()));
  LabSettings settings = TheSession().Lab().Trials().settings;
  if (std::string fault = ApplyLabOptions(*parsed, settings); !fault.empty()) return Reply(std::move(fault));
  const auto started = TheSession().Lab().Start(settings);
  return Reply(started ? "" : TrError(started.error()));
}
/// The lab's curves so far, as the text of a file.
EMSCRIPTEN_KEEPALIVE const char* gs_lab_csv() { return Reply(TheSession().Lab().Trials().Csv()); }
/// One of kLabStateNames.
EMSCRIPTEN_KEEPALIVE const char* gs_lab_state() {
  return kLabStateNames[static_cast<std::size_t>(TheSession().Lab().Trials().State())];
}

EMSCRIPTEN_KEEPALIVE void gs_pause() { TheSession().Search().Pause(); }
EMSCRIPTEN_KEEPALIVE void gs_resume() { TheSession().Search().Resume(); }
EMSCRIPTEN_KEEPALIVE void gs_stop() {
  TheSession().Stop();
  ThePage().window->RequestFrame();
}

}  // extern "C"

int main() {
  Page& page = ThePage();
  // SDL leaves the canvas's size to CSS only if the CSS size differs from the requested one.
  page.window = Window::Open({.width = 16, .height = 16});
  if (!page.window) return 1;
  page.app = std::make_unique<App>(page.host, *page.window);
  page.before_ms = emscripten_get_now();
  emscripten_set_main_loop_arg(Tick, &page, 0, false);
  return 0;
}
