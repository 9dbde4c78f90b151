# The lines of docs/clusters.md, for the tests that run them. Sourced; $root is the repository.

SHARDS=4 # in place of the page's 64

# block <heading> [number]: the n-th block of code below this heading
block() {
  awk -v heading="## $1" -v wanted="${2:-1}" '
    /^## / { inside = $0 == heading }
    inside && /^```/ { if (open) { open = 0 } else { open = 1; ++found }; next }
    open && found == wanted' "$root/docs/clusters.md" | sed "s/\b64\b/$SHARDS/g"
}

# The study of these tests: each shard has ten short trials.
STUDY="--problem star-man-travel --search sphc --search rgt --trials 20 --evaluations ${EVALUATIONS:-400} --points 4"
export STUDY

on_one_core() { # shellcheck disable=SC2086
  gaitsmith compare $STUDY --threads 1 --out one-core-results.csv --curves one-core-curves.csv
}

same_as_on_one_core() {
  cmp results.csv one-core-results.csv && cmp curves.csv one-core-curves.csv
}

# finished <shard>: the number of its trials in the file of results
finished() { local lines; lines=$(cat "r$1.csv" 2>/dev/null | wc -l); echo $((lines > 2 ? lines - 2 : 0)); }

# until_begun <shard>: waits for its first finished trial
until_begun() {
  local tries
  for tries in $(seq 3000); do [ "$(finished "$1")" = 0 ] || return 0; sleep 0.02; done
  echo "shard $1 finished no trial within $tries looks"; return 1
}
