# Arm Cortex-M7 with the double-precision FPU.
include(${CMAKE_CURRENT_LIST_DIR}/cortex-m.cmake)
set(CMAKE_C_FLAGS_INIT "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16")
