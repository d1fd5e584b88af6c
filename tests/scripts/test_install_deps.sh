#!/usr/bin/env bash
# scripts/install-deps against stand-ins for dpkg-query, apt-get, sudo and id, which log how they were called; nothing
# is installed. Each function is one claim. Usage: test_install_deps.sh PATH_OF_INSTALL_DEPS
set -euo pipefail

install_deps=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Which system it is, whatever the tests run on.
export TWIDDLE_OS_RELEASE=$work/os-release
echo 'ID=debian' >"$TWIDDLE_OS_RELEASE"

# stand_in NAME BODY: a program NAME on the PATH that install-deps sees.
stand_in()
{
    printf '#!/bin/bash\n%s\n' "$2" >"$work/bin/$1"
    chmod +x "$work/bin/$1"
}

# A machine with bash and env, and nothing else.
empty_machine()
{
    rm -rf "$work/bin" "$work/log"
    mkdir "$work/bin"
    : >"$work/log"
    ln -s "$(command -v bash)" "$(command -v env)" "$work/bin"
}

# has_packages all | all-but NAME: what dpkg-query answers; like the real one, it fails if a package is unknown.
has_packages()
{
    stand_in dpkg-query 'status=0
        for package in "${@:3}"; do
            if [[ '"$1"' == all-but && $package == "'"${2:-}"'" ]]; then status=1; else echo "installed $package"; fi
        done
        exit $status'
}

# user ID: who runs install-deps.
user()
{
    stand_in id "echo $1"
}

has_apt_get()
{
    stand_in apt-get 'echo "apt-get $* [$DEBIAN_FRONTEND]" >>"'"$work"'/log"; exit '"${1:-0}"
}

# expect STATUS [OUTPUT_PART...]: run it for the groups in `groups`; check its exit status, and that its
# output has every part.
groups=()
expect()
{
    local wanted=$1 status=0 part
    shift
    output=$(PATH=$work/bin "$install_deps" "${groups[@]}" 2>&1 </dev/null) || status=$?
    [[ $status == "$wanted" ]] || refuse "exit status $status, expected $wanted"
    for part in "$@"; do
        [[ $output == *"$part"* ]] || refuse "no '$part' in the output"
    done
}

refuse()
{
    echo "FAILED ${FUNCNAME[2]}: $1" >&2
    printf 'output: %s\nlog: %s\n' "$output" "$(<"$work/log")" >&2
    exit 1
}

expect_log()
{
    [[ $(<"$work/log") == "$1" ]] || refuse "calls other than: $1"
}

