#!/usr/bin/env bash
# Tests gaitsmith export as in docs/command-line.md:   export_test.sh <gaitsmith> <repository>
set -uo pipefail
gaitsmith=$(realpath "$1") root=$(realpath "$2") failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1

fault() { echo "FAILED: $*"; failed=1; }
same() { [ "$1" = "$2" ] || fault "$3: '$1' is not '$2'"; }
# refuses <words of the message> <command...>: non-zero exit, one sentence on standard error, no file
refuses() {
  local message=$1; shift
  "$@" >out 2>err && fault "accepted: $*"
  [ ! -s out ] && [ ! -e no.svg ] || fault "wrote something: $*"
  grep -qF -- "$message" err || fault "said '$(cat err)', not '$message': $*"
}
poses() { grep -c 'class="pose"' "$1"; }

# The exporters in their order, and options for a file of each.
mapfile -t exporters < <("$gaitsmith" catalogue | sed -n '/"exporters"/,/\]/s/.*"name": "\([^"]*\)".*/\1/p')
every=()
for name in "${exporters[@]}"; do every+=("--$name" "all.$name"); done
or=$(printf ', or --%s' "${exporters[@]:1}")

for document in "$root"/examples/*.json; do
  "$gaitsmith" export "$document" "${every[@]}" || fault "export of $document"
  same "$(poses all.svg)" 8 "poses of $document"
  "$gaitsmith" simulate "$document" --csv - | cmp -s - all.csv || fault "export and simulate write other numbers: $document"
  "$gaitsmith" export "$document" --gltf - | cmp -s - all.gltf || fault "other bytes on standard output: $document"
done
for count in 3 12 26; do
  same "$("$gaitsmith" export star-man-shuffle --svg - --poses $count | grep -c 'id="pose-')" $count "poses asked for"
done
"$gaitsmith" export star-man-shuffle --svg part.svg --poses 3 --from 1 --to 2.5 || fault "a part of a motion"
same "$(grep -oE '>[0-9.]+ s<' part.svg | tr -d '\n')" ">1.00 s<>1.75 s<>2.50 s<" "times of a part"
# A link is a document too.
same "$("$gaitsmith" link encode star-man-shuffle | "$gaitsmith" export - --svg - | md5sum)" \
  "$("$gaitsmith" export star-man-shuffle --svg - | md5sum)" "export of a link"

# As planned between keyframes: as the table of gaitsmith plan has it, and then held.
jump=$root/examples/planned/lamp-jump.json
"$gaitsmith" export "$jump" --planned --csv planned.csv --svg planned.svg || fault "a planned motion"
"$gaitsmith" export "$jump" --csv played.csv
same "$(head -1 planned.csv)" "$(head -1 played.csv)" "columns of a planned motion"
same "$(wc -l <planned.csv)" "$(wc -l <played.csv)" "length of a planned motion"
cmp -s planned.csv played.csv && fault "the planned motion is the played one"
same "$(poses planned.svg)" 8 "poses of a planned motion"
refuses 'plan: has no planned motion yet' "$gaitsmith" export star-man-shuffle --planned --svg no.svg

# One cycle of it, which ends as it begins.
loop=$("$gaitsmith" loop star-man-cartwheel | tail -1)
same "$(cut -d, -f9 <<<"$loop")" shown "a cartwheel repeats"
"$gaitsmith" export star-man-cartwheel --loop --csv loop.csv --gltf loop.gltf --svg loop.svg || fault "a loop"
"$gaitsmith" export star-man-cartwheel --loop --in-place --csv stays.csv || fault "a loop in place"
awk -F, -v loop="$loop" 'BEGIN { split(loop, of, ",") } NR == 2 { for (i = 9; i <= NF; i++) first[i] = $i; turn = $6 } { last = $0; rows = NR }
  END { split(last, at, ","); names = 13
    if (rows - 2 != int(100 * of[2] + 0.5)) exit 1
    if ((at[2] - of[3]) ^ 2 > 1e-12 || (at[6] - turn - of[4] * 6.283185307) ^ 2 > 1e-9) exit 2
    for (i = 9; i < names; i++) if ((at[i] - first[i]) ^ 2 > 1e-12) exit 3 }' loop.csv || fault "the loop's end is not its beginning ($?)"
awk -F, 'NR > 1 { x = $2 } END { exit x * x > 1e-18 }' stays.csv || fault "a loop in place moves"
same "$("$gaitsmith" loop star-man-cartwheel star-man-shuffle "$jump" | wc -l)" 4 "a row for each document"
refuses '--halves: needs --loop' "$gaitsmith" export star-man-cartwheel --halves --svg no.svg
refuses '--loop: does not go with --planned' "$gaitsmith" export "$jump" --loop --planned --svg no.svg
refuses "the figure has no two limbs that can take each other's part" "$gaitsmith" export star-man-cartwheel --loop --halves --svg no.svg
refuses 'DOC: give at least one document' "$gaitsmith" loop

# Sprites: as many and as large as asked, or in a scale.
sheet() { unzip -p "$1" sprites.json | node -e 'const { frames, meta } = JSON.parse(require("fs").readFileSync(0)); console.log(frames.length, Math.max(frames[0].frame.w, frames[0].frame.h), meta.pixelsPerMetre)'; }
if command -v unzip >/dev/null && command -v node >/dev/null; then
  "$gaitsmith" export star-man-shuffle --sprites sheet.zip --sprite-frames 7 --sprite-size 200 || fault "sprites"
  same "$(sheet sheet.zip | cut -d' ' -f1,2)" "7 200" "sprites asked for"
  "$gaitsmith" export star-man-shuffle --sprites scaled.zip --sprite-scale 50 || fault "sprites in a scale"
  same "$(sheet scaled.zip | cut -d' ' -f1,3)" "16 50.000" "scale of sprites"
fi
refuses '--sprite-frames: must be a whole number from 2 to 256, is "1"' "$gaitsmith" export star-man-shuffle --sprites no.svg --sprite-frames 1
refuses '--sprite-size: must be a whole number from 16 to 1024, is "8"' "$gaitsmith" export star-man-shuffle --sprites no.svg --sprite-size 8
refuses '--sprite-scale: must be from 1 to 1000 pixels a metre, is "0"' "$gaitsmith" export star-man-shuffle --sprites no.svg --sprite-scale 0
refuses '--sprite-scale: does not go with --sprite-size' "$gaitsmith" export star-man-shuffle --sprites no.svg --sprite-scale 9 --sprite-size 99
refuses 'are too many for a sheet' "$gaitsmith" export star-man-shuffle --sprites no.svg --sprite-frames 256 --sprite-size 1024

refuses "--${exporters[0]}: say where;${or#,}" "$gaitsmith" export star-man-shuffle
refuses 'DOC: give exactly one document' "$gaitsmith" export --svg no.svg
refuses '--poses: must be a whole number from 3 to 26, is "2"' "$gaitsmith" export star-man-shuffle --svg no.svg --poses 2
refuses '--from: must be a number' "$gaitsmith" export star-man-shuffle --svg no.svg --from soon
refuses '--to: must be from 0 to 10 s, is "11"' "$gaitsmith" export star-man-shuffle --svg no.svg --to 11
refuses '--from: must be from 0 to 10 s, is "-1"' "$gaitsmith" export star-man-shuffle --svg no.svg --from -1
refuses '--to: must be later than --from' "$gaitsmith" export star-man-shuffle --svg no.svg --from 3 --to 3
refuses 'nowhere/a.svg: cannot be written' "$gaitsmith" export star-man-shuffle --svg nowhere/a.svg
refuses 'cannot be read' "$gaitsmith" export nowhere.json --svg no.svg
"$gaitsmith" help | grep -q 'gaitsmith export DOC' || fault "help on export"

[ $failed = 0 ] && echo "export keeps its contract"
exit $failed
