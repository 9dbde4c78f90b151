// SPDX-License-Identifier: MIT
// The desktop window:
//   gaitsmith-window [document.json | link] [--theme light|dark|projector|contrast] [--size 1280x720]
//   [--scale 1.5] [--panel 0..5] [--language de|en]
// Without --language it uses that of the environment (LC_ALL, LC_MESSAGES or LANG) if there is a translation,
// else English. Dropping a file on the window opens it. Ctrl+S saves to that file, Ctrl+C copies a link.
// Other keys are in commands.cpp.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "core/document/json.h"
#include "core/document/link.h"
#include "shell/app/app.h"
#include "shell/embedded/embedded.h"
#include "shell/host/native_host.h"
#include "shell/words/hints.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

struct Arguments {
  std::string document;
  PaletteName palette = PaletteName::kLight;
  int panel = -1;
  std::string language;  // empty: from the environment
  Window::Options window;
};

/// @param tag "de", or as in the environment, "de_AT.UTF-8" @return null: no translation
const Language* FindLanguage(std::string_view tag) {
  const auto code = tag.substr(0, tag.find_first_of("-_.@"));
  const auto found = std::ranges::find(Languages(), code, &Language::code);
  return found == Languages().end() ? nullptr : &*found;
}

float Number(const char* text) {
  float value = 0.0f;
  std::from_chars(text, text + std::strlen(text), value);
  return value;
}

bool ParseTheme(std::string_view name, Arguments& arguments) {
  if (name == "light") {
    arguments.palette = PaletteName::kLight;
  } else if (name == "dark") {
    arguments.palette = PaletteName::kDark;
  } else if (name == "projector") {
    arguments.palette = PaletteName::kStrongLight;
    arguments.window.scale *= 1.25f;
  } else if (name == "contrast") {
    arguments.palette = PaletteName::kStrongDark;
  } else {
    return false;
  }
  return true;
}

bool Parse(int count, char** words, Arguments& arguments) {
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const char* next = i + 1 < count ? words[i + 1] : "";
    if (word == "--theme") {
      if (!ParseTheme(next, arguments)) return false;
      ++i;
    } else if (word == "--size") {
      if (std::sscanf(next, "%dx%d", &arguments.window.width, &arguments.window.height) != 2) return false;
      ++i;
    } else if (word == "--scale") {
      arguments.window.scale = Number(next);
      if (!(arguments.window.scale >= 0.5f && arguments.window.scale <= 8.0f)) return false;
      ++i;
    } else if (word == "--panel") {
      arguments.panel = static_cast<int>(Number(next));
      ++i;
    } else if (word == "--language") {
      arguments.language = next;
      if (FindLanguage(arguments.language) == nullptr) return false;
      ++i;
    } else if (word.starts_with("--") || !arguments.document.empty()) {
      return false;
    } else {
      arguments.document = word;
    }
  }
  return true;
}

// The first non-empty variable decides, as in POSIX.
std::string LanguageOfEnvironment() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): no other thread yet
    if (value != nullptr && *value != '\0') return value;
  }
  return {};
}

// A key's name as in Command::keys.
std::string NameOf(const SDL_Keysym& key) {
  std::string name;
  switch (key.sym) {
    case SDLK_SPACE:
      name = "Space";
      break;
    case SDLK_LEFT:
      name = "ArrowLeft";
      break;
    case SDLK_RIGHT:
      name = "ArrowRight";
      break;
    case SDLK_HOME:
      name = "Home";
      break;
    case SDLK_END:
      name = "End";
      break;
    case SDLK_ESCAPE:
      name = "Escape";
      break;
    default:
      if (key.sym <= ' ' || key.sym > '~') return {};
      name = static_cast<char>(key.sym);
      break;
  }
  const bool letter = key.sym >= SDLK_a && key.sym <= SDLK_z;
  if ((key.mod & KMOD_SHIFT) != 0 && (letter || name.size() > 1)) name = "Shift+" + name;
  if ((key.mod & (KMOD_CTRL | KMOD_GUI)) != 0) name = "Ctrl+" + name;
  return (key.mod & KMOD_ALT) != 0 ? "Alt+" + name : name;
}

class Desktop {
 public:
  explicit Desktop(Window& window) : window_(window), app_(host_, window) {}

  App& Application() { return app_; }

  void Open(const std::string& what) {
    std::string text = what;
    std::ifstream file(what, std::ios::binary);
    if (file) text.assign(std::istreambuf_iterator<char>(file), {});
    if (const auto opened = app_.State().Open(text); !opened)
      return ShowStatus(Tr("Cannot open: {1}", TrError(opened.error())));
    // A file that holds a link is not overwritten: saving creates a new file.
    const auto first = text.find_first_not_of(" \t\r\n");
    const bool document = file && first != std::string::npos && text[first] == '{';
    path_ = document ? what : "";
  }

