// SPDX-License-Identifier: MIT
// Searches that are rewarded for violating the laws of physics, over figures, grounds, starts, pushes and
// controllers at once, with the project's own search algorithms. Each find is a bug to fix or a limit to
// document.
//   adversary --out FOLDER [--model 1|2|3] [--minutes M] [--shard K/N] [--seeds S] [--evaluations E]
// Each model has its own folder. Appends to FOLDER/found.csv (with shards found-K-of-N.csv), skips cases
// already in such files, and keeps the worst document of every law and world as FOLDER/LAW-WORLD.json. Prints
// the worst case of each law at the end.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/document/json.h"
#include "core/rollout/models.h"
#include "tests/adversary/genes_as_document.h"
#include "tests/physics_laws.h"

namespace {

using namespace gaitsmith;
using namespace gaitsmith::test;

/// A law to violate, or one past the last: equal bits for every lane count.
constexpr int kBits = kLaws;
std::string NameOf(int law) {
  std::string name(law == kBits ? "bits" : LawLimits(1)[static_cast<std::size_t>(law)].name);
  for (char& letter : name) letter = letter == ' ' ? '-' : letter;
  return name;
}

struct Options {
  std::filesystem::path out;
  int model = 1;
  double minutes = 1e9;
  int shard = 1, shards = 1;
  std::uint32_t seeds = 3;
  int evaluations = 2000;
};

struct Case {
  int law;
  Scope world;
  Algorithm search;
  std::uint32_t seed;

  [[nodiscard]] std::string Key() const {
    return NameOf(law) + "," + std::string(kScopeNames[static_cast<std::size_t>(world)]) + "," +
           std::string(kAlgorithmNames[static_cast<std::size_t>(search)]) + "," + std::to_string(seed);
  }
};

std::vector<Case> AllCases(std::uint32_t seeds, int model) {
  std::vector<Case> cases;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    for (const Algorithm search : {Algorithm::kSphc, Algorithm::kCmaEs, Algorithm::kGga}) {
      for (const Scope world : {Scope::kGait, Scope::kOrdinary, Scope::kAny}) {
        for (int law = 0; law <= kBits; ++law) {
          if (law == kBits || Concerns(static_cast<Law>(law), model))
            cases.push_back({law, world, search, seed});
        }
      }
    }
  }
  return cases;
}

bool IsStill(int law) {
  return law == static_cast<int>(Law::kStillEnergy) || law == static_cast<int>(Law::kStillGain);
}

/// The adversary's reward [in the law's unit]. For differing bits, extreme speeds are rewarded until a
/// difference is found.
double Pay(int law, const Document& document) {
  const Motion motion = Simulate(document);
  if (law < kLaws) return Judge(document, motion).of[static_cast<std::size_t>(law)].by;
  const int differing = DifferingBits(document, motion);
  if (differing > 0) return differing;
  const Motion::Frame& last = motion.At(motion.Frames() - 1);
  const double speed = std::abs(last.x_m) + std::abs(last.turn_rad);
  return std::isfinite(speed) ? speed / (1e30 + speed) : 0.0;
}

struct Finding {
  double worst = -1.0;
  Document document;
};

Finding Run(const Case& one, int model, int evaluations) {
  SearchSettings settings;
  settings.algorithm = one.search;
  settings.seed = one.seed;
  settings.evaluations = one.law == kBits ? evaluations / 4 : evaluations;
  settings.cma.genes = CmaGenes::kAll;
  settings.genetic.population = 50;
  const auto search = MakeSearch(settings, SpaceOfDocuments());
  Finding finding;
  while (!search->Done()) {
    std::vector<float> paid;
    for (const Genome& genome : search->Ask(50)) {
      Document document = DocumentOf(one.world, model, IsStill(one.law), genome);
      const double pay = Pay(one.law, document);
      paid.push_back(static_cast<float>(std::min(pay, 1e30)));
      if (pay > finding.worst) finding = {pay, std::move(document)};
    }
    search->Tell(paid);
  }
  return finding;
}

