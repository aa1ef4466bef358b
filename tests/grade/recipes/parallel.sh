#!/bin/sh
# parallel.sh LESSON SUBMISSIONS OUT SECRET PARTS: PARTS graders at once with GNU parallel, then one gradebook. With
# --sshloginfile and a shared folder the same line works on several machines.
set -eu
[ $# -eq 5 ] || { echo "usage: parallel.sh LESSON SUBMISSIONS OUT SECRET PARTS" >&2; exit 2; }
cd "$(dirname "$0")/../../.."
seq "$5" | parallel --halt soon,fail=1 \
    ./raytree grade "$1" --submissions "$2" --out "$3/part-{}" --secret "$4" --shard "{}/$5" --resume
exec ./raytree merge "$3/gradebook" "$3"/part-*
