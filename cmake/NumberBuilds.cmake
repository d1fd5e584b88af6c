# One C library has one number type, so each is built once a type: twiddle_controller (float, the default),
# twiddle_controller_double, and so on. The type is a public compile definition of the target, and ends its symbols.

# twiddle_number_suffix(VARIABLE NUMBER): "" for float, "_NUMBER" otherwise.
function(twiddle_number_suffix variable number)
  if(number STREQUAL "float")
    set(${variable} "" PARENT_SCOPE)
  else()
    set(${variable} "_${number}" PARENT_SCOPE)
  endif()
endfunction()

# twiddle_c_library(NAME SOURCES... DEPENDS NAMES...): twiddle_NAME for every number type, with include/
# beside the caller.
function(twiddle_c_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  foreach(number IN LISTS TWIDDLE_NUMBERS)
    twiddle_number_suffix(suffix ${number})
    string(TOUPPER ${number} number_upper)
    set(target twiddle_${name}${suffix})
    add_library(${target} STATIC ${ARG_SOURCES})
    twiddle_c_target(${target})
    target_compile_options(${target} PRIVATE ${TWIDDLE_LIBRARY_TUNING}) # of a board's toolchain file
    target_include_directories(${target} PUBLIC
      $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_definitions(${target} PUBLIC TWD_NUMBER_${number_upper})
    foreach(dependency IN LISTS ARG_DEPENDS)
      target_link_libraries(${target} PUBLIC twiddle_${dependency}${suffix})
    endforeach()
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name}${suffix})
    add_library(twiddle::${name}${suffix} ALIAS ${target})
  endforeach()
endfunction()
