# `cpack` in the build folder makes the package heft, with heft-studio where it was built, and python3-heft where the Python
# module was. The programs find their data beside
# themselves, so the build needs no prefix.
set(doc ${CMAKE_INSTALL_DATADIR}/doc/heft)
if(HEFT_WITH_GUI)
  set(HEFT_BINARY_LICENCE "Apache-2.0, and GPL-3+ for the binary heft-studio, which links QCustomPlot")
else()
  set(HEFT_BINARY_LICENCE "Apache-2.0")
endif()
string(TIMESTAMP HEFT_CHANGELOG_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright.in copyright @ONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in changelog @ONLY)
find_program(HEFT_GZIP gzip)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/copyright DESTINATION ${doc})
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${doc})
if(HEFT_GZIP)
  # -n: the same bytes from the same text.
  execute_process(COMMAND ${HEFT_GZIP} -9nc ${CMAKE_CURRENT_BINARY_DIR}/changelog
                  OUTPUT_FILE ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz DESTINATION ${doc})
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME heft)
set(CPACK_PACKAGE_VENDOR "Heft developers")
set(CPACK_PACKAGE_CONTACT "Heft developers <heft@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "payload mass, centre of mass and inertia from robot recordings")
set(CPACK_PACKAGE_DESCRIPTION
"Heft finds out what a robot arm carries: how heavy it is, where its centre
of mass lies and how it resists being turned. It reads recordings of the
arm's motion and of a force/torque sensor at the wrist, gives every number
with a 95 % interval, and writes the payload file that the controller reads.")
if(HEFT_WITH_GUI)
  string(APPEND CPACK_PACKAGE_DESCRIPTION "\n\nThis package holds the command line, heft, and the desktop program,\nheft-studio.")
  # heft-studio --offscreen starts Xvfb, which draws with Mesa.
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "xvfb, libgl1-mesa-dri, fonts-inter")
endif()
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# Everything but the library for other programs, which is not of use without a compiler.
set(CPACK_COMPONENTS_ALL Unspecified)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME heft)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Those that programs load at their first use are not among what they link to.
get_property(on_demand GLOBAL PROPERTY HEFT_PACKAGES_ON_DEMAND)
list(REMOVE_DUPLICATES on_demand)
list(JOIN on_demand ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
if(HEFT_WITH_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-heft)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "heft (= ${PROJECT_VERSION}), python3, python3-numpy, ${CPACK_DEBIAN_PACKAGE_DEPENDS}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-matplotlib)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Heft as a Python module: import heft")
endif()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
