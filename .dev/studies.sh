# Studies: to go on with one, or to see whether it comes out again. Sourced by ./dev.

# study [NAME [--check [SEED] | --sums]]
study() {
  local name=${1:-} plan=docs/studies/${1:-}/check.json
  [ -n "$name" ] || { node docs/studies/check.mjs; return; }
  [ -d "docs/studies/$name" ] || die "./dev study takes the name of a folder of docs/studies, not '$name'. Without a name it lists them"
  if [ "${2:-}" = --sums ]; then node docs/studies/check.mjs "$name" --sums; return; fi
  ! grep -qs '{box2d}' "$plan" || setup_measures
  cmake --preset release >/dev/null
  cmake --build --preset release --target gaitsmith
  if grep -qs '{box2d}' "$plan"; then
    [[ $(cmake --build --preset release --target help) == *box2d_figure* ]] || die "this study needs Box2D, which is not installed here"
    cmake --build --preset release --target box2d_figure
  fi
  if grep -qs python-venv "docs/studies/$name/run" && [ ! -x "$VENV/bin/python" ]; then die "this study needs the Python module: ./dev python"; fi
  case ${2:-} in
    '') if [ -x "docs/studies/$name/run" ]; then "docs/studies/$name/run" build/release/shell/gaitsmith
        elif [ -e "docs/studies/$name/run.mjs" ]; then node "docs/studies/$name/run.mjs" build/release/shell/gaitsmith build/release/examples/box2d_figure
        else die "docs/studies/$name has no command 'run'"; fi ;;
    --check) node docs/studies/check.mjs "$name" build/release/shell/gaitsmith "${@:3}" ;;
    *) die "./dev study $name takes nothing, --check or --sums, not '$2'" ;;
  esac
}
