#!/bin/sh
# SPDX-License-Identifier: MIT
# Proves film.sh on a Slurm of its own (Debian's packages slurm-wlm and munge, as root): an array of 8 shards, the node
# killed in the middle and brought back, must leave the bytes that one machine makes. Prints what happened.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
export COPPERMOON="${COPPERMOON:-$here/../../build/release/coppermoon}"
work=$(mktemp -d)
cd "$work"
say() { printf '%s  %s\n' "$(date +%H:%M:%S)" "$*"; }
film="2018-07-27 --at -21.1,55.5 --frames 48 --width 240 --height 160 --field 0.9 --texture-width 512"

name=$(hostname)
mkdir state spool
cat >slurm.conf <<EOF
ClusterName=proof
SlurmctldHost=$name(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdTimeout=10
NodeName=$name NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=2000 State=UNKNOWN
PartitionName=main Nodes=$name Default=YES MaxTime=INFINITE State=UP
EOF
export SLURM_CONF="$work/slurm.conf"
install -d -o munge -g munge -m 0755 /run/munge
pgrep -x munged >/dev/null || su -s /bin/sh munge -c /usr/sbin/munged
stop() {
  for daemon in slurmctld slurmd; do [ ! -f $daemon.pid ] || kill "$(cat $daemon.pid)" || true; done
}
trap stop EXIT
slurmctld
slurmd
until sinfo -h -o %T | grep -q idle; do sleep 1; done

say "one machine"
# shellcheck disable=SC2086
"$COPPERMOON" animate $film -o one_machine >one_machine.log

say "an array of 8 shards"
# shellcheck disable=SC2086
job=$(sbatch --parsable --array=1-8 "$here/film.sh" 8 $film -o "$work/farm")
until [ "$(find farm -name 'frame.*.png' 2>/dev/null | wc -l)" -ge 10 ]; do sleep 0.2; done
say "the node dies with $(squeue -h -r -t R -j "$job" | wc -l) shards at work, $(find farm -name 'frame.*.png' | wc -l) frames made"
pkill -9 -x slurmd
pkill -9 -x slurmstepd
pkill -9 -f "animate .*$work/farm"
rm -f slurmd.pid
until sinfo -h -o %T | grep -q down; do sleep 1; done
say "Slurm has missed it, and has: $(squeue -h -r -j "$job" -o %T | sort | uniq -c | tr -s ' \n' ' ')"
slurmd
while squeue -h -j "$job" 2>/dev/null | grep -q .; do sleep 1; done
say "the array has ended: $(cat coppermoon-"$job"-*.log | grep -c 'frames made') shards to their end"
cat coppermoon-"$job"-*.log | grep 'frames made' | sed 's/^.*: /    /'

diff -r one_machine farm
say "the same bytes: $(find farm -type f | wc -l) files"
stop
trap - EXIT
sleep 2
cd / && rm -rf "$work"
