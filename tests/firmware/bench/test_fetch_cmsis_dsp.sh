#!/usr/bin/env bash
# fetch-cmsis-dsp against a stand-in for python3, whose virtual environments hold a stand-in for pip; nothing is
# downloaded. Each function is one claim. Usage: test_fetch_cmsis_dsp.sh SOURCE_DIR
set -euo pipefail

source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
folder=$work/cmsis-dsp

# machine PIP_STATUS: python3 whose pip ends so; with 0 it has downloaded a package of one file.
machine()
{
    rm -rf "$work/bin" "$folder" "$work/package" "$work/log"
    mkdir -p "$work/bin" "$work/package/cmsisdsp-1.0/Source"
    : >"$work/log"
    echo "int sine;" >"$work/package/cmsisdsp-1.0/Source/sine.c"
    tar -czf "$work/package.tar.gz" -C "$work/package" cmsisdsp-1.0
    cat >"$work/bin/pip" <<END
#!/bin/bash
echo "pip \$*" >>"$work/log"
cp "$work/package.tar.gz" "\${@: -1}/cmsisdsp-1.0.tar.gz"
exit $1
END
    cat >"$work/bin/python3" <<END
#!/bin/bash
mkdir -p "\${@: -1}/bin"
cp "$work/bin/pip" "\${@: -1}/bin/pip"
END
    chmod +x "$work/bin/python3" "$work/bin/pip"
}

# expect STATUS [OUTPUT_PART]: run it, check its exit status and that its output has the part.
expect()
{
    local status=0
    output=$(PATH=$work/bin:$PATH "$source/firmware/bench/fetch-cmsis-dsp" "$folder" 2>&1) || status=$?
    [[ $status == "$1" ]] || refuse "exit status $status, expected $1"
    [[ $output == *"${2:-}"* ]] || refuse "no '$2' in the output"
}

refuse()
{
    echo "FAILED ${FUNCNAME[2]}: $1" >&2
    printf 'output: %s\nlog: %s\n' "$output" "$(<"$work/log")" >&2
    exit 1
}

unpacks_the_pinned_sources_once()
{
    machine 0
    expect 0 "fetching CMSIS-DSP into $folder"
    grep -q '^pip download .*--no-binary cmsisdsp .*--requirement .*firmware/bench/cmsis-dsp.txt' "$work/log" ||
        refuse "did not download the pinned sources"
    [[ -e $folder/Source/sine.c ]] || refuse "did not unpack them"
    : >"$work/log"
    expect 0
    [[ -z $output && ! -s $work/log ]] || refuse "does something where all is there"
}

another_version_is_fetched_anew()
{
    machine 0
    expect 0
    echo "cmsisdsp==1.0" >"$folder/fetched"
    expect 0 "fetching"
}

without_pypi_it_says_so_and_leaves_nothing_half_done()
{
    machine 1
    expect 1 "pip could not download CMSIS-DSP from PyPI"
    [[ ! -e $folder ]] || refuse "left a folder"
}

version_and_checksum_are_pinned()
{
    output=$(<"$source/firmware/bench/cmsis-dsp.txt")
    [[ $output =~ ^cmsisdsp==[0-9.]+\ --hash=sha256:[0-9a-f]{64}$ ]] || refuse "not one version with its checksum"
}

claims=(
    unpacks_the_pinned_sources_once
    another_version_is_fetched_anew
    without_pypi_it_says_so_and_leaves_nothing_half_done
    version_and_checksum_are_pinned
)
for claim in "${claims[@]}"; do
    "$claim"
    echo "passed $claim"
done
