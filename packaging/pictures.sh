#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Creates the pictures of README and help with the program itself, without a screen: the window at its
# first start, a search, the pages in use, the memory table; both languages, both themes. Needs a build
# with the tests and a Chinese font (fonts-noto-cjk).
set -euo pipefail

# shellcheck source=packaging/common.sh
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh"

program=${1:-$BUILD_DIR/bin/servodesk}
images=$SOURCE_DIR/resources/help/images
[ -x "$program" ] || die "$program is not built." "To build it:  packaging/run.sh"
cmake --build "$BUILD_DIR" --target bench_scenes
place=$(mktemp -d)
trap 'rm -rf -- "$place"' EXIT
mkdir -p -- "$images"

# picture NAME LANGUAGE THEME OPTION...
picture() {
    local name=$1 language=$2 theme=$3
    shift 3
    env LC_ALL=C.UTF-8 QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR="$place" \
        SERVODESK_DATA_DIR="$place/data" XDG_CONFIG_HOME="$place/config" \
        "$program" --lang "$language" --theme "$theme" --size 1280x800 \
        --screenshot "$images/$name-${language%%_*}-$theme.png" "$@"
}

# scene NAME PICTURE LANGUAGE THEME
scene() {
    env LC_ALL=C.UTF-8 XDG_RUNTIME_DIR="$place" \
        "$BUILD_DIR/tests/bench_scenes" "$place" "$1-$3-$4-1280"
    cp -- "$place/$1-$3-$4-1280.png" "$images/$2-${3%%_*}-$4.png"
}

for language in en zh_CN; do
    for theme in light dark; do
        picture shell "$language" "$theme" --after 800
        picture search "$language" "$theme" --port sim:trouble --select 5 --after 4000
        picture memory "$language" "$theme" --port sim:demo --select 1 --after 4000
        scene sts-position operate "$language" "$theme"
        scene sweep-bad sweep "$language" "$theme"
        scene step-trial step "$language" "$theme"
        scene snapshots-compare snapshots "$language" "$theme"
        scene history-writes history "$language" "$theme"
        step "$language" "$theme"
    done
done
