# SPDX-License-Identifier: MIT
"""The repository that the tests compare with. They run from an empty folder, with the module of the wheel."""
import os
import subprocess
from pathlib import Path

ROOT = Path(os.environ.get("GAITSMITH_ROOT", Path(__file__).parents[2]))
PROGRAM = ROOT / "build/release/shell/gaitsmith"


def command_line(*words: str) -> str:
    """What the command line prints."""
    return subprocess.run([str(PROGRAM), *words], check=True, capture_output=True, text=True).stdout


def motions() -> list:
    """The golden motions and the shipped examples."""
    return sorted([*(ROOT / "tests/golden/motions").glob("*.json"), *(ROOT / "examples").glob("*.json")])
