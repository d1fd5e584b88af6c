# contacts.awk: when each finger touches the object in one trajectory.csv: a row for each stretch of control steps at whose ends it
# does. Use: awk -v run=SOM -f contacts.awk trajectory.csv, where `run` is what stands in the rows' first column (cells.gp).

function note(finger, touches) {
    if (touches && !(finger in since)) since[finger] = before_s
    if (!touches && finger in since) {
        print run, finger, since[finger], before_s
        delete since[finger]
    }
}

BEGIN { FS = OFS = "," }
/^#/ { next }
!header { header = 1; for (i = 1; i <= NF; i++) at[$i] = i; before_s = 0; next }
{
    note("index", $at["index_contact_n"] > 0)
    note("thumb", $at["thumb_contact_n"] > 0)
    before_s = $at["time_s"]
}
END { note("index", 0); note("thumb", 0) }
