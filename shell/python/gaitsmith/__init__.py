# SPDX-License-Identifier: MIT
"""Finds motions of 2D articulated figures by search, after *Motion-Synthesis Techniques for 2D Articulated Figures*
[Fukunaga 1994].

A document is a dictionary with the fields of a document's JSON file. It determines every bit of its motion: the same
document has the same motion here, on the command line and in the page. Every input that is wrong raises ``Error``,
which is a ``ValueError``, with a sentence that says where and what.
"""
from ._core import Error
from ._core import version as __version__
from .documents import (
    catalogue,
    complete,
    decode_link,
    document,
    encode_link,
    read,
    style_terms,
    write,
)
from .environment import Env, VectorEnv
from .motion import Motion, decisions, measure, simulate
from .playground import Playground
from .problem import Evaluations, Problem, evaluate
from .search import Search, synthesize
from .spaces import Box
from .study import Study, compare, compare_ranks, holm_adjusted

__all__ = [
    "Box",
    "Env",
    "Error",
    "Evaluations",
    "Motion",
    "Playground",
    "Problem",
    "Search",
    "Study",
    "VectorEnv",
    "__version__",
    "catalogue",
    "compare",
    "compare_ranks",
    "complete",
    "decisions",
    "decode_link",
    "document",
    "encode_link",
    "evaluate",
    "holm_adjusted",
    "measure",
    "read",
    "simulate",
    "style_terms",
    "synthesize",
    "write",
]

Error.__module__ = __name__  # where users find it
