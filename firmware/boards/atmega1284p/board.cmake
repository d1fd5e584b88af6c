# Start-up and linker script are avr-libc's.
twiddle_board(atmega1284p CORE AVR SOURCES boards/atmega1284p/board.c)
# Its printf knows float only if asked.
set(TWIDDLE_PRINT_FLOATS -Wl,-u,vfprintf -lprintf_flt)
