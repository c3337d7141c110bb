#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the tests built in build/ ten times, beside two busy loops and a program that writes to the disk, and
# lists each test that failed at least once. With a number first: that many times; the rest goes to ctest,
# e.g. `soak.sh 20 -R tst_cli_sweep`. The whole output of a run that failed is kept in build/Testing.
set -euo pipefail

# shellcheck source=packaging/common.sh
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh"

# The load belongs to the same session as the tests, or it would get the whole processor.
if [ "${1:-}" != --aside ]; then
    code=0
    run_aside "$0" --aside "$@" || code=$?
    exit "$code"
fi
shift

runs=10
if [[ ${1:-} =~ ^[1-9][0-9]*$ ]]; then
    runs=$1
    shift
fi
[ -f "$BUILD_DIR/CTestTestfile.cmake" ] ||
    die "there are no tests in $BUILD_DIR." "Build them first:  packaging/test.sh"

scratch=$(mktemp -d)
loads=()
end_load() {
    kill -- "${loads[@]}" 2>/dev/null || true
    wait -- "${loads[@]}" 2>/dev/null || true
    rm -rf -- "$scratch"
}
trap end_load EXIT
for _ in 1 2; do
    while :; do :; done &
    loads+=($!)
done
while dd if=/dev/zero of="$scratch/load" bs=1M count=256 conv=fdatasync status=none; do :; done &
loads+=($!)

for run in $(seq "$runs"); do
    began=$SECONDS
    rm -f -- "$BUILD_DIR/Testing/Temporary/LastTestsFailed.log"
    ctest --test-dir "$BUILD_DIR" --no-tests=error --output-on-failure --parallel 6 "$@" \
        >"$scratch/log" 2>&1 || sed -n '/^Errors while running CTest/q; /\*\*\*/p; /^FAIL!/,/^   Loc/p' "$scratch/log"
    grep -qE '^[0-9]+% tests passed' "$scratch/log" || { cat -- "$scratch/log"; die "the tests did not run."; }
    [ ! -s "$BUILD_DIR/Testing/Temporary/LastTestsFailed.log" ] ||
        cp -- "$scratch/log" "$BUILD_DIR/Testing/soak-$run.log"
    cut -d: -f2 -- "$BUILD_DIR/Testing/Temporary/LastTestsFailed.log" >>"$scratch/failed" 2>/dev/null || true
    step "$run/$runs" "$(grep -E '^[0-9]+% tests passed' "$scratch/log"), $((SECONDS - began)) s"
done

if [ -s "$scratch/failed" ]; then
    printf '\nTimes failed:\n'
    sort -- "$scratch/failed" | uniq -c | sort -rn
    exit 1
fi
printf '\nNo test failed.\n'
