// SPDX-License-Identifier: MIT
#include "core/rollout/rollout.h"

namespace gaitsmith {

std::vector<Takeover<1>> DecodeClips(std::span<const Clip> clips, std::span<const Controller> controllers,
                                     const Ports& ports, float step_s) {
  std::vector<Takeover<1>> takeovers;
  takeovers.reserve(clips.size());
  for (const Clip& clip : clips) {
    const Controller& controller = controllers[static_cast<std::size_t>(clip.controller)];
    const std::span<const Gene> genes(controller.genes);
    takeovers.push_back(
        {clip.start_step, DecodeControllers<1>(controller.Shape(ports.Count()), controller.senses,
                                               std::span(&genes, 1), ports, step_s)});
  }
  return takeovers;
}

}  // namespace gaitsmith
