#!/usr/bin/env bash
# test_build_parts.sh SOURCE_DIR CLAIM: what the program, the tests and the other parts ask for and build; nothing is
# compiled.
set -euo pipefail

source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
build=$work/build
unset MAKEFLAGS MAKELEVEL MFLAGS # of the make that runs the tests

refuse()
{
    echo "FAILED: $1" >&2
    [[ ! -f $work/log ]] || cat "$work/log" >&2
    exit 1
}

# A machine that has the packages of the group `run` alone, as far as pkg-config and CMake can tell.
program_packages_alone()
{
    cat >"$work/pkg-config" <<END
#!/bin/sh
case " \$* " in *' cmocka '* | *' gsl '* | *' tinyxml '* | *' simavr '* | *' libelf '*) exit 1 ;; esac
exec $(command -v pkg-config) "\$@"
END
    chmod +x "$work/pkg-config"
    export PKG_CONFIG=$work/pkg-config
    cmake --preset host -S "$source" -B "$build" -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON \
        -DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON >"$work/log" 2>&1 || refuse "the program is not configured"
}

configure()
{
    "$source/scripts/configure" "$build" "$@" >"$work/log" 2>&1
}

# What ninja would do for the program in a new folder, a line a step.
steps_of_the_program()
{
    ninja -C "$build" -n program >"$work/steps" || refuse "there is no target 'program'"
}

# The first call of install-deps by `make TARGET`, and nothing of the later ones but groups that it has.
groups_of()
{
    make -n --no-print-directory -C "$source" BUILD="$build" "$1" | grep '^scripts/install-deps' >"$work/calls"
    local call
    read -r call <"$work/calls"
    local group
    for group in $(sed 's|^scripts/install-deps||' "$work/calls"); do
        [[ " $call " == *" $group "* ]] || refuse "make $1 asks for '$group' later on"
    done
    echo "${call#scripts/install-deps }"
}

expect_groups() # GROUPS TARGET...
{
    local target groups
    for target in "${@:2}"; do
        groups=$(groups_of "$target")
        [[ $groups == "$1" ]] || refuse "make $target asks for '$groups', expected '$1'"
    done
}

case $2 in
program_needs_no_other_groups_package)
    program_packages_alone
    steps_of_the_program
    if grep -E '(^|[ /])(tests?|bench|emulators|peers)/|test_|firmware/[^a]' "$work/steps" >"$work/log"; then
        refuse "the program builds what is not its own"
    fi
    [[ $(tail -n 1 "$work/steps") == *bin/twiddle* ]] || refuse "the program is not what is built last"
    ;;
part_that_cannot_be_had_leaves_the_program_alone)
    program_packages_alone
    for part in tests bench emulators; do
        ! configure $part || refuse "configured $part without its packages"
        configure || refuse "the program cannot be configured any more"
        [[ ! -s $work/log ]] || refuse "configures again what is there"
        steps_of_the_program
    done
    ;;
tests_added_later_compile_nothing_of_the_program_again)
    configure || refuse "the program is not configured"
    ninja -C "$build" -t commands program >"$work/before"
    configure tests || refuse "the tests are not configured"
    ninja -C "$build" -t commands program | cmp "$work/before" - || refuse "the program is built otherwise"
    ninja -C "$build" -t query tests >/dev/null || refuse "there is no target 'tests'"
    configure tests
    [[ ! -s $work/log ]] || refuse "configures again what is there"
    ;;
program_takes_at_most_190_compiles)
    configure || refuse "the program is not configured"
    steps_of_the_program
    compiles=$(grep -c ' Building C\(XX\)\{0,1\} object ' "$work/steps")
    ((compiles > 0 && compiles <= 190)) || refuse "$compiles compiles"
    ;;
targets_ask_for_their_own_packages)
    expect_groups run run paper calibrate confirm program
    expect_groups "run test firmware" test
    expect_groups firmware firmware
    expect_groups "run bench" bench bench-instructions bench-peers performance
    expect_groups "run test firmware lint" lint
    expect_groups library install
    ;;
wrong_use_is_refused)
    for arguments in "" "$build program" "$build test"; do
        status=0
        # shellcheck disable=SC2086 # words
        "$source/scripts/configure" $arguments >"$work/log" 2>&1 || status=$?
        ((status == 2)) || refuse "exit status $status, expected 2"
        [[ ! -e $build ]] || refuse "made a folder"
    done
    ;;
*) refuse "no claim $2" ;;
esac
