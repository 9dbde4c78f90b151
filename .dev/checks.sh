# The checks of ./dev lint and ./dev test. Sourced by ./dev.

# Tracked files and new ones, except ignored and deleted files.
our_files() {
  git ls-files --cached --others --exclude-standard -- "$@" | while read -r file; do
    if [ -f "$file" ]; then echo "$file"; fi
  done
}

check_format() { our_files '*.h' '*.cpp' | xargs -r "clang-format-$LLVM" --dry-run --Werror; }

check_types() {
  node web/build/border.mjs --check
  web/node_modules/.bin/tsc --project web/tsconfig.json
}

check_scripts_and_styles() {
  web/node_modules/.bin/eslint --config web/build/eslint.config.js web tests
  (cd web && node_modules/.bin/stylelint --config build/stylelint.config.js '**/*.css')
}

# The repository must not contain names of package registries or of folders on the developer's machine.
check_leaks() {
  local found
  found=$(our_files ':!.dev/checks.sh' | xargs -r grep -nIE \
    'registry\.npm|npmjs\.(org|com)|(deb|security|ftp)\.debian\.org|archive\.ubuntu\.com|(^|[^[:alnum:]_.])/(work|home|Users|root)/|"resolved":' || true)
  [ -z "$found" ] || { printf '%s\n' "$found"; echo "leak: the lines above name a registry host or a machine's folder"; return 1; }
}

