# Arm Cortex-M0+ (Armv6-M): no FPU, no division, no 32x32->64 multiplication. Runs on a Cortex-M0, too.
include(${CMAKE_CURRENT_LIST_DIR}/cortex-m.cmake)
set(CMAKE_C_FLAGS_INIT "-mcpu=cortex-m0plus -mthumb -mfloat-abi=soft")
