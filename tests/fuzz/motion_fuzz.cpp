// SPDX-License-Identifier: MIT
// Any figure, controller, start, ground and pushes: the motion keeps the laws of physics until a guard makes
// it void, and has the same bits in two runs and for every lane count. Input bytes: one that selects whether
// the figure has a controller, then genes of 16 bits.
#include <cstdio>
#include <cstdlib>
#include <vector>

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
  const Document document = DocumentOf(World::kAny, still, genes);
  if (!Validate(document)) std::abort();
  const Motion motion = Simulate(document);
  const Offences offences = Judge(document, motion);
  if (const int law = offences.FirstBroken(); law < kLaws) {
    const auto i = static_cast<std::size_t>(law);
    std::fprintf(stderr, "%s: %g in frame %d\n", std::string(kLawLimits[i].name).c_str(), offences.of[i].by,
                 offences.of[i].frame);
    std::abort();
  }
  if (still ? Simulate(document).Hash() != motion.Hash() : DifferingBits(document, motion) > 0) std::abort();
  return 0;
}
