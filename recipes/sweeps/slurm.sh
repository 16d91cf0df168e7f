#!/bin/sh
# SPDX-License-Identifier: 0BSD
# Writes the certificate of one seed, on all cores of the task. The seed is the number of the task.
#
#     sbatch --array=1-50 slurm.sh SAMPLES INPUT
#SBATCH --job-name=elgen
#SBATCH --cpus-per-task=8
set -eu
mkdir -p certificates
elgen verify -q --format json --jobs "$SLURM_CPUS_PER_TASK" --limit seconds=86400 --samples "$1" \
  --seed "$SLURM_ARRAY_TASK_ID" "$2" > "certificates/$(basename "$2" .toml).$SLURM_ARRAY_TASK_ID.json"
