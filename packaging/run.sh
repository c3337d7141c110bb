#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is needed, builds ServoDesk into build/ and shows it on a simulated bus: the window,
# or, where there is no display, the tour on the command line. Arguments go to the program that is
# started. The language follows LANG.
set -euo pipefail

# shellcheck source=packaging/common.sh
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh"

# A folder that test.sh made keeps its tests: switching them off would throw their objects away.
lists=(build)
options=()
if [ ! -f "$BUILD_DIR/CMakeCache.txt" ]; then
    options+=(-DSERVODESK_TESTS=OFF)
elif [ "$(cache_value SERVODESK_TESTS)" = ON ]; then
    lists+=(test)
fi

step 1/3 "Packages"
install_packages "${lists[@]}"
step 2/3 "Building into $BUILD_DIR"
configure_release "${options[@]}"
cmake --build "$BUILD_DIR" --target servodesk servodesk-cli servodesk-sim
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}${QT_QPA_PLATFORM:-}" ]; then
    step 3/3 "The window, on a simulated bus"
    exec "$BUILD_DIR/bin/servodesk" --port sim:demo "$@"
fi
step 3/3 "The tour; there is no display for the window"
exec "$BUILD_DIR/bin/servodesk-cli" tour "$@"
