#!/bin/bash
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
# A job array in a real Slurm of one node, of which one task's program is killed and one task runs out of
# time, leaves what one process leaves: no pair is lost or matched twice.
# Usage: slurm_test.sh PROGRAM [SHAPES [TASKS]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
repository=$here/../..
isomatch=$1
shapes=${2:-5}
tasks=${3:-3}
# shellcheck source=tests/cluster/pairs.sh
. "$here/pairs.sh"
# shellcheck source=tests/cluster/slurm.sh
. "$here/slurm.sh"

has_slurm || skip "cluster.slurm: slurm-wlm and munge are not installed"
work=$(mktemp --directory /tmp/isomatch-slurm.XXXXXX)
finish() {
  local status=$?
  if [ "$status" != 0 ]; then tail -n 20 "$work"/*.log "$work"/isomatch-*.out >&2 || true; fi
  stop_slurm
  rm -rf "$work"
}
trap finish EXIT
trap 'exit 1' INT TERM

make_pairs "$shapes" "$work"
start_slurm "$work" || skip "cluster.slurm: Slurm does not start here: $(tail -n 3 "$work"/slurm*.log)"
cd "$work"

# Tasks that begin at 5 and have a step.
last=$((5 + 2 * (tasks - 1)))
export ISOMATCH_PROGRAM=$isomatch
job=$(sbatch --parsable --array="5-$last:2" --cpus-per-task=1 --mem=0 "$repository/cluster/array.sbatch" \
  pairs.csv matched "${quick[@]}")
merge=$(sbatch --parsable --dependency="afterany:$job" --output=merge.out --cpus-per-task=1 --mem=0 \
  "$repository/cluster/array.sbatch" pairs.csv matched "${quick[@]}" --merge)

# Waits for the first finished pair of a share.
first_pair_of() {
  for _ in $(seq 300); do
    [ ! -s "matched/batch-$1-of-$tasks.log" ] || return 0
    sleep .05
  done
  fail "share $1 does not begin"
}

first_pair_of 1
victim=$(pgrep --full -- "^$isomatch batch pairs.csv .*--shard 1/$tasks") || fail "no program of share 1"
kill -9 "$victim"
first_pair_of 2
scancel --batch --signal=USR1 "${job}_7"  # As before its time is up.
wait_for_jobs 200 || fail "jobs do not end: $(squeue)"

restarts() { scontrol show job "$1" | sed -n 's/.*Restarts=\([0-9]*\).*/\1/p'; }
[ "$(restarts "${job}_5")" = 1 ] || fail "the killed task was not queued again"
[ "$(restarts "${job}_7")" = 1 ] || fail "the task out of time was not queued again"
grep --quiet "share 1 of $tasks was ended by signal 9" "isomatch-${job}_5.out" || fail "its output"
grep --quiet "share 2 of $tasks is out of time" "isomatch-${job}_7.out" || fail "its output"
scontrol show job "$merge" | grep --quiet JobState=COMPLETED || fail "merge: $(cat merge.out)"
compare alone matched
matched_once matched pairs.csv 2
echo "$(wc -l <pairs.csv) pairs in $tasks tasks, of which 2 were queued again: the same files"

# Some tasks of an array again: there is nothing left to do.
again=$(ISOMATCH_ARRAY=1-$tasks sbatch --parsable --array="1,$tasks" --cpus-per-task=1 --mem=0 \
  "$repository/cluster/array.sbatch" pairs.csv matched "${quick[@]}")
gaps=$(sbatch --parsable --array=1,2,4 --cpus-per-task=1 --mem=0 "$repository/cluster/array.sbatch" \
  pairs.csv gaps "${quick[@]}")
wait_for_jobs 60 || fail "jobs do not end: $(squeue)"
scontrol show job "$again" | grep --quiet 'JobState=FAILED' && fail "the tasks again"
matched_once matched pairs.csv 2
grep --quiet 'an array with gaps' "isomatch-${gaps}_1.out" || fail "an array with gaps"
[ ! -e gaps ] || fail "an array with gaps began"
