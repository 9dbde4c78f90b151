# Longer trials of ./dev beyond its tests. Each continues where it ended, or takes only minutes. Sourced by ./dev.

soak() {
  setup_browsers
  build_site
  node tests/browser/soak.mjs $((60 * ${1:-30})) build/site "${@:2}"
}

# Golden links as text, and their bytes between header and checksum.
link_seeds() {
  local link number=0
  mkdir -p build/fuzz/links
  grep -hE '^[0-9a-f]{16} ' tests/golden/links/*.txt | while read -r _ link; do
    number=$((number + 1))
    printf %s "$link" >"build/fuzz/links/$number.link"
    printf '%s%.*s' "$link" $(((4 - ${#link} % 4) % 4)) == | tr -- -_ +/ | base64 -d | tail -c +5 | head -c -4 >"build/fuzz/links/$number.body"
  done
}

# Runs of ten minutes or more are a study and add a line each to docs/studies/fuzzing/runs.csv. Runs shorter than a
# minute guard main and must not depend on luck: they draw the same numbers each time and start without a corpus.
fuzz() {
  local seconds=${1:-60} name log runs seed=0 corpus=build/fuzz/corpus
  shift || true
  if [ "$seconds" -lt 60 ]; then
    seed=1 corpus=build/fuzz/short
    rm -rf "$corpus"
  fi
  cmake --workflow --preset fuzz
  link_seeds
  for name in ${*:-$(cd tests/fuzz && basename -s _fuzz.cpp -a ./*_fuzz.cpp)}; do
    mkdir -p "$corpus/$name"
    log=build/fuzz/$name.log
    say "$name: $seconds s"
    "build/fuzz/tests/fuzz/${name}_fuzz" -seed=$seed -max_total_time="$seconds" -artifact_prefix=build/fuzz/ -verbosity=0 -print_final_stats=1 -max_len=20000 \
      "$corpus/$name" build/fuzz/links examples tests/golden/motions tests/golden/limited tests/golden/springs tests/golden/controllers tests/adversary/finds >"$log" 2>&1 || { tail -40 "$log"; die "$name found something: build/fuzz has what it fed"; }
    runs=$(awk '/number_of_executed_units/ { print $2 }' "$log")
    say "$name: $runs runs, nothing found"
    if [ "$seconds" -ge 600 ]; then
      mkdir -p docs/studies/fuzzing
      [ -s docs/studies/fuzzing/runs.csv ] || echo program,seconds,runs >docs/studies/fuzzing/runs.csv
      echo "$name,$seconds,$runs" >>docs/studies/fuzzing/runs.csv
    fi
  done
}

# Its findings are a study. docs/physics.md explains them. Each of the three models gets a third of the time.
adversary() {
  local minutes=${1:-10} program=build/release/tests/adversary/adversary
  local third=$(awk "BEGIN { print $minutes / 3 }")
  cmake --preset release
  cmake --build --preset release --target adversary
  "$program" --out docs/studies/adversary --evaluations 8000 --seeds 1000 --minutes "$third"
  "$program" --model 2 --out docs/studies/adversary/limited --evaluations 8000 --seeds 1000 --minutes "$third"
  "$program" --model 3 --out docs/studies/adversary/springs --evaluations 8000 --seeds 1000 --minutes "$third"
}

# Other programs' judgement: MuJoCo's of model 2, with every figure (./dev test asks for one), pagmo's of searches, Slurm's
# of the lines for clusters, PyTorch's of the code that trains policies, IOHanalyzer's of running times, Godot's of exported
# scenes. docs/physics.md, docs/search.md, docs/clusters.md, docs/command-line.md and docs/exporting.md explain the tables.
peers() {
  cmake --preset release
  cmake --build --preset release --target flight gaitsmith
  node tests/peers/judge.mjs build/release/tests/peers/flight --out docs/studies/peers/mujoco.csv
  say "the errors: docs/studies/peers/mujoco.csv"
  if command -v apt-get >/dev/null; then apt_need libpagmo-dev; cmake --preset release >/dev/null; fi
  if [[ $(cmake --build --preset release --target help) == *search_judge* ]]; then
    cmake --build --preset release --target search_judge
    build/release/tests/peers/search_judge >docs/studies/peers/searches.csv
    say "our searches beside pagmo's: docs/studies/peers/searches.csv"
  else
    say "pagmo is not installed here: searches are not compared"
  fi
  local status=0
  if command -v apt-get >/dev/null; then apt_need "${SLURM[@]}"; fi
  tests/clusters/slurm_test.sh build/release/shell/gaitsmith . docs/studies/peers/slurm.csv || status=$?
  case $status in
    0) say "what became of Slurm's tasks: docs/studies/peers/slurm.csv" ;;
    "$LEFT_OUT") ;;
    *) die "the lines of docs/clusters.md fail with Slurm" ;;
  esac
  if command -v Rscript >/dev/null && Rscript -e 'library(IOHanalyzer)' >/dev/null 2>&1; then
    Rscript tests/peers/running_times.R build/release/shell/gaitsmith docs/studies/pecking-order/curves/hopper-travel-physical.csv docs/studies/peers/running-times.csv
  else
    say "IOHanalyzer, an R package, is not installed here: running times are not compared"
  fi
  if command -v apt-get >/dev/null; then apt_need python3-torch; fi
  if "$(system_python)" -c 'import torch' 2>/dev/null; then
    say "a pendulum, which the code of docs/studies/policy learns to swing up (minutes)"
    "$(system_python)" tests/peers/pendulum.py
  else
    say "PyTorch is not installed here: no policy is trained"
  fi
  if command -v apt-get >/dev/null; then apt_need godot3-server; fi
  command -v godot3-server >/dev/null || { say "Godot 3 is not installed here: scenes are not played"; return; }
  node tests/peers/godot.mjs build/release/shell/gaitsmith --out docs/studies/peers/godot.csv
  say "how far bones are away in Godot: docs/studies/peers/godot.csv"
}

# Joint coverage of the tests of core and shell and of the command line's contract. Lines of templates count once.
coverage() {
  local build=$ROOT/build/coverage report=build/coverage/report.txt
  cmake -G Ninja -B "$build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="clang++-$LLVM" \
    -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g -fprofile-instr-generate -fcoverage-mapping" >/dev/null
  cmake --build "$build" --target gaitsmith_tests gaitsmith_shell_tests gaitsmith
  rm -rf "$build/profiles"
  export LLVM_PROFILE_FILE=$build/profiles/%p.profraw
  say "tests"
  "$build/tests/gaitsmith_tests"
  "$build/tests/gaitsmith_shell_tests"
  tests/command_line/contract_test.sh "$build/shell/gaitsmith" "$ROOT"
  "llvm-profdata-$LLVM" merge -sparse "$build"/profiles/*.profraw -o "$build/all.profdata"
  "llvm-cov-$LLVM" report "$build/tests/gaitsmith_tests" -object "$build/tests/gaitsmith_shell_tests" -object "$build/shell/gaitsmith" \
    -instr-profile="$build/all.profdata" --show-branch-summary --show-region-summary=false core >"$report"
  awk '$1 == "TOTAL" { print "core: functions " $4 ", lines " $7 ", branches " $10 }' "$report"
  say "each file: $report"
}

# All pinned results on another processor, including the forty searches. Takes a quarter of an hour.
aarch64() {
  check_aarch64
  cmake --build build/aarch64 --target gaitsmith_tests
  qemu-aarch64-static build/aarch64/tests/gaitsmith_tests "[golden],[determinism]"
}

# Every level of optimisation; ./dev test has the lowest and the highest.
determinism() { check_builds tests release tidy gcc-O0 gcc-O2 clang-O2 clang-O3-avx2 gcc-O3-avx2; }

mutate() {
  local shard=1/1
  if [[ ${1:-} == */* ]]; then shard=$1; shift; fi
  node tests/mutation/run.mjs --shard "$shard" "$@"
}

# Builds in two folders, because a path must not matter either, each with a separate setup.
reproduce() {
  local twin built
  for twin in one another-one; do
    rm -rf "build/reproduce/$twin"
    git clone -q . "build/reproduce/$twin"
    (cd "build/reproduce/$twin" && ./dev site && ./dev packages)
  done
  for built in site packages; do
    diff -r "build/reproduce/one/build/$built" "build/reproduce/another-one/build/$built" || die "the two builds differ in the files above"
    say "two builds of $(git rev-parse --short HEAD), the same $(find "build/reproduce/one/build/$built" -type f | wc -l) files of the $built"
  done
}
