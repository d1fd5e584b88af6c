#!/usr/bin/env bash
# scripts/install-peers against a stand-in for python3, whose virtual environments hold a stand-in for pip; nothing is
# installed. Each function is one claim. Usage: test_install_peers.sh SOURCE_DIR
set -euo pipefail

source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
venv=$work/venv

# machine VERSION_STATUS PIP_STATUS: python3 whose answer to the question of its version and whose pip's end are given.
machine()
{
    rm -rf "$work/bin" "$venv" "$work/log"
    mkdir "$work/bin"
    : >"$work/log"
    cat >"$work/bin/python3" <<END
#!/bin/bash
case \$1 in
--version) echo "Python 3.10.1" ;;
-c) exit $1 ;;
-m)
    echo "python3 \$*" >>"$work/log"
    mkdir -p "\${@: -1}/bin"
    printf '#!/bin/bash\necho "pip \$*" >>"%s"\nexit %s\n' "$work/log" "$2" >"\${@: -1}/bin/pip"
    chmod +x "\${@: -1}/bin/pip"
    ;;
esac
END
    chmod +x "$work/bin/python3"
}

# expect STATUS [OUTPUT_PART]: run it, check its exit status and that its output has the part.
expect()
{
    local status=0
    output=$(PATH=$work/bin:$PATH "$source/scripts/install-peers" "$venv" 2>&1) || status=$?
    [[ $status == "$1" ]] || refuse "exit status $status, expected $1"
    [[ $output == *"${2:-}"* ]] || refuse "no '$2' in the output"
}

refuse()
{
    echo "FAILED ${FUNCNAME[2]}: $1" >&2
    printf 'output: %s\nlog: %s\n' "$output" "$(<"$work/log")" >&2
    exit 1
}

installs_the_pinned_list_once()
{
    machine 0 0
    expect 0 "installing MuJoCo into $venv"
    grep -q "^python3 -m venv --clear $venv$" "$work/log" || refuse "made no virtual environment"
    grep -q "^pip install .*--requirement .*peers/requirements.txt$" "$work/log" || refuse "did not install the list"
    : >"$work/log"
    expect 0
    [[ -z $output && ! -s $work/log ]] || refuse "does something where all is there"
}

another_list_is_installed_anew()
{
    machine 0 0
    expect 0
    echo "mujoco==1.0" >"$venv/installed"
    expect 0 "installing"
}

without_pypi_it_says_so_and_the_next_start_tries_again()
{
    machine 0 1
    expect 1 "is PyPI reachable?"
    [[ ! -e $venv/installed ]] || refuse "calls it installed"
    expect 1 "is PyPI reachable?"
}

an_old_python_is_named()
{
    machine 1 0
    expect 1 "MuJoCo needs Python 3.11 or later; this machine's python3 is Python 3.10.1"
    [[ ! -s $work/log ]] || refuse "went on"
}

every_version_is_pinned()
{
    output=$(grep -v '^[a-z]*==[0-9.]*$' "$source/peers/requirements.txt") || return 0
    refuse "lines without a version"
}

claims=(
    installs_the_pinned_list_once
    another_list_is_installed_anew
    without_pypi_it_says_so_and_the_next_start_tries_again
    an_old_python_is_named
    every_version_is_pinned
)
for claim in "${claims[@]}"; do
    "$claim"
    echo "passed $claim"
done
