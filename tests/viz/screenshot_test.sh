#!/bin/sh
# The viewer without a display: screenshot_test.sh VIEWER PNG_FACTS, in the project's root folder.
set -u
viewer=$1
facts=$2
unset DISPLAY
scene=lessons/02_mirrors/scenes/pure_specular.toml
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

fail()
{
    echo "FAILED: $*" >&2
    failures=$((failures + 1))
}

# expect NAME CODE COMMAND...: the exit code, and one line on standard error if it is not 0.
expect()
{
    name=$1
    code=$2
    shift 2
    "$@" >"$folder/out" 2>"$folder/err"
    got=$?
    [ "$got" = "$code" ] || fail "$name: exit code $got, expected $code: $(cat "$folder/err")"
    [ "$code" = 0 ] || [ "$(wc -l <"$folder/err")" = 1 ] || fail "$name: expected one sentence, got: $(cat "$folder/err")"
    [ ! -s "$folder/out" ] || fail "$name: wrote to standard output"
}

# picture NAME WIDTH HEIGHT COLOURS: at least that many colours.
picture()
{
    set -- "$1" "$2" "$3" "$4" $("$facts" "$folder/$1")
    [ "$5 $6" = "$2 $3" ] || fail "$1 is $5 x $6, expected $2 x $3"
    [ "$7" -ge "$4" ] || fail "$1 has only $7 colours"
}

expect screenshot 0 "$viewer" 2 "$scene" --pixel 360,250 --screenshot "$folder/view.png"
picture view.png 1600 900 5000
expect smaller 0 "$viewer" "$scene" --screenshot "$folder/small.png" --size-window 1280x720 --real float --depth 1
picture small.png 1280 720 5000
expect again 0 "$viewer" 2 "$scene" --pixel 360,250 --screenshot "$folder/again.png"
cmp -s "$folder/view.png" "$folder/again.png" || fail "the same call gives another picture"
expect otherPixel 0 "$viewer" 2 "$scene" --pixel 100,100 --screenshot "$folder/other.png"
! cmp -s "$folder/view.png" "$folder/other.png" || fail "another pixel gives the same picture"

# Nothing to see is no reason to fail.
printf '[camera]\neye = [0, 1, 5]\ntarget = [0, 1, 0]\nsize = [1, 1]\n' >"$folder/empty.toml"
expect empty 0 "$viewer" "$folder/empty.toml" --screenshot "$folder/empty.png"
picture empty.png 1600 900 200

# No display: a window cannot be opened, and a screenshot needs Xvfb or is refused.
mkdir "$folder/bin"
expect window 3 "$viewer" 2 "$scene"
expect noXvfb 3 env PATH="$folder/bin" "$viewer" 2 "$scene" --screenshot "$folder/none.png"
[ ! -e "$folder/none.png" ] || fail "a picture was written without a display"

# Bad input is said before anything is opened.
expect noLesson 2 "$viewer" 77
expect noScene 2 "$viewer" "$folder/missing.toml" --screenshot "$folder/none.png"
expect outside 2 "$viewer" 2 "$scene" --pixel 9999,1 --screenshot "$folder/none.png"
expect noFolder 2 "$viewer" 2 "$scene" --screenshot "$folder/missing/view.png"
expect beyond 2 "$viewer" 1 "$scene" --screenshot "$folder/none.png"
expect badSize 2 "$viewer" 2 "$scene" --size-window 10x --screenshot "$folder/none.png"
[ "$(find "$folder" -name '.part-*' | wc -l)" = 0 ] || fail "temporary files were left"

[ "$failures" = 0 ] && echo "all screenshot checks passed"
exit "$failures"
