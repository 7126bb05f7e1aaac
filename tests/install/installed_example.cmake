# Installs a build to a temporary prefix, then builds and runs sample_tools/library against it, and asks the installed
# program for its sample tools: what `cmake --install` gives is enough. Needs BUILD and SOURCE, and everything built.
set(work ${BUILD}/installed_example)
set(prefix ${work}/prefix)
file(REMOVE_RECURSE ${work})
function(do)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  set(said "${said}" PARENT_SCOPE)
endfunction()

foreach(component program development)
  do(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component ${component})
endforeach()
do(${CMAKE_COMMAND} -S ${SOURCE}/sample_tools/library -B ${work}/library -DCMAKE_PREFIX_PATH=${prefix})
do(${CMAKE_COMMAND} --build ${work}/library)
do(${work}/library/coordination)
if(NOT said MATCHES "360 clumps, coordination number [3-9]\\.")
  message(FATAL_ERROR "the example says: ${said}")
endif()

# Away from the source tree, which the program would find as well.
do(${CMAKE_COMMAND} -E chdir ${prefix} bin/diefill lab --list)
if(NOT said MATCHES "silo")
  message(FATAL_ERROR "the installed program does not find the laboratory: ${said}")
endif()
do(${prefix}/bin/diefill new ${work}/my_die --kind ring)
foreach(file share/man/man1/diefill.1 share/bash-completion/completions/diefill share/zsh/vendor-completions/_diefill
    share/diefill/README.md share/diefill/process/scene/README.md share/diefill/process/estimate/against_runs.csv
    share/diefill/process/plan/grain_size_errors.csv)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()
file(REMOVE_RECURSE ${work})
