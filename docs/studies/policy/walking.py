# SPDX-License-Identifier: MIT
"""Mr. Star-Man's problem as a task for ppo.py, and what a policy's mean action does in it."""
from __future__ import annotations

from typing import Any

import numpy as np

import gaitsmith

STEP = 0.01  # s
PROBLEM = gaitsmith.read("star-man-travel")


class Walk:
    """Worlds of one problem side by side. Keeps the best way of all episodes so far [m]."""

    def __init__(self, worlds: int, frame_skip: int) -> None:
        self._worlds = gaitsmith.VectorEnv(PROBLEM, num_envs=worlds, observation="state", autoreset_mode="same_step",
                                           frame_skip=frame_skip, tau=PROBLEM["senses"]["tau_min_s"])
        space = self._worlds.single_action_space
        self.low, self.high = space.low.astype(np.float64), space.high.astype(np.float64)
        self.observations = len(self._worlds.observation_names)
        self.worlds, self.seconds_per_step = worlds, frame_skip * STEP
        self.best = -np.inf
        self._way = np.zeros(worlds)

    def reset(self) -> np.ndarray:
        return self._worlds.reset()[0]

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Returns what is seen next, rewards, who broke, who ended, and what those saw last who ended."""
        seen, rewards, broke, ended, infos = self._worlds.step(actions.astype(np.float32))
        self._way += rewards
        over, last = broke | ended, seen
        if over.any():
            last = seen.copy()
            for i in np.flatnonzero(over):
                last[i] = infos["final_obs"][i]
            if ended.any():
                self.best = max(self.best, float(self._way[ended & ~broke].max(initial=-np.inf)))
            self._way[over] = 0.0
        return seen, rewards, broke, ended, last

    def trial(self, policy: Any) -> tuple[float, np.ndarray, float]:
        """One episode of the mean action in a task of one world: its way [m] (no number if physics broke), its actions (decisions, joints) float32, and its
        simulated seconds."""
        seen, way, actions = self.reset(), 0.0, []
        while True:
            actions.append(policy.mean_action(seen)[0].astype(np.float32))
            seen, rewards, broke, ended, _ = self.step(actions[-1][np.newaxis])
            way += float(rewards[0])
            if broke[0] or ended[0]:
                return float("nan") if broke[0] else way, np.array(actions), len(actions) * self.seconds_per_step
