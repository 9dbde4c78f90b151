#!/usr/bin/env bash
# The contract of docs/command-line.md, seen from a script:   contract_test.sh <gaitsmith> <repository>
set -uo pipefail
gaitsmith=$(realpath "$1") root=$(realpath "$2") failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1

fault() { echo "FAILED: $*"; failed=1; }
# refuses <words of the message> <command...>: non-zero exit, the message on standard error, nothing on standard output
refuses() {
  local message=$1 status=0; shift
  "$@" >out 2>err || status=$?
  [ $status != 0 ] || fault "accepted: $*"
  [ ! -s out ] || fault "printed to standard output: $*"
  grep -qF -- "$message" err || fault "said '$(cat err)', not '$message': $*"
}
same() { [ "$1" = "$2" ] || fault "$3: '$1' is not '$2'"; }

golden=$root/tests/golden/motions/star-man-physical.json
hash=$("$gaitsmith" hash "$golden")
same "$hash" "$(sed -n 's/.*"hash": "\([0-9a-f]*\)".*/\1/p' "$golden")" "hash of a golden"
for document in "$root"/tests/golden/motions/*.json; do
  [ "$(grep -c '"start_step"' "$document")" = 1 ] || continue
  for lanes in 1 2 4 8 16; do
    same "$("$gaitsmith" hash --lanes $lanes "$document")" "$("$gaitsmith" hash "$document")" "$document in $lanes lanes"
  done
done
"$gaitsmith" validate "$golden" >/dev/null || fault "a golden is not valid"

# Documents come and go by file, link and standard streams without a changed byte.
"$gaitsmith" link encode "$golden" >link.txt || fault "link encode"
"$gaitsmith" link decode "$(cat link.txt)" >decoded.json || fault "link decode"
cmp -s decoded.json "$golden" || fault "JSON -> link -> JSON changed the document"
same "$("$gaitsmith" hash - <link.txt)" "$hash" "hash of a link on standard input"
same "$("$gaitsmith" hash star-man-shuffle)" "$("$gaitsmith" hash "$root/examples/star-man-shuffle.json")" "shipped example"

# One row a step, the start included, every column named.
"$gaitsmith" simulate "$golden" --csv motion.csv || fault "simulate"
same "$(head -1 motion.csv | cut -d, -f1-9)" "t,x,y,vx,vy,phi,L,rule,theta_1" "CSV header"
same "$(wc -l <motion.csv)" 1002 "rows of a 10 s motion"
same "$(awk -F, '{print NF}' motion.csv | sort -u | wc -l)" 1 "columns in every row"

# Every term of a motion in one row.
"$gaitsmith" measure "$golden" >measured.csv || fault "measure"
same "$(head -1 measured.csv)" "travel,max_cm_height,slip_sum,rotations,effort,upright,smoothness,head_height,fitness,hash" "header"
same "$(wc -l <measured.csv)" 2 "rows of measure"
same "$(sed -n 2p measured.csv | cut -d, -f10)" "$hash" "hash in measure"
# column <number> <document>
column() { "$gaitsmith" measure "$2" | sed -n 2p | cut -d, -f"$1"; }
same "$(column 6 star-man-shuffle)" "$("$gaitsmith" link encode star-man-shuffle | "$gaitsmith" measure - | sed -n 2p | cut -d, -f6)" \
  "upright of a link"

# A weight changes what a search finds and what it is worth.
weigh() { "$gaitsmith" synthesize --figure inchworm --sense timer=0.8 --search rgt --evaluations 200 --seed 4 --out "$1" "${@:2}"; }
weigh plain.json
weigh lazy.json --weight effort=-1 --weight head_height=0.5
grep -q '"effort": -1' lazy.json || fault "the weight of effort is not in the document"
grep -q '"effort"' plain.json && fault "a weight of 0 is in the document"
awk -v lazy="$(column 5 lazy.json)" -v plain="$(column 5 plain.json)" 'BEGIN { exit !(lazy < plain) }' || fault "less effort was not found"
awk -F, 'NR == 2 { d = ($1 < 0 ? -$1 : $1) - $5 + 0.5 * $8 - $9; exit !(d * d < 1e-8) }' <("$gaitsmith" measure lazy.json) ||
  fault "fitness is not the sum of its terms"

# The same document for any number of threads.
find() { "$gaitsmith" synthesize --figure inchworm --task travel --sense timer=0.8 --weight slip_sum=0.5 --search "$1" \
  --evaluations 300 --seed 9 --out "$2" --curve curve.csv --threads "$3" --search-option torus.side=8; }
for search in rgt sphc gga ssga shc mpga nelder-mead powell cma-es map-elites; do
  find $search one.json 1 || fault "synthesize"
  for threads in $([ $search = sphc ] && echo 2 3 4 5 6 7 8 || echo 3); do
    find $search many.json $threads; cmp -s one.json many.json || fault "$search with $threads threads found something else"
  done
done
same "$(head -1 curve.csv)" "evaluation,best" "curve header"
"$gaitsmith" validate one.json >/dev/null || fault "a found document is not valid"
"$gaitsmith" synthesize --figure "$root/examples/figures/hopper.json" --task jump --search rgt --evaluations 20 --out - \
  2>/dev/null | "$gaitsmith" validate - >/dev/null || fault "synthesize | validate"
# A refiner starts from what was found, and the new document says from where.
"$gaitsmith" synthesize --from one.json --search powell --evaluations 50 --search-option refine.step=0.05 --out refined.json \
  --curve refined.csv || fault "synthesize --from"
"$gaitsmith" validate refined.json >/dev/null || fault "a refined document is not valid"
same "$(sed -n 2p refined.csv)" "1,$(tail -1 curve.csv | cut -d, -f2)" "fitness that a refiner starts from"
same "$(grep -c '"start": 0' refined.json)" 1 "start in a refined document"

# Bad input: one clear sentence, and nothing is harmed.
echo keep >precious.json
refuses 'there is no figure "mr-moon"' "$gaitsmith" synthesize --figure mr-moon --out precious.json
refuses '"fly" is not known; choose from travel' "$gaitsmith" synthesize --task fly --out precious.json
refuses '--weight max_cm_height=x: must be a number' "$gaitsmith" synthesize --weight max_cm_height=x --out precious.json
refuses '"zeal" is not known; choose from max_cm_height, slip_sum, rotations, effort, upright, smoothness, head_height' \
  "$gaitsmith" synthesize --weight zeal=1 --out precious.json
for weight in nan inf '' 1e; do
  refuses "--weight effort=$weight: must be a number" "$gaitsmith" synthesize --weight effort=$weight --out precious.json
done
refuses 'task.weights.upright: must be from -1000 to 1000, is 1001' "$gaitsmith" synthesize --weight upright=1001 --out precious.json
refuses 'DOC: give exactly one document' "$gaitsmith" measure
refuses 'must be from 0.02 to 120 s' "$gaitsmith" synthesize --sense timer=0.001 --out precious.json
refuses 'must be a whole number from 1 to 100000000, is "many"' "$gaitsmith" synthesize --evaluations many --out precious.json
refuses '--colour: this command has no such option' "$gaitsmith" synthesize --colour red --out precious.json
refuses '"annealing" is not known; choose from rgt, sphc, gga' "$gaitsmith" synthesize --search annealing --out precious.json
refuses '"rate" is not known; choose from population' "$gaitsmith" synthesize --search-option rate=1 --out precious.json
refuses '--search-option genetic.mutation_rate: must be from 0 to 1, is 2' \
  "$gaitsmith" synthesize --search-option genetic.mutation_rate=2 --out precious.json
refuses '--search-option torus.side: must be a whole number, is ""' "$gaitsmith" synthesize --search-option torus.side --out precious.json
refuses 'must be at least the population, 200, is 100' "$gaitsmith" synthesize --search gga --evaluations 100 --out precious.json
refuses '--figure: cannot be given with --from' "$gaitsmith" synthesize --from one.json --figure hopper --out precious.json
refuses '--out: say where' "$gaitsmith" synthesize
same "$(cat precious.json)" keep "a file after refused commands"
refuses 'cannot be read' "$gaitsmith" hash nowhere.json
refuses 'was cut' "$gaitsmith" link decode "$(head -c 100 link.txt)"
refuses 'there is no command' "$gaitsmith" fly
sed 's/"friction": 0.8/"friction": 12/' "$golden" >bad.json
refuses 'environment.friction: must be from 0 to 10, is 12' "$gaitsmith" validate bad.json
sed 's/"friction": 0.8/"friction": 0.7/' "$golden" >other.json
refuses 'the motion differs from the one its maker saw' "$gaitsmith" validate other.json

[ $failed = 0 ] && echo "the command line keeps its contract"
exit $failed
