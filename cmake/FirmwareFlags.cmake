# Every function and object in a section of its own, so that an image holds only what it uses; a .su file with the stack
# of each function beside each object file, for scripts/stack-usage; and what a debugger and make bench-firmware need to
# know.
add_compile_options(-ffunction-sections -fdata-sections -fstack-usage -g)
