# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
# A Slurm of one node, all of it in a folder: for whoever runs it, without root or systemd.
# shellcheck shell=bash

# Whether Debian's slurm-wlm and munge are there.
has_slurm() {
  PATH=$PATH:/usr/sbin:/sbin
  command -v munged slurmctld slurmd sbatch >/dev/null
}

slurm_config() {
  local host port
  host=$(hostname -s)
  port=$((20000 + $$ % 20000))
  cat <<EOF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
# A job that is queued again begins as soon as its old credential is invalid, otherwise two minutes later.
AuthInfo=socket=$1/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$1/state
SlurmdSpoolDir=$1/spool
SlurmctldPidFile=$1/slurmctld.pid
SlurmdPidFile=$1/slurmd.pid
SlurmctldLogFile=$1/slurmctld.log
SlurmdLogFile=$1/slurmd.log
# No cgroups, which a container may not make.
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=2,batch_sched_delay=1
MinJobAge=3600
KillWait=5
ReturnToService=2
# Also where the machine has fewer.
SlurmdParameters=config_overrides
NodeName=$host NodeAddr=127.0.0.1 CPUs=${SLURM_TEST_CPUS:-2} State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
EOF
}

# Stops it when the process of this number is gone, should that be killed.
stop_slurm_after() {
  (setsid bash -c ". '${BASH_SOURCE[0]}'; slurm_folder='$slurm_folder'
    while kill -0 $1 2>/dev/null; do sleep 1; done
    stop_slurm" </dev/null >/dev/null 2>&1 &)
}

# Starts it and sets SLURM_CONF. The folder's name is short, since sockets lie in it.
# Usage: start_slurm FOLDER [PROCESS], by default for as long as this process lives
start_slurm() {
  slurm_folder=$1
  mkdir -p "$1/state" "$1/spool"
  chmod 755 "$1"
  export SLURM_CONF=$1/slurm.conf
  slurm_config "$1" >"$SLURM_CONF"
  (umask 077 && head -c 128 /dev/urandom >"$1/munge.key")
  stop_slurm_after "${2:-$$}"
  munged --force --key-file="$1/munge.key" --socket="$1/munge.socket" --pid-file="$1/munged.pid" \
    --log-file="$1/munged.log" --seed-file="$1/munge.seed" || return 1
  slurmctld -c || return 1
  slurmd -c || return 1
  for _ in $(seq 100); do
    [ "$(sinfo --noheader --format=%t 2>/dev/null)" != idle ] || return 0
    sleep .2
  done
  return 1
}

# Ends all that it started; says nothing if there is nothing.
stop_slurm() {
  local name pid
  [ -n "${slurm_folder:-}" ] || return 0
  timeout 10 scancel --user="$(id -un)" --quiet 2>/dev/null || true
  for name in slurmd slurmctld munged; do
    pid=$(cat "$slurm_folder/$name.pid" 2>/dev/null) || continue
    kill "$pid" 2>/dev/null || continue
    for _ in $(seq 50); do
      kill -0 "$pid" 2>/dev/null || break
      sleep .1
    done
    kill -9 "$pid" 2>/dev/null || true
  done
}

# Waits until no job is left in the queue.
# Usage: wait_for_jobs SECONDS
wait_for_jobs() {
  local end=$((SECONDS + $1))
  while [ -n "$(squeue --noheader)" ]; do
    [ "$SECONDS" -lt "$end" ] || return 1
    sleep .3
  done
}
