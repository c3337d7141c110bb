# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The parts of the check, for .ci/run and deep-check.sh. To be sourced after common.sh, with the root of
# the project as current folder.

chapters=()      # "Name|seconds"
test_summaries=() # "asan: 100% tests passed …"
unstable_tests=()
chapter_name=
chapter_began=$SECONDS
check_finished=false

end_chapter() {
    [ -z "$chapter_name" ] || chapters+=("$chapter_name|$((SECONDS - chapter_began))")
    chapter_began=$SECONDS
}

# chapter NAME: ends the one before it.
chapter() {
    end_chapter
    chapter_name=$1
    printf '\n=== %s (after %d s) ===\n' "$1" "$SECONDS"
}

print_chapters() {
    local entry
    for entry in "${chapters[@]}"; do
        printf '%6d s  %s\n' "${entry##*|}" "${entry%|*}"
    done
    printf '%6d s  in total\n' "$SECONDS"
}

passed() {
    end_chapter
    check_finished=true
    printf '\n=== Passed (after %d s) ===\n' "$SECONDS"
    printf '%s\n' "${test_summaries[@]}"
    [ ${#unstable_tests[@]} -eq 0 ] || printf 'unstable: %s\n' "${unstable_tests[@]}"
    print_chapters
}

report_failure() {
    ! $check_finished || return 0
    end_chapter
    print_chapters
    printf '\n=== FAILED: %s (after %d s) ===\n' "$chapter_name" "$SECONDS"
}
trap 'report_failure >&2' EXIT

# run_tests NAME BUILD_FOLDER COMMAND...: the command runs ctest in that folder. Tests that fail are
# repeated alone, at most twice, so that a busy machine does not fail the check; those that pass then are
# named as unstable at the end. More than a tenth of them is not chance.
run_tests() {
    local name=$1 folder=$2 log failed names
    shift 2
    failed=$folder/Testing/Temporary/LastTestsFailed.log
    log=$(mktemp)
    rm -f -- "$failed"
    if ! run_aside "$@" 2>&1 | tee -- "$log"; then
        [ -s "$failed" ] || return 1 # it failed before the tests
        mapfile -t names < <(cut -d: -f2 -- "$failed")
        [ ${#names[@]} -le 24 ] || return 1
        printf '\n%d of the tests failed; repeating them alone: %s\n' "${#names[@]}" "${names[*]}"
        run_aside ctest --test-dir "$folder" --rerun-failed --parallel 1 --repeat until-pass:2 --output-on-failure
        unstable_tests+=("${names[@]/%/ ($name)}")
    fi
    test_summaries+=("$name: $(grep -E '^[0-9]+% tests passed' "$log")")
    rm -f -- "$log"
}

# build_preset PRESET [OPTION OF CMAKE...]
build_preset() {
    cmake --preset "$@" >/dev/null
    cmake --build --preset "$1"
}

check_format() {
    local sources
    mapfile -d '' sources < <(git ls-files -z -- '*.cpp' '*.h')
    printf '%d sources\n' "${#sources[@]}"
    clang-format-14 --dry-run --Werror "${sources[@]}"
}

check_scripts() {
    local scripts
    mapfile -d '' scripts < <(git ls-files -z -- '*.sh' '*.bash' packaging/linux/postinst .ci/run)
    shellcheck -x "${scripts[@]}"
}

# changed_sources COMMITS: the sources of src and ui that differ from the state so many commits ago, or
# include a header that does; all, if the history is shorter or the list of checks differs.
changed_sources() {
    local base headers
    if ! base=$(git rev-parse -q --verify "HEAD~$1^{commit}") || ! git diff --quiet "$base" -- .clang-tidy; then
        git ls-files -- 'src/*.cpp' 'ui/*.cpp'
        return
    fi
    git diff --name-only --diff-filter=d "$base" -- 'src/*.cpp' 'ui/*.cpp'
    headers=$(git diff --name-only --diff-filter=d "$base" -- 'src/*.h' 'ui/*.h' | sed -E 's,^src/,,')
    [ -z "$headers" ] ||
        git grep -lF -f <(sed -E 's,.*,#include "&",' <<<"$headers") -- 'src/*.cpp' 'ui/*.cpp' || true
}

# check_tidy all | COMMITS: clang-tidy over all sources, or over those that differ from the state so many
# commits ago. It reads the unity sources, so the headers are read a few dozen times instead of six hundred.
check_tidy() {
    local sources absolute units
    if [ "$1" = all ]; then
        sources=$(git ls-files -- 'src/*.cpp' 'ui/*.cpp')
    else
        sources=$(changed_sources "$1" | sort -u)
    fi
    [ -n "$sources" ] || { echo "No source differs."; return 0; }
    absolute=$SOURCE_DIR/${sources//$'\n'/$'\n'$SOURCE_DIR/}
    cmake -S . -B build-tidy -G Ninja -DCMAKE_BUILD_TYPE=Release -DSERVODESK_TESTS=OFF \
        -DSERVODESK_UNITY=ON >/dev/null
    cmake --build build-tidy --target sd_text >/dev/null
    mapfile -d '' units < <(
        find build-tidy/src build-tidy/ui -name 'unity_*.cxx' -print0 | xargs -0 grep -lZF -e "$sources"
        # those that are compiled on their own
        sed -nE 's/^ *"file": "(.*)",?$/\1/p' build-tidy/compile_commands.json |
            grep -xF -e "$absolute" | tr '\n' '\0')
    printf '%d units\n' "${#units[@]}"
    [ ${#units[@]} -gt 0 ] || die "the sources for clang-tidy were not found."
    printf '%s\0' "${units[@]}" |
        xargs -0 -n 1 -P 2 clang-tidy-14 -quiet -p build-tidy -header-filter='/(src|ui)/' \
            2>build-tidy/log || { cat build-tidy/log >&2; return 1; }
}
