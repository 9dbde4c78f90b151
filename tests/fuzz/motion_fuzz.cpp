// SPDX-License-Identifier: MIT
// Any figure, controller, start, ground and pushes, in every model: the motion keeps the laws of physics
// until a guard makes it void, and has the same bits in two runs and for every lane count. Input bytes: one
// that selects whether the figure has a controller and whether its joints are limited, then genes of 16 bits.
// What breaks a law is also written as a document, into the file that GAITSMITH_FIND names.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "core/document/json.h"
#include "core/rollout/models.h"
#include "tests/adversary/genes_as_document.h"
#include "tests/physics_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gaitsmith;
  using namespace gaitsmith::test;
  if (size < 3) return 0;
  std::vector<Gene> genes;
  for (std::size_t at = 1; at + 2 <= size && genes.size() < kDocumentGenes; at += 2) {
    genes.push_back(static_cast<Gene>(data[at] << 8 | data[at + 1]));
  }
  const bool still = data[0] % 4 == 0;
  const int model = 1 + data[0] / 4 % kModelVersion;
  const Document document = DocumentOf(Scope::kAny, model, still, genes);
  if (!Validate(document)) std::abort();
  const Motion motion = Simulate(document);
  const Offences offences = Judge(document, motion);
  if (offences.FirstBroken() < kLaws) {
    std::fprintf(stderr, "%s\n", offences.Sentence().c_str());
    if (const char* find = std::getenv("GAITSMITH_FIND")) std::ofstream(find) << EncodeJson(document);
    std::abort();
  }
  if (still ? Simulate(document).Hash() != motion.Hash() : DifferingBits(document, motion) > 0) std::abort();
  return 0;
}
