# Keep the first command of each source in a compile_commands.json: a source that is compiled for several number types is then
# looked at once. A room that is compiled as one unit is taken apart into its sources. GCC's options of link-time
# optimisation, which clang takes for mistakes, go, and so do precompiled headers. Expects CMake's layout, one object of
# several lines an entry.
function keep(entry)
{
    gsub(/ -flto=auto| -ffat-lto-objects| -Winvalid-pch| -include [^ ]*cmake_pch.hxx/, "", entry)
    print kept++ ? "," : "", entry "}"
}

# The entry of `unit` as one entry for each source that it includes.
function keep_sources(entry, unit,    line, source, copy)
{
    while ((getline line < unit) > 0) {
        if (line !~ /^#include "/) continue
        source = substr(line, 11, length(line) - 11)
        if (seen[source]++) continue
        copy = entry
        gsub(unit, source, copy)
        keep(copy)
    }
    close(unit)
}

BEGIN {
    RS = "},?\n"
    printf "["
}

match($0, /"file": "[^"]*"/) {
    file = substr($0, RSTART + 9, RLENGTH - 10)
    entry = substr($0, index($0, "{"))
    unit_line_separator = RS
    if (file ~ /\/Unity\/unity_[0-9]+_cxx[.]cxx$/) {
        RS = "\n"
        keep_sources(entry, file)
        RS = unit_line_separator
    } else if (!seen[file]++) {
        keep(entry)
    }
}

END {
    print "]"
}
