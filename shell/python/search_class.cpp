// SPDX-License-Identifier: MIT
// Searches, by asking and telling or run to their end.
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <type_traits>

#include "core/document/json.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/search_options.h"
#include "shell/python/array_check.h"
#include "shell/python/bindings.h"
#include "shell/python/fault.h"
#include "shell/python/problem_class.h"
#include "shell/search/parallel_search.h"

namespace gaitsmith::python {

namespace py = pybind11;

namespace {

/// The document with the search settings changed as far as given.
Document WithSearch(const std::string& json, const std::optional<std::string>& algorithm,
                    std::optional<long long> seed, std::optional<long long> evaluations,
                    const std::vector<std::string>& options) {
  Document document = DocumentOf(json);
  if (algorithm)
    document.search.algorithm =
        static_cast<Algorithm>(Take(shell::IndexOf(kAlgorithmNames, *algorithm, "algorithm")));
  if (seed) {
    if (*seed < 0 || *seed > 0xffffffffLL)
      throw Fault("seed: must be from 0 to 4294967295, is " + std::to_string(*seed));
    document.search.seed = static_cast<std::uint32_t>(*seed);
  }
  if (evaluations) document.search.evaluations = InRange("evaluations", *evaluations, 1, 100'000'000);
  for (const std::string& option : options) Take(shell::SetSearchOption(option, document.search));
  document.hash.reset();
  Take(Validate(document));
  return document;
}

/// Every method waits for the others of the same search without the interpreter's lock, so that threads of
/// Python may share it.
class SearchClass {
 public:
  explicit SearchClass(Document document)
      : document_(std::move(document)),
        scorer_(ProblemOf(document_)),
        search_(New()),
        genes_(scorer_.Space().shape.Genes()) {}

  [[nodiscard]] std::string Json() const { return EncodeJson(document_); }