# asks_for GROUPS PACKAGES: a machine that has nothing is told these packages for these groups, and no
# more. Both are words.
asks_for()
{
    local asked
    read -ra groups <<<"$1"
    empty_machine
    user 0
    expect 1 "there is no apt-get"
    one_sentence
    asked=${output##*means: }
    asked=$(printf '%s\n' $asked | sort)
    [[ $asked == "$(printf '%s\n' $2 | sort)" ]] || refuse "other packages than: $2"
    groups=()
}

one_sentence()
{
    [[ $output != *$'\n'* ]] || refuse "more than one line"
}

says_and_does_nothing_where_all_packages_are_there()
{
    empty_machine
    has_packages all
    has_apt_get
    user 0
    expect 0
    [[ -z $output ]] || refuse "output where none is expected"
    expect_log ""
}

root_updates_and_installs_what_is_missing_and_no_more()
{
    empty_machine
    has_packages all-but libccd-dev
    has_apt_get
    user 0
    expect 0 "installing libccd-dev"
    expect_log "apt-get update [noninteractive]
apt-get install --no-install-recommends --yes libccd-dev [noninteractive]"
}

a_user_goes_through_sudo_without_a_question()
{
    empty_machine
    has_packages all-but ninja-build
    has_apt_get
    user 1000
    stand_in true ''
    stand_in sudo '[[ $1 == -n ]] || exit 1; echo sudo >>"'"$work"'/log"; shift; exec "$@"'
    expect 0
    expect_log "sudo
sudo
apt-get update [noninteractive]
sudo
apt-get install --no-install-recommends --yes ninja-build [noninteractive]"
}

a_user_without_sudo_is_told_what_to_ask_for()
{
    empty_machine
    has_packages all-but ninja-build
    has_apt_get
    user 1000
    expect 1 "only root can install packages" ninja-build
    one_sentence
    expect_log ""
}

a_user_whom_sudo_refuses_is_told_what_to_ask_for()
{
    empty_machine
    has_packages all-but ninja-build
    has_apt_get
    user 1000
    stand_in sudo 'exit 1'
    expect 1 "sudo does not let you" ninja-build
    one_sentence
    expect_log ""
}

a_machine_without_apt_get_is_told_what_is_missing()
{
    empty_machine
    has_packages all-but gnuplot-nox
    user 0
    expect 1 "there is no apt-get" gnuplot-nox
    one_sentence
}

a_machine_without_dpkg_is_told_the_whole_list()
{
    empty_machine
    user 0
    expect 1 "there is no apt-get" build-essential libbullet-dev clang-tidy
    one_sentence
}

# What the README promises of `make run`: the program, and nothing of tests, boards or benchmarks.
program="build-essential cmake ninja-build pkg-config git libbullet-dev libccd-dev liburdfdom-dev libcli11-dev
    libtomlplusplus-dev nlohmann-json3-dev libboost-math-dev gnuplot-nox fonts-dejavu-core"
tests="libcmocka-dev libgtest-dev libgsl-dev libbullet-extras-dev libtinyxml-dev clang
    chromium slurmctld slurmd slurm-client munge procps python3-venv"
boards="gcc-arm-none-eabi libnewlib-arm-none-eabi gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf gcc-avr avr-libc
    qemu-system-arm qemu-system-misc libsimavr-dev libelf-dev"

each_group_has_its_own_packages()
{
    asks_for run "$program"
    asks_for library "build-essential cmake ninja-build"
    asks_for test "$tests"
    asks_for firmware "cmake ninja-build $boards python3-venv"
    asks_for bench "libbenchmark-dev valgrind python3-venv"
    asks_for lint "clang-format clang-tidy"
}

what_two_groups_share_is_asked_for_once()
{
    asks_for "test bench" "$tests libbenchmark-dev valgrind"
    asks_for "bench test" "$tests libbenchmark-dev valgrind"
    asks_for "run firmware" "$program $boards python3-venv"
}

# Ubuntu's chromium is a snap.
ubuntu_is_asked_for_all_but_the_browser()
{
    printf 'NAME="Ubuntu"\nID=ubuntu\nID_LIKE=debian\n' >"$TWIDDLE_OS_RELEASE"
    asks_for test "${tests/chromium /}"
    echo 'ID=debian' >"$TWIDDLE_OS_RELEASE"
}

no_group_is_all_of_them()
{
    asks_for "" "$program $tests $boards libbenchmark-dev valgrind clang-format clang-tidy"
}

another_groups_missing_package_is_nobodys_business()
{
    empty_machine
    has_packages all-but qemu-system-arm
    has_apt_get
    user 1000
    groups=(run test bench)
    expect 0
    [[ -z $output ]] || refuse "output where none is expected"
    groups=(run firmware)
    expect 1 "ask for these: qemu-system-arm"
    one_sentence
    groups=()
    expect_log ""
}

a_group_that_is_not_there_is_wrong_use()
{
    empty_machine
    has_packages all
    user 0
    groups=(run tests)
    expect 2 "there is no group 'tests'; the groups are: run library test firmware bench lint"
    one_sentence
    groups=()
}

a_failing_apt_get_fails_the_script()
{
    empty_machine
    has_packages all-but cmake
    has_apt_get 100
    user 0
    expect 1 "apt-get could not update"
}

claims=(
    says_and_does_nothing_where_all_packages_are_there
    root_updates_and_installs_what_is_missing_and_no_more
    a_user_goes_through_sudo_without_a_question
    a_user_without_sudo_is_told_what_to_ask_for
    a_user_whom_sudo_refuses_is_told_what_to_ask_for
    a_machine_without_apt_get_is_told_what_is_missing
    a_machine_without_dpkg_is_told_the_whole_list
    each_group_has_its_own_packages
    what_two_groups_share_is_asked_for_once
    ubuntu_is_asked_for_all_but_the_browser
    no_group_is_all_of_them
    another_groups_missing_package_is_nobodys_business
    a_group_that_is_not_there_is_wrong_use
    a_failing_apt_get_fails_the_script
)
for claim in "${claims[@]}"; do
    "$claim"
    echo "passed $claim"
done
