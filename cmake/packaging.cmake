# `cpack -G DEB` in a build folder makes Debian packages of the program and of the library.
set(CPACK_PACKAGE_VENDOR "The isomatch authors")
set(CPACK_PACKAGE_CONTACT "The isomatch authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_COMPONENTS_GROUPING IGNORE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME isomatch)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "Dense correspondence between 3D shapes in different poses
 Finds, for every vertex of a triangle mesh, its place on another mesh of the
 same thing in a different pose. This package has the program isomatch.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libisomatch-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "g++, libeigen3-dev (>= 3.4), libfmt-dev, libglu1-mesa-dev, libmeshoptimizer-dev, libtinygltf-dev, libzip-dev, zlib1g-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "Dense correspondence between 3D shapes, C++ library
 This package has the static library isomatch, its headers, and what CMake and
 pkg-config need to find it.")
if(ISOMATCH_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-isomatch)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # What `python3 -m isomatch` runs.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS isomatch)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
      "Dense correspondence between 3D shapes, Python package
 This package has the Python module isomatch, for numpy arrays.")
endif()
include(CPack)
