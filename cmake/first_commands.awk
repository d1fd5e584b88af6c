# Keep the first command of each source in a compile_commands.json: a source that is compiled for several number types is then
# looked at once. GCC's options of link-time optimisation, which clang takes for mistakes, go, and so do precompiled headers. Expects CMake's layout, one
# object of several lines an entry.
BEGIN {
    RS = "},?\n"
    printf "["
}
match($0, /"file": "[^"]*"/) && !seen[substr($0, RSTART, RLENGTH)]++ {
    gsub(/ -flto=auto| -ffat-lto-objects| -Winvalid-pch| -include [^ ]*cmake_pch.hxx/, "")
    print kept++ ? "," : "", substr($0, index($0, "{")) "}"
}
END {
    print "]"
}
