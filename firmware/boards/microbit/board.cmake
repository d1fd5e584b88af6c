include(boards/cortex-m/board.cmake)
twiddle_cortex_m(microbit Cortex-M0+)
