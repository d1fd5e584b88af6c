# RISC-V RV32IMAC: multiplication and division, no FPU; picolibc is the C library.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY) # the compiler's own start-up knows no board
set(CMAKE_C_FLAGS_INIT "-march=rv32imac -mabi=ilp32 -mcmodel=medany --specs=picolibc.specs")
# For the two libraries alone: fewer registers are saved, a hundredth of a tick.
set(TWIDDLE_LIBRARY_TUNING -fno-schedule-insns)
