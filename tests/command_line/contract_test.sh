#!/usr/bin/env bash
# Tests docs/command-line.md with the program:   contract_test.sh <gaitsmith> <repository>
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
for document in "$root"/tests/golden/{motions,springs}/*.json; do
  [ "$(grep -c '"start_step"' "$document")" = 1 ] || continue
  for lanes in 1 2 4 8 16; do
    same "$("$gaitsmith" hash --lanes $lanes "$document")" "$("$gaitsmith" hash "$document")" "$document in $lanes lanes"
  done
done
"$gaitsmith" validate "$golden" >/dev/null || fault "a golden is not valid"

# Documents survive files, links and standard streams byte for byte.
"$gaitsmith" link encode "$golden" >link.txt || fault "link encode"
"$gaitsmith" link decode "$(cat link.txt)" >decoded.json || fault "link decode"
cmp -s decoded.json "$golden" || fault "JSON -> link -> JSON changed the document"
same "$("$gaitsmith" hash - <link.txt)" "$hash" "hash of a link on standard input"
for problem in "$root"/examples/problems/*.json; do
  same "$("$gaitsmith" hash "$(basename "$problem" .json)")" "$("$gaitsmith" hash "$problem")" "shipped problem"
done
same "$("$gaitsmith" hash star-man-shuffle)" "$("$gaitsmith" hash "$root/examples/star-man-shuffle.json")" "shipped example"
for motion in gallery/star-man-cartwheel gallery/frog-on-the-moon lessons/6-clock-12; do
  same "$("$gaitsmith" hash "${motion#*/}")" "$("$gaitsmith" hash "$root/examples/$motion.json")" "motion of $motion"
done
[ -z "$(basename -a "$root"/examples/*.json "$root"/examples/{problems,gallery,lessons}/*.json | sort | uniq -d)" ] ||
  fault "a motion of the gallery or of a lesson has the name of another example"

# One row per step, including the start, with named columns.
"$gaitsmith" simulate "$golden" --csv motion.csv || fault "simulate"
same "$(head -1 motion.csv | cut -d, -f1-9)" "t,x,y,vx,vy,phi,L,rule,theta_1" "CSV header"
same "$(wc -l <motion.csv)" 1002 "rows of a 10 s motion"
same "$(awk -F, '{print NF}' motion.csv | sort -u | wc -l)" 1 "columns in every row"

# Limited joints and very unequal rods: a warning, once, and the command goes on.
for model in 1 2; do
  echo '{"model":'$model',"figure":{"name":"Anvil","rods":[{"mass_kg":50},{"parent":0,"mass_kg":0.25}]}}' >anvil-$model.json
done
warns() { # times, command…
  local times=$1; shift
  "$@" 2>warned || fault "with a warning: $*"
  same "$(grep -cF 'the heaviest rod weighs 200 times as much as the lightest' warned)" "$times" "warnings of: $*"
}
warns 1 "$gaitsmith" simulate anvil-2.json --csv anvil.csv
warns 1 "$gaitsmith" synthesize --problem anvil-2.json --evaluations 20 --threads 1 --out anvil.json
warns 1 "$gaitsmith" synthesize --problem anvil-1.json --joints limited --evaluations 20 --threads 1 --out anvil.json
warns 1 "$gaitsmith" compare --problem anvil-2.json --search sphc --search rgt --trials 2 --evaluations 20 --out anvils.csv --curves anvil-curves.csv
warns 0 "$gaitsmith" simulate anvil-1.json --csv anvil.csv
warns 0 "$gaitsmith" synthesize --problem anvil-2.json --joints strong --evaluations 20 --threads 1 --out anvil.json

# Names that other programs may use.
"$gaitsmith" catalogue >catalogue.json || fault "catalogue"
same "$(sed -n 's/^  "\([a-z_]*\)": \[$/\1/p' catalogue.json | tr '\n' ' ')" \
  "algorithms tasks terms senses sense_kinds control_modes controller_kinds panels locks exporters languages gene_groups " "tables of the catalogue"
same "$(sed -n 's/.*"name": "\([a-z]*\)".*"number": \([0-9]*\).*/\1 \2/p' catalogue.json | tr '\n' ' ')" \
  "figure 0 controller 1 style 2 search 3 lab 4 timeline 5 keyframes 6 " "numbers of panels in links"
refuses 'all: catalogue takes no words' "$gaitsmith" catalogue all
same "$("$gaitsmith" version)" "gaitsmith $(sed -n 's/^project(gaitsmith VERSION \([0-9.]*\) .*/\1/p' "$root/CMakeLists.txt")" "version"
same "$("$gaitsmith" --version)" "$("$gaitsmith" version)" "--version"

# Children of picked motions: the same for any number of threads, and picks of a next round.
breed() { "$gaitsmith" breed star-man-shuffle --evaluations 300 --seed 5 "$@"; }
breed --out-prefix kid --threads 1 >kids.csv || fault "breed"
same "$(wc -l <kids.csv)" 10 "a heading and nine children"
same "$(head -1 kids.csv | cut -d, -f1-4)" "child,file,fitness,travel" "the heading of breed"
same "$(awk -F, 'NR == 4 { print $NF }' kids.csv)" "$("$gaitsmith" hash kid-3.json)" "the hash of a child"
for kid in 1 9; do "$gaitsmith" validate kid-$kid.json >/dev/null || fault "kid-$kid.json"; done
breed --out-prefix kin --threads 3 >kin.csv
same "$(sed 's/kin/kid/' kin.csv)" "$(cat kids.csv)" "children of three threads"
"$gaitsmith" breed kid-2.json kid-7.json --evaluations 300 --children 4 --difference 0.8 --keep goal --keep rule=2 --keep joint=1 \
  --out-prefix grandkid >grandkids.csv || fault "a second round"
same "$(wc -l <grandkids.csv)" 5 "four children"

# A taste that prefers the child that slips less, each time.
{ echo first,second,verdict
  awk -F, 'NR > 1 { file[NR] = $2; slip[NR] = $6 }
    END { for (i = 2; i <= NR; ++i) for (k = 2; k < i; ++k) print file[i] "," file[k] "," (slip[i] < slip[k] ? "first" : "second") }' kids.csv
} >taste.csv
"$gaitsmith" taste taste.csv --out liked.json >taste.txt || fault "taste"
same "$(head -1 taste.txt)" "trait,unit,scale,weight,doubt,likes" "the heading of taste"
same "$(grep '^slip,' taste.txt | cut -d, -f6)" less "what is liked"
"$gaitsmith" validate liked.json >/dev/null || fault "liked.json"
awk '/"slip_sum"/ { exit !($2 + 0 < 0) }' liked.json || fault "the weight of slip that was learned"
same "$("$gaitsmith" taste taste.csv --out -)" "$(cat liked.json)" "a document on standard output"

# The two children whose comparison would tell most.
"$gaitsmith" taste taste.csv --ask kid-1.json --ask kid-2.json --ask kid-3.json --out asked.json >question.csv || fault "a question"
same "$(head -1 question.csv)" "first,second,telling" "the heading of a question"
same "$(wc -l <question.csv)" 2 "one question"
same "$(cat asked.json)" "$(cat liked.json)" "a document beside a question"
# Children of the usual size have their picks with them.
"$gaitsmith" breed star-man-shuffle --out-prefix heir >/dev/null || fault "breed with standard options"
grep -q '"lineage"' heir-9.json || fault "the lineage of a child"
grep -q '"lineage"' kid-1.json && fault "a lineage that cannot be bred again"

