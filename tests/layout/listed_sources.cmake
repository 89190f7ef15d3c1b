# SPDX-License-Identifier: BSD-3-Clause
# Every source of a module is listed in the module's CMakeLists.txt, and every test source in that of the tests.
#   cmake -DSOURCE_DIR=<root> -P listed_sources.cmake

cmake_minimum_required(VERSION 3.25)

set(failures "")
function(check_listed folder list_file)
  file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR}/${folder} ${SOURCE_DIR}/${folder}/*.cpp)
  file(READ ${SOURCE_DIR}/${list_file} listing)
  foreach(file ${files})
    if(file MATCHES "^(bench|fuzz|package)/")
      continue()
    endif()
    string(FIND "${listing}" "${file}" place)
    if(place EQUAL -1)
      list(APPEND failures "${folder}/${file} is not listed in ${list_file}")
    endif()
  endforeach()
  set(failures "${failures}" PARENT_SCOPE)
endfunction()

foreach(folder core parser contact io app tests)
  check_listed(${folder} ${folder}/CMakeLists.txt)
endforeach()

if(failures)
  list(JOIN failures "\n  " text)
  message(FATAL_ERROR "sources that are not built:\n  ${text}")
endif()
