# SPDX-License-Identifier: MIT
"""Motions as arrays."""
from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from .border import Document, json_of, whole


class Motion(dict[str, np.ndarray]):
    """The columns of ``gaitsmith simulate`` by name: arrays with one number for each frame, float64 but for ``rule``.

    ``t`` [s]; ``x``, ``y`` of the centre of mass [m] and its velocity ``vx``, ``vy`` [m/s]; turn of the root rod ``phi``
    [rad]; angular momentum ``L`` [kg m^2/s]; active ``rule`` from 1 (int32); joint angles ``theta_1``... [rad];
    endpoints ``node0_x``, ``node0_y``... [m]; normal and tangential contact forces ``fn0``, ``ft0``... [N].

    hash:  the trajectory's hash, 16 hexadecimal digits
    terms: the columns of ``gaitsmith measure`` but for the hash: travel [m], the secondary terms, fitness
    """

    hash: str
    terms: dict[str, float]

    def __init__(self, columns: dict[str, np.ndarray], hash: str, terms: dict[str, float]) -> None:
        super().__init__(columns)
        self.hash = hash
        self.terms = terms


def simulate(document: Document) -> Motion:
    """Simulates a document's motion, in steps of 0.01 s. Frame 0 is the start. The interpreter's lock is released.

    Raises Error if the document is not valid.
    """
    return Motion(*_core.simulate(json_of(document)))


def measure(document: Document) -> dict[str, float]:
    """The terms of a document's motion and its fitness; -1e9 for a motion that breaks physics."""
    return simulate(document).terms


def decisions(document: Document, clip: int = 0) -> dict[str, np.ndarray]:
    """What a clip's controller sensed and decided, the numbers of ``gaitsmith senses``.

    clip: index of the document's timeline, from 0
    Returns ``step`` and ``rule`` (n,), ``senses`` (n, senses), and by joint ``target`` [rad], ``inverse_tau`` [1/s] and
    ``decay``, e^(-0.01 s / tau) (n, joints). The first row is the moment at which the controller takes over.
    """
    return _core.decisions(json_of(document), whole("clip", clip))
