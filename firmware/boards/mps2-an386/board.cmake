include(boards/cortex-m/board.cmake)
twiddle_cortex_m(mps2-an386 Cortex-M4F)
