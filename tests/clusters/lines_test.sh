#!/usr/bin/env bash
# Runs the lines of docs/clusters.md, with a stand-in for sbatch: lines_test.sh <gaitsmith> <repository>
# tests/clusters/slurm_test.sh runs them with Slurm.
set -uo pipefail
gaitsmith=$(realpath "$1") root=$(realpath "$2") failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
PATH=$(dirname "$gaitsmith"):$PATH
. "$root/tests/clusters/page_lines.sh"
fault() { echo "FAILED: $*"; failed=1; }
same() { [ "$1" = "$2" ] || fault "$3: '$1' is not '$2'"; }

block "A cluster: Slurm" >study.sbatch
submit=$(block "A cluster: Slurm" 2) progress=$(block Progress) again=$(block "What is left") merge=$(block Merge) parallel=$(block "One machine: GNU parallel")
same "$submit" "sbatch study.sbatch" "the line that submits"
grep -q -- '--array=1-4 ' study.sbatch && grep -q -- '--requeue' study.sbatch || fault "the script: $(cat study.sbatch)"
# The study of the page, whose thousandth shard of a thousand has no trial.
# shellcheck disable=SC2086
( eval "$(block Shards)" && gaitsmith compare $STUDY --shard 1000/1000 --out page-r.csv --curves page-c.csv ) || fault "the study of the page"

# Runs each task of the array as Slurm would: side by side, each with its number. Task 2 is killed and started again, as
# if requeued. Task 3 is killed, and the file of task 4 is lost.
sbatch() {
  local tasks=${1#--array=} task pids=() pid
  [ $# = 2 ] || tasks=$(sed -n 's/^#SBATCH --array=1-\([0-9]*\) .*/\1/p' study.sbatch | xargs seq -s,)
  for task in ${tasks//,/ }; do
    SLURM_ARRAY_TASK_ID=$task bash study.sbatch >>"task-$task.log" 2>&1 &
    pids[task]=$!
  done
  if [ $# = 1 ]; then
    for task in 2 3; do
      for _ in 1 2 3 4 5; do # a busy machine may look too late
        until_begun $task && kill -KILL "${pids[task]}" 2>/dev/null
        wait "${pids[task]}" 2>/dev/null
        [ "$(finished $task)" -ge 10 ] || break
        rm "r$task.csv" "c$task.csv"
        SLURM_ARRAY_TASK_ID=$task bash study.sbatch >>"task-$task.log" 2>&1 &
        pids[task]=$!
      done
      [ "$(finished $task)" -lt 10 ] || fault "task $task was finished before it could be killed"
    done
    SLURM_ARRAY_TASK_ID=2 bash study.sbatch >>task-2.log 2>&1 &
    pids[2]=$!
  fi
  for pid in "${pids[@]}"; do wait "$pid" 2>/dev/null; done
  [ $# = 2 ] || rm r4.csv
}

on_one_core || fault "on one core"
eval "$submit"
eval "$progress" >progress.csv 2>sentence && fault "a lost shard passes for a finished study"
same "$(grep -v '^3,' progress.csv | tr '\n' ' ')" \
  "shard,of,done,due,state,file 1,4,10,10,complete,r1.csv 2,4,10,10,complete,r2.csv 4,4,0,10,missing, all,,$((20 + $(finished 3))),40,unfinished, " "progress"
grep -q ' trials are missing: shard 3/4 is not finished (r3.csv); shard 4/4 has no file$' sentence || fault "it said '$(cat sentence)'"
eval "$merge" 2>sentence && fault "an unfinished study was merged"
grep -q 'shard 4/4 has no file$' sentence && [ ! -e results.csv ] || fault "merge said '$(cat sentence)'"
eval "$again" 2>/dev/null
same "$left" 3,4 "shards that are left"
eval "$progress" >progress.csv || fault "a finished study is not complete: $(cat progress.csv)"
eval "$merge" || fault "merge"
same_as_on_one_core || fault "other bytes than on one core"
eval "$again"
same "$left" "" "shards that are left of a finished study"

# Killed in the middle of a write: the system ends a program whose file grows beyond a limit, here 1 KiB, after it has
# written what fits.
# shellcheck disable=SC2086
{ ( ulimit -c 0 -f 1; exec gaitsmith compare $STUDY --threads 1 --shard 1/4 --out torn-r.csv --curves torn-c.csv ); } 2>/dev/null
tail -c 1 torn-c.csv | od -An -c | grep -q '\\n' && fault "the file is not torn"
gaitsmith merge --progress torn-c.csv >/dev/null 2>sentence && fault "a torn shard passes for a finished one"
grep -q 'shard 1/4 is not finished (torn-c.csv)' sentence || fault "of a torn file it said '$(cat sentence)'"
# shellcheck disable=SC2086
gaitsmith compare $STUDY --threads 1 --shard 1/4 --out torn-r.csv --curves torn-c.csv || fault "a torn shard does not go on"
cmp torn-r.csv r1.csv && cmp torn-c.csv c1.csv || fault "a torn shard has other bytes"

if command -v parallel >/dev/null; then
  rm -f r*.csv c*.csv
  eval "$parallel" 2>sentence && eval "$merge" && same_as_on_one_core || fault "GNU parallel: $(cat sentence)"
fi

[ $failed = 0 ] && echo "the lines of docs/clusters.md hold"
exit $failed
