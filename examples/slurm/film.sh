#!/bin/sh
# SPDX-License-Identifier: MIT
# A film on a farm, as a job array of N shards in a folder that all nodes see:
#
#     sbatch --array=1-8 film.sh 8 2018-07-27 --at -21.1,55.5 --frames 240 -o /shared/film
#
# Whoever comes first computes the light, the others wait for it. A shard that died with its node is requeued and goes on
# where it was: frames that verify are kept. To make one shard again by hand: sbatch --array=3 film.sh 8 ...
# When all have ended, coppermoon animate with the same words finishes the film: --movie and others need every frame.
#SBATCH --job-name=coppermoon
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=coppermoon-%A-%a.log
set -eu
shards=$1
shift
exec "${COPPERMOON:-coppermoon}" animate "$@" --shard "$SLURM_ARRAY_TASK_ID/$shards" --threads "${SLURM_CPUS_PER_TASK:-1}"
