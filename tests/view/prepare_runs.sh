#!/bin/sh
# prepare_runs.sh PROGRAM FOLDER: runs, and the pages that `twiddle view` makes of them, for test_view.py.
set -eu
program=$1
folder=$2

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

train() { # OBJECT MODEL RUN
    "$program" train --object "$1" --model "$2" --seed 1 --trials 200 --out "$3"
    "$program" replay "$3"
}

train small-sphere cpg-h run
train medium-cube cpg-c other
"$program" view run
"$program" view run --compare other --out both.html

cat >sweep.toml <<'END'
trials = 60

[[runs]]
objects = ["small-sphere", "large-cube"]
models = ["cpg-c", "cpg-h"]
seeds = 2
END
"$program" sweep sweep.toml --out sweep --jobs 2
"$program" view sweep

# A stranger's run: its text tries to be markup.
cp -r run harmful
markup='</script><script>window.harmed = 1</script><img src=x onerror="window.harmed = 1">'
MARKUP=$markup awk '
    /^# object: / { print "# object: " ENVIRON["MARKUP"]; next }
    { print }' run/trajectory.csv >harmful/trajectory.csv
MARKUP=$markup python3 -c '
import json, os
run = json.load(open("run/run.json"))
run["command"] = run["setup"] = os.environ["MARKUP"]
json.dump(run, open("harmful/run.json", "w"))'
"$program" view harmful
