# Every function and object in a section of its own, so that an image holds only what it uses; and a .su file with the stack
# of each function beside each object file, for scripts/stack-usage.
add_compile_options(-ffunction-sections -fdata-sections -fstack-usage)
