#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the required packages, builds ServoDesk into build/ and starts it on a simulated bus: the
# window, or the tour of the command line if there is no display. Arguments are passed to the program.
# The language follows LANG.
set -euo pipefail

# shellcheck source=packaging/common.sh
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh"

# If test.sh has configured the folder, the tests stay on: turning them off would discard their build.
lists=(build)
options=()
if [ ! -f "$BUILD_DIR/CMakeCache.txt" ]; then
    options+=(-DSERVODESK_TESTS=OFF)
elif [ "$(cache_value SERVODESK_TESTS)" = ON ]; then
    lists+=(test)
fi

step 1/3 "Packages"
install_packages "${lists[@]}"
step 2/3 "Building in $BUILD_DIR"
configure_release "${options[@]}"
cmake --build "$BUILD_DIR" --target servodesk servodesk-cli servodesk-sim
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}${QT_QPA_PLATFORM:-}" ]; then
    step 3/3 "Starting the window on a simulated bus"
    exec "$BUILD_DIR/bin/servodesk" --port sim:demo "$@"
fi
step 3/3 "There is no display, so starting the tour of the command line"
exec "$BUILD_DIR/bin/servodesk-cli" tour "$@"