# All terms of a motion, in one row.
"$gaitsmith" measure star-man-shuffle --worlds 4 >worlds.csv || fault "measure --worlds"
same "$(head -1 worlds.csv)" "world,friction,slope_rad,delay_steps,travel,fitness,substeps" "header of worlds"
same "$(wc -l <worlds.csv)" 5 "rows of worlds"
same "$(sed -n 2p worlds.csv | cut -d, -f1,5)" "0,$("$gaitsmith" measure star-man-shuffle | sed -n 2p | cut -d, -f1)" "the document's own world"
same "$(tail -n +3 worlds.csv | cut -d, -f5 | sort -u | wc -l)" 3 "worlds that differ"
same "$("$gaitsmith" measure star-man-shuffle --worlds 4 --noise delay | tail -n +2 | cut -d, -f2,3 | sort -u | wc -l)" 1 "one noise alone"
same "$("$gaitsmith" measure star-man-shuffle --worlds 9 --noise step | tail -n +2 | cut -d, -f2,3,7 | sort -u | wc -l)" 3 "steps of three lengths alone"
refuses '--noise: must be one of friction, mass, slope, delay, step, is "rain"' "$gaitsmith" measure star-man-shuffle --worlds 4 --noise rain
refuses '--noise: needs --worlds' "$gaitsmith" measure star-man-shuffle --noise mass
refuses '--worlds: needs a motion of one clip' "$gaitsmith" measure there-and-back --worlds 4
same "$("$gaitsmith" measure star-man-shuffle --substeps 1)" "$("$gaitsmith" measure star-man-shuffle)" "one substep"
[ "$("$gaitsmith" measure star-man-shuffle --substeps 4)" != "$("$gaitsmith" measure star-man-shuffle)" ] || fault "four substeps change nothing"
refuses '--substeps: must be a power of two, is 3' "$gaitsmith" measure star-man-shuffle --substeps 3
refuses '--substeps: needs a motion of one clip' "$gaitsmith" measure there-and-back --substeps 2
"$gaitsmith" measure "$golden" >measured.csv || fault "measure"
same "$(head -1 measured.csv)" "travel,max_cm_height,slip_sum,rotations,effort,upright,smoothness,head_height,fitness,hash,on_way,in_pose,work,peak_power,cost_of_transport" "header"
same "$(wc -l <measured.csv)" 2 "rows of measure"
same "$(sed -n 2p measured.csv | cut -d, -f10)" "$hash" "hash in measure"
# column <number> <document>
column() { "$gaitsmith" measure "$2" | sed -n 2p | cut -d, -f"$1"; }
same "$(column 6 star-man-shuffle)" "$("$gaitsmith" link encode star-man-shuffle | "$gaitsmith" measure - | sed -n 2p | cut -d, -f6)" \
  "upright of a link"

# A weight changes the result of a search and its score.
weigh() { "$gaitsmith" synthesize --figure inchworm --sense timer=0.8 --search rgt --evaluations 200 --seed 4 --out "$1" "${@:2}"; }
weigh plain.json
weigh lazy.json --weight effort=-1 --weight head_height=0.5
grep -q '"effort": -1' lazy.json || fault "the weight of effort is not in the document"
grep -q '"effort"' plain.json && fault "a weight of 0 is in the document"
awk -v lazy="$(column 5 lazy.json)" -v plain="$(column 5 plain.json)" 'BEGIN { exit !(lazy < plain) }' || fault "less effort was not found"
awk -F, 'NR == 2 { d = ($1 < 0 ? -$1 : $1) - $5 + 0.5 * $8 - $9; exit !(d * d < 1e-8) }' <("$gaitsmith" measure lazy.json) ||
  fault "fitness is not the sum of its terms"

# A way and a pose that the figure is shown.
teach() { "$gaitsmith" synthesize --figure inchworm --task travel --sense timer=0.8 --duration 3 --evaluations 600 --seed 2 --out "$@"; }
teach led.json --way 0:0:0.2,3:-1.5:0.2 || fault "--way"
teach free.json
"$gaitsmith" validate led.json >/dev/null || fault "led.json"
grep -q '"on_way": 10' led.json || fault "a way has no weight"
same "$(column 11 free.json)" 0 "on_way without a way"
awk -v way="$(column 11 led.json)" 'BEGIN { exit !(way < 0 && way > -0.75) }' || fault "the way was not met"
for wrong in "--way 0:0" "--way 1:0:2,1:3:2" "--way x:0:2" "--pose 1:0:2" "--pose 99999:0:0"; do
  # shellcheck disable=SC2086
  teach wrong.json $wrong 2>wrong.txt && fault "$wrong"
  [ -s wrong.txt ] && [ ! -e wrong.json ] || fault "$wrong says nothing, or writes"
done

# The number of threads does not change the document.
find() { "$gaitsmith" synthesize --figure inchworm --task travel --sense timer=0.8 --weight slip_sum=0.5 --search "$1" \
  --evaluations 300 --seed 9 --out "$2" --curve curve.csv --threads "$3" --search-option torus.side=8; }
for search in rgt sphc gga ssga shc mpga nelder-mead powell cma-es map-elites two-stage pose-cycle de nsga-ii cma-mae; do
  find $search one.json 1 || fault "synthesize"
  for threads in $([ $search = sphc ] && echo 2 3 4 5 6 7 8 || echo 3); do
    find $search many.json $threads; cmp -s one.json many.json || fault "$search with $threads threads found something else"
  done
done
same "$(head -1 curve.csv)" "evaluation,best" "curve header"
"$gaitsmith" validate one.json >/dev/null || fault "a found document is not valid"
"$gaitsmith" synthesize --figure "$root/examples/figures/hopper.json" --task jump --search rgt --evaluations 20 --out - \
  2>/dev/null | "$gaitsmith" validate - >/dev/null || fault "synthesize | validate"
# Goals: a document has the goal's task, and each motion that was found is counted.
"$gaitsmith" new --figure acrobat --goal calm --out calm.json || fault "new --goal"
grep -q '"effort": -0.0' calm.json || fault "calm has no weight on effort"
refuses 'choose from far, high-jump' "$gaitsmith" new --goal fly
"$gaitsmith" goals --search pose-cycle --figure acrobat --goal far --goal cartwheel --strength 2 --seeds 2 --evaluations 300 --out goals.csv \
  2>/dev/null || fault "goals"
"$gaitsmith" goals --summary goals.csv >met.csv || fault "goals --summary"
same "$(head -1 met.csv)" "figure,goal,strength,seeds,met" "columns of goals --summary"
same "$(grep -cE '^acrobat,(far|cartwheel),2,2,[0-2]$' met.csv)" 2 "rows of goals --summary"
refuses 'must be above 0, at most 16' "$gaitsmith" goals --search pose-cycle --strength 17 --seeds 1 --evaluations 9 --out no.csv
refuses 'no other option' "$gaitsmith" goals --summary goals.csv --seeds 2
sed 's/acrobat\.far\.2/acrobat-far/g' goals.csv >odd.csv
refuses 'must be FIGURE.GOAL.STRENGTH' "$gaitsmith" goals --summary odd.csv

# MAP-Elites keeps the best motion of every style, each as a document.
styles() { "$gaitsmith" synthesize --task travel --search "$1" --evaluations 600 --seed 9 --out kept.json --styles kept; }
styles map-elites || fault "synthesize --styles"
same "$(head -1 kept/styles.csv)" "height_bin,slip_bin,turns_bin,fitness,max_cm_height,slip_sum,rotations,file" "columns of styles"
[ "$(wc -l <kept/styles.csv)" -gt 3 ] || fault "too few styles"
while IFS=, read -r _ _ _ fitness height _ _ file; do
  same "$("$gaitsmith" measure "kept/$file" | tail -1 | cut -d, -f2)" "$height" "height of $file"
  same "$("$gaitsmith" validate "kept/$file" >/dev/null && echo valid)" valid "$file"
  echo "$fitness"
done < <(tail -n +2 kept/styles.csv) >kept/fitness
same "$(sort -g kept/fitness | tail -1)" "$("$gaitsmith" measure kept.json | awk -F, 'NR == 1 { while ($++i != "fitness"); } END { print $i }')" "the best style"
refuses 'goes with --search map-elites' styles sphc
rm -r kept
styles cma-mae || fault "synthesize --search cma-mae --styles"
[ "$(wc -l <kept/styles.csv)" -gt 3 ] || fault "too few styles of cma-mae"
# NSGA-II keeps the best motion for every price: each has the score and no motion both scores more and costs less.
front() { "$gaitsmith" synthesize --task travel --search "$1" --evaluations 1000 --seed 9 --search-option genetic.population=50 --out best.json --front front; }
front nsga-ii || fault "synthesize --front"
same "$(head -1 front/front.csv)" "fitness,cost,file" "columns of a front"
[ "$(wc -l <front/front.csv)" -gt 3 ] || fault "too few motions on a front"
while IFS=, read -r fitness _ file; do
  same "$("$gaitsmith" measure "front/$file" | awk -F, 'NR == 1 { while ($++i != "fitness"); } END { print $i }')" "$fitness" "fitness of $file"
