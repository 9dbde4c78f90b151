# SPDX-License-Identifier: MIT
"""A known task, to see whether the PPO of ppo.py learns: a pendulum to swing up, with the equations, costs and limits of
Gymnasium's Pendulum-v1. Episodes last 200 steps and begin again at once, as VectorEnv's do with "same_step"."""
from __future__ import annotations

from typing import Any

import numpy as np

GRAVITY, MASS, LENGTH, STEP = 10.0, 1.0, 1.0, 0.05
MOST_SPEED, MOST_TORQUE, STEPS = 8.0, 2.0, 200


class Pendulums:
    """Several pendulums, each by itself. Observation: cosine, sine, angular speed [rad/s]; action: torque [N m]."""

    observations = 3
    low, high = np.array([-MOST_TORQUE]), np.array([MOST_TORQUE])
    seconds_per_step = STEP

    def __init__(self, worlds: int, seed: int) -> None:
        self.worlds = worlds
        self._random = np.random.default_rng(seed)
        self._angle, self._speed = np.zeros(worlds), np.zeros(worlds)
        self._steps = 0

    def reset(self) -> np.ndarray:
        self._angle = self._random.uniform(-np.pi, np.pi, self.worlds)
        self._speed = self._random.uniform(-1.0, 1.0, self.worlds)
        self._steps = 0
        return self._seen()

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Returns what is seen next, rewards, who broke, who ended, and what those saw last who ended."""
        torque = np.clip(actions[:, 0], -MOST_TORQUE, MOST_TORQUE)
        away = (self._angle + np.pi) % (2.0 * np.pi) - np.pi  # from upright
        rewards = -(away**2 + 0.1 * self._speed**2 + 0.001 * torque**2)
        turn = 3.0 * GRAVITY / (2.0 * LENGTH) * np.sin(self._angle) + 3.0 / (MASS * LENGTH**2) * torque
        self._speed = np.clip(self._speed + turn * STEP, -MOST_SPEED, MOST_SPEED)
        self._angle = self._angle + self._speed * STEP
        self._steps += 1
        last = self._seen()
        ended = np.full(self.worlds, self._steps == STEPS)
        return self.reset() if ended.all() else last, rewards, np.zeros(self.worlds, dtype=bool), ended, last

    def _seen(self) -> np.ndarray:
        return np.stack([np.cos(self._angle), np.sin(self._angle), self._speed], axis=1).astype(np.float32)


def mean_return(policy: Any, episodes: int, seed: int) -> float:
    """Of the mean action, over this many episodes."""
    task = Pendulums(episodes, seed)
    seen, total = task.reset(), np.zeros(episodes)
    for _ in range(STEPS):
        seen, rewards, _, _, _ = task.step(policy.mean_action(seen))
        total += rewards
    return float(total.mean())
