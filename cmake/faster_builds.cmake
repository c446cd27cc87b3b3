# What makes builds of this project itself fast.

# The headers that most files of a target include, parsed once. tests/consumer builds the library
# without them, which finds missing includes.
set(ISOMATCH_COMMON_HEADERS
    <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <filesystem> <fmt/format.h> <functional>
    <numeric> <optional> <span> <string> <string_view> <utility> <vector>)
set(ISOMATCH_PROGRAM_HEADERS ${ISOMATCH_COMMON_HEADERS} <CLI/CLI.hpp>)
set(ISOMATCH_RESULT_HEADERS ${ISOMATCH_COMMON_HEADERS} <nlohmann/json.hpp>)
set(ISOMATCH_TOOL_HEADERS ${ISOMATCH_PROGRAM_HEADERS} <nlohmann/json.hpp>)
set(ISOMATCH_PYTHON_HEADERS
    ${ISOMATCH_COMMON_HEADERS} <pybind11/numpy.h> <pybind11/stl.h>)
set(ISOMATCH_TEST_HEADERS ${ISOMATCH_COMMON_HEADERS} <gmock/gmock.h> <gtest/gtest.h>)

# The same object files for every checkout of the sources, wherever it lies.
find_program(ISOMATCH_CCACHE ccache)
set(ISOMATCH_CCACHE_SETTINGS
    CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime)
if(PROJECT_IS_TOP_LEVEL AND ISOMATCH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env ${ISOMATCH_CCACHE_SETTINGS} ${ISOMATCH_CCACHE})
endif()

# Code that is not worth optimising much: the library is what runs long.
function(isomatch_compile_quickly)
  add_compile_options($<$<CONFIG:RelWithDebInfo,Release>:-O1>)
endfunction()
