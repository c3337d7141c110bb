#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the required packages, builds ServoDesk with its tests into build/ and runs them. Arguments
# are passed to ctest, e.g. `-R journal`; with --times as the first, the twenty slowest tests are listed at
# the end. With CI=true, warnings are errors.
set -euo pipefail

# shellcheck source=packaging/common.sh
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh"

times=false
if [ "${1:-}" = --times ]; then
    times=true
    shift
fi
options=(-DSERVODESK_TESTS=ON)
[ "${CI:-}" != true ] || options+=(-DSERVODESK_WERROR=ON)

step 1/3 "Packages"
install_packages build test
step 2/3 "Building in $BUILD_DIR"
configure_release "${options[@]}"
cmake --build "$BUILD_DIR"
step 3/3 "Tests"
tests=(ctest --test-dir "$BUILD_DIR" --output-on-failure --no-tests=error --parallel 8 "$@")
code=0
if ! $times; then
    run_aside "${tests[@]}" || code=$?
    exit "$code"
fi

log=$(mktemp)
trap 'rm -f -- "$log"' EXIT
run_aside "${tests[@]}" | tee -- "$log" || code=$?
printf '\nThe slowest, in seconds:\n'
sed -nE 's/^ *[0-9]+\/[0-9]+ +Test +#[0-9]+: ([^ ]+) .* ([0-9.]+) sec.*/\2 \1/p' "$log" | sort -rn | sed 20q
exit "$code"
