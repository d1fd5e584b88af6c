# Start-up and linker script are avr-libc's.
twiddle_board(atmega1284p CORE AVR SOURCES boards/atmega1284p/board.c)
