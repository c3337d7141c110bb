#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and runs all benches and prints their measurements. `--smoke`: five seconds of each, which show that they
# run and do not crash; their figures mean little on a shared machine, so missed ones do not count.
set -euo pipefail

# shellcheck source=packaging/common.sh
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh"

smoke=false
[ "${1:-}" != --smoke ] || smoke=true
[ -f "$BUILD_DIR/CMakeCache.txt" ] || die "nothing is built." "To build it with the tests:  packaging/test.sh"
cmake --build "$BUILD_DIR" --target benches || die "this build has no benches." "To build it with them:  packaging/test.sh"
TMPDIR=$(mktemp -d) # a bench that is ended leaves its files
export TMPDIR
trap 'rm -rf -- "$TMPDIR"' EXIT

for bench in "$BUILD_DIR"/tests/bench_*; do
    [ -x "$bench" ] || continue
    name=$(basename -- "$bench")
    arguments=()
    case $name in
    bench_scenes) continue ;; # makes pictures, measures nothing
    bench_interruption_campaign)
        ! $smoke || continue # takes an hour; tst_interruption_campaign runs a part of it
        ;;
    bench_recorder) ! $smoke || arguments=(1000000) ;;  # instead of 26 million rows
    bench_sweep_overnight) ! $smoke || arguments=(1) ;; # instead of eight hours
    esac
    step "$name" ""
    if $smoke; then
        status=0
        timeout 5 "$bench" "${arguments[@]}" 2>&1 | sed 's/^/      /' || status=${PIPESTATUS[0]}
        case $status in
        0 | 124) ;; # done, still measuring
        1) say "A figure was missed." ;;
        *) die "$name ended with code $status." ;;
        esac
    else
        "$bench" "${arguments[@]}" 2>&1 | sed 's/^/      /'
    fi
done