done < <(tail -n +2 front/front.csv)
tail -n +2 front/front.csv | sort -c -g -t, -k1,1 || fault "a front is not by rising score"
tail -n +2 front/front.csv | sort -c -g -t, -k2,2 || fault "a front is not by rising cost"
refuses 'goes with --search nsga-ii' front sphc

# A search can start from an earlier result, and the new document records this.
"$gaitsmith" synthesize --from one.json --search powell --evaluations 50 --search-option refine.step=0.05 --out refined.json \
  --curve refined.csv || fault "synthesize --from"
"$gaitsmith" validate refined.json >/dev/null || fault "a refined document is not valid"
same "$(sed -n 2p refined.csv)" "1,$(tail -1 curve.csv | cut -d, -f2)" "fitness that a refiner starts from"
same "$(grep -c '"start": 0' refined.json)" 1 "start in a refined document"

# A problem by name, as in compare: the motion equals that of compare's first seed.
"$gaitsmith" synthesize --problem hopper-jump --weight rotations=1 --search shc --evaluations 40 --seed 3 --out hopper.json || fault "a problem"
"$gaitsmith" compare --problem hopper-jump --weight rotations=1 --search shc --evaluations 40 --trials 1 --first-seed 3 --points 1 \
  --out hopper.csv --curves hopper-curve.csv
for weight in usual 30; do
  "$gaitsmith" compare --problem star-man-travel --weight rotations=$weight --search shc --evaluations 9 --trials 1 --points 1 \
    --out usual-$weight.csv --curves usual-curve-$weight.csv
done
cmp -s usual-usual.csv usual-30.csv || fault "usual weights of a study"
same "$("$gaitsmith" hash hopper.json)" "$(sed -n '3s/.*,//p' hopper.csv)" "what synthesize and compare find of one problem"
refuses '--figure: cannot be given with --problem' "$gaitsmith" synthesize --problem hopper-jump --figure hopper --out no.json
"$gaitsmith" synthesize --problem star-man-travel --sense timer=3 --weight slip_sum=usual --search shc --evaluations 8 --seed 3 --out usual.json
same "$(grep '"slip_sum"' usual.json | tr -d ' ,')" '"slip_sum":0.45' "the usual weight"
"$gaitsmith" synthesize --problem star-man-travel --sense timer=3 --weight slip_sum=-gentle --search shc --evaluations 8 --seed 3 --out gentle.json
same "$(grep '"slip_sum"' gentle.json | tr -d ' ,')" '"slip_sum":-0.37' "less by the gentle weight"
refuses '--weight slip_sum=gently: must be' "$gaitsmith" synthesize --figure hopper --weight slip_sum=gently --out no.json

# A study has the same bytes for any number of threads or shards, and after interruptions.
study() { "$gaitsmith" compare --problem one.json --problem refined.json --search powell \
  --search ssga:genetic.population=8:genetic.rates=per-component --trials 2 --first-seed 9 --evaluations 60 --points 7 "$@"; }
study --threads 1 --out results.csv --curves curves.csv || fault "compare"
study --threads 2 --out results2.csv --curves curves2.csv || fault "compare with two threads"
for file in results curves; do cmp -s $file.csv ${file}2.csv || fault "two threads wrote other $file"; done
same "$(sed -n 2p results.csv)" "problem,search,seed,evaluations,best,travel,max_cm_height,slip_sum,rotations,grounded,bearers,hash" "columns of results"
same "$(sed -n 2p curves.csv)" "problem,search,seed,evaluation,best" "columns of curves"
same "$(wc -l <results.csv) $(wc -l <curves.csv)" "10 58" "rows of a study"
same "$(sed -n '3,9s/^one,powell,9,\([0-9]*\),.*/\1/p' curves.csv | tr '\n' ' ')" "8 17 25 34 42 51 60 " "points of a curve"
# A trial equals a search of synthesize, and starts from the controller of search.start.
"$gaitsmith" synthesize --from one.json --search powell --evaluations 60 --seed 9 --out trial.json
same "$(grep '^refined,powell,9,' results.csv | cut -d, -f12)" "$("$gaitsmith" hash trial.json)" "hash of a trial"
for i in 1 2 3; do study --shard $i/3 --out shard$i.csv --curves curve$i.csv || fault "shard $i/3"; done
"$gaitsmith" merge --complete --out merged.csv shard3.csv shard1.csv shard2.csv || fault "merge"
cmp -s merged.csv results.csv || fault "merged shards are not the whole"
"$gaitsmith" merge --complete --out - curve2.csv curve3.csv curve1.csv curve1.csv | cmp -s - curves.csv || fault "merged curves"
"$gaitsmith" merge --out part.csv shard1.csv shard3.csv 2>err || fault "merge of some"
same "$(cat err)" "gaitsmith merge: 3 of 8 trials are missing: shard 2/3 has no file" "warning about a lost shard"
same "$(sed -n '1s/.* searches [^ ]*//p' shard2.csv part.csv)" " shard 2/3" "the shard in a heading, not in that of a merged file"
"$gaitsmith" merge --out - part.csv 2>err >/dev/null
same "$(cat err)" "gaitsmith merge: 3 of 8 trials are missing, first that of one with powell and seed 10" "warning about missing trials"

# Progress over shards, also while they are written: a cut row, a file without a heading.
"$gaitsmith" merge --progress shard?.csv >progress.csv || fault "merge --progress"
same "$(cat progress.csv)" "$(printf '%s\n' shard,of,done,due,state,file 1,3,3,3,complete,shard1.csv 2,3,3,3,complete,shard2.csv \
  3,3,2,2,complete,shard3.csv all,,8,8,complete,)" "progress of a finished study"
head -c -20 shard3.csv >cut3.csv; : >bare.csv; cp curve1.csv "curve, 1.csv"
"$gaitsmith" merge --progress cut3.csv bare.csv shard1.csv >progress.csv 2>err && fault "an unfinished study exits with 0"
same "$(cat progress.csv)" "$(printf '%s\n' shard,of,done,due,state,file 1,3,3,3,complete,shard1.csv 2,3,0,3,missing, \
  3,3,1,2,unfinished,cut3.csv ,,0,,unfinished,bare.csv all,,4,8,unfinished,)" "progress of an unfinished study"
same "$(cat err)" "gaitsmith merge: 4 of 8 trials are missing: shard 2/3 has no file; shard 3/3 is not finished (cut3.csv)" "what is missing"
same "$("$gaitsmith" merge --progress curve2.csv "curve, 1.csv" 2>/dev/null | tail -n +2 | head -2)" \
  "$(printf '%s\n' '1,3,3,3,complete,"curve, 1.csv"' 2,3,3,3,complete,curve2.csv)" "progress of curves"
# One process per shard, several in parallel.
export -f study; export gaitsmith
seq 3 | xargs -P 2 -I{} bash -c 'study --threads 1 --shard {}/3 --out many{}.csv --curves manyc{}.csv'
"$gaitsmith" merge --complete --out - many?.csv | cmp -s - results.csv || fault "shards side by side"

# Truncated at any byte: complete trials are kept, and the others run again.
for bytes in 0 40 250 700 -1; do
  for file in results curves; do head -c $bytes $file.csv >torn-$file.csv; done
  study --out torn-results.csv --curves torn-curves.csv || fault "continued at $bytes"
  for file in results curves; do cmp -s $file.csv torn-$file.csv || fault "continued at $bytes: other $file"; done
