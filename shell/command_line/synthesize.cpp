// SPDX-License-Identifier: MIT
// gaitsmith synthesize: finds a controller and writes it as a document.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "core/document/json.h"
#include "core/evolution/elites.h"
#include "core/evolution/nsga.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/command_line/synthesize_request.h"
#include "shell/command_line/warnings.h"
#include "shell/search/parallel_search.h"

namespace gaitsmith::shell {

namespace {

/// A progress bar on standard error, drawn at most ten times a second, and only on a terminal.
class ProgressBar {
 public:
  void Draw(const SearchProgress& progress) {
    const auto now = std::chrono::steady_clock::now();
    const bool done = progress.state == SearchState::kDone;
    if (!terminal_ || (now - drawn_ < std::chrono::milliseconds(100) && !done)) return;
    drawn_ = now;
    constexpr int kWidth = 28;
    std::string bar(kWidth, ' ');
    const auto filled = std::int64_t{progress.evaluations} * kWidth / progress.budget;
    std::fill_n(bar.begin(), filled, '=');
    std::fprintf(stderr, "\r[%s] %d of %d  %.0f/s  best %.3f  %.0f s left \x1b[K%s", bar.c_str(),
                 progress.evaluations, progress.budget, progress.evaluations_per_second,
                 static_cast<double>(progress.best_fitness), progress.seconds_left, done ? "\n" : "");
  }

 private:
  std::chrono::steady_clock::time_point drawn_;
  bool terminal_ = isatty(STDERR_FILENO) != 0;
};

std::string CurveCsv(const std::vector<Search::CurvePoint>& curve) {
  std::string csv = "evaluation,best\n";
  for (const auto& point : curve) {
    char line[64];
    std::snprintf(line, sizeof line, "%d,%.9g\n", point.evaluation, static_cast<double>(point.best));
    csv += line;
  }
  return csv;
}

/// @param option that names the folder
Result<void> MakeFolder(const std::string& option, const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault)
    return Fail(ErrorCode::kMissing, option + " " + folder.string(), "cannot be made: " + fault.message());
  return {};
}

/// Writes one of the motions that a search has found.
/// @param own  how many controllers the document has of its own, as in Request
Result<void> WriteMotion(const std::filesystem::path& file, const Document& searched, int own,
                         const Genome& genome) {
  Document document = searched;
  Controller controller = TakeFound(searched, genome, document);
  controller.name =
      "found by " + std::string(kAlgorithmNames[static_cast<std::size_t>(searched.search.algorithm)]);
  if (auto put = PutFound(controller, own, document); !put) return std::unexpected(put.error());
  document.hash = Simulate(document).Hash();
  return WriteText(file.string(), EncodeJson(document));
}

/// Writes the motions of the front that NSGA-II has found, by rising score, and a table of them.
Result<void> WriteFront(const std::filesystem::path& folder, const Document& searched, int own,
                        const SearchProgress& found) {
  if (auto made = MakeFolder("--front", folder); !made) return made;
  const auto front = FrontOf(searched.search, ProblemOf(searched).Shape().Genes(), found.saved);
  std::string csv = "fitness,cost,file\n";
  for (std::size_t i = 0; front && i < front->size(); ++i) {
    const Compromise& one = (*front)[i];
    std::string number = std::to_string(i + 1);
    number.insert(0, std::to_string(front->size()).size() - number.size(), '0');
    const std::string name = number + ".json";
    if (auto written = WriteMotion(folder / name, searched, own, one.genome); !written) return written;
    char values[48];
    std::snprintf(values, sizeof values, "%.9g,%.9g,", static_cast<double>(one.aims.score),
                  0.0 - static_cast<double>(one.aims.thrift));
    csv.append(values).append(name).append("\n");
  }
  return WriteText((folder / "front.csv").string(), csv);
}

/// Writes the motion of every style that the search has found, and a table of them.
Result<void> WriteStyles(const std::filesystem::path& folder, const Document& searched, int own,
                         const SearchProgress& found) {
  if (auto made = MakeFolder("--styles", folder); !made) return made;
  const auto elites = ElitesOf(searched.search, ProblemOf(searched).Shape().Genes(), found.saved);
  std::string csv = "height_bin,slip_bin,turns_bin,fitness,max_cm_height,slip_sum,rotations,file\n";
  const auto bins = static_cast<std::size_t>(searched.search.elites.bins);
  for (std::size_t cell = 0; elites && cell < elites->Cells().size(); ++cell) {
    const Elite& elite = elites->Cells()[cell];
    if (elite.genome.empty()) continue;
    std::string name, row;
    for (const std::size_t bin : {cell / bins / bins, cell / bins % bins, cell % bins}) {
      name.append(name.empty() ? "" : "-").append(std::to_string(bin));
      row.append(std::to_string(bin)).append(",");
    }
    name.append(".json");
    if (auto written = WriteMotion(folder / name, searched, own, elite.genome); !written) return written;
    char values[80];
    const auto& [high, slid, turned] = elite.score.style;
    std::snprintf(values, sizeof values, "%.9g,%.9g,%.9g,%.9g,", static_cast<double>(elite.score.fitness),
                  static_cast<double>(high), static_cast<double>(slid), static_cast<double>(turned));
    csv.append(row).append(values).append(name).append("\n");
  }
  return WriteText((folder / "styles.csv").string(), csv);
}

}  // namespace