  bool Take(const SDL_Event& event) {
    if (event.type == SDL_DROPFILE) {
      Open(event.drop.file);
      SDL_free(event.drop.file);
      return true;
    }
    const bool control = event.type == SDL_KEYDOWN && (event.key.keysym.mod & (KMOD_CTRL | KMOD_GUI)) != 0;
    if (control && !ImGui::GetIO().WantTextInput) {
      if (event.key.keysym.sym == SDLK_s) return Save();
      if (event.key.keysym.sym == SDLK_c) {
        SDL_SetClipboardText(EncodeLink(app_.State().Doc()).c_str());
        ShowStatus(Tr("Link copied."));
        return true;
      }
    }
    if (event.type == SDL_KEYDOWN && app_.Key(NameOf(event.key.keysym), true, event.key.repeat != 0))
      return true;
    return app_.Take(event);
  }

  bool Advance(double seconds) {
    if (auto progress = host_.TakeProgress()) {
      app_.State().OnSearchProgress(std::move(*progress));
      window_.RequestFrame();
    }
    for (const TransitionPart& part : host_.TakeTransitions()) {
      app_.State().Timeline().Transitions().OnScores(part);
      window_.RequestFrame();
    }
    for (PlanUpdate& update : host_.TakePlanUpdates()) {
      app_.State().Planning().OnReport(update.generation, std::move(update.report));
      window_.RequestFrame();
    }
    if (const std::string title = host_.WindowTitle(); title != title_) window_.SetTitle(title_ = title);
    return app_.Advance(seconds);
  }

 private:
  bool Save() {
    const std::string path = path_.empty() ? FreePath() : path_;
    std::ofstream file(path, std::ios::binary);
    file << EncodeJson(app_.State().WithHash());
    file.close();
    if (file.good()) path_ = path;
    ShowStatus(Tr(file.good() ? "Saved as {1}." : "Cannot write {1}.", path));
    return true;
  }
  // The first free name of gaitsmith.json, gaitsmith-2.json, …
  static std::string FreePath() {
    std::string path = "gaitsmith.json";
    std::error_code fault;
    for (int number = 2; std::filesystem::exists(path, fault); ++number)
      path = "gaitsmith-" + std::to_string(number) + ".json";
    return path;
  }
  void ShowStatus(const std::string& sentence) {
    app_.State().Notice() = sentence;
    host_.Status(sentence);
  }

  Window& window_;
  NativeHost host_;
  App app_;
  std::string path_;  // where to save; empty until a document is opened or saved
  std::string title_;
};

int Run(int count, char** words) {
  Arguments arguments;
  if (!Parse(count, words, arguments)) {
    std::fputs(
        "usage: gaitsmith-window [document.json | link] [--theme light|dark|projector|contrast] [--size WxH] "
        "[--scale S] [--panel N] [--language CODE]\n",
        stderr);
    return 2;
  }
  const std::string language = arguments.language.empty() ? LanguageOfEnvironment() : arguments.language;
  const Language* spoken = FindLanguage(language);
  if (spoken != nullptr && !SetLanguage(spoken->json))
    std::fprintf(stderr, "gaitsmith-window: the table of %s is broken\n", std::string(spoken->name).c_str());
  if (const std::string_view hints = (spoken != nullptr ? *spoken : Languages().front()).hints;
      !SetHints(hints))
    std::fputs("gaitsmith-window: the table of hints is broken\n", stderr);
  const auto window = Window::Open(arguments.window);
  if (!window) {
    std::fprintf(stderr, "gaitsmith-window: %s\n", SDL_GetError());
    return 1;
  }
  window->SetPalette(arguments.palette);
  Desktop desktop(*window);
  if (!arguments.document.empty()) desktop.Open(arguments.document);
  if (arguments.panel >= 0)
    desktop.Application().State().SetView([&](View& view) { view.panel = arguments.panel; });

  auto before = std::chrono::steady_clock::now();
  const Window::EventFilter filter = [&](const SDL_Event& event) { return desktop.Take(event); };
  bool due = true;
  // Sleeps until an event unless a motion plays. Polls a search ten times a second.
  while (window->TakeEvents(due ? 0 : 100, filter)) {
    const auto now = std::chrono::steady_clock::now();
    due = desktop.Advance(std::chrono::duration<double>(now - before).count());
    before = now;
    due = window->NeedsFrame() || due;
    if (due) window->Draw([&] { desktop.Application().Draw(); });
    // Limits the frame rate of displays without vertical synchronisation.
    const auto spent = std::chrono::steady_clock::now() - now;
    if (due && spent < std::chrono::milliseconds(12)) SDL_Delay(4);
  }
  return 0;
}

}  // namespace
}  // namespace gaitsmith::shell

int main(int count, char** words) { return gaitsmith::shell::Run(count, words); }
