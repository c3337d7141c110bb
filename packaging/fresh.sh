#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tests the commands of the README on a fresh machine: creates a Debian 12 with minimal packages by
# debootstrap, copies the current commit into it, and runs run.sh and test.sh there, which install only
# the listed packages.
#   packaging/fresh.sh [run | test [CTEST OPTION...]]     without an argument: run, then test
#   packaging/fresh.sh package FILE.deb                   installs, tries and removes this package there
# With CI=true, warnings are errors there too. Needs root, debootstrap, git, and 5 GB in TMPDIR (default:
# /var/tmp) until it ends. Sources, keys, proxy and certificates of apt are those of this machine.
set -euo pipefail

# shellcheck source=packaging/common.sh
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh"

release=bookworm
inside=/root/servodesk # the project on the fresh machine

what=${1:-all}
[ $# -eq 0 ] || shift
case $what in
run | test | all) ;;
package) [ -f "${1:-}" ] || die "packaging/fresh.sh package needs a package." ;;
*) die "unknown argument \"$what\"." "Usage:  packaging/fresh.sh [run | test [CTEST OPTION...] | package FILE.deb]" ;;
esac
[ "$(id -u)" -eq 0 ] || die "this script needs root."
for tool in debootstrap git unshare; do
    command -v "$tool" >/dev/null ||
        die "$tool is required but not installed." "To install it:  apt-get install debootstrap git util-linux"
done

root=$(mktemp -d "${TMPDIR:-/var/tmp}/servodesk-fresh.XXXXXX")
# There are no mounts to undo: each belongs to a namespace of its own, which ends with its program.
trap 'rm -rf --one-file-system -- "$root"' EXIT
chmod 755 "$root" # mktemp sets 700, but PostgreSQL does not run as root and must enter

# "URI suite component" of each archive of this Debian release in apt's sources, without third parties.
archives() {
    # shellcheck disable=SC2016 # apt expands these
    apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
        grep -E " $release(-updates|-security)? main\$" | sort -u
}

# The machine as after an installation, with access to the archives like this one.
make_machine() {
    local mirror keys log=$root.log
    mirror=$(archives | sed -n "s/ $release main\$//p" | head -n 1)
    [ -n "$mirror" ] || die "apt on this machine has no source for Debian $release."
    if ! debootstrap --variant=minbase "$release" "$root" "$mirror" >"$log" 2>&1; then
        tail -n 15 -- "$log" >&2
        rm -f -- "$log"
        die "debootstrap failed; see the messages above."
    fi
    rm -f -- "$log"
    archives | sed 's/^/deb /' >"$root/etc/apt/sources.list"
    apt-config dump Acquire >"$root/etc/apt/apt.conf.d/90acquire"
    for keys in /etc/apt/trusted.gpg.d /etc/apt/keyrings /usr/share/keyrings \
        /usr/local/share/ca-certificates; do
        [ ! -d "$keys" ] || { mkdir -p -- "$root$keys" && cp -r -- "$keys/." "$root$keys"; }
    done
    if [ -f /etc/ssl/certs/ca-certificates.crt ]; then
        mkdir -p -- "$root/etc/ssl/certs"
        cp -- /etc/ssl/certs/ca-certificates.crt "$root/etc/ssl/certs"
    fi
    cp -L -- /etc/resolv.conf /etc/hosts "$root/etc"
    mkdir -p -- "$root$inside"
    git -C "$SOURCE_DIR" archive HEAD | tar -x -C "$root$inside"
}

# on_machine [NAME=VALUE...] COMMAND...: in the project folder there, without display and input.
on_machine() {
    # shellcheck disable=SC2016 # expanded inside
    unshare --mount --pid --fork --kill-child --propagation private bash -euc '
        root=$1 inside=$2
        shift 2
        mount -t proc proc "$root/proc"
        mount -t sysfs -o ro sysfs "$root/sys"
        mkdir -p "$root/dev/pts" "$root/dev/shm"
        mount -t devpts -o newinstance,ptmxmode=0666,mode=620,gid=5 devpts "$root/dev/pts"
        mount -t tmpfs tmpfs "$root/dev/shm"
        exec chroot "$root" env -i HOME=/root LANG=C.UTF-8 \
            PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
            ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
            ${no_proxy:+no_proxy="$no_proxy"} ${CI:+CI="$CI"} \
            sh -c "cd \"\$1\" && shift && exec env \"\$@\"" sh "$inside" "$@"' \
        bash "$root" "$inside" "$@" </dev/null
}

# Only with what the package depends on: no recommended packages, no display.
try_package() {
    cp -- "$1" "$root/root/servodesk.deb"
    step fresh "Installing $(basename -- "$1")"
    on_machine sh -c 'apt-get -qq update && apt-get -qq -y --no-install-recommends install /root/servodesk.deb >/dev/null'
    step fresh "Using it"
    on_machine QT_QPA_PLATFORM=offscreen servodesk --self-test
    on_machine servodesk-cli --port sim:demo scan
    on_machine servodesk-cli --version
    step fresh "Removing it"
    on_machine apt-get -qq -y purge servodesk >/dev/null
    local rest
    rest=$(find "$root"/usr "$root"/etc "$root"/var/lib -iname '*servodesk*')
    [ -z "$rest" ] || die "files are left behind:" "$rest"
    step fresh "The package can be installed, used and removed."
}

[ -z "$(git -C "$SOURCE_DIR" status --porcelain)" ] || [ "$what" = package ] ||
    say "Uncommitted changes are not included."
step fresh "Creating a machine with only the minimal packages of Debian"
make_machine
if [ "$what" = package ]; then
    try_package "$1"
    exit
fi
if [ "$what" != test ]; then
    step fresh "packaging/run.sh, without a display"
    on_machine packaging/run.sh
    step fresh "packaging/run.sh, the window"
    on_machine QT_QPA_PLATFORM=offscreen packaging/run.sh --screenshot /root/window.png --after 4000
    [ -s "$root/root/window.png" ] || die "the window did not save a screenshot."
fi
if [ "$what" != run ]; then
    step fresh "packaging/test.sh $*"
    on_machine packaging/test.sh "$@"
fi
step fresh "Both commands of the README work with the listed packages."
