# SPDX-License-Identifier: BSD-3-Clause
# Installs contactsim, builds the example against what was installed, and runs it.
#   cmake -DBUILD_DIR=<of contactsim> -DEXAMPLE_DIR=<this folder> -DCOMPILER=<c++> -P build_and_run.cmake
cmake_minimum_required(VERSION 3.25)

set(work ${BUILD_DIR}/package_test)
file(REMOVE_RECURSE ${work})
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${work}/installed)
run(${CMAKE_COMMAND} -S ${EXAMPLE_DIR} -B ${work}/build -DCMAKE_PREFIX_PATH=${work}/installed
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/two_cubes)
run(${work}/installed/bin/contactsim --version)
