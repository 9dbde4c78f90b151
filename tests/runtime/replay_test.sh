#!/usr/bin/env bash
# Tests gaitsmith senses as in docs/command-line.md, and that the runtime of docs/runtime.md decides as the simulator does:
#   replay_test.sh <gaitsmith> <repository> <node>
# For every controller of every golden and shipped motion, in C with every compiler that is here, and in JavaScript.
set -uo pipefail
gaitsmith=$(realpath "$1") root=$(realpath "$2") node=$3 failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1

fault() { echo "FAILED: $*"; failed=1; }
same() { [ "$1" = "$2" ] || fault "$3: '$1' is not '$2'"; }
refuses() { # words of the message, command...
  local message=$1; shift
  "$@" >out 2>err && fault "accepted: $*"
  grep -qF -- "$message" err || fault "said '$(cat err)', not '$message': $*"
}

# Every controller, its senses, and the motion if it moves strong joints from the start.
names=()
for document in "$root"/tests/golden/{motions,limited,springs}/*.json "$root"/examples/*.json "$root"/examples/{gallery,lessons}/*.json; do
  for ((clip = 1; ; ++clip)); do
    name=$(basename "$(dirname "$document")")-$(basename "$document" .json)-$clip
    "$gaitsmith" senses "$document" --clip $clip --controller "$name.json" --out "$name.csv" 2>err || break
    [ "$(wc -l <"$name.csv")" -gt 1 ] || continue # the clip begins after the end
    names+=("$name")
    [ $clip = 1 ] && grep -q '"model": 1,' "$document" && "$gaitsmith" simulate "$document" --csv "$name.motion.csv"
  done
  grep -qE 'clip: must be a whole number|timeline: has no controller' err || fault "$document: $(cat err)"
done
[ ${#names[@]} -ge 100 ] || fault "only ${#names[@]} controllers were found"
for kind in '"kind": "rules"' '"kind": "network"' '"kind": "trajectory"' '"name": "timer"' '"name": "corner"' '"at_end": "rest"' '"at_end": "repeat"'; do
  grep -qF "$kind" ./*.json || fault "no controller with $kind"
done

# As a document's motion, by export.
"$gaitsmith" export star-man-shuffle --controller exported.json || fault "export --controller"
cmp -s exported.json examples-star-man-shuffle-1.json || fault "export and senses write other controllers"
same "$(head -1 examples-star-man-shuffle-1.csv | cut -d, -f1-5)" "step,clip,rule,angle_1,angle_2" "the columns of senses"
same "$(sed -n 2p examples-star-man-shuffle-1.csv | cut -d, -f1-3)" "0,1,1" "the first row of senses"
same "$("$gaitsmith" senses star-man-shuffle | md5sum)" "$(md5sum <examples-star-man-shuffle-1.csv)" "senses on standard output"
same "$(cut -d, -f3 examples-star-man-shuffle-1.csv)" "$("$gaitsmith" simulate star-man-shuffle --csv - | cut -d, -f8)" "rules in senses and in simulate"
refuses 'timeline: has no controller' "$gaitsmith" senses hopper-jump
refuses 'timeline: has no controller' "$gaitsmith" export hopper-jump --controller no.json
refuses '--clip: must be a whole number from 1 to 1, is "2"' "$gaitsmith" senses star-man-shuffle --clip 2
refuses 'DOC: give exactly one document' "$gaitsmith" senses
[ ! -e no.json ] || fault "a controller that is none"

# The format, and what tests without the command line and fuzzers begin with.
while read -r golden name; do
  cmp -s "$root/tests/golden/controllers/$golden.json" "$name-1.json" || fault "another $golden.json than tests/golden/controllers has"
done <<'GOLDEN'
rules motions-star-man-physical
timer motions-star-man-timer-left
network motions-star-man-network
sight limited-star-man-sees-a-step
trajectory limited-star-man-trajectory
springs springs-star-sees-stairs
GOLDEN

# The examples of docs/runtime.md: both programs decide the same.
fenced() { awk -v fence="\`\`\`$1" '$0 == fence { on = 1; next } /^```/ { on = 0 } on' "$root/docs/runtime.md"; } # language
cp "$root/core/runtime/gaitsmith.h" "$root/web/runtime/runtime.js" .
echo '{"type": "module"}' >package.json
fenced c >example.c; fenced js >example.mjs
cc=$(command -v gcc || command -v clang-19)
"$cc" -std=c99 -pedantic -Wall -Wextra -Werror -O2 example.c -o example || fault "the example in C"
./example <exported.json >in-c.txt || fault "the example in C fails"
"$node" example.mjs <exported.json >in-js.txt || fault "the example in JavaScript fails"
same "$(wc -l <in-c.txt)" 100 "steps of the example"
same "$(cut -d, -f1 in-c.txt)" "$(cut -d, -f1 in-js.txt)" "rules of both examples"
./example </dev/null >in-c.txt && fault "the example accepts an empty file"
same "$(cat in-c.txt)" "not a controller: byte 0" "the example without a controller"

# In C, without and with fused multiply-add: not a bit may differ.
compiled=0
while read -r compiler flags; do
  command -v "$compiler" >/dev/null || continue
  case $flags in *-march=*) grep -qw fma /proc/cpuinfo 2>/dev/null || continue ;; esac # not on this processor
  # shellcheck disable=SC2086
  "$compiler" -std=c99 -pedantic -Wall -Wextra -Werror $flags -I "$root" "$root/tests/runtime/replay.c" -o replay || { fault "$compiler $flags"; continue; }
  compiled=$((compiled + 1))
  echo "$compiler $flags: $(./replay "${names[@]}" 2>&1)"
  ./replay "${names[@]}" >/dev/null 2>&1 || fault "$compiler $flags decides otherwise"
done <<'COMPILERS'
gcc -O2 -ffp-contract=off
clang-19 -O2 -ffp-contract=off
gcc -O3 -march=haswell -ffp-contract=fast
clang-19 -O3 -march=haswell -ffp-contract=fast
COMPILERS
[ $compiled -gt 0 ] || fault "no C compiler was found"
"$node" "$root/tests/runtime/replay.mjs" "${names[@]}" >replayed || fault "JavaScript decides otherwise"
echo "JavaScript: $(cat replayed)"

# Small enough for any game.
[ "$(gzip -9 <"$root/core/runtime/gaitsmith.h" | wc -c)" -le 5120 ] || fault "gaitsmith.h has more than 5 KB, compressed"

[ $failed = 0 ] && echo "the runtime decides as the simulator does"
exit $failed
