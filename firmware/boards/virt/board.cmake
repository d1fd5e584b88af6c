twiddle_board(virt CORE RV32IMAC
  SOURCES boards/virt/startup.c support/memory.c support/semihosting.c
  LINK_OPTIONS -nostartfiles -T link.ld)
