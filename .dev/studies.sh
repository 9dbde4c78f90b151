# Studies: to go on with one, or to see whether it comes out again. Sourced by ./dev.

# study [NAME [--check [SEED] | --sums]]
study() {
  local name=${1:-} plan=docs/studies/${1:-}/check.json
  [ -n "$name" ] || { node docs/studies/check.mjs; return; }
  [ -d "docs/studies/$name" ] || die "./dev study takes the name of a folder of docs/studies, not '$name'. Without a name it lists them"
  if [ "${2:-}" = --sums ]; then node docs/studies/check.mjs "$name" --sums; return; fi
  cmake --preset release >/dev/null
  cmake --build --preset release --target gaitsmith
  if grep -qs '{box2d}' "$plan"; then
    setup_measures
    cmake --build --preset release --target box2d_figure
  fi
  if grep -qs python-venv "docs/studies/$name/run" && [ ! -x "$VENV/bin/python" ]; then die "this study needs the Python module: ./dev python"; fi
  case ${2:-} in
    '') [ -x "docs/studies/$name/run" ] || die "docs/studies/$name has no command 'run'"
        "docs/studies/$name/run" build/release/shell/gaitsmith ;;
    --check) node docs/studies/check.mjs "$name" build/release/shell/gaitsmith "${@:3}" ;;
    *) die "./dev study $name takes nothing, --check or --sums, not '$2'" ;;
  esac
}
