// SPDX-License-Identifier: MIT
#include "shell/python/problem_class.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <mutex>

#include "core/document/json.h"
#include "shell/command_line/synthesize_request.h"
#include "shell/python/array_check.h"
#include "shell/python/bindings.h"
#include "shell/python/fault.h"
#include "shell/search/parallel_evaluation.h"

namespace gaitsmith::python {

namespace py = pybind11;

namespace {

/// Number of a document's own controllers. Those that only handovers use follow them.
int OwnControllers(const Document& document) {
  int own = static_cast<int>(document.controllers.size());
  const auto keeps = [&](int controller) {
    return document.search.start == controller ||
           std::ranges::find(document.timeline, controller, &Clip::controller) != document.timeline.end() ||
           std::ranges::find(document.search.handovers, controller, &Handover::controller) ==
               document.search.handovers.end();
  };
  while (own > 0 && !keeps(own - 1)) --own;
  return own;
}

class ProblemClass {
 public:
  explicit ProblemClass(const std::string& json)
      : document_(DocumentOf(json)), problem_(ProblemOf(document_)), evaluator_(problem_) {}

  [[nodiscard]] std::size_t Genes() const { return problem_.Shape().Genes(); }
  [[nodiscard]] std::string Json() const { return EncodeJson(document_); }

  /// @return names of the columns, their numbers (columns, n), which motions are void, and the hashes or None
  py::tuple Evaluate(const py::object& genomes, long long threads, bool with_hash) {
    const auto rows = RowsOf(genomes, Genes());
    const int crew = InRange("threads", threads, 1, 256);
    const auto n = static_cast<py::ssize_t>(rows.size());
    std::vector<Evaluation> found;
    SignalWatch watch;
    {
      const py::gil_scoped_release released;
      const Evaluator& evaluator = with_hash ? HashingEvaluator() : evaluator_;
      found = shell::EvaluateInParallel(evaluator, rows, crew, [&] { return watch(); });
    }
    watch.ThrowIfStopped();
    const std::vector<std::string> names = ColumnNames();
    py::array_t<float> columns({static_cast<py::ssize_t>(names.size()), n});
    py::array_t<bool> broken(n);
    auto cell = columns.mutable_unchecked<2>();
    for (py::ssize_t i = 0; i < n; ++i) {
      const Evaluation& one = found[static_cast<std::size_t>(i)];
      py::ssize_t column = 0;
      cell(column++, i) = one.fitness;
      cell(column++, i) = one.terms.travel_m;
      for (const StyleTerm term : MeasuredTerms()) cell(column++, i) = one.terms.Style(term);
      if (document_.search.algorithm == Algorithm::kNsga)
        cell(column++, i) = CostOf(one.traits, document_.search.cost);
      broken.mutable_data()[i] = one.fitness <= kNoMotion;
    }
    py::object hashes = py::none();
    if (with_hash) {
      py::array_t<std::uint64_t> values(n);
      std::ranges::transform(found, values.mutable_data(), &Evaluation::trajectory_hash);
      hashes = values;
    }
    return py::make_tuple(names, columns, broken, hashes);
  }

  [[nodiscard]] py::array_t<Gene> RandomGenomes(long long count, long long seed) const {
    const int n = InRange("count", count, 1, 1'000'000);
    static_cast<void>(InRange("seed", seed >> 31, 0, 1));  // [0, 2^32)
    const SearchSpace space{problem_.Shape(), problem_.senses};
    std::vector<Genome> genomes;
    genomes.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
      genomes.push_back(FirstGenome(space, document_.search.variation, static_cast<std::uint32_t>(seed), i));
    return ArrayOf(genomes, Genes());
  }

  /// A child of each, as climbers make them, from its own random numbers.
  [[nodiscard]] py::array_t<Gene> Perturbed(const py::object& genomes, long long seed) const {
    const auto rows = RowsOf(genomes, Genes());
    static_cast<void>(InRange("seed", seed >> 31, 0, 1));  // [0, 2^32)
    const ControllerShape shape = problem_.Shape();
    std::vector<Genome> children;
    children.reserve(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      RandomStream random(static_cast<std::uint64_t>(seed), i, 1);
      children.push_back(Perturb(rows[i], shape, problem_.senses, document_.search.variation, random));
    }
    return ArrayOf(children, Genes());
  }

