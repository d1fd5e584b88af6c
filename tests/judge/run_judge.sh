#!/bin/sh
# run_judge.sh VENV: the tests of this folder, in the virtual environment that `make test` makes.
set -eu
venv=$1
if [ ! -f "$venv/installed" ]; then
    echo "judge: there is no MuJoCo in $venv; 'make test' installs it (or: scripts/install-peers $venv)" >&2
    exit 1
fi
cd "$(dirname "$0")"
exec "$venv/bin/python" -B -m unittest --verbose
