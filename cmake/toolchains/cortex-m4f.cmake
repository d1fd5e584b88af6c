# Arm Cortex-M4 with its single-precision FPU.
include(${CMAKE_CURRENT_LIST_DIR}/cortex-m.cmake)
set(CMAKE_C_FLAGS_INIT "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16")
