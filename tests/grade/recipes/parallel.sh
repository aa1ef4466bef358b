#!/bin/sh
# parallel.sh LESSON SUBMISSIONS OUT SECRET PARTS: PARTS graders at once with GNU parallel, then one gradebook. When
# interrupted, the same line goes on. With PARALLEL="--sshloginfile FILE" and a shared folder, several machines work.
set -eu
[ $# -eq 5 ] || { echo "usage: parallel.sh LESSON SUBMISSIONS OUT SECRET PARTS" >&2; exit 2; }
parallel --version 2>/dev/null | grep -q "^GNU parallel" ||
    { echo "parallel.sh: GNU parallel is missing; expected it on the PATH, as from: apt-get install parallel" >&2; exit 2; }
lesson=$1 submissions=$(realpath "$2") out=$(realpath -m "$3") secret=$(realpath "$4") parts=$5
cd "${RAYTREE:-$(dirname "$0")/../../..}"
seq "$parts" | parallel --quote --halt soon,fail=1 "$PWD/raytree" grade "$lesson" --submissions "$submissions" \
    --out "$out/part-{}" --secret "$secret" --shard "{}/$parts" --resume ||
    { code=$?; echo "parallel.sh: not all parts are done; the same line goes on" >&2; exit "$code"; }
set -- "$out/gradebook"
for part in $(seq "$parts"); do set -- "$@" "$out/part-$part"; done
exec ./raytree merge "$@"
