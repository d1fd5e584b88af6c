# Link-time optimisation of the programs that simulate: 6 % fewer instructions on the small sphere, 2 % on the medium
# cylinder (callgrind, 300 trials), the same results. Their libraries hold machine code too, so that all other programs
# link without it, in a fiftieth of the time.
set(TWIDDLE_LINK_TIME $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-flto=auto>)

# GCC optimises at link time whenever an object offers it, unless told not to.
define_property(TARGET PROPERTY TWIDDLE_LINK_TIME_PROGRAM BRIEF_DOCS "Whether a program is optimised at link time")
set(other_program $<NOT:$<BOOL:$<TARGET_PROPERTY:TWIDDLE_LINK_TIME_PROGRAM>>>)
add_link_options($<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>,${other_program}>:-fno-lto>)

function(twiddle_link_time_library target)
  target_compile_options(${target} PRIVATE ${TWIDDLE_LINK_TIME}
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-ffat-lto-objects>)
endfunction()

function(twiddle_link_time_program target)
  target_compile_options(${target} PRIVATE ${TWIDDLE_LINK_TIME})
  # Two types of one name, such as those of two builds of the C libraries, are an error.
  target_link_options(${target} PRIVATE ${TWIDDLE_LINK_TIME}
    "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Werror=odr;-Werror=lto-type-mismatch>")
  set_target_properties(${target} PROPERTIES TWIDDLE_LINK_TIME_PROGRAM ON)
endfunction()
