#!/usr/bin/env bash
# What a large study costs (docs/clusters.md): cost.sh GAITSMITH, a release build. Writes two tables beside this file:
# throughput.csv, processor seconds of one search on one core, and merge.csv, what merging files of many trials takes.
# About 20 minutes. Needs GNU time.
set -euo pipefail
gaitsmith=$(realpath "$1") here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

echo joints,search,seed,evaluations,user_s >"$here/throughput.csv"
for joints in strong limited; do
  for search in rgt sphc cma-es; do
    for seed in 1 2 3; do
      rm -f r.csv c.csv
      /usr/bin/time -o time -f %U "$gaitsmith" compare --problem star-man-travel --joints $joints --search $search --trials 1 --first-seed $seed \
        --evaluations 40000 --threads 1 --out r.csv --curves c.csv
      echo "$joints,$search,$seed,40000,$(cat time)" >>"$here/throughput.csv"
    done
  done
done

# Rows as long as real ones: merge does not know that no search has found them.
heading() { echo "# gaitsmith study 0123456789abcdef trials $2 $1 evaluations 40000 points 100 first-seed 1 problems star-man-travel searches sphc"; }
results() {
  heading results "$1"
  echo problem,search,seed,evaluations,best,travel,max_cm_height,slip_sum,rotations,grounded,bearers,hash
  awk -v n="$1" 'BEGIN { for (i = 1; i <= n; ++i) printf "star-man-travel,sphc,%d,40000,%.9g,%.9g,%.9g,%.9g,%.9g,0.71%d,5,%08x%08x\n", i, 29.1234567 + i / 1e5,
    29.1234567 + i / 1e5, 2.65 + i / 1e7, 9.12345 + i / 1e6, -0.123456789 - i / 1e7, i % 9 + 1, i, i * 7 }'
}
curves() {
  heading curves "$1"
  echo problem,search,seed,evaluation,best
  awk -v n="$1" 'BEGIN { for (i = 1; i <= n; ++i) for (k = 1; k <= 100; ++k) printf "star-man-travel,sphc,%d,%d,%.9g\n", i, 400 * k, k / 4 + i / 1e6 }'
}
echo kind,trials,bytes,memory_kb,user_s >"$here/merge.csv"
for job in "results 100000" "results 1000000" "curves 1000" "curves 10000" "curves 100000"; do
  read -r kind trials <<<"$job"
  $kind "$trials" >one.csv
  /usr/bin/time -o time -f %M,%U "$gaitsmith" merge --complete --out merged.csv one.csv
  cmp one.csv merged.csv
  echo "$kind,$trials,$(wc -c <one.csv),$(cat time)" >>"$here/merge.csv"
  rm merged.csv
done
