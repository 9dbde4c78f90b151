# Builds the Python module as a wheel and tests the wheel. Sourced by ./dev. docs/python.md describes the module.

PYTHON_PACKAGES=(python3-dev python3-venv python3-pip python3-numpy python3-matplotlib pybind11-dev)
WHEELS=build/python
VENV=build/python-venv

# The system's Python, because the system's NumPy and headers belong to it. Elsewhere the first one on PATH.
system_python() { if [ -x /usr/bin/python3 ]; then echo /usr/bin/python3; else command -v python3; fi; }

setup_python() {
  mkdir -p "$T"; touch "$LOG"
  command -v apt-get >/dev/null || { say "no apt here: the Python module needs pybind11, NumPy and Python's headers from elsewhere"; return; }
  apt_need "${PYTHON_PACKAGES[@]}"
}

# Whether CMake found pybind11 and Python's headers, which only the user can install.
has_python_target() {
  cmake --preset release "-DPython3_EXECUTABLE=$(system_python)" >/dev/null
  [[ $(cmake --build --preset release --target help) == *gaitsmith_python* ]]
}
has_numpy() { "$(system_python)" -c 'import numpy, venv' 2>/dev/null; }

wheel() {
  cmake --build --preset release --target gaitsmith gaitsmith_python
  rm -rf "$WHEELS" build/release/wheel
  mkdir -p "$WHEELS"
  node web/package/texts.mjs python build/release/wheel
  "$(system_python)" shell/python/wheel.py build/release "$WHEELS"
}

python() { # names of tests…
  setup_python
  has_python_target || die "the Python module needs pybind11 2.10 or newer and the headers of Python 3.9 or newer"
  has_numpy || die "the tests of the Python module need NumPy and venv for $(system_python)"
  wheel
  test_wheel "$@"
}

check_python() {
  setup_python
  has_python_target || leave_out "no pybind11 or no headers of Python here: the Python module is left out"
  wheel
  has_numpy || leave_out "no NumPy or no venv here: the Python module is built but not tested"
  test_wheel
}

# Installs the wheel without a network where nothing else of the repository is, and runs the tests of tests/python from there.
test_wheel() { # names of tests…
  local folder tests=()
  rm -rf "$VENV"
  "$(system_python)" -m venv --system-site-packages "$VENV"
  "$VENV/bin/python" -m pip install --quiet --disable-pip-version-check --no-index --no-deps --force-reinstall "$WHEELS"/gaitsmith-*.whl
  folder=$(mktemp -d)
  if [ $# = 0 ]; then tests=(discover -s "$ROOT/tests/python" -t "$ROOT/tests/python" -p '*_test.py'); else tests=("$@"); fi
  (cd "$folder" && GAITSMITH_ROOT=$ROOT PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$ROOT/tests/python MPLBACKEND=agg MPLCONFIGDIR=$folder \
    "$ROOT/$VENV/bin/python" -W error::ResourceWarning -m unittest "${tests[@]}")
  rm -rf "$folder"
}
