# One precompiled header for all C++ test programs: GoogleTest, JSON and the standard headers take half of what they
# compile.
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp CONTENT "")
add_library(twiddle_gtest_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp)
target_link_libraries(twiddle_gtest_headers PRIVATE GTest::gtest nlohmann_json::nlohmann_json)
target_precompile_headers(twiddle_gtest_headers PRIVATE
  <gtest/gtest.h> <nlohmann/json.hpp>
  <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <random> <sstream> <string> <vector>)

# Tests check; what runs long, they call in libraries, which are optimised.
set(TWIDDLE_GTEST_OPTIONS $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CONFIG:Release>>:-Og>)
target_compile_options(twiddle_gtest_headers PRIVATE ${TWIDDLE_GTEST_OPTIONS})

# twiddle_gtest_program(TARGET SOURCES... LIBRARIES... PREFIX TEXT. SUFFIX .NUMBER PROPERTIES...): a GoogleTest program,
# whose tests become ctest's one by one, named with prefix and suffix. They are looked up when ctest runs. Helpers in
# tests/harness are found by name.
function(twiddle_gtest_program target)
  cmake_parse_arguments(ARG "" "PREFIX;SUFFIX" "SOURCES;LIBRARIES;PROPERTIES" ${ARGN})
  add_executable(${target} ${ARG_SOURCES})
  twiddle_c_target(${target})
  twiddle_cxx_target(${target})
  target_compile_options(${target} PRIVATE ${TWIDDLE_GTEST_OPTIONS})
  target_precompile_headers(${target} REUSE_FROM twiddle_gtest_headers)
  list(FILTER ARG_SOURCES INCLUDE REGEX "[.]c$")
  set_source_files_properties(${ARG_SOURCES} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/harness)
  target_compile_definitions(${target} PRIVATE TWIDDLE_MODELS="${PROJECT_SOURCE_DIR}/models"
    TWIDDLE_SETUPS="${PROJECT_SOURCE_DIR}/experiments/setups"
    TWIDDLE_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/harness/data")
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} GTest::gtest_main)
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST TEST_PREFIX "${ARG_PREFIX}" TEST_SUFFIX "${ARG_SUFFIX}"
    PROPERTIES ${ARG_PROPERTIES})
endfunction()
