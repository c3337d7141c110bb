#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What is too slow for every change: all tests with every case, also under both sanitizers, the programs built
# file by file, clang-tidy over all sources, the benches in full with an hour of interrupted restores, and the
# README's two commands in a new Debian 12. Takes several hours; needs root and debootstrap for the last part.
set -euo pipefail

# shellcheck source=packaging/common.sh
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh"
# shellcheck source=packaging/checks.sh
. "$SOURCE_DIR/packaging/checks.sh"
cd -- "$SOURCE_DIR"
export SERVODESK_DEEP_CHECK=1

chapter "Packages"
install_packages build test ci

chapter "Release build and tests"
CI=true run_tests release build packaging/test.sh

chapter "The window at 150 and 200 %"
for scale in 1.5 2; do
    QT_SCALE_FACTOR=$scale ctest --test-dir build -R '^tst_layout-' --output-on-failure
done

chapter "The programs without batches, with all warnings"
cmake --preset dev >/dev/null
cmake --build --preset dev --target servodesk servodesk-cli servodesk-sim

chapter "Address and undefined-behavior sanitizers, all tests"
build_preset asan -DSERVODESK_SANITIZE_ALL=ON
run_tests asan build-asan ctest --preset asan

chapter "Thread sanitizer, all tests without the window"
cmake --preset tsan -DSERVODESK_SANITIZE_ALL=ON >/dev/null
cmake --build --preset tsan --target core_tests
run_tests tsan build-tsan ctest --test-dir build-tsan -LE 'window|no_tsan' --parallel 3 --output-on-failure

chapter "clang-tidy over all sources"
check_tidy all

chapter "Benches in full"
packaging/bench.sh

chapter "README's two commands in a new Debian 12"
packaging/fresh.sh

passed
