# shellcheck shell=sh disable=SC2034,SC2154
# What the front door of the course and that of a hand-out share: installing, building, waiting for one another.
# Sourced by a POSIX shell that has set
#   root     the folder of the sources
#   build    the folder of the build
#   preset   the CMake preset whose folder that is
#   parts    the parts of the project that can be left out, as CMake's options RAYTREE_... name them
#   command  what was asked for, in words, for whoever has to wait

# What each part needs of Debian 12 and 13 and Ubuntu 24.04. What a word of the front door uses is installed, and no more.
core_packages="g++ cmake ninja-build libglm-dev libtbb-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libfmt-dev libpng-dev"
# Reading pictures, and writing others than .png and .ppm.
picture_packages="libopenimageio-dev"
viewer_packages="libvtk9-dev fonts-dejavu-core xvfb xauth libgl1-mesa-dri"
# The grader, and `learn`.
grade_packages="python3 bubblewrap util-linux pkg-config libseccomp-dev libarchive-dev libssl-dev libutfcpp-dev libpugixml-dev"

fail() {
    echo "raytree: $1" >&2
    exit 2
}

say() {
    echo "raytree: $1" >&2
}

# Which of these packages are not installed? In one line.
missing_of() {
    present=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | sed -n 's/ installed$//p' | tr '\n' ' ') || true
    for package in "$@"; do
        case " $present " in
            *" $package "*) ;;
            *) printf '%s ' "$package" ;;
        esac
    done
}

# apt-get as root; waits for other programs that install packages. Its words go to the log.
apt() {
    # shellcheck disable=SC2086
    $as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -o DPkg::Lock::Timeout=1800 "$@" </dev/null 9>&-
}

# Brings the lists of packages up to date. A source that fails is no reason to stop: what is needed may come from another.
refresh_lists() {
    waited=""
    while :; do
        code=0
        apt update >"$log.update" 2>&1 || code=$?
        cat "$log.update" >>"$log"
        if ! grep -q 'Could not get lock' "$log.update"; then break; fi
        [ -n "$waited" ] || say "waiting: another program is installing packages"
        waited=yes
        sleep 2
    done
    broken=$(sed -n 's/^[EW]: //p' "$log.update" | head -n 1)
    rm -f "$log.update"
    if [ "$code" != 0 ] || [ -n "$broken" ]; then
        say "some lists of packages could not be brought up to date (${broken:-see $log}); going on with those that are there"
    fi
}

# Prints how far apt-get is, one line in ten per cent, and keeps all that it says in the log.
progress() {
    shown=0
    while IFS= read -r line; do
        case "$line" in
            dlstatus:* | pmstatus:*)
                share=${line#*:*:}
                share=${share%%[.:]*}
                case "$line" in dlstatus:*) doing="fetched" ;; *) doing="installed" ;; esac
                if [ "$doing" != "${done_before:-fetched}" ]; then shown=0; fi
                done_before=$doing
                if [ "$share" -ge $((shown + 20)) ] 2>/dev/null; then
                    shown=$share
                    say "packages: $share % $doing"
                fi
                ;;
            *)
                printf '%s\n' "$line" >>"$log"
                case "$line" in *"Could not get lock"*) say "waiting: another program is installing packages" ;; esac
                ;;
        esac
    done
}

# packages "NAME ..." ["NAME ..."]: installs those that are missing. Without the ones of the second list the command goes on.
# Ends with one sentence if it may not install them, or cannot.
packages() {
    # Elsewhere nobody knows what is there: CMake will tell, and what `configure` says then names these.
    wanted=$1
    command -v dpkg-query >/dev/null && command -v apt-get >/dev/null || return 0
    # shellcheck disable=SC2086
    needed=$(missing_of $1)
    # shellcheck disable=SC2086
    useful=$(missing_of ${2:-})
    [ -n "$needed$useful" ] || return 0
    log="$build/packages.log"
    : >"$log"
    by_hand="apt-get update && apt-get install -y --no-install-recommends $needed$useful"
    as_root=""
    if [ "$(id -u)" != 0 ]; then
        if ! command -v sudo >/dev/null; then
            trouble="packages are missing, and there is no sudo"
        elif ! sudo -n true 2>/dev/null && ! { [ -t 0 ] && sudo -v; }; then
            trouble="packages are missing, and sudo does not let $(id -un) install them"
        fi
        if [ -n "${trouble:-}" ]; then
            trouble="$trouble; have root run this line once:
$by_hand"
            [ -z "$needed" ] || fail "$trouble"
            say "$trouble"
            return 0
        fi
        as_root="sudo"
    fi
    refresh_lists
    # Names that no list knows: of the second list they are left out.
    # shellcheck disable=SC2086
    unknown=$(apt install -s --no-install-recommends $needed $useful 2>&1 |
        sed -n "s/^E: Unable to locate package //p; s/^E: Package '\(.*\)' has no installation candidate/\1/p" | tr '\n' ' ')
    for package in $unknown; do
        case " $needed " in *" $package "*) fail "apt-get knows no package $package; Debian 12 and 13 and Ubuntu 24.04 have it: see /etc/apt/sources.list" ;; esac
    done
    chosen=$needed
    for package in $useful; do
        case " $unknown " in
            *" $package "*) say "there is no package $package here: what needs it is left out" ;;
            *) chosen="$chosen $package" ;;
        esac
    done
    # shellcheck disable=SC2086
    set -- $chosen
    [ $# -gt 0 ] || return 0
    size=$(apt install --assume-no --no-install-recommends "$@" 2>/dev/null |
        sed -n 's/^[0-9]* upgraded, \([0-9]*\) newly.*/\1 packages/p; s/^Need to get \([^ ]* [kMG]B\).*/\1 to fetch/p; s/^After this operation, \([^ ]* [kMG]B\) of add.*/\1 on disk/p' |
        tr '\n' ',' | sed 's/,$//; s/,/, /g')
    say "installing packages (${size:-unknown size}); all that apt-get says is in $log"
    echo "asked for: $*" >>"$log"
    code=$({ { apt install -y -q -o APT::Status-Fd=1 --no-install-recommends "$@" 2>&1 3>&-; echo $? >&3; } | progress 3>&-; } 3>&1)
    left=$(missing_of "$@")
    if [ "$code" = 0 ] && [ -z "$left" ]; then return 0; fi
    reason=$(grep '^E: ' "$log" | tail -n 1 | sed 's/^E: //')
    trouble="apt-get could not install ${left:-all packages}(${reason:-see $log}); all that it said is in $log"
    for package in $left; do
        case " $needed " in *" $package "*) fail "$trouble" ;; esac
    done
    say "$trouble"
}

