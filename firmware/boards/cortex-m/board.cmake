# twiddle_cortex_m(NAME CORE): a board with a Cortex-M, whose link.ld names its memories.
function(twiddle_cortex_m name core)
  twiddle_board(${name} CORE ${core}
    SOURCES boards/cortex-m/startup.c boards/cortex-m/newlib.c support/memory.c support/semihosting.c
    LINK_OPTIONS -nostartfiles -T link.ld)
  set(TWIDDLE_CORE ${TWIDDLE_CORE} PARENT_SCOPE)
endfunction()
