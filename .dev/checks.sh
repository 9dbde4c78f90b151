# What ./dev lint and ./dev test check. Sourced by ./dev.

# Tracked files and those about to be; a file deleted but not yet staged is left out.
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

# Nothing in the repository may name a package registry or a folder of the machine it was written on.
check_leaks() {
  local found
  found=$(our_files ':!.dev/checks.sh' | xargs -r grep -nIE \
    'registry\.npm|npmjs\.(org|com)|(deb|security|ftp)\.debian\.org|archive\.ubuntu\.com|(^|[^[:alnum:]_.])/(work|home|Users|root)/|"resolved":' || true)
  [ -z "$found" ] || { printf '%s\n' "$found"; echo "leak: the lines above name a registry host or a machine's folder"; return 1; }
}

lint() {
  say "clang-format"; check_format
  say "tsc"; check_types
  say "leaks"; check_leaks
  say "clang-tidy"; cmake --workflow --preset tidy
  say "lint is clean"
}

# Replays the golden and the shipped motions bit for bit:   replay_motions <name> <gaitsmith, as it is called...>
replay_motions() {
  local name=$1 document; shift
  for document in tests/golden/motions/*.json examples/*.json examples/gallery/*.json examples/lessons/*.json; do
    echo "$name: $document"
    "$@" validate "$document"
  done
}

# Every compiler and optimisation level replays them, in every lane count, and the command line keeps its contract there. dev is gcc
# -O1, release gcc -O3.
check_determinism() {
  local name compiler flags
  while read -r name compiler flags; do
    case $name in
      dev | release) cmake --preset "$name" >/dev/null ;;
      *-avx2)
        if ! grep -qw avx2 /proc/cpuinfo 2>/dev/null; then say "$name: not on this processor"; continue; fi ;&
      *) cmake -G Ninja -B "build/$name" -DCMAKE_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS_DEBUG="$flags" >/dev/null ;;
    esac
    cmake --build "build/$name" --target gaitsmith
    replay_motions "$name" "build/$name/shell/gaitsmith"
    tests/command_line/contract_test.sh "build/$name/shell/gaitsmith" . </dev/null
  done <<MATRIX
dev
release
gcc-O0 g++ -O0
gcc-O2 g++ -O2
clang-O0 clang++-$LLVM -O0
clang-O2 clang++-$LLVM -O2
clang-O3-avx2 clang++-$LLVM -O3 -march=x86-64-v3
gcc-O3-avx2 g++ -O3 -march=x86-64-v3
MATRIX
}

# Another processor, for as long as qemu's user mode, thirty times slower, takes for every motion and a few short searches.
check_aarch64() {
  local search here there qemu=(qemu-aarch64-static build/aarch64/shell/gaitsmith)
  command -v apt-get >/dev/null || leave_out "no apt here: aarch64 under qemu is left out"
  apt_need "${AARCH64[@]}"
  cmake --preset dev >/dev/null
  cmake --build build/dev --target gaitsmith
  cmake -G Ninja -B build/aarch64 -DCMAKE_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=Release -DCMAKE_TOOLCHAIN_FILE=.dev/aarch64.cmake >/dev/null
  cmake --build build/aarch64 --target gaitsmith
  replay_motions aarch64 "${qemu[@]}"
  for search in sphc cma-es ssga; do
    echo "aarch64: $search"
    here=$(build/dev/shell/gaitsmith synthesize --search "$search" --evaluations 400 --out -)
    there=$("${qemu[@]}" synthesize --search "$search" --evaluations 400 --out -)
    [ "$here" = "$there" ] || die "$search finds another motion on aarch64"
  done
}

# Threads are only in the native program: ThreadSanitizer watches whatever uses them, and the command line's whole contract.
check_threads() {
  cmake -G Ninja -B build/threads -DCMAKE_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="clang++-$LLVM" \
    -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g -fsanitize=thread" >/dev/null
  cmake --build build/threads --target gaitsmith gaitsmith_shell_tests
  build/threads/tests/gaitsmith_shell_tests
  tests/command_line/contract_test.sh build/threads/shell/gaitsmith .
}

# Where time cannot be trusted, instructions can.
check_instructions() {
  setup_measures
  cmake --preset release >/dev/null
  cmake --build --preset release --target instructions
  tests/bench/instruction_guard.sh build/release/tests/bench/instructions
}

# Links, anchors, pictures, HTML and search of the book beside the built page; then the book in Chromium.
check_book() {
  GAITSMITH_SITE=build/site node --test tests/web/book.test.mjs
  node tests/browser/book.mjs
}

check_browsers() { node tests/browser/run.mjs; }

# Long enough to see a leak; ./dev soak takes its time.
check_soak() { node tests/browser/soak.mjs 120; }

# What this machine cannot do is neither passed nor failed.
LEFT_OUT=77
leave_out() { say "$*"; exit $LEFT_OUT; }

# A stage stops at its first failure; the later stages still run.
passed=0 left_out=0 failed=()
stage() {
  local name=$1 start=$SECONDS status=0; shift
  printf '\n######## %s\n' "$name"
  set +e; ( set -e; "$@" ); status=$?; set -e
  if [ $status = 0 ]; then passed=$((passed + 1)); printf '######## %s: passed, %d s\n' "$name" $((SECONDS - start))
  elif [ $status = $LEFT_OUT ]; then left_out=$((left_out + 1)); printf '######## %s: left out\n' "$name"
  else failed+=("$name"); printf '######## %s: FAILED, %d s\n' "$name" $((SECONDS - start)); fi
}

test_everything() {
  stage set-up setup
  stage "set-up of the browsers" setup_browsers
  stage lint lint
  stage "tests (dev)" cmake --workflow --preset dev
  stage "tests (sanitizers)" cmake --workflow --preset asan
  stage threads check_threads
  stage determinism check_determinism
  stage aarch64 check_aarch64
  stage "instruction count" check_instructions
  stage "tests (WASM)" cmake --workflow --preset wasm
  stage site build_site
  stage book check_book
  stage browsers check_browsers
  stage soak check_soak
  stage fuzz fuzz 10
  printf '\n'
  [ ${#failed[@]} = 0 ] || printf 'failed: %s\n' "${failed[@]}"
  printf '%d passed, %d left out, %d failed\n' "$passed" "$left_out" ${#failed[@]}
  [ ${#failed[@]} = 0 ]
}
