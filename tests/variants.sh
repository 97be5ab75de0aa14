# variants.sh - for scripts that build the project in other ways: each build has no warning, and draws the frames of the
# base, $BUILD. In $tmp are the builds, and $tmp/expected are the base's frames.
set -u
base=${BUILD:-build}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
unset BUILD CC CFLAGS CROSS F64 DRM PNG CHAFA JSON ASSIMP OSMESA EGL DESTDIR PREFIX MAKEFLAGS MFLAGS MAKELEVEL

# result CASE STATUS [WHY]
result() {
    if [ "$2" -eq 0 ]; then echo "ok $1"; else echo "FAIL $1: $(printf '%s' "${3:-status $2}" | head -c 600 | tr '\n' ' ')"; fi
}

# have CASE TOOL PACKAGE
have() {
    command -v "$2" >/dev/null && return
    echo "skip $1: no $2 (install $3)"
    return 1
}

# frames COMMAND...: checksums of the scene in each light
frames() {
    for keys in '' a d s w 'a<right><down><pgup>'; do
        "$@" -d none -i none -n 1 -s 200x151 -k "$keys" --checksum || return
    done 2>&1
}

# same_frames CASE COMMAND...
same_frames() {
    case=$1
    shift
    frames "$@" >"$tmp/frames"
    cmp -s "$tmp/expected" "$tmp/frames"
    result "$case" $? "$(diff "$tmp/expected" "$tmp/frames")"
}

# build CASE TARGETS VARIABLE=VALUE...: without a warning
build() {
    case=$1 targets=$2
    shift 2
    # shellcheck disable=SC2086 # targets are words
    make -j"${TEST_JOBS:-$(nproc)}" -s $targets BUILD="$tmp/$case" "$@" >"$tmp/log" 2>&1
    status=$?
    if grep -q 'warning: ' "$tmp/log"; then status=1; fi
    result "build_$case" $status "$(grep -E 'warning: |error|Error' "$tmp/log" || tail -3 "$tmp/log")"
    return $status
}

frames "$base/tia" >"$tmp/expected"
result frames_expected $? "$(tail -1 "$tmp/expected")"