# A conda environment brings compilers, tools and libraries of its own to the PATH; they do not fit those of the system. Prints
# the PATH without them.
path_without_conda() {
    printf '%s\n' "$PATH" | tr ':' '\n' | while IFS= read -r folder; do
        [ -d "${folder%/*}/conda-meta" ] || printf '%s:' "$folder"
    done | sed 's/:$//'
}

# One at a time in a folder: whoever comes second waits, and says for what. What is started to build inherits the lock, so that it
# holds for as long as any of it runs, even if this shell is killed.
take_turn() {
    mkdir -p "$build" 2>/dev/null || true
    [ -w "$build" ] || fail "$build cannot be written to; expected a clone of your own"
    command -v flock >/dev/null || return 0
    exec 9>>"$build/.lock"
    if ! flock -n 9; then
        say "waiting: \"$(cat "$build/.busy" 2>/dev/null)\" is building in this folder"
        flock 9
    fi
    echo "$command" >"$build/.busy"
}

end_turn() {
    exec 9>&-
}

# configure [PART ...]: makes the build's files where they are missing or stale, with these parts (RAYTREE_PART in CMakeLists.txt)
# and those that were asked for before.
configure() {
    cache="$build/CMakeCache.txt"
    fits=no
    if grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache" 2>/dev/null && [ -f "$build/build.ninja" ]; then fits=yes; fi
    asked=" $* "
    set --
    for part in $parts; do
        state=OFF
        case "$asked" in *" $part "*) state=ON ;; esac
        if grep -q "^RAYTREE_$part:BOOL=ON" "$cache" 2>/dev/null; then state=ON; elif [ "$state" = ON ]; then fits=no; fi
        set -- "$@" "-DRAYTREE_$part=$state"
    done
    if [ "$fits" = yes ]; then
        cmake --build "$build" --target build.ninja
    else
        (cd "$root" && cmake --preset "$preset" "$@")
    fi >"$build/configure.log" 2>&1 && return 0
    # What a killed run left behind, or a folder that was moved, is no reason to fail.
    (cd "$root" && cmake --fresh --preset "$preset" "$@") >"$build/configure.log" 2>&1 && return 0
    tail -n 20 "$build/configure.log" >&2
    command -v dpkg-query >/dev/null || say "this is neither Debian nor Ubuntu; expected the equivalents of these packages:
$wanted"
    fail "cmake failed; all of it is in $build/configure.log"
}

# Builds with the options of `cmake --build`. Only a build that has something to do, or fails, has something to say.
compile() {
    status=$({ { cmake --build "$build" "$@" 2>&1 3>&-; echo $? >&3; } |
        sed -u '/Re-checking globbed directories/d; /^ninja: no work to do/d' >&2 3>&-; } 3>&1)
    [ "$status" = 0 ] || fail "the build failed: see above"
}

# prepare "NEEDED ..." "USEFUL ..." "PART ..." [OPTION ...]: packages, configuration and build, when it is our turn.
prepare() {
    needed_here=$1 useful_here=$2 parts_here=$3
    shift 3
    take_turn
    path=$PATH
    PATH=$(path_without_conda)
    packages "$needed_here" "$useful_here"
    # shellcheck disable=SC2086
    configure $parts_here
    compile "$@"
    PATH=$path
    end_turn
}

# The lesson's number in two digits.
number() {
    case "${1:-}" in
        [0-9]) echo "0$1" ;;
        [0-9][0-9]) echo "$1" ;;
        *) fail "expected the number of a lesson, got \"${1:-}\" (as in: ./raytree $word 2)" ;;
    esac
}

# help_of NAME [NN]: what a program can do, without building it.
help_of() {
    if [ -f "$root/common/help/$1$2.txt" ]; then
        cat "$root/common/help/$1$2.txt"
    else
        sed "s/NN/${2:-NN}/g" "$root/common/help/$1.txt"
    fi
    exit 0
}

# Are we asked what a word can do? That is answered at once, without building.
asks_for_help() {
    for argument in "$@"; do
        case "$argument" in
            -h | --help) return 0 ;;
            --) return 1 ;;
        esac
    done
    return 1
}
