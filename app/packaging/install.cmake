# What `cmake --install` puts where: the program with its pages and sample tools, and the libraries for other projects.
# Components: program, development, python (python/CMakeLists.txt).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(DIEFILL_SHARE ${CMAKE_INSTALL_DATADIR}/diefill)
set(DIEFILL_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/diefill)

# Files of the tree, relative to its top, below `destination` in the same folders.
function(diefill_install_tree component destination)
  foreach(file ${ARGN})
    get_filename_component(folder ${file} DIRECTORY)
    install(FILES ${CMAKE_SOURCE_DIR}/${file} DESTINATION ${destination}/${folder} COMPONENT ${component})
  endforeach()
endfunction()

# The program finds its sample tools beside it: bin/../share/diefill/sample_tools (process/input/sample_tools.h).
install(TARGETS diefill RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS diefill_opencascade LIBRARY DESTINATION lib/diefill COMPONENT program)
if(TARGET diefill-mpi) # which diefill starts from beside itself
  install(TARGETS diefill-mpi RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ranks) # in no package: its licence
endif()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/sample_tools DESTINATION ${DIEFILL_SHARE} COMPONENT program
  PATTERN "*.cpp" EXCLUDE PATTERN "library" EXCLUDE PATTERN "__pycache__" EXCLUDE)
diefill_install_tree(development ${DIEFILL_SHARE}
  sample_tools/library/CMakeLists.txt sample_tools/library/coordination.cpp)
diefill_install_tree(program ${DIEFILL_SHARE} README.md CHANGELOG.md CITATION.cff LICENSE)
foreach(folder engine geometry process render app tests)
  file(GLOB_RECURSE pages RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS
    ${CMAKE_SOURCE_DIR}/${folder}/*.md ${CMAKE_SOURCE_DIR}/${folder}/*.png ${CMAKE_SOURCE_DIR}/${folder}/*.csv)
  diefill_install_tree(program ${DIEFILL_SHARE} ${pages})
endforeach()

# The program writes its manual page and shell completion itself, so that they list the options that it has: into a
# temporary folder, so that an installation as root leaves nothing in the build.
install(CODE "
  execute_process(COMMAND mktemp -d OUTPUT_VARIABLE written OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  function(install_written file folder)
    execute_process(COMMAND \"$<TARGET_FILE:diefill>\" \${ARGN} OUTPUT_FILE \"\${written}/\${file}\"
      COMMAND_ERROR_IS_FATAL ANY)
    file(INSTALL \"\${written}/\${file}\" DESTINATION \"\${CMAKE_INSTALL_PREFIX}/\${folder}\")
  endfunction()
  install_written(diefill.1 \"${CMAKE_INSTALL_MANDIR}/man1\" --man)
  install_written(diefill \"${CMAKE_INSTALL_DATADIR}/bash-completion/completions\" --completion bash)
  install_written(_diefill \"${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions\" --completion zsh)
  file(REMOVE_RECURSE \"\${written}\")" COMPONENT program)

# Libraries. Headers lie in include/diefill and name each other in the tree as "engine/...": installed they say
# "diefill/engine/...", as users do, so that the path of who links holds no folder of the name engine or process.
foreach(folder engine geometry process)
  file(GLOB_RECURSE headers RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.h)
  diefill_install_tree(development ${CMAKE_INSTALL_INCLUDEDIR}/diefill ${headers})
endforeach()
install(CODE "
  file(GLOB_RECURSE headers \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/diefill/*.h\")
  foreach(header IN LISTS headers)
    file(READ \"\${header}\" text)
    string(REGEX REPLACE \"(#include \\\")(engine|geometry|process)/\" \"\\\\1diefill/\\\\2/\" text \"\${text}\")
    file(WRITE \"\${header}\" \"\${text}\")
  endforeach()" COMPONENT development)
foreach(library engine geometry results calibration_methods process)
  set_target_properties(diefill_${library} PROPERTIES EXPORT_NAME ${library})
  target_include_directories(diefill_${library} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(diefill_${library} INTERFACE cxx_std_20)
  install(TARGETS diefill_${library} EXPORT diefill_${library}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT diefill_${library} NAMESPACE diefill:: FILE ${library}.cmake DESTINATION ${DIEFILL_PACKAGE}
    COMPONENT development)
endforeach()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/diefill-config.cmake.in
  ${CMAKE_BINARY_DIR}/diefill-config.cmake INSTALL_DESTINATION ${DIEFILL_PACKAGE})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/diefill-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/diefill-config.cmake ${CMAKE_BINARY_DIR}/diefill-config-version.cmake
  DESTINATION ${DIEFILL_PACKAGE} COMPONENT development)

# Every Debian package has to hold its licence.
foreach(package "program diefill" "development libdiefill-dev" "python python3-diefill")
  separate_arguments(package)
  list(POP_FRONT package component)
  if(NOT component STREQUAL "python" OR TARGET _results)
    install(FILES ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
      COMPONENT ${component})
  endif()
endforeach()
