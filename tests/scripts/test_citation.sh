#!/bin/sh
# test_citation.sh SOURCE_DIR VERSION: CITATION.cff cites the version that CMake knows, under the licence that is there.
set -eu
citation=$1/CITATION.cff

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

grep -qx "version: $2" "$citation" || fail "$(grep '^version:' "$citation"), but the project's version is $2"
licence=$(sed -n 's/^license: //p' "$citation")
grep -q "^$licence License$" "$1/LICENSE" || fail "licence $licence is not that of LICENSE"
