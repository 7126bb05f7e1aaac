# Debian packages by CPack: `cpack --config build/CPackConfig.cmake -B build/packages`. Dependencies on shared libraries
# are found by dpkg-shlibdeps; those on files that are opened while the program runs stand here.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME diefill)
set(CPACK_PACKAGE_CONTACT "The diefill authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "predicts how powder fills a die")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Whatever the umask of who packs.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME diefill)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Density maps of filled dies from CAD tools and a short scene file, by a \
discrete element method\nwith coarse graining. Program, manual page, documentation and sample tools.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fonts-dejavu-core, libgl1-mesa-dri, libosmesa6")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libdiefill-dev)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Static libraries and headers of diefill, for find_package(diefill).")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "diefill (= ${PROJECT_VERSION}), libeigen3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "libtbb-dev, libboost-dev, libassimp-dev, libminizip-dev, libcgal-dev, libembree-dev, libhdf5-dev, \
libtomlplusplus-dev, nlohmann-json3-dev, lib3mf-dev, libudunits2-dev, voro++-dev, \
libnlopt-dev, zlib1g-dev")

if(TARGET _results)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-diefill)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python package of diefill: scenes run, results as NumPy arrays.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # The module is compiled for one version of Python.
  get_directory_property(major DIRECTORY ${CMAKE_SOURCE_DIR}/app/python DEFINITION Python3_VERSION_MAJOR)
  get_directory_property(minor DIRECTORY ${CMAKE_SOURCE_DIR}/app/python DEFINITION Python3_VERSION_MINOR)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "diefill (= ${PROJECT_VERSION}), python3 (>= ${major}.${minor}), \
python3 (<< ${major}.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib")
endif()
include(CPack)