  py::array_t<Gene> Ask(long long wanted) {
    const int count = InRange("wanted", wanted, 1, 100'000);
    std::vector<Genome> genomes;
    Alone([&] {
      if (open_ > 0)
        throw Fault("ask: pass the scores of the last " + std::to_string(open_) + " genomes to tell first");
      if (!search_->Done()) genomes = search_->Ask(count);
      open_ = genomes.size();
    });
    return ArrayOf(genomes, genes_);
  }

  void Tell(const py::object& fitness, const py::object& style, const py::object& cost) {
    const auto numbers = Floats("fitness", fitness, {-1});
    std::vector<Score> scores(static_cast<std::size_t>(numbers.size()));
    for (std::size_t i = 0; i < scores.size(); ++i) scores[i].fitness = numbers.data()[i];
    if (!style.is_none()) {
      const auto terms = Floats("style", style, {numbers.size(), 3});
      for (std::size_t i = 0; i < scores.size(); ++i)
        std::copy_n(terms.data() + 3 * i, 3, scores[i].style.begin());
    }
    if (!cost.is_none()) {
      const auto costs = Floats("cost", cost, {numbers.size()});
      const auto trait =
          static_cast<std::size_t>(kCostTraits[static_cast<std::size_t>(document_.search.cost)]);
      for (std::size_t i = 0; i < scores.size(); ++i) scores[i].traits[trait] = costs.data()[i];
    }
    Alone([&] {
      if (open_ == 0) throw Fault("tell: no genomes have been asked for");
      if (scores.size() != open_)
        throw Fault("fitness: must be " + std::to_string(open_) +
                    " numbers, one for each genome of the last ask, are " + std::to_string(scores.size()));
      search_->Tell(scores);
      open_ = 0;
    });
  }

  /// Runs it to its end natively.
  void Run(long long threads) {
    const int crew = InRange("threads", threads, 1, 256);
    SignalWatch watch;
    Alone([&] {
      if (open_ > 0)
        throw Fault("run: pass the scores of the last " + std::to_string(open_) + " genomes to tell first");
      shell::SearchControl control;
      shell::RunToEnd(scorer_, *search_, document_.search.evaluations, crew, control, [&](const auto&) {
        if (watch()) control.Cancel();
      });
    });
    watch.ThrowIfStopped();
  }

  bool Done() {
    return Looked([](const Search& search) { return search.Done(); });
  }
  int Evaluations() {
    return Looked([](const Search& search) { return search.Evaluations(); });
  }
  float BestFitness() {
    return Looked([](const Search& search) { return search.BestFitness(); });
  }
  std::vector<float> Population() {
    return Looked([](const Search& search) { return search.PopulationFitness(); });
  }
  py::object BestGenome() {
    const Genome best = Looked([](const Search& search) { return search.BestGenome(); });
    if (best.empty()) return py::none();
    return py::array_t<Gene>(static_cast<py::ssize_t>(best.size()), best.data());
  }
  py::tuple Curve() {
    const auto curve = Looked([](const Search& search) { return search.Curve(); });
    py::array_t<std::int32_t> evaluations(static_cast<py::ssize_t>(curve.size()));
    py::array_t<float> best(evaluations.size());
    std::ranges::transform(curve, evaluations.mutable_data(), &Search::CurvePoint::evaluation);
    std::ranges::transform(curve, best.mutable_data(), &Search::CurvePoint::best);
    return py::make_tuple(evaluations, best);
  }
  std::string Found() {
    const Genome best = Looked([](const Search& search) { return search.BestGenome(); });
    if (best.empty()) throw Fault("search: has found nothing yet");
    const py::gil_scoped_release released;
    return EncodeJson(DocumentWith(document_, best));
  }

  py::bytes Save() {
    std::vector<std::uint8_t> bytes;
    Alone([&] {
      if (open_ > 0)
        throw Fault("save: pass the scores of the last " + std::to_string(open_) + " genomes to tell first");
      BitWriter writer;
      search_->Save(writer);
      bytes = writer.Bytes();
    });
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  /// A state that is damaged leaves the search as it is.
  void Load(const py::bytes& state) {
    const auto text = static_cast<std::string_view>(state);
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    Alone([&] {
      auto search = New();
      BitReader reader(bytes);
      Take(search->Load(reader));
      search_ = std::move(search);
      open_ = 0;
    });
  }

 private:
  [[nodiscard]] std::unique_ptr<Search> New() const {
    return MakeSearch(document_.search, scorer_.Space(StartOf(document_)));
  }
  /// Calls without the interpreter's lock, one at a time.
  template <class Call>
  void Alone(Call call) {
    const py::gil_scoped_release released;
    const std::lock_guard lock(mutex_);
    call();
  }
  template <class Look>
  auto Looked(Look look) -> std::invoke_result_t<Look, const Search&> {
    const py::gil_scoped_release released;
    const std::lock_guard lock(mutex_);
    return look(std::as_const(*search_));
  }

  std::mutex mutex_;  // guards all of the search's state
  Document document_;
  Scorer scorer_;
  std::unique_ptr<Search> search_;
  std::size_t genes_;
  std::size_t open_ = 0;  // genomes that have been asked for, and whose scores have not come
};

}  // namespace

void AddSearchClass(py::module_& core) {
  py::class_<SearchClass>(core, "Search")
      .def(py::init([](const std::string& json, const std::optional<std::string>& algorithm,
                       std::optional<long long> seed, std::optional<long long> evaluations,
                       const std::vector<std::string>& options) {
        return std::make_unique<SearchClass>(WithSearch(json, algorithm, seed, evaluations, options));
      }))
      .def("json", &SearchClass::Json)
      .def("ask", &SearchClass::Ask)
      .def("tell", &SearchClass::Tell)
      .def("run", &SearchClass::Run)
      .def("found", &SearchClass::Found)
      .def("save", &SearchClass::Save)
      .def("load", &SearchClass::Load)
      .def("curve", &SearchClass::Curve)
      .def("population", &SearchClass::Population)
      .def("done", &SearchClass::Done)
      .def("evaluations", &SearchClass::Evaluations)
      .def("best_fitness", &SearchClass::BestFitness)
      .def("best_genome", &SearchClass::BestGenome);
}

}  // namespace gaitsmith::python