done
sed -n '1,2p;6,7p' results.csv >torn-results.csv; sed -n 4p results.csv >>torn-results.csv; rm torn-curves.csv  # as trials finish
study --out torn-results.csv --curves torn-curves.csv || fault "continued with one file"
for file in results curves; do cmp -s $file.csv torn-$file.csv || fault "continued with one file: other $file"; done
"$gaitsmith" compare --problem one.json --search sphc --trials 4000 --evaluations 1000 --out stopped.csv --curves stoppedc.csv 2>err &
for _ in $(seq 400); do [ "$(wc -l 2>/dev/null <stopped.csv || echo 0)" -le 3 ] || break; sleep 0.05; done
kill -TERM $!; wait $! && fault "a stopped study exits with 0"
grep -q 'of 4000 trials are left' err || fault "a stopped study said '$(cat err)'"
"$gaitsmith" merge --out - stopped.csv >/dev/null 2>&1 || fault "a stopped study left a torn file"
same "$("$gaitsmith" compare --summary results.csv | grep -c ,)" 8 "rows of a summary"
same "$("$gaitsmith" compare --summary results.csv | sed -n 7p)" "problem,search_a,search_b,median_a,median_b,A12,p_holm" "pairs of a summary"
"$gaitsmith" compare --problem one.json --search rgt --search powell --trials 3 --first-seed 9 --evaluations 100 --out more.csv --curves more-curves.csv || fault "a second study"
"$gaitsmith" compare --summary results.csv --summary more.csv >both.csv || fault "a summary of two files"
grep -q '^one,powell in results,' both.csv && grep -q '^one,powell in more,3,' both.csv && grep -q '^one,rgt,3,' both.csv || fault "two files in one summary: $(cat both.csv)"
same "$("$gaitsmith" compare --summary results.csv --summary more.csv --search powell | grep -c '^one,')" 3 "rows of a summary of one search"
# Ranks over problems and seeds, as tables and as a diagram.
"$gaitsmith" compare --summary results.csv --ranks ranks.svg >ranked.csv || fault "compare --ranks"
grep -q '^search,blocks,mean_rank$' ranked.csv && grep -q '^better,worse,rank_difference,p_holm$' ranked.csv || fault "tables of ranks: $(cat ranked.csv)"
grep -q '^<svg xmlns=' ranks.svg && grep -q '</svg>' ranks.svg || fault "a diagram of ranks"
# Of curves: how soon targets are reached, and the same for IOHanalyzer.
"$gaitsmith" compare --summary curves.csv --ioh ioh >soon.csv || fault "a summary of curves"
same "$(head -1 soon.csv)" "problem,search,target,reached,n,ert,ert_low,ert_high" "columns of running times"
grep -q '^problem,search,evaluations,reached_share$' soon.csv || fault "columns of shares"
last_share() { awk -F, '/reached_share/ { on = 1; next } on && $1 == "one" && $2 == "'"$1"'" { share = $4 } END { print share }' soon.csv; }
same "$(awk -F, '/^problem,search,target/ { on = 1; next } /^$/ { on = 0 } on && $1 == "one" && $2 == "powell" { sum += $4 / $5; n++ } END { printf "%.6g", sum / n }' soon.csv)" \
  "$(printf '%.6g' "$(last_share powell)")" "the last share is the mean share of targets reached"
if command -v node >/dev/null; then node "$root/tests/command_line/ioh_check.mjs" ioh >/dev/null || fault "files for IOHanalyzer"; fi
refuses 'needs files of results' "$gaitsmith" compare --summary curves.csv --ranks no.svg
refuses 'needs files of curves' "$gaitsmith" compare --summary results.csv --ioh no
refuses 'summarise them one by one' "$gaitsmith" compare --summary results.csv --summary curves.csv
refuses 'goes with --summary' "$gaitsmith" compare --ioh no --out a.csv --curves b.csv

# A suite is a study with the motions, and can be resumed like one.
suite() { "$gaitsmith" suite --figure hopper --sense physical --sense timer=0.8 --task travel --task jump --style plain=slip_sum:0 \
  --style shuffle=slip_sum:usual,max_cm_height:-0.5 --search sphc --seeds 2 --first-seed 4 --evaluations 40 --rules 6 "$@"; }
suite --threads 1 --out suite.csv || fault "suite"
suite --threads 2 --out suite2.csv; cmp -s suite.csv suite2.csv || fault "two threads wrote another suite"
same "$(sed -n 2p suite.csv)" "$(sed -n 2p results.csv),link" "columns of a suite"
same "$(sed '1,2d;s/,.*//' suite.csv | uniq | tr '\n' ' ')" "physical.travel.plain physical.travel.shuffle physical.jump.plain \
physical.jump.shuffle timer=0.8.travel.plain timer=0.8.travel.shuffle timer=0.8.jump.plain timer=0.8.jump.shuffle " "labels of a suite"
for i in 1 2 3; do suite --shard $i/3 --out suite-shard$i.csv || fault "shard $i/3 of a suite"; done
"$gaitsmith" merge --complete --out - suite-shard?.csv | cmp -s - suite.csv || fault "merged shards of a suite"
for bytes in 0 40 500 3000 -1; do
  head -c $bytes suite.csv >torn-suite.csv
  suite --out torn-suite.csv && cmp -s suite.csv torn-suite.csv || fault "a suite continued at $bytes"
done
"$gaitsmith" suite --problem hopper-jump --search sphc --seeds 4000 --evaluations 1000 --out stopped-suite.csv 2>err &
for _ in $(seq 400); do [ "$(wc -l 2>/dev/null <stopped-suite.csv || echo 0)" -le 3 ] || break; sleep 0.05; done
kill -TERM $!; wait $! && fault "a stopped suite exits with 0"
grep -q 'of 4000 trials are left' err || fault "a stopped suite said '$(cat err)'"
same "$(sed -n '3s/,.*//p' stopped-suite.csv)" "physical.jump.plain" "what a suite of a problem is without --sense, --task and --style"
# Limited joints: the motions that synthesize finds, and another study than with strong ones.
hopping() { "$gaitsmith" suite --figure hopper --search sphc --seeds 1 --first-seed 4 --evaluations 40 "$@"; }
hopping --joints 1.5 --out limited-suite.csv || fault "a suite with limited joints"
"$gaitsmith" suite --extract limited-suite.csv --out-dir limited || fault "suite --extract with limited joints"
"$gaitsmith" synthesize --figure hopper --joints 1.5 --search sphc --evaluations 40 --seed 4 --out limited.json
same "$("$gaitsmith" hash limited/physical.travel.plain-4.json)" "$("$gaitsmith" hash limited.json)" "what suite and synthesize find with limited joints"
same "$(grep -c '"model": 2' limited/physical.travel.plain-4.json)" 1 "model of a suite with limited joints"
refuses 'is of another study' hopping --joints strong --out limited-suite.csv
hopping --joints strong --out strong-suite.csv && hopping --out plain-suite.csv && cmp -s strong-suite.csv plain-suite.csv ||
  fault "the joints of a figure are not strong by themselves"
# Joints that can do something else are another figure's for what one controller takes over from another.
"$gaitsmith" switches --times 3 --length 2 --out limited-switches.csv limited.json "$root/examples/problems/hopper-jump.json" 2>err &&
  fault "switches between limited joints and a document without a controller"
"$gaitsmith" synthesize --figure hopper --search sphc --evaluations 40 --seed 4 --out strong.json
"$gaitsmith" synthesize --figure hopper --joints 3 --search sphc --evaluations 40 --seed 4 --out stronger.json
"$gaitsmith" synthesize --figure hopper --joints 1.5 --search sphc --evaluations 40 --seed 5 --out limited-too.json
for other in strong stronger; do
  refuses "$other.json: has joints of another strength than limited.json" "$gaitsmith" switches --out none.csv limited.json $other.json
  refuses "--handover $other.json@2: has joints of another strength than the search" \
    "$gaitsmith" synthesize --figure hopper --joints 1.5 --handover $other.json@2 --search sphc --evaluations 40 --out none.json
done
"$gaitsmith" switches --times 3 --length 2 --out limited-switches.csv limited.json limited-too.json || fault "switches between limited joints"
same "$(wc -l <limited-switches.csv)" 7 "rows of switches between limited joints"
"$gaitsmith" synthesize --figure hopper --joints 1.5 --handover limited-too.json@2 --search sphc --evaluations 40 --out takes-over.json ||
  fault "a handover between limited joints"
"$gaitsmith" breed limited.json strong.json --evaluations 200 --children 2 --out-prefix mixed >mixed.csv 2>err || fault "breeding of limited and strong joints"
grep -q 'strong.json has joints of another strength; all children get those of limited.json' err || fault "breed said '$(cat err)'"
same "$(grep -c '"model": 2' mixed-1.json)" 1 "model of a child"
[ "$("$gaitsmith" validate mixed-1.json >/dev/null && echo valid)" = valid ] || fault "a child with limited joints is not valid"
# A push counts, and every option that takes documents takes these.
"$gaitsmith" measure limited.json >/dev/null && "$gaitsmith" validate limited.json >/dev/null || fault "measure and validate of limited joints"
for lanes in 1 2 4 8 16; do same "$("$gaitsmith" hash --lanes $lanes limited.json)" "$("$gaitsmith" hash limited.json)" "limited joints in $lanes lanes"; done
"$gaitsmith" simulate limited.json --csv limited.csv && "$gaitsmith" simulate strong.json --csv strong.csv || fault "simulate limited joints"
same "$(head -1 limited.csv)" "$(head -1 strong.csv)" "columns of limited joints"
"$gaitsmith" export limited.json --svg limited.svg --gltf limited.gltf --csv limited-too.csv || fault "export of limited joints"
cmp -s limited.csv limited-too.csv || fault "export and simulate wrote different numbers"

