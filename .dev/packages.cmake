# What the packages of ./dev packages hold, beside the library (core/CMakeLists.txt), and how CPack makes a Debian package of the program.
if(EMSCRIPTEN)
  file(WRITE "${PROJECT_BINARY_DIR}/compiler.txt" "Emscripten ${EMSCRIPTEN_VERSION}, ${CMAKE_CXX_COMPILER_ID}\n")
endif()
if(CMAKE_CROSSCOMPILING)
  return()
endif()

install(TARGETS gaitsmith RUNTIME DESTINATION bin COMPONENT program)
file(GLOB documents CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/*.json)
install(FILES ${documents} DESTINATION share/doc/gaitsmith/examples COMPONENT program)
install(FILES examples/hello_figure.cpp DESTINATION share/doc/gaitsmith/examples COMPONENT library)
# Licences, notices and the manual page are written where they are installed.
foreach(component library program)
  install(CODE "execute_process(COMMAND \"${NODE_PROGRAM}\" \"${PROJECT_SOURCE_DIR}/web/package/texts.mjs\" ${component} \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\" COMMAND_ERROR_IS_FATAL ANY)"
    COMPONENT ${component})
endforeach()

# Debian's name of the processor. Programs for other systems have the system's name before it.
set(architecture ${CMAKE_SYSTEM_PROCESSOR})
string(REGEX REPLACE "^(x86_64|AMD64)$" amd64 architecture ${architecture})
string(REGEX REPLACE "^aarch64$" arm64 architecture ${architecture})
if(NOT CMAKE_SYSTEM_NAME STREQUAL Linux)
  string(TOLOWER "${CMAKE_SYSTEM_NAME}-${architecture}" architecture)
endif()

set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};gaitsmith;program;/")
set(CPACK_PACKAGE_NAME gaitsmith)
set(CPACK_PACKAGE_FILE_NAME gaitsmith_${PROJECT_VERSION}_${architecture})
set(CPACK_PACKAGE_VENDOR "The Gaitsmith authors")
set(CPACK_PACKAGE_CONTACT "The Gaitsmith authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${architecture})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "The command line: it finds motions of figures, plays, measures and exports them.")
include(CPack)

# For PROVENANCE.json.
file(WRITE "${PROJECT_BINARY_DIR}/compiler.txt" "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${architecture}\n")
