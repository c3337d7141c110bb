#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the Debian package and the source archive of the current commit in dist/, with the notes of this version
# from CHANGELOG.md and SHA-256 sums, and checks them: desktop file, metainfo, manual pages, completions, lintian
# without errors. With --try (root), the package is then installed, used and removed on a fresh Debian 12.
#   packaging/release.sh [--try]
set -euo pipefail

# shellcheck source=packaging/common.sh
. "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/common.sh"
BUILD_DIR=$SOURCE_DIR/build-package
dist=$SOURCE_DIR/dist

[ "${1:-}" = "" ] || [ "${1:-}" = --try ] || die "unknown argument \"$1\"." "Usage:  packaging/release.sh [--try]"
[ "${1:-}" != --try ] || [ "$(id -u)" -eq 0 ] || die "--try needs root."
[ -z "$(git -C "$SOURCE_DIR" status --porcelain)" ] || say "Uncommitted changes are in the package too."

step release "Packages"
install_packages build release

step release "Building"
configure_release -DSERVODESK_TESTS=OFF -DSERVODESK_WERROR=ON -DSERVODESK_PACKAGE=ON
cmake --build "$BUILD_DIR"
version=$(cache_value CMAKE_PROJECT_VERSION)

step release "dist/"
rm -rf -- "$dist"
mkdir -- "$dist"
(cd -- "$BUILD_DIR" && cpack -G DEB -B "$dist" >cpack.log 2>&1) || {
    cat -- "$BUILD_DIR/cpack.log" >&2
    die "the package could not be made; see the messages above."
}
rm -rf -- "$dist/_CPack_Packages"
package=$(echo "$dist"/servodesk_"$version"_*.deb)
git -C "$SOURCE_DIR" archive --prefix="servodesk-$version/" -o "$dist/servodesk-$version.tar.gz" HEAD
# The first section: the version's, or what is not released yet.
awk '/^## / { if (++sections > 1) exit } sections' "$SOURCE_DIR/CHANGELOG.md" >"$dist/NOTES.md"

step release "Checks"
docs=$BUILD_DIR/docs
desktop-file-validate "$SOURCE_DIR/packaging/linux/servodesk.desktop"
appstreamcli validate --no-net "$docs/org.servodesk.servodesk.metainfo.xml"
xmllint --noout "$SOURCE_DIR/packaging/linux/servodesk-mime.xml"
for page in "$docs"/*.1; do
    # Long words leave holes in a line; that is no mistake.
    warnings=$(LC_ALL=C.UTF-8 man --warnings -l -- "$page" 2>&1 >/dev/null | grep -v 'cannot adjust line' || true)
    [ -z "$warnings" ] || die "$(basename -- "$page"): $warnings"
    ! grep -q '???' -- "$page" || die "$(basename -- "$page") has lost characters."
done
completions=$SOURCE_DIR/packaging/linux/completions
PATH=$BUILD_DIR/bin:$PATH
[ "$(fish -c "source '$completions/servodesk-cli.fish'; complete -C 'servodesk-cli --port sim:demo scan --ti'" |
    cut -f 1)" = --timeout ] || die "the completion for fish does not work."
# As bash calls it.
# shellcheck source=/dev/null disable=SC2034
[ "$(. "$completions/servodesk-cli.bash" && COMP_LINE="servodesk-cli --port sim:de" && COMP_POINT=${#COMP_LINE} &&
    _servodesk_cli && echo "${COMPREPLY[*]}")" = demo ] || die "the completion for bash does not work."
zsh -n "$completions/_servodesk-cli"
lintian --allow-root --fail-on error -- "$package"
QT_QPA_PLATFORM=offscreen "$BUILD_DIR/bin/servodesk" --self-test

(cd -- "$dist" && sha256sum -- * >SHA256SUMS)
if [ "${1:-}" = --try ]; then
    "$SOURCE_DIR/packaging/fresh.sh" package "$package"
fi
step release "Ready:"
(cd -- "$dist" && ls -l -- *)