# Figures of springs: their columns, what they have, and what they do not have.
"$gaitsmith" simulate table-trip --csv springs.csv || fault "simulate a figure of springs"
same "$(head -1 springs.csv | cut -d, -f6-10)" "phi,L,rule,length_1,length_2" "the columns of springs"
same "$(head -1 springs.csv | grep -o 'node[0-9]*_x' | tail -1)" "node9_x" "a place for each node"
same "$("$gaitsmith" validate table-trip | cut -d, -f1-4)" "valid: Walking Table, 10 nodes, 19 springs, 8 muscles" "what springs are counted"
"$gaitsmith" export table-trip --controller springs.json --svg springs.svg || fault "export a figure of springs"
grep -q '"name": "muscle 8", "rod": -1, "spring": 18' springs.json || fault "no eighth muscle in the exported controller"
"$gaitsmith" export table-trip --sprites springs.zip --loop --in-place && "$gaitsmith" export table-trip --csv springs.csv --loop || fault "export a figure of springs as a loop"
same "$(sed -n 2p springs.csv | cut -d, -f9-16)" "$(tail -1 springs.csv | cut -d, -f9-16)" "lengths where a loop of springs begins and ends"
refuses 'figure: has springs, and this kind of file shows rods' "$gaitsmith" export table-trip --gltf precious.gltf
refuses '--joints: a figure of springs has no joints' "$gaitsmith" synthesize --figure jelly --joints limited --out precious.json
refuses 'kind: a figure of springs follows rules or curves, not a network' "$gaitsmith" synthesize --figure jelly --controller network --evaluations 20 --out precious.json
refuses 'figure: has springs: only angles of joints are recorded as curves' "$gaitsmith" record table-trip --out precious.json
refuses '--pose: is for figures of rods, and this one has springs' "$gaitsmith" synthesize --figure jelly --pose 1:0 --out precious.json
refuses 'plan: figures of springs have no keyframes' "$gaitsmith" plan table-trip --out precious.json
# They are chained, mapped, handed over, repaired and bred as others.
table=$root/tests/golden/springs/table-there-and-back.json
"$gaitsmith" synthesize --figure walking-table --search sphc --evaluations 40 --seed 3 --out another-table.json || fault "synthesize for springs"
"$gaitsmith" switches --times 3 --length 2 --out spring-switches.csv table-trip another-table.json || fault "switches between springs"
same "$(wc -l <spring-switches.csv)" 7 "rows of switches between springs"
"$gaitsmith" synthesize --figure walking-table --handover table-trip@2 --search sphc --evaluations 40 --out takes-over.json || fault "a handover between springs"
"$gaitsmith" synthesize --repair "$table" --clip 2 --search sphc --evaluations 40 --out repaired.json || fault "a repair of springs"
"$gaitsmith" breed table-trip another-table.json --evaluations 200 --children 2 --out-prefix soft >soft.csv || fault "breeding of springs"
for made in takes-over repaired soft-1; do
  grep -q '"model": 3' $made.json && "$gaitsmith" validate $made.json >/dev/null || fault "$made.json is no valid document of springs"
done
"$gaitsmith" link decode "$("$gaitsmith" link encode limited.json)" | cmp -s - limited.json || fault "a link changed limited joints"
"$gaitsmith" compare --problem limited.json --search sphc --trials 1 --first-seed 4 --evaluations 40 --joints strong --out cs.csv --curves cc.csv &&
  "$gaitsmith" compare --problem strong.json --search sphc --trials 1 --first-seed 4 --evaluations 40 --out co.csv --curves cd.csv &&
  same "$(sed -n 3p cs.csv | cut -d, -f2-)" "$(sed -n 3p co.csv | cut -d, -f2-)" "what compare finds with strong joints" || fault "compare with --joints"
