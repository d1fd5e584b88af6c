# Each public header is the only include of a source of its own, in C and in C++, under our warnings; that this links
# into one program is the test.
file(GLOB headers CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/controller/include/twiddle/*.h ${PROJECT_SOURCE_DIR}/learner/include/twiddle/*.h)
set(header_sources)
foreach(header IN LISTS headers)
  get_filename_component(name ${header} NAME_WE)
  foreach(language IN ITEMS c cpp)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/headers/${name}.${language})
    file(CONFIGURE OUTPUT ${source} CONTENT "#include <twiddle/${name}.h>\n\nextern int twd_compiles_alone;\n")
    list(APPEND header_sources ${source})
  endforeach()
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/headers/main.c CONTENT "int main(void)\n{\n    return 0;\n}\n")

foreach(number IN LISTS TWIDDLE_NUMBERS)
  twiddle_number_suffix(suffix ${number})
  add_executable(test_headers${suffix} ${CMAKE_CURRENT_BINARY_DIR}/headers/main.c ${header_sources})
  twiddle_c_target(test_headers${suffix})
  twiddle_cxx_target(test_headers${suffix})
  target_link_libraries(test_headers${suffix} PRIVATE twiddle_learner${suffix})
  add_test(NAME headers.compile_alone.${number} COMMAND test_headers${suffix})
  set_tests_properties(headers.compile_alone.${number} PROPERTIES LABELS "${number}")
endforeach()
