# SPDX-License-Identifier: MIT
"""Environments for reinforcement learning, by the rules of Gymnasium 1.0 and later. Gymnasium need not be installed:
where it is, these classes are its own VectorEnv and Env, and their spaces its own."""
from __future__ import annotations

import enum
from typing import Any, Optional, Union

import numpy as np

from . import _core
from .border import Document, json_of, text, whole
from .problem import Problem
from .spaces import Box

try:
    from gymnasium import Env as _EnvBase
    from gymnasium.vector import VectorEnv as _VectorBase
except ImportError:
    _EnvBase = _VectorBase = object

try:
    from gymnasium.vector import AutoresetMode
except ImportError:

    class AutoresetMode(enum.Enum):  # type: ignore[no-redef]
        """When a world whose episode has ended begins again."""

        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"


def _mode(mode: Any) -> AutoresetMode:
    for one in AutoresetMode:
        if mode is one or mode in (one.value, one.name, one.name.lower()):
            return one
    raise _core.Error(f"autoreset_mode: must be one of next_step, same_step, disabled, is {mode!r}")


class VectorEnv(_VectorBase):
    """Several worlds of one problem, whose joints follow actions in place of a controller.

    problem:        a Problem or a document, of any physical model
    num_envs:       worlds, 1 to 65536
    observation:    "senses": what the problem's controllers sense [Fukunaga 1994, Table 1], normalised; or "state":
                    joint angles [rad] and rates [rad/s], sine, cosine and rate [rad/s] of the root's turn, height [m]
                    and velocity [m/s] of the centre of mass, and 1 for each endpoint that the ground pushes. The
                    paper's senses suffice for its rules, but lack the rates of joints and of the turn. Figures of
                    springs have lengths of muscles [drawn lengths] and the turn that fits best
    autoreset_mode: "next_step", "same_step" or "disabled", or Gymnasium's AutoresetMode
    tau:            time constant [s], 0.02 to 10, with which joints approach their targets as the paper's responses do
                    [section 2]: theta'' = (target - theta) / tau^2 - 2 theta' / tau, critically damped
    frame_skip:     simulation steps of 0.01 s for each action
    start_noise:    greatest change of the start's velocity [m/s] and spin [rad/s], uniform; 0: every episode begins
                    alike, and ``seed`` changes nothing

    Action: a target for each joint relative to its drawn angle [rad], or for each muscle its length without force
    [drawn lengths], within limits. Targets beyond are brought into them. Reward: by how much the task's primary term
    has grown [m], so that the rewards of an episode add up to the fitness without style. ``terminated``: physics broke,
    which takes back all the episode's rewards, since its motion is void. ``truncated``: the task's duration is over.
    ``infos["travel"]``: way of the centre of mass [m].

    By standard a world that has ended begins again in the next step (NEXT_STEP): that step ignores its action, and
    returns its first observation with a reward of 0. With "same_step" the last observation is in
    ``infos["final_obs"]``, and the last infos in ``infos["final_info"]``. With "disabled" worlds begin again by
    ``reset(options={"reset_mask": mask})``.

    Raises Error for a problem that begins elsewhere than at its start or has several worlds, and for wrong actions.
    """

    spec = None
    render_mode = None
    closed = False

    def __init__(
        self,
        problem: Union[Problem, Document],
        num_envs: int = 1,
        observation: str = "senses",
        autoreset_mode: Any = AutoresetMode.NEXT_STEP,
        tau: float = 0.15,
        frame_skip: int = 1,
        start_noise: float = 0.0,
    ) -> None:
        self._mode = _mode(autoreset_mode)
        self.metadata = {"autoreset_mode": self._mode, "render_modes": [], "render_fps": 100}
        if not _is_number(tau):
            raise _core.Error(f"tau: must be a number, is {tau!r}")
        if not _is_number(start_noise) or not 0.0 <= start_noise <= 10.0:
            raise _core.Error(f"start_noise: must be from 0 to 10, is {start_noise!r}")
        self._worlds = _core.Worlds(
            json_of(problem), whole("num_envs", num_envs), text("observation", observation), float(tau),
            whole("frame_skip", frame_skip),
        )
        self.num_envs = int(num_envs)
        self.observation_names: list[str] = self._worlds.names()
        low, high = self._worlds.limits()
        size = (len(self.observation_names),)
        self.single_observation_space = Box(-np.inf, np.inf, size, np.float32)
        self.observation_space = Box(-np.inf, np.inf, (self.num_envs, *size), np.float32)
        self.single_action_space = Box(low, high, dtype=np.float32)
        self.action_space = Box(np.tile(low, (self.num_envs, 1)), np.tile(high, (self.num_envs, 1)), dtype=np.float32)
        self._noise = float(start_noise)
        self._random = [np.random.default_rng() for _ in range(self.num_envs)]
        self._ended = np.zeros(self.num_envs, dtype=bool)
        self._begun = False

    def reset(self, *, seed: Optional[int] = None, options: Optional[dict[str, Any]] = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Begins an episode in every world.

        seed:    makes the starts repeatable, of each world by itself; None goes on drawing
        options: {"reset_mask": bool (num_envs,)} begins only these worlds
        Returns the observations (num_envs, n) float32, and the infos.
        """
        self._check_open()
        if seed is not None:
            base = whole("seed", seed)
            if base < 0:
                raise _core.Error(f"seed: must not be negative, is {base}")
            self._random = [np.random.default_rng([base, i]) for i in range(self.num_envs)]
        mask = np.ones(self.num_envs, dtype=bool)
        if options is not None and options.get("reset_mask") is not None:
            mask = np.asarray(options["reset_mask"])
            if mask.dtype != bool or mask.shape != (self.num_envs,):
                raise _core.Error(
                    f"reset_mask: must be an array of bool with shape ({self.num_envs},), is {mask.dtype} with shape {mask.shape}"
                )
            if not self._begun and not mask.all():
                raise _core.Error("reset_mask: the first reset must be of all worlds")
        self._begin(mask)
        self._begun = True
        return self._worlds.observe(), self._infos()

    def step(self, actions: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Moves every world on by one action. The interpreter's lock is released.

        actions: targets [rad] (num_envs, joints)
        Returns observations (num_envs, n) float32, rewards float64, terminated and truncated (num_envs,) bool, infos.
        """
        self._check_open()
        if not self._begun:
            raise _core.Error("step: reset must come first")
        resting = self._ended
        if resting.any() and self._mode is AutoresetMode.DISABLED:
            raise _core.Error(f"step: world {int(np.argmax(resting))} has ended, and must be reset first")
        seen, rewards, terminated, truncated = self._worlds.step(actions, resting)
        if resting.any():  # NEXT_STEP: they begin again, whatever their action
            self._begin(resting)
            seen = self._worlds.observe()
        self._ended = terminated | truncated
        infos = self._infos()
        if self._mode is AutoresetMode.SAME_STEP and self._ended.any():
            ended = self._ended
            final_obs = np.full(self.num_envs, None, dtype=object)  # as Gymnasium has it
            for i in np.flatnonzero(ended):
                final_obs[i] = seen[i]
            final = {"travel": np.where(ended, infos["travel"], 0.0), "_travel": ended.copy()}
            self._begin(ended)
            seen = self._worlds.observe()
            infos = self._infos()
            infos.update(final_obs=final_obs, _final_obs=ended.copy(), final_info=final, _final_info=ended.copy())
        return seen, rewards, terminated, truncated, infos

    def close(self, **kwargs: Any) -> None:
        """Nothing can be done with the environment afterwards."""
        self.closed = True

    def render(self) -> None:
        """There are no pictures: simulate a document, or export it."""
        return None

    @property
    def unwrapped(self) -> VectorEnv:
        return self

    def _begin(self, mask: np.ndarray) -> None:
        noise = np.zeros((self.num_envs, 3), dtype=np.float32)
        if self._noise > 0.0:
            for i in np.flatnonzero(mask):
                noise[i] = self._random[i].uniform(-self._noise, self._noise, 3)
        self._worlds.reset(mask, noise)
        self._ended = self._ended & ~mask

    def _infos(self) -> dict[str, Any]:
        return {"travel": self._worlds.travel(), "_travel": np.ones(self.num_envs, dtype=bool)}

    def _check_open(self) -> None:
        if self.closed:
            raise _core.Error("environment: is closed")


class Env(_EnvBase):
    """One world, by the rules of Gymnasium's Env. The arguments are those of VectorEnv but for num_envs and
    autoreset_mode."""

    spec = None
    render_mode = None
    metadata: dict[str, Any] = {"render_modes": [], "render_fps": 100}

    def __init__(
        self,
        problem: Union[Problem, Document],
        observation: str = "senses",
        tau: float = 0.15,
        frame_skip: int = 1,
        start_noise: float = 0.0,
    ) -> None:
        self._vector = VectorEnv(problem, 1, observation, AutoresetMode.DISABLED, tau, frame_skip, start_noise)
        self.observation_names = self._vector.observation_names
        self.observation_space = self._vector.single_observation_space
        self.action_space = self._vector.single_action_space

    def reset(self, *, seed: Optional[int] = None, options: Optional[dict[str, Any]] = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Begins an episode. Returns the observation (n,) float32 and the info."""
        if _EnvBase is not object:
            super().reset(seed=seed)
        observations, infos = self._vector.reset(seed=seed)
        return observations[0], {"travel": float(infos["travel"][0])}

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Moves on by one action (joints,) [rad]. Returns observation, reward, terminated, truncated, info."""
        seen, rewards, terminated, truncated, infos = self._vector.step(np.asarray(action)[np.newaxis])
        return seen[0], float(rewards[0]), bool(terminated[0]), bool(truncated[0]), {"travel": float(infos["travel"][0])}

    def render(self) -> None:
        """There are no pictures."""
        return None

    def close(self) -> None:
        self._vector.close()


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool)