# Each row's motion equals the document of synthesize, with the figure's name.
"$gaitsmith" suite --extract suite.csv --out-dir all || fault "suite --extract"
"$gaitsmith" suite --extract suite.csv --best --out-dir best || fault "suite --extract --best"
same "$(ls all | wc -l) $(ls best | wc -l)" "16 8" "documents of a suite"
for document in all/*.json; do "$gaitsmith" validate "$document" >/dev/null || fault "$document of a suite is not valid"; done
"$gaitsmith" synthesize --figure hopper --sense timer=0.8 --task jump --weight slip_sum=usual --weight max_cm_height=-0.5 --rules 6 \
  --search sphc --evaluations 40 --seed 5 --out trial.json
same "$("$gaitsmith" hash all/timer=0.8.jump.shuffle-5.json)" "$("$gaitsmith" hash trial.json)" "what suite and synthesize find"
grep -q '"name": "Hopper"' all/physical.jump.plain-4.json || fault "a suite lost the figure's name"
"$gaitsmith" suite --list suite.csv >list.txt || fault "suite --list"
same "$(head -1 list.txt | tr -s ' ')" "label seed score travel height slip rotations" "head of a list"
sed 1d list.txt | LC_ALL=C sort -c -k1,1 -k3,3gr || fault "a list is not sorted"
for line in $(sed 1d list.txt | awk '!seen[$1]++ { print $1 "-" $2 ".json" }'); do [ -e "best/$line" ] || fault "$line is not among the best"; done

# Repairing a clip changes nothing else.
# way <document>: distance that clip 2 of there-and-back moves to the right
way() { "$gaitsmith" simulate "$1" --csv - | awk -F, 'NR == 335 { x = $2 } NR == 702 { print $2 - x }'; }
repair() { "$gaitsmith" synthesize --repair "$1" --clip 2 --evaluations "$2" --out "$3" --curve repair.csv --threads "${4:-2}"; }
repair there-and-back 300 repaired.json || fault "synthesize --repair"
repair there-and-back 300 repaired1.json 1; cmp -s repaired.json repaired1.json || fault "one thread repaired otherwise"
"$gaitsmith" validate repaired.json >/dev/null || fault "a repaired document is not valid"
grep -q '"in_place_of"\|"start": [0-9]' repaired.json && fault "a repaired document still asks for its repair"
awk -F, 'NR == 2 { first = $2 } END { exit !(NR > 2 && $2 > first) }' repair.csv || fault "a repair did not improve its clip"
awk -v new="$(way repaired.json)" -v old="$(way there-and-back)" 'BEGIN { exit !(new > old) }' || fault "a repaired clip goes less far"
clips() { "$gaitsmith" link decode "$("$gaitsmith" link encode "$1")" | sed -n '/"timeline"/,/\]/p' | grep start_step; }
same "$(clips repaired.json)" "$(clips there-and-back)" "clips of a repaired document"
best=$(tail -1 repair.csv | cut -d, -f2)
repair repaired.json 1 again.json || fault "a repair that finds nothing"
same "$(tail -1 repair.csv)" "1,$best" "what a repair begins with"
same "$("$gaitsmith" hash again.json)" "$("$gaitsmith" hash repaired.json)" "a repair that finds nothing keeps the motion"
# Grounds by name: the same rubble for every command, and only with limited joints.
course() { "$gaitsmith" synthesize --figure hopper --joints 1.5 --search sphc --evaluations 40 --seed 4 --out course.json "$@"; }
for ground in step stairs ramp gap hurdles rubble rubble:7; do
  course --ground $ground && "$gaitsmith" validate course.json >/dev/null && grep -q '"ground"' course.json || fault "--ground $ground"
done
hopping --joints 1.5 --ground rubble:7 --out course-suite.csv && "$gaitsmith" suite --extract course-suite.csv --out-dir course || fault "a suite on rubble"
same "$("$gaitsmith" hash course/physical.travel.plain-4.json)" "$("$gaitsmith" hash course.json)" "what suite and synthesize find on rubble"
refuses 'is of another study' hopping --joints 1.5 --ground rubble:8 --out course-suite.csv
"$gaitsmith" compare --problem course.json --ground step --search sphc --trials 1 --evaluations 40 --out gs.csv --curves gc.csv || fault "compare --ground"
course --ground level && cmp -s course.json limited.json || fault "level ground is what a figure stands on anyway"
refuses '--ground: only limited joints know such ground: add --joints limited' "$gaitsmith" synthesize --figure hopper --ground step --out none.json
refuses '--ground rubble: must be a whole number from 1 to 999, is "0"' course --ground rubble:0
course --ground rubble:7
same "$("$gaitsmith" measure course.json --ground rubble:7)" "$("$gaitsmith" measure course.json)" "measure on the document's own ground"
refuses '--ground: only limited joints know such ground' "$gaitsmith" measure star-man-shuffle --ground step
"$gaitsmith" synthesize --figure mr-star-man --joints 4 --search pose-cycle --evaluations 400 --seed 1 --out strider.json || fault "a strider"
[ "$("$gaitsmith" measure strider.json | tail -1)" != "$("$gaitsmith" measure strider.json --ground step | tail -1)" ] || fault "measure --ground"
for wrong in swamp gap:2 rubble7; do
  refuses "--ground: must be level, step, stairs, ramp, gap, hurdles, rubble or rubble:SEED, is \"$wrong\"" course --ground $wrong
done
refuses '--ground: cannot be given with --repair' "$gaitsmith" synthesize --repair star-man-shuffle --clip 1 --ground step --out none.json

# A clip of a chain with limited joints is repaired in their model.
sed 's/"model": 1/"model": 2/' "$root/examples/there-and-back.json" >limited-chain.json
"$gaitsmith" hash limited-chain.json --out limited-chain.json >/dev/null
repair limited-chain.json 100 limited-repaired.json || fault "synthesize --repair with limited joints"
same "$(grep -c '"model": 2' limited-repaired.json)" 1 "model of a repaired document"
"$gaitsmith" validate limited-repaired.json >/dev/null || fault "a repaired document with limited joints is not valid"
refuses '--joints: cannot be given with --repair' "$gaitsmith" synthesize --repair limited-chain.json --clip 2 --joints strong --out none.json

# A search with --handover yields an ordinary document.
handed() { "$gaitsmith" synthesize --figure mr-star-man --evaluations 60 --seed 2 --out "$@"; }
handed handed.json --handover star-man-shuffle@2 --handover star-man-shuffle@3.5 --threads 1 || fault "synthesize --handover"
handed handed2.json --handover star-man-shuffle@2 --handover star-man-shuffle@3.5 --threads 2
cmp -s handed.json handed2.json || fault "two threads found another robust controller"
same "$("$gaitsmith" validate handed.json)" "valid: Mr. Star-Man, 5 rods, 1 controllers, 1 clips, 5 s" "a robust controller's document"
grep -q '"handovers"' handed.json && fault "a robust controller's document holds its handovers"
handed unhanded.json
cmp -s handed.json unhanded.json && fault "handovers change nothing"
"$gaitsmith" synthesize --from star-man-shuffle --handover star-man-shuffle@2 --evaluations 20 --out handed.json || fault "--from --handover"
same "$("$gaitsmith" validate handed.json | cut -d, -f3)" " 2 controllers" "--from with --handover"

# All switches between controllers.
"$gaitsmith" switches --times 4 --threads 1 --summary --out switches.csv best/p*.json best/timer=0.8.jump.plain-*.json >rates.csv || fault "switches"
"$gaitsmith" switches --times 4 --threads 2 --out switches2.csv best/p*.json best/timer=0.8.jump.plain-*.json
cmp -s switches.csv switches2.csv || fault "two threads made other switches"
# A shard of them is some of the pairs.
shared() { "$gaitsmith" switches --times 4 best/p*.json best/timer=0.8.jump.plain-*.json "$@"; }
for i in 1 2 3; do shared --shard $i/3 --out part-switches$i.csv || fault "shard $i/3 of switches"; done
"$gaitsmith" merge --complete --out - part-switches?.csv | cmp -s - switches.csv || fault "merged shards of switches"
"$gaitsmith" merge --progress part-switches[13].csv >progress.csv 2>err && fault "lost switches pass for complete"
same "$(cat progress.csv)" "$(printf '%s\n' shard,of,done,due,state,file 1,3,7,7,complete,part-switches1.csv 2,3,0,7,missing, \
  3,3,6,6,complete,part-switches3.csv all,,13,20,unfinished,)" "progress of switches"
same "$(cat err)" "gaitsmith merge: 7 of 20 pairs are missing: shard 2/3 has no file" "what is missing of switches"
refuses 'holds trials that are not in the files given' "$gaitsmith" merge --out part-switches1.csv part-switches2.csv
refuses 'results.csv:1: is not a shard of gaitsmith switches' "$gaitsmith" merge --progress part-switches1.csv results.csv
refuses '--summary: cannot be given with --shard' shared --shard 1/3 --summary --out none.csv
"$gaitsmith" switches --times 5 --shard 2/3 --out other-switches.csv best/p*.json
refuses 'is of another study' "$gaitsmith" merge --out - part-switches1.csv other-switches.csv
same "$(head -1 switches.csv)" "from,to,step,score,usual,success,distance" "columns of switches"
same "$(wc -l <switches.csv)" 81 "rows of switches"
same "$(sed -n 2,5p switches.csv | cut -d, -f3 | tr '\n' ' ')" "100 233 366 500 " "steps of switches"
same "$(head -1 rates.csv) $(wc -l <rates.csv)" "from_class,to_class,switches,successes,rate 4" "rates of switches"
same "$(awk -F, 'NR > 1 { n += $6 } END { print n }' switches.csv)" "$(awk -F, 'NR > 1 { n += $4 } END { print n }' rates.csv)" "successes"
awk -F, 'NR > 1 { least = $5 > 0 ? $5 / 2 : $5 * 1.5; if ($6 != ($4 >= least)) exit 1 }' switches.csv || fault "success is not half of the usual"
jump=$(ls best/physical.jump.plain-*.json)
same "$(grep -m1 ",$(basename "$jump" .json)," switches.csv | cut -d, -f5)" "$("$gaitsmith" measure "$jump" | sed -n 2p | cut -d, -f9)" "the usual"

# Invalid input: one clear sentence, and files are unchanged.
echo keep >precious.json
refuses 'there is no figure "mr-moon"' "$gaitsmith" synthesize --figure mr-moon --out precious.json
refuses '"fly" is unknown: choose from travel' "$gaitsmith" synthesize --task fly --out precious.json
refuses '--weight max_cm_height=x: must be a number' "$gaitsmith" synthesize --weight max_cm_height=x --out precious.json
refuses '"zeal" is unknown: choose from max_cm_height, slip_sum, rotations, effort, upright, smoothness, head_height' \
  "$gaitsmith" synthesize --weight zeal=1 --out precious.json
for weight in nan inf '' 1e; do
  refuses "--weight effort=$weight: must be a number" "$gaitsmith" synthesize --weight effort=$weight --out precious.json
done
refuses 'task.weights.upright: must be from -1000 to 1000, is 1001' "$gaitsmith" synthesize --weight upright=1001 --out precious.json
refuses 'DOC: give exactly one document' "$gaitsmith" measure
refuses 'must be from 0.02 to 120 s' "$gaitsmith" synthesize --sense timer=0.001 --out precious.json
refuses 'must be a whole number from 1 to 100000000, is "many"' "$gaitsmith" synthesize --evaluations many --out precious.json
refuses '--colour: this command has no such option' "$gaitsmith" synthesize --colour red --out precious.json
refuses '"annealing" is unknown: choose from rgt, sphc, gga' "$gaitsmith" synthesize --search annealing --out precious.json
refuses '"rate" is unknown: choose from population' "$gaitsmith" synthesize --search-option rate=1 --out precious.json
refuses '--search-option genetic.mutation_rate: must be from 0 to 1, is 2' \
  "$gaitsmith" synthesize --search-option genetic.mutation_rate=2 --out precious.json
refuses '--search-option torus.side: must be a whole number, is ""' "$gaitsmith" synthesize --search-option torus.side --out precious.json
refuses 'must be at least the population, 200, is 100' "$gaitsmith" synthesize --search gga --evaluations 100 --out precious.json
refuses '--figure: cannot be given with --from' "$gaitsmith" synthesize --from one.json --figure hopper --out precious.json
refuses '--out: say where' "$gaitsmith" synthesize
# wrong <status> <words> <command...>: refused with exactly this exit status
wrong() { refuses "${@:2}"; "${@:3}" >/dev/null 2>&1; same $? "$1" "exit status of: ${*:3}"; }
to=(--out results.csv --curves curves.csv)
cp results.csv results-before.csv; cp curves.csv curves-before.csv
wrong 2 '--trials: must be a whole number from 1 to 1000000, is "0"' study "${to[@]}" --trials 0
wrong 2 '--points: must be a whole number from 1 to 60, is "61"' study "${to[@]}" --points 61
wrong 2 'must be at least the population, 200, is 60' study "${to[@]}" --search gga
wrong 2 '"annealing" is unknown: choose from rgt, sphc' study "${to[@]}" --search annealing
wrong 2 '"rate" is unknown: choose from population' study "${to[@]}" --search sphc:rate=1
wrong 2 '--search: "powell" is there twice' study "${to[@]}" --search powell
wrong 2 '--problem: "one" is there twice' study "${to[@]}" --problem ./one.json
wrong 1 'nowhere.json: cannot be read' study "${to[@]}" --problem nowhere.json
wrong 2 'must be i/n with i from 1 to n, such as 2/8, is "3/2"' study "${to[@]}" --shard 3/2
wrong 2 'must be i/n with i from 1 to n' study "${to[@]}" --shard 5/18446744073709551615
wrong 2 '--weight slip_sum=nan: must be a number' study "${to[@]}" --weight slip_sum=nan
wrong 2 'weights.slip_sum: must be from -1000 to 1000, is 2000' study "${to[@]}" --weight slip_sum=2000
wrong 2 'search.start: must be a controller of the kind, the senses' study "${to[@]}" --sense physical
wrong 2 'must be another file than --out' study --out results.csv --curves ./results.csv
wrong 2 '--out: must be a file' study --out - --curves curves.csv
wrong 2 '--curves: say which file' study --out results.csv
wrong 1 'nowhere/c.csv: cannot be written' study --out new.csv --curves nowhere/c.csv
[ ! -e new.csv ] || fault "a refused study left a file"
wrong 1 "results.csv: is of another study, $(head -1 results.csv | cut -d' ' -f4); this one is" study "${to[@]}" --first-seed 8
wrong 1 'holds the other table' study --out curves.csv --curves results.csv
wrong 1 'precious.json:1: is not a file of gaitsmith compare' study --out precious.json --curves curves.csv
wrong 1 'is of another study' "$gaitsmith" merge --out precious.json results.csv stopped.csv
wrong 1 'holds curves, but results.csv holds results' "$gaitsmith" merge --out precious.json results.csv curves.csv
wrong 1 '3 of 8 trials are missing' "$gaitsmith" merge --complete --out precious.json shard1.csv shard3.csv
wrong 1 'holds trials that are not in the files given' "$gaitsmith" merge --out shard1.csv shard2.csv shard3.csv
wrong 2 'give the files to be merged' "$gaitsmith" merge --out precious.json
refuses 'give the files to be merged' "$gaitsmith" merge --progress
refuses '--progress: goes with no other option' "$gaitsmith" merge --progress --out precious.json results.csv
refuses 'is of another study' "$gaitsmith" merge --progress results.csv stopped.csv
refuses 'curves.csv: holds curves, but results.csv holds results' "$gaitsmith" merge --progress results.csv curves.csv
refuses 'precious.json:1: is not a file of gaitsmith compare or suite' "$gaitsmith" merge --progress results.csv precious.json
refuses 'has no heading yet, and neither has any other file' "$gaitsmith" merge --progress bare.csv
refuses 'is of shard 1/3; this run is shard 2/3' study --shard 2/3 --out shard1.csv --curves curve1.csv
refuses 'is of shard 1/3; this run is the whole study' study --out shard1.csv --curves curve1.csv
sed 's/ shard 1\/3$/ shard 2\/3/' shard1.csv >damaged.csv
refuses 'damaged.csv:3: is of no trial of shard 2/3' "$gaitsmith" merge --progress damaged.csv
sed '5s/,60,/,59,/' results.csv >damaged.csv
wrong 1 'damaged.csv:5: must have 60 evaluations' "$gaitsmith" merge --out precious.json damaged.csv
sed 5d curves.csv >damaged.csv
wrong 1 'damaged.csv:5: must be of evaluation 25' "$gaitsmith" merge --out precious.json damaged.csv
sed '6s/,60,[0-9]/,60,7/' results.csv >damaged.csv
wrong 1 'damaged.csv:6: disagrees about a trial with results.csv:6' "$gaitsmith" merge --out precious.json results.csv damaged.csv
wrong 1 'damaged.csv:6: this trial now finds something else' study --out damaged.csv --curves new.csv
head -c 700 results.csv >damaged.csv
wrong 1 'the trial is cut short' "$gaitsmith" merge --out precious.json damaged.csv
wrong 2 'goes with no other option' "$gaitsmith" compare --summary results.csv --threads 2
wrong 1 'no file has trials of gga' "$gaitsmith" compare --summary results.csv --search gga
wrong 1 'is given twice' "$gaitsmith" compare --summary results.csv --summary results.csv
wrong 2 '--problem: must be given, or --figure' "$gaitsmith" suite --search sphc --seeds 1 --evaluations 9 --out precious.json
wrong 2 '--figure: cannot be given with --problem' suite --problem hopper-jump --out suite.csv
wrong 1 'there is no figure' "$gaitsmith" suite --figure moon --search sphc --seeds 1 --evaluations 9 --out precious.json
wrong 2 '--seeds: must be a whole number from 1 to 1000000, is "0"' suite --seeds 0 --out suite.csv
wrong 2 '--style a: must be NAME=TERM:W[,TERM:W]' suite --style a --out suite.csv
wrong 2 '--style a/b=slip_sum:1: "a/b" cannot be a name' suite --style a/b=slip_sum:1 --out suite.csv
wrong 2 '--style a=slip_sum: "slip_sum" must be TERM:W' suite --style a=slip_sum --out suite.csv
wrong 2 '--style a=zeal:1: "zeal" is unknown: choose from max_cm_height' suite --style a=zeal:1 --out suite.csv
wrong 2 '--style a=slip_sum:x: must be a number, is "x"' suite --style a=slip_sum:x --out suite.csv
wrong 2 'weights.slip_sum: must be from -1000 to 1000, is 2000' suite --style a=slip_sum:2000 --out suite.csv
wrong 2 '"physical.travel.plain" is there twice' suite --sense physical --out suite.csv
wrong 2 '"fly" is unknown: choose from travel' suite --task fly --out suite.csv
wrong 2 '--search: can be given once' suite --search rgt --out suite.csv
wrong 2 '--joints: must be strong, limited or a strength in M g L, is "weak"' suite --joints weak --out suite.csv
wrong 2 'strength: must be from 0 to 1000, is 1001' suite --joints 1001 --out suite.csv
wrong 2 '--extract: goes with --best and --out-dir alone' "$gaitsmith" suite --extract suite.csv --joints limited --out-dir all
wrong 2 '--extract: goes with --best and --out-dir alone' "$gaitsmith" suite --extract suite.csv --ground step --out-dir all
wrong 2 '--ground: only limited joints know such ground' suite --ground stairs --out suite.csv
wrong 2 '--out: must be a file' suite --out -
wrong 2 '--best: goes with --extract alone' suite --out suite.csv --best
wrong 2 '--out-dir: say in which folder' "$gaitsmith" suite --extract suite.csv
wrong 2 '--list: goes with no other option' "$gaitsmith" suite --list suite.csv --threads 2
wrong 1 'holds results, not the motions of a suite' "$gaitsmith" suite --list results.csv
wrong 1 'holds motions; a summary is made from' "$gaitsmith" compare --summary suite.csv
wrong 1 'is of another study' suite --out suite.csv --duration 4
wrong 1 'holds motions, but shard1.csv holds results' "$gaitsmith" merge --out precious.json shard1.csv \
  <(sed "1s/[0-9a-f]\{16\}/$(head -1 shard1.csv | cut -d' ' -f4)/" suite.csv)
sed '5s/......$/AAAAAA/' suite.csv >damaged.csv
wrong 1 'damaged.csv:5: its link is damaged' "$gaitsmith" merge --out precious.json damaged.csv
awk -F, -v OFS=, 'NR == FNR { link[FNR] = $NF; next } FNR == 5 { $NF = link[6] } { print }' suite.csv suite.csv >damaged.csv
wrong 1 'damaged.csv:5: its link holds the motion of another trial' suite --out damaged.csv
refuses '--clip: say which clip' "$gaitsmith" synthesize --repair there-and-back --out precious.json
refuses '--clip: must be a whole number from 2 to 3, is "1"' "$gaitsmith" synthesize --repair there-and-back --clip 1 --out precious.json
refuses '--clip: must be a whole number from 2 to 3, is "4"' "$gaitsmith" synthesize --repair there-and-back --clip 4 --out precious.json
refuses '--clip: goes with --repair alone' "$gaitsmith" synthesize --clip 2 --out precious.json
refuses 'has no clip that takes over from another one' "$gaitsmith" synthesize --repair star-man-shuffle --clip 2 --out precious.json
for option in figure=hopper problem=hopper-jump from=one.json handover=one.json@1 sense=physical rules=9 controller=rules duration=3; do
  refuses "--${option%%=*}: cannot be given with --repair" "$gaitsmith" synthesize --repair there-and-back --clip 2 --$option --out precious.json
done
refuses '--handover one.json: must be DOC@SECONDS' "$gaitsmith" synthesize --handover one.json --out precious.json
refuses '--handover one.json@0: must be from 0.01 to 119.99 s' "$gaitsmith" synthesize --handover one.json@0 --out precious.json
refuses '--handover star-man-shuffle@2: is of another figure, "Mr. Star-Man"; the search is for "Hopper"' \
  "$gaitsmith" synthesize --figure hopper --handover star-man-shuffle@2 --out precious.json
refuses '--handover hopper-jump@2: has no controller' "$gaitsmith" synthesize --figure hopper --handover hopper-jump@2 --out precious.json
wrong 2 "--out-prefix: say what the children's files begin with" "$gaitsmith" breed star-man-shuffle
wrong 2 'DOC: give at least one document' "$gaitsmith" breed --out-prefix precious
wrong 1 'hopper-jump: has no motion to breed from' "$gaitsmith" breed hopper-jump --out-prefix precious
wrong 1 'has another figure than star-man-shuffle' "$gaitsmith" breed star-man-shuffle "$jump" --out-prefix precious
wrong 1 'its controller has another kind, other senses or another number of rules' "$gaitsmith" breed star-man-shuffle usual.json --out-prefix precious
wrong 2 '--difference: must be from 0 to 1' "$gaitsmith" breed star-man-shuffle --difference 1.5 --out-prefix precious
wrong 2 '--children: must be a whole number from 1 to 16, is "17"' "$gaitsmith" breed star-man-shuffle --children 17 --out-prefix precious
wrong 2 '--keep: must be goal, rule=N or joint=N, is leg=1' "$gaitsmith" breed star-man-shuffle --keep leg=1 --out-prefix precious
wrong 2 '--keep rule: must be a whole number from 1 to 10, is "11"' "$gaitsmith" breed star-man-shuffle --keep rule=11 --out-prefix precious
wrong 2 '--keep joint: must be a whole number from 1 to 4, is "1.5"' "$gaitsmith" breed star-man-shuffle --keep joint=1.5 --out-prefix precious
wrong 2 'CSV: give exactly one file' "$gaitsmith" taste
wrong 2 '--ask: give at least two documents' "$gaitsmith" taste precious.json --ask precious.json
wrong 1 'precious.json:1: must be the heading first,second,verdict' "$gaitsmith" taste precious.json
printf 'first,second,verdict\nkid-1.json,kid-2.json,maybe\n' >bad.csv
wrong 1 'bad.csv:2: "maybe" is unknown: choose from first, second, neither' "$gaitsmith" taste bad.csv --out precious.json
printf 'first,second,verdict\nkid-1.json,first\n' >bad.csv
wrong 1 'bad.csv:2: must be first,second,verdict' "$gaitsmith" taste bad.csv --out precious.json
printf 'first,second,verdict\nkid-1.json,%s,first\n' "$jump" >bad.csv
wrong 1 'has another figure than the motions before' "$gaitsmith" taste bad.csv --out precious.json
printf 'first,second,verdict\n' >bad.csv
wrong 1 'bad.csv: has no comparison' "$gaitsmith" taste bad.csv --out precious.json
wrong 2 '--out: say where to write the rows' "$gaitsmith" switches "$jump" trial.json
wrong 2 'DOC: give at least two documents' "$gaitsmith" switches --out precious.json "$jump"
wrong 2 '--times: must be a whole number from 1 to 1000, is "0"' "$gaitsmith" switches --times 0 --out precious.json "$jump" trial.json
wrong 2 '--length: must be from 0.01 to 120 s' "$gaitsmith" switches --length 0 --out precious.json "$jump" trial.json
wrong 1 'one.json: is of another figure than' "$gaitsmith" switches --out precious.json "$jump" one.json
wrong 1 'hopper-jump: has no controller' "$gaitsmith" switches --out precious.json "$jump" hopper-jump
wrong 1 'is there twice; names must differ' "$gaitsmith" switches --out precious.json "$jump" "$jump"
suite --out suite.csv; cmp -s suite.csv suite2.csv || fault "a refused command changed a suite"
cmp -s results.csv results-before.csv && cmp -s curves.csv curves-before.csv || fault "a refused command changed a study"
same "$(cat precious.json)" keep "a file after refused commands"
# A motion in both forms, and a search among trajectories.
"$gaitsmith" record "$golden" --knots 8 --out curves.json >record.csv
same "$(head -1 record.csv)" knots,typical_rad,worst_rad,travel,recorded_travel "the columns of record"
"$gaitsmith" validate curves.json >/dev/null || fault "a recording is not valid"
"$gaitsmith" synthesize --controller trajectory:rest --sense timer=1 --rules 6 --search rgt --evaluations 20 --out curves.json
grep -q '"at_end": "rest"' curves.json || fault "a trajectory that rests"
"$gaitsmith" synthesize --controller trajectory --sense timer=1 --search pose-cycle --evaluations 60 --out curves.json
grep -q '"knots"' curves.json || fault "the knots of a trajectory"
refuses 'a trajectory follows a timer and has no other senses' "$gaitsmith" synthesize --controller trajectory --out precious.json
refuses '--knots: must be a whole number from 2 to 32, is "1"' "$gaitsmith" record "$golden" --knots 1
refuses 'has no controller whose motion could be recorded' "$gaitsmith" record hopper-jump
# A motion between keyframes, planned and played, and one that cannot be.
"$gaitsmith" plan "$root/examples/plans/lamp-jump.json" --degree 3 --pieces 16 --motion planned.csv --out planned.json >plan.csv
same "$(head -1 plan.csv)" iterations,cost,residual,played_miss,first_miss,corrections "the columns of plan"
awk -F, 'NR == 2 && !($4 < 0.01) { exit 1 }' plan.csv || fault "the lamp is not played where it is planned"
same "$(wc -l <planned.csv)" 202 "a row for each step of a plan"
"$gaitsmith" validate planned.json >/dev/null || fault "a planned document is not valid"
grep -q '"knots"' planned.json || fault "a plan is played by a trajectory"
sed 's/"x_m": 0.6/"x_m": 60/' "$root/examples/plans/lamp-jump.json" >far.json
refuses 'plan.keyframes[0].marks[0].x_m: cannot be met: the nearest motion misses it by' "$gaitsmith" plan far.json
refuses 'plan: has no keyframe' "$gaitsmith" plan "$golden"
refuses '--degree: must be a whole number from 3 to 5, is "2"' "$gaitsmith" plan planned.json --degree 2
refuses 'cannot be read' "$gaitsmith" hash nowhere.json
refuses 'was cut' "$gaitsmith" link decode "$(head -c 100 link.txt)"
for command in compare suite merge switches breed taste; do
  "$gaitsmith" help | grep -q "gaitsmith $command " || fault "help on $command"
  "$gaitsmith" $command --help | grep -q "gaitsmith $command " || fault "$command --help"
done
refuses 'there is no command' "$gaitsmith" fly
sed 's/"friction": 0.8/"friction": 12/' "$golden" >bad.json
refuses 'environment.friction: must be from 0 to 10, is 12' "$gaitsmith" validate bad.json
sed 's/"friction": 0.8/"friction": 0.7/' "$golden" >other.json
refuses 'the motion differs from the one its maker saw' "$gaitsmith" validate other.json

[ $failed = 0 ] && echo "the command line keeps its contract"
exit $failed
