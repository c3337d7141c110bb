# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installing packages, configuring and building, for run.sh, test.sh and .ci/run. To be sourced, not
# run. SOURCE_DIR is the root of the project, also if a script is called through a symlink.

COMMON_FILE=$(readlink -f -- "${BASH_SOURCE[0]}")
SOURCE_DIR=$(dirname -- "$(dirname -- "$COMMON_FILE")")
BUILD_DIR=$SOURCE_DIR/build

step() { printf '[%s] %s\n' "$1" "$2"; }
say() { printf '      %s\n' "$@"; }
die() {
    printf '%s: %s\n' "$(basename -- "$0")" "$1" >&2
    shift
    [ $# -eq 0 ] || printf '  %s\n' "$@" >&2
    exit 1
}

# Names of the lists (build, test, ci) -> their packages, one a line.
packages_of() {
    local list
    for list in "$@"; do
        sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' \
            "$SOURCE_DIR/packaging/$list-packages.txt"
    done
}

# Prints the given packages that are not installed.
missing_packages() {
    local package
    for package in "$@"; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
            printf '%s\n' "$package"
    done
}

# True if as_root works; sudo may ask for the password.
may_be_root() {
    [ "$(id -u)" -eq 0 ] || { command -v sudo >/dev/null && sudo true; }
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo -- "$@"; fi
}

# update_package_lists LOG. The lists' own lock is not covered by DPkg::Lock::Timeout, hence the
# loop. A broken third-party source does not matter as long as the packages are found.
update_package_lists() {
    local attempt
    for attempt in $(seq 60); do
        if as_root apt-get -q -o Acquire::Retries=3 update >"$1" 2>&1; then
            return 0
        fi
        grep -q 'Could not get lock' "$1" || break
        [ "$attempt" -ne 1 ] || say "Another package manager is running; waiting for it."
        sleep 5
    done
    say "The package lists could not be updated; continuing with the present ones."
}

# install_packages LIST...: does nothing, and needs no network, if all are installed.
install_packages() {
    local wanted missing log
    mapfile -t wanted < <(packages_of "$@")
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "This is not Debian, so no packages are installed. You need a C++20 compiler, CMake 3.22," \
            "Ninja, Qt 6.4 (Widgets, PrintSupport, DBus, Network, SerialPort, Linguist tools, Test, its Chinese translation and the SVG plugin), CLI11 and tl-expected." \
            "Their names in Debian: ${wanted[*]}"
        return 0
    fi
    mapfile -t missing < <(missing_packages "${wanted[@]}")
    if [ ${#missing[@]} -eq 0 ]; then
        say "All ${#wanted[@]} packages are installed."
        return 0
    fi
    say "Installing these packages (a few minutes the first time): ${missing[*]}"
    may_be_root || die "packages are missing, and you cannot install them without root or sudo." \
        "Ask an administrator to run:  apt-get install ${missing[*]}"
    log=$(mktemp)
    update_package_lists "$log"
    if ! as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
        -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 install "${missing[@]}" >"$log" 2>&1; then
        tail -n 15 -- "$log" >&2
        die "the packages could not be installed; see the messages above." \
            "To install them manually:  apt-get install ${missing[*]}" "Complete log:  $log"
    fi
    rm -f -- "$log"
}

cache_value() { sed -n "s|^$1:[A-Z]*=||p" "$BUILD_DIR/CMakeCache.txt"; }

# A cache for another folder or generator cannot be used; the rest of the build folder can.
drop_stale_cache() {
    [ -f "$BUILD_DIR/CMakeCache.txt" ] || return 0
    if [ "$(cache_value CMAKE_GENERATOR)" != Ninja ] ||
        [ "$(cache_value CMAKE_HOME_DIRECTORY)" != "$SOURCE_DIR" ] ||
        [ "$(cache_value CMAKE_CACHEFILE_DIR)" != "$BUILD_DIR" ]; then
        say "The build folder belongs to another source folder or generator; configuring it again."
        rm -rf -- "$BUILD_DIR/CMakeCache.txt" "$BUILD_DIR/CMakeFiles"
    fi
}

# configure_release OPTION...: Release into build/.
configure_release() {
    local tool
    for tool in cmake ninja; do
        command -v "$tool" >/dev/null || die "$tool is required but not installed."
    done
    { mkdir -p -- "$BUILD_DIR" && [ -w "$BUILD_DIR" ]; } 2>/dev/null ||
        die "cannot write to the folder $BUILD_DIR." \
            "If root created it, remove it or run this script as root."
    drop_stale_cache
    local log=$BUILD_DIR/configure.log
    if ! cmake -S "$SOURCE_DIR" -B "$BUILD_DIR" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DSERVODESK_PCH=ON -DSERVODESK_UNITY=ON "$@" >"$log" 2>&1; then
        cat -- "$log" >&2
        die "the project could not be configured; see the messages above."
    fi
}

# run_aside COMMAND...: in a session that yields the processor to every other one. The kernel carries the
# bytes of a pseudo-terminal in a thread of its own, and where Linux shares the processor by sessions
# (autogroup) that thread waited up to half a second beside a session that is never idle (6.18, seen with
# `perf sched`): longer than servos may take to reply. Ctrl-C ends the command too. Its temporary files are in
# a folder of their own that is removed, because tests kill programs that cannot remove theirs.
run_aside() {
    local child temporary code=0
    temporary=$(mktemp -d)
    chmod 711 "$temporary" # they start PostgreSQL as another user
    # What runs in the background of a script ignores Ctrl-C, and so would the programs that the tests start.
    # shellcheck disable=SC2016 # for the inner shell
    TMPDIR=$temporary setsid env --default-signal=INT,QUIT bash -c \
        'echo 19 2>/dev/null >/proc/self/autogroup || true; exec "$@"' bash "$@" &
    child=$!
    # shellcheck disable=SC2064 # this child
    trap "kill -- -$child 2>/dev/null" INT TERM HUP QUIT
    wait "$child" || code=$?
    for _ in {1..50}; do # what a signal ends needs a moment
        kill -0 -- "-$child" 2>/dev/null || break
        sleep 0.1 || true
    done
    trap - INT TERM HUP QUIT
    rm -rf -- "$temporary" || true
    return "$code"
}