bool Parse(int count, char** words, Options& options) {
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string name = words[i];
    const char* value = words[i + 1];
    if (name == "--out")
      options.out = value;
    else if (name == "--model")
      options.model = std::stoi(value);
    else if (name == "--minutes")
      options.minutes = std::stod(value);
    else if (name == "--seeds")
      options.seeds = static_cast<std::uint32_t>(std::stoul(value));
    else if (name == "--evaluations")
      options.evaluations = std::stoi(value);
    else if (name == "--shard") {
      if (std::sscanf(value, "%d/%d", &options.shard, &options.shards) != 2) return false;
    } else
      return false;
  }
  return count % 2 == 1 && !options.out.empty() && options.shard >= 1 && options.shard <= options.shards &&
         options.evaluations >= 4 && options.model >= 1 && options.model <= kModelVersion;
}

/// Adds the rows of a file of findings. The key is the text before the worst value.
void Read(const std::filesystem::path& file, std::map<std::string, double>& rows) {
  std::ifstream in(file);
  for (std::string row; std::getline(in, row);) {
    if (row.empty() || row[0] == '#' || row.starts_with("law,")) continue;
    std::istringstream cells(row);
    std::string key, cell;
    for (int i = 0; i < 4 && std::getline(cells, cell, ','); ++i) key += (i > 0 ? "," : "") + cell;
    std::getline(cells, cell, ',');  // evaluations
    if (std::getline(cells, cell, ',')) rows[key] = std::stod(cell);
  }
}

}  // namespace

int main(int count, char** words) {
  Options options;
  if (!Parse(count, words, options)) {
    std::fprintf(stderr,
                 "adversary --out FOLDER [--model 1|2|3] [--minutes M] [--shard K/N] [--seeds S] "
                 "[--evaluations E]\n");
    return 2;
  }
  std::filesystem::create_directories(options.out);
  const std::string suffix =
      options.shards == 1 ? ""
                          : "-" + std::to_string(options.shard) + "-of-" + std::to_string(options.shards);
  const std::filesystem::path file = options.out / ("found" + suffix + ".csv");
  std::map<std::string, double> found;  // findings of all shards
  for (const auto& entry : std::filesystem::directory_iterator(options.out)) {
    if (entry.path().extension() == ".csv") Read(entry.path(), found);
  }
  std::map<std::string, double> worst;  // worst value of each law and world
  const auto place = [](const std::string& key) { return key.substr(0, key.find(',', key.find(',') + 1)); };
  for (const auto& [key, by] : found) worst[place(key)] = std::max(worst[place(key)], by);

  const bool fresh = !std::filesystem::exists(file);
  std::ofstream out(file, std::ios::app);
  if (fresh) out << "law,world,search,seed,evaluations,worst,limit,unit,frame,hash\n";
  const auto began = std::chrono::steady_clock::now();
  const std::vector<Case> cases = AllCases(options.seeds, options.model);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& one = cases[i];
    const std::string key = one.Key();
    if (static_cast<int>(i % static_cast<std::size_t>(options.shards)) != options.shard - 1 ||
        found.contains(key))
      continue;
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() >
        60.0 * options.minutes)
      break;
    Finding finding = Run(one, options.model, options.evaluations);
    const Motion motion = Simulate(finding.document);
    finding.document.hash = motion.Hash();
    const std::string name = NameOf(one.law);
    finding.document.title = name;
    int frame = 0;
    double by = finding.worst;
    LawLimit limit{"bits", "lane counts", 0.0};
    if (one.law < kLaws) {
      limit = LawLimits(options.model)[static_cast<std::size_t>(one.law)];
      frame = Judge(finding.document, motion).of[static_cast<std::size_t>(one.law)].frame;
    } else if (by < 1.0) {
      by = 0.0;  // the reward was for speed, not for a difference
    }
    char cells[200];
    std::snprintf(cells, sizeof cells, "%d,%.9g,%g,%s,%d,",
                  one.law == kBits ? options.evaluations / 4 : options.evaluations, by, limit.most,
                  std::string(limit.unit).c_str(), frame);
    out << key << ',' << cells << HashText(motion.Hash()) << '\n'
        << std::flush;  // finished cases are kept if the program is killed
    found[key] = by;
    const bool first = !worst.contains(place(key));
    double& most = worst[place(key)];
    if (first || by > most) {
      most = by;
      std::string stem = place(key);
      stem[stem.find(',')] = '-';
      if (by > 0.0) std::ofstream(options.out / (stem + suffix + ".json")) << EncodeJson(finding.document);
    }
  }
  for (const auto& [where, by] : worst) std::printf("%-28s %.6g\n", where.c_str(), by);
  return 0;
}