# lint [target…]: clang-tidy over these targets, or over everything
lint() {
  say "clang-format"; check_format
  say "tsc"; check_types
  say "eslint and stylelint"; check_scripts_and_styles
  say "leaks"; check_leaks
  [ $# -gt 0 ] || setup_python # so that the Python module is read as well
  say "clang-tidy"
  cmake --preset tidy >/dev/null
  cmake --build --preset tidy ${1:+--target "$@"}
  say "lint is clean"
}

# Replays the golden and the shipped motions bit for bit: replay_motions <name> <command that runs gaitsmith...>
replay_motions() {
  local name=$1 document; shift
  for document in tests/golden/{motions,limited,springs}/*.json examples/*.json examples/gallery/*.json examples/lessons/*.json; do
    echo "$name: $document"
    "$@" validate "$document"
  done
}

# Replays them with both compilers, from no optimisation to the most, and checks the command line's contract there. The
# tests are built with gcc -O1, release with gcc -O3, the linter with clang -O0, sanitizers with clang -O1.
check_determinism() { check_builds tests release tidy; }

# check_builds NAME…: of the matrix
check_builds() {
  local name compiler flags
  while read -r name compiler flags; do
    [[ " $* " == *" $name "* ]] || continue
    case $name in
      tests | release | tidy) cmake --preset "$name" >/dev/null ;;
      *-avx2)
        if ! grep -qw avx2 /proc/cpuinfo 2>/dev/null; then say "$name: not on this processor"; continue; fi ;&
      *) cmake -G Ninja -B "build/$name" -DCMAKE_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS_DEBUG="$flags" >/dev/null ;;
    esac
    cmake --build "build/$name" --target gaitsmith
    replay_motions "$name" "build/$name/shell/gaitsmith"
    # The tests include the contract, and without optimisation it takes long.
    [[ $name != tests && $name != tidy ]] || continue
    tests/command_line/contract_test.sh "build/$name/shell/gaitsmith" . </dev/null
  done <<MATRIX
tests
release
tidy
gcc-O0 g++ -O0
gcc-O2 g++ -O2
clang-O2 clang++-$LLVM -O2
clang-O3-avx2 clang++-$LLVM -O3 -march=x86-64-v3
gcc-O3-avx2 g++ -O3 -march=x86-64-v3
MATRIX
}

# Another processor: every motion and a few short searches, because qemu's user mode is thirty times slower.
check_aarch64() {
  local search here there qemu=(qemu-aarch64-static build/aarch64/shell/gaitsmith)
  command -v apt-get >/dev/null || leave_out "no apt here: aarch64 under qemu is left out"
  apt_need "${AARCH64[@]}"
  cmake --preset tests >/dev/null
  cmake --build build/tests --target gaitsmith
  cmake -G Ninja -B build/aarch64 -DCMAKE_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=Release -DCMAKE_TOOLCHAIN_FILE=.dev/aarch64.cmake >/dev/null
  cmake --build build/aarch64 --target gaitsmith
  replay_motions aarch64 "${qemu[@]}"
  for search in "mr-star-man sphc" "mr-star-man cma-es" "mr-star-man ssga" "walking-table pose-cycle"; do
    echo "aarch64: $search"
    set -- --figure "${search% *}" --search "${search#* }" --evaluations 400 --out -
    here=$(build/tests/shell/gaitsmith synthesize "$@")
    there=$("${qemu[@]}" synthesize "$@")
    [ "$here" = "$there" ] || die "$search finds another motion on aarch64"
  done
}

# The lines of docs/clusters.md on a cluster of one node. Exit status 77: Slurm cannot run here.
check_slurm() {
  command -v apt-get >/dev/null || leave_out "no apt here: Slurm is left out"
  apt_need "${SLURM[@]}"
  cmake --preset tests >/dev/null
  cmake --build build/tests --target gaitsmith
  tests/clusters/slurm_test.sh build/tests/shell/gaitsmith .
}

# Only the native program has threads. ThreadSanitizer checks all code that uses them, and the command line's whole
# contract.
check_threads() {
  cmake -G Ninja -B build/threads -DCMAKE_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="clang++-$LLVM" \
    -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1 -fsanitize=thread" >/dev/null
  cmake --build build/threads --target gaitsmith gaitsmith_shell_tests
  build/threads/tests/gaitsmith_shell_tests
  tests/command_line/contract_test.sh build/threads/shell/gaitsmith .
}

# Counts instructions, because times vary from run to run.
check_instructions() {
  setup_measures
  cmake --preset release >/dev/null
  cmake --build --preset release --target instructions
  tests/bench/instruction_guard.sh build/release/tests/bench/instructions
}

# The runtime in native Box2D. Its versions for JavaScript run with the tests of the page.
check_box2d() {
  setup_measures
  cmake --preset release >/dev/null
  local targets
  targets=$(cmake --build --preset release --target help)
  [[ $targets == *box2d_figure* ]] || leave_out "Box2D is not installed here"
  cmake --build --preset release --target box2d_figure
  ctest --test-dir build/release -R '^box2d-figure$' --output-on-failure
}

# Runs a program that drives a browser, for at most so many minutes: a browser that hangs must not hold up all the rest.
within() { # minutes, program...
  local minutes=$1 status=0; shift
  command -v timeout >/dev/null || { "$@"; return; }
  timeout -k 20 "${minutes}m" "$@" || status=$?
  [ "$status" != 124 ] || echo "error: stopped after $minutes minutes: $*"
  return "$status"
}

# Links, anchors, pictures, HTML and search of the book in the built page, then the book in Chromium.
check_book() {
  GAITSMITH_SITE=build/site within 10 node --test tests/web/book.test.mjs
  within 15 node tests/browser/book.mjs
}

check_browsers() { within 45 node tests/browser/run.mjs; }
# A short visit in the engine of Safari. Exit status 77: its driver is not installed.
check_webkit() { within 10 node tests/browser/webkit.mjs; }
main_scenarios() { BROWSER=chromium within 20 node tests/browser/run.mjs build/site --main; }

# Exit status of a stage that this machine cannot run: neither passed nor failed.
LEFT_OUT=77
leave_out() { say "$*"; exit $LEFT_OUT; }

# The result of each stage, one line per stage: "<seconds> <processor seconds> <passed|left-out|failed> <name>". A stage
# stops at its first failure. The later stages still run. What a stage prints is also kept, for the summary.
RESULTS=build/test-results.txt
STAGES=build/stages
stage() {
  local name=$1 start=$SECONDS status=0 result log writer; shift
  printf '\n######## %s\n' "$name"
  exec {log}> >(exec tee "$STAGES/$name.log"); writer=$!
  set +e; ( trap 'times >"$STAGES/$name.times"' EXIT; set -e; "$@" ) >&"$log" 2>&1; status=$?; set -e
  exec {log}>&-
  timeout 5 tail --pid="$writer" -f /dev/null || true # until all is written, or a process left behind holds the log
  case $status in
    0) result=passed ;;
    "$LEFT_OUT") result=left-out ;;
    *) result=failed ;;
  esac
  printf '%d %d %s %s\n' $((SECONDS - start)) "$(processor_seconds "$STAGES/$name.times")" "$result" "$name" >>"$RESULTS"
  printf '######## %s: %s, %d s\n' "$name" "$result" $((SECONDS - start))
}

# What `times` wrote: a shell's minutes and seconds, for its user and for the system, then those of all that it waited for.
processor_seconds() { awk -F'[ms ]+' '{ sum += $1 * 60 + $2 + $3 * 60 + $4 } END { printf "%d", sum }' "$1" 2>/dev/null || echo 0; }

# The usual seconds of each stage: "<seconds> <name>" a line. A stage that takes half a minute and a quarter more has grown.
USUAL=.dev/stage-seconds.txt
growth() { # seconds, name
  local usual
  usual=$(awk -v name="$2" '$0 == $1 " " name { print $1 }' "$USUAL")
  [ -z "$usual" ] || (( $1 <= usual + 30 + usual / 4 )) || printf ' (usually %d s)' "$usual"
}

# The lines of a failed stage that name what failed, because a long log hides them.
failures() { # name
  printf '\n%s:\n' "$1"
  grep -vE '^ok |^ +Start +[0-9]+:| Passed +[0-9.]+ sec$' "$STAGES/$1.log" | grep -E -A4 'FAILED|^ *not ok|✖|\*\*\*|error:|warning:|differ' | cut -c 1-300 | head -40 ||
    tail -5 "$STAGES/$1.log"
}

# Prints each stage's time, what failed, and the number of passed stages. Fails if a stage failed.
summary() {
  local passed left_out failed names seconds processor result name
  passed=$(grep -c ' passed ' "$RESULTS" || true)
  left_out=$(grep -c ' left-out ' "$RESULTS" || true)
  failed=$(grep -c ' failed ' "$RESULTS" || true)
  printf '\n%7s %9s  %-9s %s\n' seconds processor result stage
  while read -r seconds processor result name; do
    printf '%7d %9d  %-9s %s%s\n' "$seconds" "$processor" "$result" "$name" "$(growth "$seconds" "$name")"
  done <"$RESULTS"
  printf '%7d  in all\n' $SECONDS
  while read -r seconds processor result name; do [ "$result" != failed ] || failures "$name"; done <"$RESULTS"
  echo
  names=$(awk '$3 == "failed" { sub(/^[0-9]+ [0-9]+ failed /, ""); printf "%s%s", n++ ? ", " : ": ", $0 }' "$RESULTS")
  printf '%d passed, %d left out, %d failed%s\n' "$passed" "$left_out" "$failed" "$names"
  [ "$failed" = 0 ]
}

begin_stages() {
  rm -rf "$STAGES"
  mkdir -p "$STAGES"
  : >"$RESULTS"
  stage set-up setup
  stage "set-up of the browsers" setup_browsers
}

# Stages that wait most of the time run in a second lane, in parallel with the compilers. No build folder may be used in
# both lanes.
second_lane() {
  stage book check_book
  stage browsers check_browsers
  stage WebKit check_webkit
  stage threads check_threads
  stage fuzz fuzz 5
}

test_everything() {
  local second
  begin_stages
  stage site build_site
  second_lane >build/second-lane.log 2>&1 &
  second=$!
  # The scenarios wait for frames, so the browsers go before the compilers.
  renice -n 10 -p $BASHPID >/dev/null
  # The tests' own code, a third of all, is left to ./dev lint.
  stage lint lint gaitsmith gaitsmith_window example_programs
  stage "tests (WASM)" cmake --workflow --preset wasm
  stage "tests (gcc)" cmake --workflow --preset tests
  stage "tests (sanitizers)" cmake --workflow --preset asan
  stage determinism check_determinism
  stage packages check_packages
  stage python check_python
  stage aarch64 check_aarch64
  stage Slurm check_slurm
  stage "instruction count" check_instructions
  stage "Box2D" check_box2d
  say "waiting for the second lane"
  wait "$second" || true
  cat build/second-lane.log
  summary
}

# For use between two commits: the checks that find most mistakes.
test_quickly() {
  begin_stages
  stage format check_format
  stage types check_types
  stage "scripts and styles" check_scripts_and_styles
  stage leaks check_leaks
  stage "tests (gcc)" cmake --workflow --preset tests
  stage "tests (WASM)" cmake --workflow --preset wasm
  stage site build_site
  stage "browser" main_scenarios
  summary
}
