#!/usr/bin/env bash
# scripts/install-deps against stand-ins for dpkg-query, apt-get, sudo and id, which log how they were called; nothing is installed.
# Each function is one claim. Usage: test_install_deps.sh PATH_OF_INSTALL_DEPS
set -euo pipefail

install_deps=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

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

# expect STATUS [OUTPUT_PART...]: run it, check its exit status and that its output has every part.
expect()
{
    local wanted=$1 status=0 part
    shift
    output=$(PATH=$work/bin "$install_deps" 2>&1 </dev/null) || status=$?
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
    a_failing_apt_get_fails_the_script
)
for claim in "${claims[@]}"; do
    "$claim"
    echo "passed $claim"
done
