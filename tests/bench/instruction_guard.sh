#!/usr/bin/env bash
# Counts the evaluator's instructions per figure and step with valgrind, independent of the machine's load.
# Fails if a workload takes over 10 % more than in tests/bench/instructions.txt.
#   tests/bench/instruction_guard.sh PROGRAM            PROGRAM: build/release/tests/bench/instructions
#   tests/bench/instruction_guard.sh PROGRAM --renew    writes the present counts
set -euo pipefail
program=$1
command -v valgrind >/dev/null || { echo "no valgrind here: instructions are not counted"; exit; }
numbers=$(dirname "${BASH_SOURCE[0]}")/instructions.txt
compiler="g++ $(g++ -dumpfullversion -dumpversion | cut -d. -f1) $(uname -m)"

# The difference of two runs excludes loading, searching and cleaning up.
counted() { # workload, times
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$1" "$2" 2>&1 |
    awk '/figure-steps/ { steps = $1 } /Collected/ { print $NF, steps }'
}
per_step() { # workload
  local few many
  few=$(counted "$1" 1) many=$(counted "$1" 3)
  echo "$few $many" | awk '{ printf "%.0f\n", ($3 - $1) / ($4 - $2) }'
}

if [ "${2:-}" = --renew ]; then
  {
    echo "# Instructions per figure and step. Renew with: tests/bench/instruction_guard.sh build/release/tests/bench/instructions --renew"
    echo "compiler $compiler"
    for workload in random timer gait; do echo "$workload $(per_step $workload)"; done
  } >"$numbers.new"
  mv "$numbers.new" "$numbers"
  cat "$numbers"
  exit
fi

known=$(sed -n 's/^compiler //p' "$numbers")
if [ "$known" != "$compiler" ]; then
  echo "instructions were counted with $known, this is $compiler: nothing to compare"
  exit
fi
status=0
while read -r workload allowed; do
  now=$(per_step "$workload")
  echo "$workload: $now instructions per figure and step, $allowed when last renewed"
  (( now * 10 <= allowed * 11 )) || { echo "$workload takes over 10 % more than $numbers says"; status=1; }
  (( now * 10 >= allowed * 9 )) || echo "$workload takes less by a tenth: renew $numbers"
done < <(grep -vE '^(#|compiler)' "$numbers")
exit $status
