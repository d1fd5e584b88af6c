# What the Cortex-M boards share.
twiddle_board(${TWIDDLE_BOARD}
  SOURCES boards/cortex-m/startup.c support/memory.c support/semihosting.c
  LINK_OPTIONS -nostartfiles -T link.ld)