  /// The genome of one of a document's controllers.
  [[nodiscard]] py::array_t<Gene> GenomeIn(const std::string& json, long long controller) const {
    const Document other = DocumentOf(json);
    if (other.controllers.empty()) throw Fault("document.controllers: has no controller");
    const int most = static_cast<int>(other.controllers.size()) - 1;
    const int index = InRange("controller", controller, 0, most);
    const Controller& one = other.controllers[static_cast<std::size_t>(index)];
    if (!FitsSearch(document_, one) || one.genes.size() != Genes())
      throw Fault("document.controllers[" + std::to_string(index) +
                  "]: has another kind, other senses or another number of rules than the problem");
    return ArrayOf(std::span(&one.genes, 1), Genes());
  }

  [[nodiscard]] std::string DocumentOfGenome(const py::object& genome) const {
    const auto rows = RowsOf(genome, Genes());
    if (rows.size() != 1) throw Fault("genome: must be one, there are " + std::to_string(rows.size()));
    return EncodeJson(DocumentWith(document_, Genome(rows[0].begin(), rows[0].end())));
  }

 private:
  /// Terms that a search measures: the paper's, and further ones with a weight.
  [[nodiscard]] std::vector<StyleTerm> MeasuredTerms() const {
    const FurtherTerms further = WeightedFurtherTerms(problem_.task);
    std::vector<StyleTerm> terms;
    for (int term = 0; term < kStyleTerms; ++term) {
      if (term < kPaperTerms || further[static_cast<std::size_t>(term - kPaperTerms)])
        terms.push_back(static_cast<StyleTerm>(term));
    }
    return terms;
  }
  [[nodiscard]] std::vector<std::string> ColumnNames() const {
    std::vector<std::string> names{"fitness", "travel"};
    for (const StyleTerm term : MeasuredTerms())
      names.emplace_back(kStyleTermNames[static_cast<std::size_t>(term)]);
    if (document_.search.algorithm == Algorithm::kNsga) names.emplace_back("cost");
    return names;
  }
  /// Made when first needed. Several threads may ask for it.
  const Evaluator& HashingEvaluator() {
    std::call_once(hashing_made_, [this] { hashing_.emplace(problem_, true); });
    return *hashing_;
  }

  Document document_;
  Problem problem_;
  Evaluator evaluator_;
  std::once_flag hashing_made_;
  std::optional<Evaluator> hashing_;
};

}  // namespace

Document DocumentWith(const Document& searched, const Genome& found) {
  Document document = searched;
  const int own = OwnControllers(document);
  if (document.search.in_place_of < 0 && own >= kMaxControllers)
    throw Fault("document.controllers: has " + std::to_string(own) + "; there is no room for another one");
  Controller controller = TakeFound(searched, found, document);
  controller.name =
      "found by " + std::string(kAlgorithmNames[static_cast<std::size_t>(document.search.algorithm)]);
  Take(shell::PutFound(controller, own, document));
  document.hash.reset();
  Take(Validate(document));
  document.hash = Simulate(document).Hash();
  return document;
}

void AddProblemClass(py::module_& core) {
  py::class_<ProblemClass>(core, "Problem")
      .def(py::init<const std::string&>())
      .def_property_readonly("genes", &ProblemClass::Genes)
      .def("json", &ProblemClass::Json)
      .def("evaluate", &ProblemClass::Evaluate)
      .def("random_genomes", &ProblemClass::RandomGenomes)
      .def("perturbed", &ProblemClass::Perturbed)
      .def("genome_in", &ProblemClass::GenomeIn)
      .def("document_of", &ProblemClass::DocumentOfGenome);
}

}  // namespace gaitsmith::python
