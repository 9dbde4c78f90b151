# SPDX-License-Identifier: MIT
"""Proximal policy optimisation [Schulman et al. 2017] with generalised advantages [Schulman et al. 2016], for tasks of
several worlds side by side: pendulum.py has one, walking.py another."""
from __future__ import annotations

from typing import Any, Callable

import numpy as np
import torch
from torch import nn

LAMBDA, GREATEST_GRADIENT, VALUE_WEIGHT, BOUND = 0.95, 0.5, 0.5, 10.0


class Spread:
    """Running mean and variance, by joining batches [Chan et al. 1983]."""

    def __init__(self, size: int) -> None:
        self.mean, self.variance, self.count = np.zeros(size), np.ones(size), 1e-4

    def add(self, batch: np.ndarray) -> None:
        rows, difference = len(batch), batch.mean(axis=0) - self.mean
        total = self.count + rows
        self.variance = (self.variance * self.count + batch.var(axis=0) * rows + difference**2 * self.count * rows / total) / total
        self.mean = self.mean + difference * rows / total
        self.count = total


def layers(inputs: int, outputs: int, last: float) -> nn.Sequential:
    """Two hidden layers of 64, orthogonal weights, the last ones scaled."""
    found = nn.Sequential(nn.Linear(inputs, 64), nn.Tanh(), nn.Linear(64, 64), nn.Tanh(), nn.Linear(64, outputs))
    for layer, gain in zip(found[::2], (2**0.5, 2**0.5, last)):
        nn.init.orthogonal_(layer.weight, gain)
        nn.init.zeros_(layer.bias)
    return found


class Policy:
    """A normal distribution over actions, whose mean is a network of what is seen. Actions of the network are scaled so that
    -1 and 1 are the ends of each range; the task brings what lies beyond back into it."""

    def __init__(self, task: Any, spread: float) -> None:
        self.middle, self.half = (task.low + task.high) / 2.0, (task.high - task.low) / 2.0
        self.seen = Spread(task.observations)
        self.actor = layers(task.observations, len(task.low), 0.01)
        self.critic = layers(task.observations, 1, 1.0)
        self.log_spread = nn.Parameter(torch.full((len(task.low),), float(np.log(spread))))

    def normal(self, seen: np.ndarray) -> torch.Tensor:
        return torch.as_tensor(np.clip((seen - self.seen.mean) / np.sqrt(self.seen.variance + 1e-8), -BOUND, BOUND), dtype=torch.float32)

    def distribution(self, normal: torch.Tensor) -> torch.distributions.Normal:
        return torch.distributions.Normal(self.actor(normal), self.log_spread.exp())

    def action(self, unscaled: torch.Tensor) -> np.ndarray:
        return self.middle + self.half * unscaled.numpy().astype(np.float64)

    def mean_action(self, seen: np.ndarray) -> np.ndarray:
        with torch.no_grad():
            return self.action(self.actor(self.normal(seen)))


def train(task: Any, settings: dict[str, Any], seed: int, seconds: float, after_update: Callable[[Policy, float], float]) -> Policy:
    """Trains until the worlds have simulated this long.

    settings:     learning_rate, discount, entropy, clip, epochs, horizon, minibatch, spread
    after_update: called with the policy and the simulated seconds so far, returns how many it has simulated itself
    """
    torch.manual_seed(seed)
    torch.set_num_threads(1)
    policy = Policy(task, settings["spread"])
    parameters = [*policy.actor.parameters(), *policy.critic.parameters(), policy.log_spread]
    optimiser = torch.optim.Adam(parameters, lr=settings["learning_rate"], eps=1e-5)
    horizon, worlds, discount = int(settings["horizon"]), task.worlds, float(settings["discount"])
    gains, gain_spread = np.zeros(worlds), Spread(1)
    seen, simulated = task.reset(), 0.0
    while simulated < seconds:
        for group in optimiser.param_groups:
            group["lr"] = settings["learning_rate"] * (1.0 - simulated / seconds)
        observed, unscaled, chances = [], [], []
        rewards, broke, ended = (np.zeros((horizon, worlds)) for _ in range(3))
        last_values = np.zeros((horizon, worlds))
        policy.seen.add(seen)
        for t in range(horizon):
            normal = policy.normal(seen)
            with torch.no_grad():
                distribution = policy.distribution(normal)
                drawn = distribution.sample()
                chances.append(distribution.log_prob(drawn).sum(1))
            observed.append(normal)
            unscaled.append(drawn)
            seen, rewards[t], broke[t], ended[t], last = task.step(policy.action(drawn))
            policy.seen.add(seen)
            if ended[t].any() or t == horizon - 1:  # an episode cut off by its time limit goes on in its value
                with torch.no_grad():
                    last_values[t] = policy.critic(policy.normal(last)).numpy()[:, 0]
            gains = gains * discount + rewards[t]
            gain_spread.add(gains[:, np.newaxis])
            gains[(ended[t] + broke[t]) > 0] = 0.0
        scaled = np.clip(rewards / np.sqrt(gain_spread.variance[0] + 1e-8), -BOUND, BOUND)
        simulated += horizon * worlds * task.seconds_per_step
        together = torch.stack(observed)
        with torch.no_grad():
            values = policy.critic(together).numpy()[:, :, 0]
        advantages, running = np.zeros((horizon, worlds)), np.zeros(worlds)
        for t in reversed(range(horizon)):
            over = (ended[t] + broke[t]) > 0
            following = np.where(over | (t == horizon - 1), last_values[t], values[min(t + 1, horizon - 1)])
            error = scaled[t] + discount * np.where(broke[t] > 0, 0.0, following) - values[t]
            running = error + discount * LAMBDA * np.where(over, 0.0, running)
            advantages[t] = running
        learn(policy, optimiser, parameters, settings, together.flatten(0, 1), torch.stack(unscaled).flatten(0, 1), torch.cat(chances),
              torch.as_tensor(advantages, dtype=torch.float32).flatten(), torch.as_tensor(advantages + values, dtype=torch.float32).flatten())
        simulated += after_update(policy, simulated)
    return policy


def learn(policy: Policy, optimiser: torch.optim.Optimizer, parameters: list[torch.Tensor], settings: dict[str, Any], seen: torch.Tensor, unscaled: torch.Tensor,
          chances: torch.Tensor, advantages: torch.Tensor, returns: torch.Tensor) -> None:
    """One update: several passes over what was seen, in shuffled minibatches."""
    for _ in range(int(settings["epochs"])):
        order = torch.randperm(len(seen))
        for batch in order.split(int(settings["minibatch"])):
            distribution = policy.distribution(seen[batch])
            ratio = (distribution.log_prob(unscaled[batch]).sum(1) - chances[batch]).exp()
            advantage = advantages[batch]
            advantage = (advantage - advantage.mean()) / (advantage.std(unbiased=False) + 1e-8)
            clipped = ratio.clamp(1.0 - settings["clip"], 1.0 + settings["clip"])
            gain = torch.min(ratio * advantage, clipped * advantage).mean()
            error = (policy.critic(seen[batch])[:, 0] - returns[batch]).pow(2).mean()
            loss = VALUE_WEIGHT * error - gain - settings["entropy"] * distribution.entropy().sum(1).mean()
            optimiser.zero_grad()
            loss.backward()
            nn.utils.clip_grad_norm_(parameters, GREATEST_GRADIENT)
            optimiser.step()
