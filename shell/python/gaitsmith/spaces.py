# SPDX-License-Identifier: MIT
"""The space of arrays within limits: Gymnasium's ``spaces.Box`` where it is installed, otherwise one with the same
members as far as environments need them."""
from __future__ import annotations

from typing import Any, Optional

import numpy as np


class OwnBox:
    """Arrays of one shape and type, each number within limits of its own.

    low, high: arrays of the shape; -inf and inf where there is no limit
    """

    def __init__(
        self, low: Any, high: Any, shape: Optional[tuple[int, ...]] = None, dtype: Any = np.float32, seed: Any = None
    ) -> None:
        self.dtype = np.dtype(dtype)
        self.shape = tuple(np.shape(low) if shape is None else shape)
        self.low = np.broadcast_to(np.asarray(low, dtype=self.dtype), self.shape).copy()
        self.high = np.broadcast_to(np.asarray(high, dtype=self.dtype), self.shape).copy()
        self._np_random = np.random.default_rng(seed)

    def seed(self, seed: Optional[int] = None) -> Any:
        """Seeds what ``sample`` draws."""
        self._np_random = np.random.default_rng(seed)
        return seed

    def sample(self) -> np.ndarray:
        """A random array: uniform between limits, normal where there is no limit."""
        bounded = np.isfinite(self.low) & np.isfinite(self.high)
        drawn = self._np_random.normal(size=self.shape)
        low, high = np.where(bounded, self.low, 0.0), np.where(bounded, self.high, 0.0)
        drawn = np.where(bounded, self._np_random.uniform(low, high, size=self.shape), drawn)
        return np.clip(drawn.astype(self.dtype), self.low, self.high)

    def contains(self, x: Any) -> bool:
        """Whether an array has the space's shape, a type that fits, and numbers within the limits."""
        x = np.asarray(x)
        return bool(
            np.can_cast(x.dtype, self.dtype)
            and x.shape == self.shape
            and np.all(x >= self.low)
            and np.all(x <= self.high)
        )

    def __contains__(self, x: Any) -> bool:
        return self.contains(x)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, OwnBox)
            and self.shape == other.shape
            and self.dtype == other.dtype
            and np.array_equal(self.low, other.low)
            and np.array_equal(self.high, other.high)
        )

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"Box({self.low.min(initial=np.inf)}, {self.high.max(initial=-np.inf)}, {self.shape}, {self.dtype})"


try:
    from gymnasium.spaces import Box
except ImportError:
    Box = OwnBox  # type: ignore[misc, assignment]
