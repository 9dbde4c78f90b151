# SPDX-License-Identifier: MIT
"""Documents: files, links, and the options of ``gaitsmith synthesize``."""
from __future__ import annotations

import json
import os
from typing import Any

from . import _core
from .border import Document, Name, json_of, option_values, text


def read(name: Name) -> dict[str, Any]:
    """Reads a document, with every field.

    name: a JSON file, a link, or the name of a shipped example, problem or motion, such as "star-man-travel".
    Raises Error if there is none, or if it is not valid.
    """
    name = text("name", os.fspath(name) if isinstance(name, os.PathLike) else name)
    if name == "-":
        raise _core.Error("name: standard input is read by the command line only")
    return json.loads(_core.read(name))


def write(document: Document, path: Name) -> None:
    """Writes a document as a JSON file, with every field, as ``gaitsmith`` writes it.

    Raises Error if the document is not valid, and OSError if the file cannot be written.
    """
    content = _core.complete(json_of(document))
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(content)


def complete(document: Document) -> dict[str, Any]:
    """Checks a document and fills in every field that was left out. Raises Error with the first fault."""
    return json.loads(_core.complete(json_of(document)))


def encode_link(document: Document) -> str:
    """The document as the text after # in an address of the playground, with its trajectory's hash."""
    return _core.encode_link(json_of(document))


def decode_link(link: str) -> dict[str, Any]:
    """The document of a link, or of a whole address. Raises Error if it is damaged."""
    return json.loads(_core.decode_link(text("link", link)))


def document(**options: Any) -> dict[str, Any]:
    """A document for a search, from the options of ``gaitsmith synthesize``, without the controller to be found.

    Names are those of docs/command-line.md, with _ in place of -, and ``from_`` for --from: figure, problem, from_, repair, clip,
    task, sense, weight, way, pose, controller, rules, duration [s], joints, ground, handover, search, search_option,
    evaluations, seed. An option that may come several times takes a list, or a dictionary:
    ``weight={"slip_sum": "usual"}``, ``search_option={"cma.step": 0.2}``.

    Raises Error, which names the option as on the command line.
    """
    words: list[str] = []
    for name, value in options.items():
        for one in option_values(name, value):
            words += ["--" + name.rstrip("_").replace("_", "-"), one]
    return json.loads(_core.document(words))


def catalogue() -> dict[str, Any]:
    """Every table of names: algorithms, style terms, senses, tasks and more, as ``gaitsmith catalogue`` prints it."""
    return json.loads(_core.catalogue())


def style_terms() -> list[dict[str, Any]]:
    """The secondary terms of a task [Fukunaga 1994, Table 3, and our own]: names, units and usual weights."""
    return catalogue()["terms"]
