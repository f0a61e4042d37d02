# find_package(heft): every library of core as heft::NAME (heft::estimation, ...), headers as "core/NAME/....h".
include(CMakePackageConfigHelpers)
get_property(libraries GLOBAL PROPERTY HEFT_CORE_LIBRARIES)
foreach(target IN LISTS libraries)
  string(REGEX REPLACE "^heft_" "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/heft>)
  target_compile_features(${target} INTERFACE cxx_std_20)
endforeach()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/heft)
install(TARGETS ${libraries} EXPORT heftTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT heftTargets NAMESPACE heft:: DESTINATION ${package_folder} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/heft COMPONENT development
        FILES_MATCHING PATTERN "*.h")
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/heftConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/heftConfig.cmake
                              INSTALL_DESTINATION ${package_folder} PATH_VARS HEFT_ON_DEMAND)
# Before 1.0 every minor version may break programs.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/heftConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/heftConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/heftConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)
