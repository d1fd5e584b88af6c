include(boards/cortex-m/board.cmake)
