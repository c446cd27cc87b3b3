# A test a suite: what a suite prepares for all of its cases is prepared once, and a process is not
# started for every case. Waiting threads give way to other tests instead of spinning.
function(add_gtest_suites target)
  set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
  add_custom_command(TARGET ${target} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${target}> -DLIST=${list}
      -P ${PROJECT_SOURCE_DIR}/cmake/list_gtest_suites.cmake
    COMMENT "Listing the suites of ${target}" VERBATIM)
  if(NOT EXISTS ${list})
    file(WRITE ${list} "add_test(${target}.is_built ${target}.is_not_built)\n")
  endif()
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${list})
endfunction()
