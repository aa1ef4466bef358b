#!/bin/sh
# Makes autograder.zip to upload: pack.sh LESSON TERM SECRET [OUT.zip]. The zip holds the secret: it is for Gradescope only.
set -eu
[ $# -ge 3 ] || { echo "usage: pack.sh LESSON TERM SECRET_FILE [OUT.zip]" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../../.." && pwd)
out=$(realpath -m "${4:-autograder.zip}")
case $1 in [0-9] | [1-9][0-9]) lesson=$(printf %02d "$1") ;; *) lesson=no ;; esac
ls "$root/lessons/$lesson"_*/exercise.h >/dev/null 2>&1 || {
    echo "pack.sh: expected the number of a lesson that has exercises, such as 6, got \"$1\"" >&2
    exit 2
}
case $2 in *[!A-Za-z0-9._-]*) echo "pack.sh: expected a term of letters, digits and . _ -, got \"$2\"" >&2; exit 2 ;; esac
[ -r "$3" ] || { echo "pack.sh: $3 cannot be read; expected the file of the course's secret" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder" "$out.part"' EXIT
mkdir "$folder/raytree"
# By name, and not as git lists them: there may be no git, no clone, or one of another owner. tests/course/texts.py has the list.
for part in common lessons slides-notes tests viz CHANGELOG.md CMakeLists.txt CMakePresets.json CONTRIBUTING.md LICENSE README.md raytree; do
    cp -R "$root/$part" "$folder/raytree/"
done
find "$folder/raytree" -name __pycache__ -prune -exec rm -rf {} +
cp "$here/setup.sh" "$here/run_autograder" "$folder/"
chmod +x "$folder/setup.sh" "$folder/run_autograder"
cp "$3" "$folder/secret"
chmod 600 "$folder/secret" # students' code must not read it there either
printf 'LESSON=%s\nTERM_NAME=%s\n' "$1" "$2" >"$folder/course.sh"
(umask 077 && cd "$folder" && python3 -m zipfile -c "$out.part" ./*)
mv "$out.part" "$out"
echo "$out"
