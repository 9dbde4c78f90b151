# SPDX-License-Identifier: MIT
"""What crosses the border to the compiled part: documents as JSON, options as words."""
from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any, Union

from . import _core

Document = Mapping[str, Any]
Name = Union[str, "os.PathLike[str]"]


def json_of(document: Any) -> str:
    """The JSON of a document, or of anything that holds one (a Problem, a Search)."""
    document = getattr(document, "document", document)
    if callable(document):  # a Search makes its document when asked
        document = document()
    if not isinstance(document, Mapping):
        raise _core.Error(f"document: must be a dictionary, is a {type(document).__name__}")
    try:
        return json.dumps(document, default=_number)
    except (TypeError, ValueError, RecursionError) as fault:
        raise _core.Error(f"document: cannot be written as JSON: {fault}") from None


def _number(value: Any) -> Any:
    """Numbers and arrays of NumPy inside a document."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"a {type(value).__name__} is neither text nor number")


def whole(name: str, value: Any) -> int:
    """A whole number, also one of NumPy. Limits are checked by the compiled part."""
    try:
        number = value.__index__()
    except (AttributeError, TypeError):
        raise _core.Error(f"{name}: must be a whole number, is {value!r}") from None
    if isinstance(value, bool) or abs(number) >= 1 << 62:
        raise _core.Error(f"{name}: must be a whole number below 2^62, is {value!r}")
    return number


def text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise _core.Error(f"{name}: must be text, is a {type(value).__name__}")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise _core.Error(f"{name}: is not well-formed Unicode: {value!r}") from None
    return value


def threads_or_cores(threads: Any) -> int:
    """A number of threads; None means all cores."""
    return _core.cores() if threads is None else whole("threads", threads)


def option_values(name: str, value: Any) -> list[str]:
    """One value of an option, a list of values, or a dictionary whose pairs become NAME=VALUE."""
    if isinstance(value, Mapping):
        return [text(name, f"{key}={one}") for key, one in value.items()]
    if isinstance(value, (list, tuple)):
        return [text(name, str(one)) for one in value]
    if value is None or isinstance(value, bool):
        raise _core.Error(f"{name}: must be text, a number, or a list or dictionary of them, is {value!r}")
    return [text(name, os.fspath(value) if isinstance(value, os.PathLike) else str(value))]
