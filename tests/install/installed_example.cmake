# Installs a build to a temporary prefix, then builds and runs the installed example of the engine and a program for each
# other component (components/) against it, asks the installed program for its sample tools, and imports the Python
# package: what `cmake --install` gives is enough. Needs BUILD and SOURCE, and everything built.
set(work ${BUILD}/installed_example)
set(prefix ${work}/prefix)
set(samples ${prefix}/share/diefill/sample_tools)
file(REMOVE_RECURSE ${work})
function(do)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  set(said "${said}" PARENT_SCOPE)
endfunction()
# The same, and that the output matches `wanted`.
function(expect wanted)
  do(${ARGN})
  if(NOT said MATCHES "${wanted}")
    message(FATAL_ERROR "not \"${wanted}\": ${said}")
  endif()
endfunction()

set(components program development)
file(GLOB python_module ${BUILD}/python/diefill/_results*.so)
if(python_module)
  list(APPEND components python)
endif()
foreach(component ${components})
  do(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component ${component})
endforeach()
foreach(file share/man/man1/diefill.1 share/bash-completion/completions/diefill share/zsh/vendor-completions/_diefill
    share/diefill/README.md share/diefill/process/scene/README.md share/diefill/process/estimate/against_runs.csv
    share/diefill/process/plan/grain_size_errors.csv share/doc/diefill/copyright share/doc/libdiefill-dev/copyright)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

# What is built here again and again comes from the compiler cache, where there is one.
find_program(ccache ccache)
set(cached "")
if(ccache)
  set(cached -DCMAKE_CXX_COMPILER_LAUNCHER=${ccache})
  set(ENV{CCACHE_BASEDIR} ${SOURCE})
  set(ENV{CCACHE_NOHASHDIR} 1)
endif()

# Headers name each other as users do.
file(GLOB_RECURSE headers ${prefix}/include/*.h)
foreach(header ${headers})
  file(STRINGS ${header} wrong REGEX "#include \"(engine|geometry|process)/")
  if(wrong)
    message(FATAL_ERROR "${header}: ${wrong}")
  endif()
endforeach()
do(${CMAKE_COMMAND} -S ${samples}/library -B ${work}/library -DCMAKE_PREFIX_PATH=${prefix} ${cached})
do(${CMAKE_COMMAND} --build ${work}/library)
expect("360 clumps, coordination number [3-9]\\." ${work}/library/coordination)

set(sources ${SOURCE}/tests/install/components)
do(${CMAKE_COMMAND} -S ${sources} -B ${work}/components -DCMAKE_PREFIX_PATH=${prefix} ${cached})
do(${CMAKE_COMMAND} --build ${work}/components)
expect("^1791\\.6 mm\\^3" ${work}/components/use_geometry ${samples}/rectangular_die/punch.stl)
expect("^[0-9.]+ mm\\^3" ${work}/components/use_geometry ${samples}/shoe/shoe.step)
expect("^1 passage at 0\\.2 m/s" ${work}/components/use_process ${samples}/rectangular_die/fill.toml)
expect("no such results file" ${work}/components/use_results ${samples})
# CMake enables no language within a function: the package says so.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${sources} -B ${work}/function -DCMAKE_PREFIX_PATH=${prefix} -DIN_FUNCTION=ON
  RESULT_VARIABLE refused OUTPUT_QUIET ERROR_VARIABLE said)
if(NOT refused OR NOT said MATCHES "need the language C")
  message(FATAL_ERROR "found within a function without C: ${said}")
endif()

# Away from the source tree.
expect("silo" ${CMAKE_COMMAND} -E chdir ${prefix} bin/diefill lab --list)
do(${prefix}/bin/diefill new ${work}/my_die --kind ring)
if(python_module)
  find_program(python python3 PATHS /usr/bin NO_DEFAULT_PATH) # as in app/python
  find_program(python python3 REQUIRED)
  expect("^diefill [0-9.]+" ${CMAKE_COMMAND} -E chdir ${work} ${CMAKE_COMMAND} -E env --unset=DIEFILL_PROGRAM
    PYTHONPATH=${prefix}/lib/python3/dist-packages ${python} -B -c "print(__import__('diefill').version())")
endif()
file(REMOVE_RECURSE ${work})
