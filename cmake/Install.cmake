# `cmake --install`: the C libraries of every number type, their headers, a CMake package (find_package(twiddle)) and
# pkg-config files. Both kinds find their files from where they lie, so an installed tree may be moved as a whole.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/twiddle)
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# twiddle_pkgconfig(NAME DESCRIPTION REQUIRES CFLAGS LIBS): writes and installs NAME.pc.
function(twiddle_pkgconfig name description requires cflags libs)
  set(PC_NAME ${name})
  set(PC_DESCRIPTION ${description})
  set(PC_REQUIRES ${requires})
  set(PC_CFLAGS ${cflags})
  set(PC_LIBS ${libs})
  file(RELATIVE_PATH PC_PREFIX /${pkgconfig_dir} /)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/twiddle.pc.in ${PROJECT_BINARY_DIR}/pkgconfig/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/${name}.pc DESTINATION ${pkgconfig_dir})
endfunction()

foreach(number IN LISTS TWIDDLE_NUMBERS)
  twiddle_number_suffix(suffix ${number})
  install(TARGETS twiddle_controller${suffix} twiddle_learner${suffix} EXPORT twiddle-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})

  string(REPLACE "_" "-" dashed "${suffix}")
  string(TOUPPER ${number} number_upper)
  twiddle_pkgconfig(twiddle-controller${dashed} "Rhythmic hand skills: the controller, numbers in ${number}" ""
    "-I\${includedir} -DTWD_NUMBER_${number_upper}" "-L\${libdir} -ltwiddle_controller${suffix}")
  twiddle_pkgconfig(twiddle-learner${dashed} "Rhythmic hand skills: the learner, numbers in ${number}"
    "twiddle-controller${dashed} = ${PROJECT_VERSION}" "" "-L\${libdir} -ltwiddle_learner${suffix}")
  twiddle_pkgconfig(twiddle${dashed} "Rhythmic hand skills: controller and learner, numbers in ${number}"
    "twiddle-learner${dashed} = ${PROJECT_VERSION}, twiddle-controller${dashed} = ${PROJECT_VERSION}" "" "")
endforeach()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/controller/include/ ${PROJECT_SOURCE_DIR}/learner/include/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")

install(EXPORT twiddle-targets NAMESPACE twiddle:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/twiddle-config.cmake.in
  ${PROJECT_BINARY_DIR}/twiddle-config.cmake INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Before 1.0 a minor version may break what a user relies on.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/twiddle-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/twiddle-config.cmake ${PROJECT_BINARY_DIR}/twiddle-config-version.cmake
  DESTINATION ${package_dir})
