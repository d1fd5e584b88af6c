# Arm Cortex-M4 with its single-precision FPU.
include(${CMAKE_CURRENT_LIST_DIR}/cortex-m.cmake)
# Fused multiply-adds, which ISO C leaves to the compiler, save the float build a tenth; the fixed build has
# no use for them.
set(CMAKE_C_FLAGS_INIT "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -ffp-contract=fast")
# For the two libraries alone: fewer registers are busy in the loops over oscillators, which take 5 to 8 %
# fewer instructions.
set(TWIDDLE_LIBRARY_TUNING -fno-schedule-insns -fno-tree-pre -fno-ivopts -fira-region=mixed -fira-loop-pressure)
