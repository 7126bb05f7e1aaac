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
if(TARGET diefill-mpi) # which diefill starts from beside itself
  install(TARGETS diefill-mpi RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ranks) # in no package: its licence
endif()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/sample_tools DESTINATION ${DIEFILL_SHARE} COMPONENT program
  PATTERN "*.cpp" EXCLUDE PATTERN "CMakeLists.txt" EXCLUDE PATTERN "__pycache__" EXCLUDE)
diefill_install_tree(program ${DIEFILL_SHARE} README.md CHANGELOG.md CITATION.cff LICENSE)
foreach(folder engine geometry process render app tests)
  file(GLOB_RECURSE pages RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS
    ${CMAKE_SOURCE_DIR}/${folder}/*.md ${CMAKE_SOURCE_DIR}/${folder}/*.png ${CMAKE_SOURCE_DIR}/${folder}/*.csv)
  diefill_install_tree(program ${DIEFILL_SHARE} ${pages})
endforeach()

# The program writes its manual page and shell completion itself, so that they list the options that it has.
set(DIEFILL_WRITTEN ${CMAKE_BINARY_DIR}/written_by_program)
install(CODE "
  file(MAKE_DIRECTORY \"${DIEFILL_WRITTEN}\")
  foreach(page \"--man>diefill.1\" \"--completion bash>diefill\" \"--completion zsh>_diefill\")
    string(REPLACE \">\" \";\" parts \"\${page}\")
    list(GET parts 0 options)
    list(GET parts 1 file)
    separate_arguments(options)
    execute_process(COMMAND \"$<TARGET_FILE:diefill>\" \${options} OUTPUT_FILE \"${DIEFILL_WRITTEN}/\${file}\"
      COMMAND_ERROR_IS_FATAL ANY)
  endforeach()" COMPONENT program)
install(FILES ${DIEFILL_WRITTEN}/diefill.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${DIEFILL_WRITTEN}/diefill DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  COMPONENT program)
install(FILES ${DIEFILL_WRITTEN}/_diefill DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)

# Libraries. Headers lie in include/diefill and name each other as in the tree ("engine/..."), so both include/ and
# include/diefill are on the path of who links; users write <diefill/engine/...>.
foreach(folder engine geometry process)
  file(GLOB_RECURSE headers RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.h)
  diefill_install_tree(development ${CMAKE_INSTALL_INCLUDEDIR}/diefill ${headers})
endforeach()
foreach(library engine geometry results calibration_methods process)
  set_target_properties(diefill_${library} PROPERTIES EXPORT_NAME ${library})
  target_include_directories(diefill_${library} PUBLIC
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/diefill>)
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
