// SPDX-License-Identifier: MIT
// gaitsmith: the command line.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "shell/command_line/commands.h"
#include "shell/export/exporters.h"

namespace {

using gaitsmith::shell::Words;

struct Command {
  std::string_view name;
  gaitsmith::shell::Outcome (*run)(Words);
  const char* usage;  // "{exporters}" is replaced by ExporterOptions()
};

constexpr auto kCommands = std::to_array<Command>({
    {"simulate", gaitsmith::shell::SimulateCommand, "simulate DOC --csv OUT"},
    {"export", gaitsmith::shell::ExportCommand,
     "export DOC {exporters} [--poses N] [--from S] [--to S] [--sprite-frames N]\n"
     "             [--sprite-size PX | --sprite-scale PX] [--planned | --loop [--halves] [--in-place]]"},
    {"synthesize", gaitsmith::shell::SynthesizeCommand,
     "synthesize --figure F --task T --sense physical|timer=SECONDS|sight --weight TERM=W\n"
     "             --search ALG --evaluations N --seed S --out DOC [--curve CSV] [--styles DIR] [--front "
     "DIR]\n"
     "             [--threads K]\n"
     "             [--controller rules|network|trajectory|trajectory:rest] [--rules N] [--duration SECONDS] "
     "[--joints "
     "strong|limited|STRENGTH]\n"
     "             [--ground level|step|stairs|ramp|gap|hurdles|rubble[:SEED]]\n"
     "             [--search-option NAME=VALUE] [--problem DOC | --from DOC] [--handover DOC@SECONDS …]\n"
     "  gaitsmith synthesize --repair DOC --clip N --out DOC [--task T] [--weight TERM=W] [--search ALG] …"},
    {"compare", gaitsmith::shell::CompareCommand,
     "compare --problem DOC … --search ALG[:OPTION=VALUE…] … --trials N --evaluations E --out CSV\n"
     "             --curves CSV [--first-seed S] [--points P] [--sense physical|timer=SECONDS|sight]\n"
     "             [--weight TERM=W] [--duration SECONDS] [--joints strong|limited|STRENGTH]\n"
     "             [--ground level|step|stairs|ramp|gap|hurdles|rubble[:SEED]]\n"
     "             [--shard I/N] [--threads K]\n"
     "  gaitsmith compare --summary CSV [--summary CSV …] [--search LABEL …] [--ranks SVG] [--ioh DIR]"},
    {"suite", gaitsmith::shell::SuiteCommand,
     "suite --problem DOC | --figure F --search ALG[:OPTION=VALUE…] --seeds N --evaluations E --out CSV\n"
     "             [--sense physical|timer=SECONDS|sight …] [--task T …] [--style NAME=TERM:W[,TERM:W] …]\n"
     "             [--first-seed S] [--duration SECONDS] [--controller "
     "rules|network|trajectory|trajectory:rest] [--rules "
     "N]\n"
     "             [--joints strong|limited|STRENGTH]\n"
     "             [--ground level|step|stairs|ramp|gap|hurdles|rubble[:SEED]]\n"
     "             [--shard I/N] [--threads K]\n"
     "  gaitsmith suite --list CSV\n"
     "  gaitsmith suite --extract CSV --out-dir DIR [--best]"},
    {"merge", gaitsmith::shell::MergeCommand,
     "merge --out CSV [--complete] SHARD …\n  gaitsmith merge --progress SHARD …"},
    {"switches", gaitsmith::shell::SwitchesCommand,
     "switches --out CSV [--times T] [--length SECONDS] [--summary] [--shard I/N] [--threads K] DOC DOC …"},
    {"new", gaitsmith::shell::NewCommand, "new [--figure F] [--goal G] [--out DOC]"},
    {"goals", gaitsmith::shell::GoalsCommand,
     "goals --search ALG --seeds N --evaluations E --out CSV [--figure F …] [--goal G …] [--strength X …]\n"
     "             [--first-seed S] [--shard I/N] [--threads K]\n"
     "  gaitsmith goals --summary CSV"},
    {"breed", gaitsmith::shell::BreedCommand,
     "breed DOC … --out-prefix PATH [--difference X] [--seed S] [--children N] [--evaluations E]\n"
     "             [--keep goal|rule=N|joint=N …] [--threads K]"},
    {"taste", gaitsmith::shell::TasteCommand, "taste CSV [--ask DOC --ask DOC …] [--out DOC]"},
    {"hash", gaitsmith::shell::HashCommand, "hash DOC [--lanes 1|2|4|8|16] [--out DOC]"},
    {"senses", gaitsmith::shell::SensesCommand, "senses DOC [--clip N] [--controller JSON] [--out CSV]"},
    {"validate", gaitsmith::shell::ValidateCommand, "validate DOC"},
    {"measure", gaitsmith::shell::MeasureCommand,
     "measure DOC [--joints J] [--ground G] [--substeps N] [--worlds N [--seed S] [--noise NAME]]"},
    {"record", gaitsmith::shell::RecordCommand, "record DOC [--knots N] [--out DOC]"},
    {"loop", gaitsmith::shell::LoopCommand, "loop DOC … [--halves]"},
    {"plan", gaitsmith::shell::PlanCommand,
     "plan DOC [--degree 3|4|5] [--pieces N] [--motion CSV] [--out DOC] [--rules DOC]"},
    {"link", gaitsmith::shell::LinkCommand, "link encode DOC | link decode LINK [--out DOC]"},
    {"catalogue", gaitsmith::shell::CatalogueCommand, "catalogue"},
});

/// "--svg OUT | --gltf OUT | --csv OUT"
std::string ExporterOptions() {
  std::string options;
  for (const gaitsmith::shell::ExporterRow& row : gaitsmith::shell::kExporters)
    options.append(options.empty() ? "--" : " | --").append(row.id).append(" OUT");
  return options;
}

std::string UsageOf(const Command& command) {
  constexpr std::string_view kPlace = "{exporters}";
  std::string usage = command.usage;
  const std::size_t at = usage.find(kPlace);
  if (at != std::string::npos) usage.replace(at, kPlace.size(), ExporterOptions());
  return usage;
}

int Usage(std::FILE* out) {
  std::fputs("gaitsmith finds motions of 2D articulated figures and plays them.\n\nusage:\n", out);
  for (const Command& command : kCommands) std::fprintf(out, "  gaitsmith %s\n", UsageOf(command).c_str());
  std::fputs("  gaitsmith version\n", out);
  std::fputs(
      "\nDOC is a file of JSON, a file that holds a link, a shipped example, or - for standard input.\n",
      out);
  return out == stdout ? 0 : 2;
}

bool IsHelp(std::string_view word) { return word == "--help" || word == "-h"; }

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string_view> given(words + 1, words + count);
  if (given.empty()) return Usage(stderr);
  if (given[0] == "help" || IsHelp(given[0])) return Usage(stdout);
  if (given[0] == "version" || given[0] == "--version") {
    std::puts("gaitsmith " GAITSMITH_VERSION);
    return 0;
  }
  for (const Command& command : kCommands) {
    if (command.name != given[0]) continue;
    if (std::ranges::any_of(given, IsHelp)) {
      std::printf("usage:\n  gaitsmith %s\n", UsageOf(command).c_str());
      return 0;
    }
    const auto done = command.run(Words(given).subspan(1));
    if (done) return 0;
    std::fprintf(stderr, "gaitsmith %s: %s\n", std::string(command.name).c_str(),
                 done.error().error.Sentence().c_str());
    return done.error().status;
  }
  std::fprintf(stderr, "gaitsmith: there is no command \"%.*s\"; gaitsmith help lists them\n",
               static_cast<int>(given[0].size()), given[0].data());
  return 2;
}
