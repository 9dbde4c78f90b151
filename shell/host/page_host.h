// SPDX-License-Identifier: MIT
// The functions of the page that the application calls. page.cpp has the opposite direction.
#pragma once

#include <emscripten/emscripten.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/document/binary.h"
#include "shell/words/language.h"
#include "shell/workspace/host.h"

extern "C" {
// Implemented in page.library.js.
int gs_page_max_workers();
void gs_page_start_search(const std::uint8_t* document, std::size_t bytes, int workers);
void gs_page_start_trial(const std::uint8_t* document, std::size_t bytes, int workers, const char* words,
                         int finished, int total);
void gs_page_start_queued(const std::uint8_t* document, std::size_t bytes, int workers, const char* words);
void gs_page_start_preview(const std::uint8_t* document, std::size_t bytes, int workers);
void gs_page_store_found(const char* id, const char* text);
void gs_page_ask_name(const char* id, const char* name, const char* usual);
void gs_page_learn_from(const char* id, int more);
void gs_page_open_dialog(const char* command);
void gs_page_lab_ended();
void gs_page_save_text(const char* name, const char* text);
void gs_page_pause_search();
void gs_page_resume_search();
void gs_page_stop_search();
void gs_page_start_transition_map(const std::uint8_t* request, std::size_t bytes, int generation);
void gs_page_stop_transition_map();
void gs_page_start_plan(const std::uint8_t* document, std::size_t bytes, int generation);
void gs_page_stop_plan();
void gs_page_status(const char* sentence);
void gs_page_document_changed(const char* title);
void gs_page_first_frame();
void gs_page_leave_canvas(int direction);
}

namespace gaitsmith::shell {

class WebHost final : public Host {
 public:
  [[nodiscard]] int MaxWorkers() const override { return std::max(1, gs_page_max_workers()); }
  void StartSearch(const Document& document, int workers) override {
    const std::vector<std::uint8_t> bytes = EncodeBinary(document);
    gs_page_start_search(bytes.data(), bytes.size(), workers);
  }
  void StartTrial(const Document& document, int workers, const TrialWords& trial) override {
    const std::vector<std::uint8_t> bytes = EncodeBinary(document);
    gs_page_start_trial(bytes.data(), bytes.size(), workers, trial.words.c_str(), trial.finished,
                        trial.total);
  }
  void StartQueued(const Document& document, int workers, const std::string& words) override {
    const std::vector<std::uint8_t> bytes = EncodeBinary(document);
    gs_page_start_queued(bytes.data(), bytes.size(), workers, words.c_str());
  }
  void StartPreview(const Document& document, int workers) override {
    const std::vector<std::uint8_t> bytes = EncodeBinary(document);
    gs_page_start_preview(bytes.data(), bytes.size(), workers);
  }
  void StoreFound(const std::string& id, const std::string& text) override {
    gs_page_store_found(id.c_str(), text.c_str());
  }
  [[nodiscard]] bool CanAskName() const override { return true; }
  void AskName(const std::string& id, const std::string& name, const std::string& usual) override {
    gs_page_ask_name(id.c_str(), name.c_str(), usual.c_str());
  }
  [[nodiscard]] bool CanLearn() const override { return true; }
  void LearnFrom(const std::string& id, bool more) override { gs_page_learn_from(id.c_str(), more ? 1 : 0); }
  [[nodiscard]] bool HasDialogs() const override { return true; }
  void OpenDialog(const std::string& command) override { gs_page_open_dialog(command.c_str()); }
  [[nodiscard]] double NowS() const override { return 1e-3 * emscripten_date_now(); }
  void LabEnded() override { gs_page_lab_ended(); }
  void SaveText(const std::string& name, const std::string& text) override {
    gs_page_save_text(name.c_str(), text.c_str());
  }
  void PauseSearch() override { gs_page_pause_search(); }
  void ResumeSearch() override { gs_page_resume_search(); }
  void StopSearch() override { gs_page_stop_search(); }
  void StartTransitionMap(const Document& request, int generation) override {
    const std::vector<std::uint8_t> bytes = EncodeBinary(request);
    gs_page_start_transition_map(bytes.data(), bytes.size(), generation);
  }
  void StopTransitionMap() override { gs_page_stop_transition_map(); }
  void StartPlan(const Document& document, int generation) override {
    const std::vector<std::uint8_t> bytes = EncodeBinary(document);
    gs_page_start_plan(bytes.data(), bytes.size(), generation);
  }
  void StopPlan() override { gs_page_stop_plan(); }
  void Status(const std::string& sentence) override { gs_page_status(sentence.c_str()); }
  void DocumentChanged(const std::string& title) override {
    gs_page_document_changed(TrTitle(title).c_str());
  }
  void FirstFrame() override { gs_page_first_frame(); }
  void LeaveCanvas(int direction) override { gs_page_leave_canvas(direction); }
};

}  // namespace gaitsmith::shell
