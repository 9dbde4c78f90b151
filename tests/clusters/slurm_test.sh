#!/usr/bin/env bash
# Runs the lines of docs/clusters.md on a Slurm cluster of one node, set up here and stopped again:
#   slurm_test.sh <gaitsmith> <repository> [CSV]
# One task is requeued and one killed. Writes what became of each to CSV. Exit status 77: Slurm cannot run here.
set -uo pipefail
gaitsmith=$(realpath "$1") root=$(realpath "$2") table=${3:-} failed=0
for program in munged slurmctld slurmd sbatch scontrol; do
  PATH=$PATH:/usr/sbin command -v $program >/dev/null || { echo "Slurm is not installed here ($program): its test is left out"; exit 77; }
done
[ -z "$table" ] || table=$(realpath -m "$table")
base=$(mktemp -d)
PATH=$(dirname "$gaitsmith"):$PATH:/usr/sbin
EVALUATIONS=3000 # half a second a trial, long enough to be stopped in between
. "$root/tests/clusters/page_lines.sh"
fault() { echo "FAILED: $*"; failed=1; }
same() { [ "$1" = "$2" ] || fault "$3: '$1' is not '$2'"; }

# Ends the daemon whose process id is in a file, whatever state it is in.
end() {
  local pid tries
  pid=$(cat "$1" 2>/dev/null) && [ -n "$pid" ] || return 0
  kill "$pid" 2>/dev/null
  for tries in $(seq 50); do kill -0 "$pid" 2>/dev/null || return 0; sleep 0.1; done
  echo "$1 did not end within $tries looks"; kill -KILL "$pid" 2>/dev/null
}
clean_up() {
  if [ -e "$base/submitted" ]; then
    scancel --full --signal=KILL "$(cat "$base/submitted")" 2>/dev/null
    scancel "$(cat "$base/submitted")" 2>/dev/null
  fi
  for daemon in slurmd slurmctld munged; do end "$base/$daemon.pid"; done
  rm -rf "$base"
}
trap clean_up EXIT
trap 'exit 1' INT TERM

# Slurm runs as the user who tests. It needs no cgroups, no database, and one processor, of which it believes to be four.
host=$(hostname -s) me=$(id -un) port=$((20000 + $$ % 10000))
chmod 755 "$base"
mkdir -m 755 "$base/munge" "$base/state" "$base/spool" "$base/work"
(umask 077; head -c 1024 /dev/urandom >"$base/munge/key")
cat >"$base/slurm.conf" <<CONF
ClusterName=gaitsmith
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$me
SlurmdUser=$me
AuthType=auth/munge
CredType=cred/munge
# A requeued task waits until its credential is void, usually two minutes.
AuthInfo=socket=$base/munge/socket,cred_expire=5
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmctldPidFile=$base/slurmctld.pid
SlurmdPidFile=$base/slurmd.pid
SlurmctldLogFile=$base/slurmctld.log
SlurmdLogFile=$base/slurmd.log
StateSaveLocation=$base/state
SlurmdSpoolDir=$base/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=defer,sched_interval=2
SlurmdParameters=config_overrides
ReturnToService=2
MailProg=/bin/true
NodeName=$host NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$base/slurm.conf
cannot() { echo "Slurm cannot run here: $1: $(tail -n 3 "$base/$2.log" 2>/dev/null | tr '\n' ' ')"; exit 77; }
munged --key-file="$base/munge/key" --socket="$base/munge/socket" --pid-file="$base/munged.pid" \
  --seed-file="$base/munge/seed" --log-file="$base/munged.log" || cannot munged munged
slurmctld -i || cannot slurmctld slurmctld
slurmd || cannot slurmd slurmd
for _ in $(seq 150); do [ "$(sinfo -h -o %T 2>/dev/null)" != idle ] || break; sleep 0.2; done
[ "$(sinfo -h -o %T 2>/dev/null)" = idle ] || cannot "its node does not get ready" slurmd

cd "$base/work" || exit 1
block "A cluster: Slurm" >study.sbatch
submit=$(block "A cluster: Slurm" 2) progress=$(block Progress) again=$(block "What is left") merge=$(block Merge)
on_one_core || fault "on one core"

answer=$(eval "$submit") || fault "sbatch: $answer"
job=${answer##* }
echo "$job" >"$base/submitted"
# state <task>: as PENDING, RUNNING, FAILED
state() { scontrol -o show job "${job}_$1" 2>/dev/null | sed -n 's/.* JobState=\([A-Z_]*\).*/\1/p'; }
restarts() { scontrol -o show job "${job}_$1" 2>/dev/null | sed -n 's/.* Restarts=\([0-9]*\).*/\1/p'; }
# Waits until Slurm has no task that waits or runs.
until_idle() {
  local tries
  for tries in $(seq 900); do [ -n "$(squeue -h 2>/dev/null)" ] || return 0; sleep 0.2; done
  fault "tasks still run after $tries looks: $(squeue)"
}

until_begun 2 && scontrol requeue "${job}_2" || fault "task 2 cannot be requeued"
had=$(finished 2)
until_begun 3 || fault "task 3"
pid=$(scontrol listpids 2>/dev/null | awk -v job="$(scontrol -o show job "${job}_3" | sed -n 's/^JobId=\([0-9]*\) .*/\1/p')" '$2 == job { print $1; exit }')
if [ -n "$pid" ] && kill -KILL "$pid"; then :; else fault "task 3 cannot be killed: $(scontrol listpids 2>&1)"; fi
[ "$had" -lt 10 ] && [ "$(finished 3)" -lt 10 ] || fault "tasks were finished before they could be stopped"
until_idle
same "$(state 1),$(state 2),$(state 3),$(state 4)" COMPLETED,COMPLETED,FAILED,COMPLETED "states of the tasks"
same "$(restarts 2),$(restarts 3)" 1,0 "restarts of the tasks"
eval "$progress" >progress.csv 2>sentence && fault "a killed task passes for a finished one"
grep -q ' trials are missing: shard 3/4 is not finished (r3.csv)$' sentence || fault "it said '$(cat sentence)'"
first=("$(state 1)" "$(state 2)" "$(state 3)" "$(state 4)") requeued=$(restarts 2)

eval "$again" >answer 2>/dev/null || fault "sbatch once more: $(cat answer)"
same "$left" 3 "shards that are left"
until_idle
eval "$progress" >progress.csv || fault "not all is finished: $(cat progress.csv task-*.log)"
eval "$merge" && same_as_on_one_core || fault "other bytes than on one core"

if [ $failed = 0 ] && [ -n "$table" ]; then
  { echo "slurm,task,event,first_state,starts,trials,same_bytes"
    version=$(sinfo --version | sed 's/.* //')
    for task in 1 2 3 4; do
      case $task in 2) event=requeued starts=$((requeued + 1)) ;; 3) event=killed starts=2 ;; *) event=none starts=1 ;; esac
      echo "$version,$task,$event,${first[task - 1]},$starts,$(finished $task),yes"
    done
  } >"$table"
fi
[ $failed = 0 ] && echo "Slurm: four tasks, one requeued, one killed and submitted again, and the bytes of one core"
exit $failed
