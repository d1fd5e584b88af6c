# The warnings that every source of ours compiles under, as errors.
set(TWIDDLE_C_WARNINGS -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror)
set(TWIDDLE_CXX_WARNINGS -Wall -Wextra -Wshadow -Werror)

# twiddle_c_target(TARGET) and twiddle_cxx_target(TARGET): our warnings, nobody else's.
function(twiddle_c_target target)
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:C>:${TWIDDLE_C_WARNINGS}>)
endfunction()

function(twiddle_cxx_target target)
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:${TWIDDLE_CXX_WARNINGS}>)
endfunction()
