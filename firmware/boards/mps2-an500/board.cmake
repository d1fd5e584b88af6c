include(boards/cortex-m/board.cmake)
twiddle_cortex_m(mps2-an500 Cortex-M7)