Outcome SynthesizeCommand(Words words) {
  static constexpr std::string_view kOptions[] = {
      "figure",   "task",  "sense",    "weight", "search",        "evaluations", "seed",    "out",    "curve",
      "threads",  "rules", "duration", "from",   "search-option", "controller",  "problem", "repair", "clip",
      "handover", "way",   "pose",     "styles", "joints",        "ground",      "front"};
  const auto arguments = Arguments::ParseOptions(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  if (!arguments->Has("out"))
    return Fail(ErrorCode::kMissing, "--out", "say where to write the document (- for standard output)");
  auto request = ReadRequest(*arguments);
  if (!request) return std::unexpected(request.error());
  Document& document = request->document;
  const auto threads = arguments->Integer("threads", 1, 256, Cores());
  if (!threads) return std::unexpected(threads.error());

  if (arguments->Has("styles") && !KeepsElites(document.search.algorithm))
    return Fail(ErrorCode::kStructure, "--styles",
                "goes with --search map-elites or cma-mae, which keep every style");
  if (arguments->Has("front") && document.search.algorithm != Algorithm::kNsga)
    return Fail(ErrorCode::kStructure, "--front", "goes with --search nsga-ii, which keeps a front");

  WarnOfMasses(document.figure.name, document);
  const Document searched = document;
  ProgressBar bar;
  SearchControl control;
  const SearchProgress found = RunParallelSearch(
      ProblemOf(document), document.search, static_cast<int>(*threads), control,
      [&](const SearchProgress& progress) { bar.Draw(progress); }, StartOf(document));

  const auto algorithm = kAlgorithmNames[static_cast<std::size_t>(document.search.algorithm)];
  Controller controller = TakeFound(document, found.best_genome, document);
  controller.name = "found by " + std::string(algorithm);
  if (auto put = PutFound(controller, request->own, document); !put) return std::unexpected(put.error());
  document.hash = Simulate(document).Hash();
  if (auto written = WriteText(arguments->Last("out"), EncodeJson(document)); !written) return written;
  if (arguments->Has("styles")) {
    if (auto written = WriteStyles(arguments->Last("styles"), searched, request->own, found); !written)
      return written;
  }
  if (arguments->Has("front")) {
    if (auto written = WriteFront(arguments->Last("front"), searched, request->own, found); !written)
      return written;
  }
  if (arguments->Has("curve")) return WriteText(arguments->Last("curve"), CurveCsv(found.curve));
  return {};
}

}  // namespace gaitsmith::shell
