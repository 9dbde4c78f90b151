# SPDX-License-Identifier: MIT
"""The twenty configurations of each side (question.md): the published or shipped one, and nineteen drawn with a fixed seed."""
from __future__ import annotations

from typing import Any, Union

import numpy as np

DRAWS = 3100

POLICY: dict[str, tuple[Any, ...]] = {
    "learning_rate": (3e-4, 1e-4, 6e-4, 1e-3),
    "discount": (0.99, 0.95, 0.98, 0.995),
    "entropy": (0.0, 0.003, 0.01),
    "clip": (0.2, 0.1, 0.3),
    "epochs": (10, 5),
    "horizon": (64, 32, 128),        # decisions of each world between two updates
    "minibatch": (1024, 256),        # decisions
    "spread": (1.0, 0.37, 0.6),      # standard deviation of the first actions, in half the range of a joint
    "frame_skip": (10, 5, 20),       # steps of 0.01 s for each decision
}
RULES: dict[str, tuple[Any, ...]] = {
    "population": (10, 2, 4, 20),
    "reseed_interval": (200, 50, 100, 400),
    "gene_chance": (0.1, 0.05, 0.2),
    "creep": (0.1, 0.05, 0.2),
    "redraw": (0.05, 0.02, 0.1),
    "dont_care": (0.8, 0.7, 0.9),
}


def configurations(ranges: dict[str, tuple[Any, ...]]) -> list[dict[str, Union[int, float]]]:
    """The first of each range, then nineteen others, all different."""
    random = np.random.default_rng(DRAWS)
    found = [{name: values[0] for name, values in ranges.items()}]
    while len(found) < 20:
        drawn = {name: values[int(random.integers(len(values)))] for name, values in ranges.items()}
        if drawn not in found:
            found.append(drawn)
    return found
