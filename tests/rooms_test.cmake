# The rooms in shell/ and web/, and which rooms each may use: only rooms before it here, so there are no cycles. Fails
# on an include or import that is not in these tables, on an entry that no file needs, on a file outside all rooms, and on
# a room that does not exist.
#   cmake -DROOT=<repository> -P rooms_test.cmake
cmake_policy(VERSION 3.25)

# room: rooms it may use
set(shell_rooms
    "embedded:"
    "search:"
    "study:"
    "body:"
    "export: body"
    "words:"
    "workspace: embedded search words"
    "results: search study words workspace"
    "session: embedded words workspace results"
    "catalogue: embedded export words workspace"
    "command_line: embedded search study export words catalogue"
    "python: search study export catalogue command_line"
    "widgets: embedded export words"
    "stage: body words session widgets"
    "timeline: words session widgets"
    "panels/figure: words session widgets stage"
    "panels/controller: words session widgets stage"
    "panels/style: words session widgets stage"
    "panels/search: words results session widgets stage timeline"
    "panels/make: words session widgets stage"
    "panels/lab: words session widgets"
    "panels/keyframes: words session widgets stage"
    "app: words workspace session widgets stage timeline panels/figure panels/controller panels/style panels/search panels/make panels/lab panels/keyframes"
    "host: embedded search catalogue words workspace results session app")
set(web_rooms
    "browser:"
    "catalogue:"
    "runtime:"
    "languages: browser catalogue"
    "app: browser languages"
    "access: browser languages"
    "search: browser catalogue languages app"
    "plan: browser"
    "storage: browser languages"
    "dialogs: languages"
    "share: browser catalogue languages search dialogs"
    "build: share"
    "breed: browser languages search dialogs share"
    "page: browser catalogue languages app access search plan storage dialogs share breed"
    "classroom: catalogue languages search share page"
    "explorable: languages search share"
    "book: catalogue languages search share storage page classroom explorable"
    "package: build share")
# Rooms that never include a window's libraries, because the session's tests run without a window. They use only one
# another.
set(windowless embedded search study export body words workspace results session catalogue command_line python)

set(faults "")
macro(fault text)
  string(APPEND faults "\n${text}")
endmacro()

# Sets `result` to the room that contains a path, or to nothing.
function(room_of path rooms result)
  set(${result} "" PARENT_SCOPE)
  foreach(room IN LISTS rooms)
    if(path MATCHES "^${room}/")
      set(${result} ${room} PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

foreach(top shell web)
  set(names "")
  foreach(line IN LISTS ${top}_rooms)
    string(REGEX MATCH "^([a-z_/]+): *(.*)$" _ "${line}")
    set(name ${CMAKE_MATCH_1})
    string(REPLACE " " ";" uses "${CMAKE_MATCH_2}")
    foreach(use IN LISTS uses)
      if(NOT use IN_LIST names)
        fault("${top}/${name} uses ${use}, which does not stand above it in the table")
      endif()
      if(top STREQUAL "shell" AND name IN_LIST windowless AND NOT use IN_LIST windowless)
        fault("${top}/${name} uses ${use}, which may include a window's library")
      endif()
    endforeach()
    if(NOT IS_DIRECTORY ${ROOT}/${top}/${name})
      fault("there is no room ${top}/${name}")
    endif()
    list(APPEND names ${name})
    set(${top}_uses_${name} ${uses})
  endforeach()

  file(GLOB_RECURSE files RELATIVE ${ROOT}/${top} ${ROOT}/${top}/*.h ${ROOT}/${top}/*.cpp ${ROOT}/${top}/*.js ${ROOT}/${top}/*.mjs)
  list(FILTER files EXCLUDE REGEX "node_modules/")
  foreach(file IN LISTS files)
    room_of(${file} "${names}" room)
    if(room STREQUAL "" AND NOT file STREQUAL "engine.js") # at the root, because programs outside know its address
      fault("${top}/${file} lies in no room")
    endif()
    if(file MATCHES "\\.(js|mjs)$")
      file(READ ${ROOT}/${top}/${file} text)
      string(REGEX REPLACE "/\\*[^*]*\\*+([^/*][^*]*\\*+)*/" "" text "${text}") # types in comments are not dependencies
      string(REGEX MATCHALL "(from|import|import\\() ?'\\.[^']*'" arrows "${text}")
    else()
      file(STRINGS ${ROOT}/${top}/${file} arrows REGEX "^[ \t]*#[ \t]*include")
      if(room IN_LIST windowless AND arrows MATCHES "imgui|SDL|GLES")
        fault("${top}/${file} includes a window's library")
      endif()
    endif()
    foreach(arrow IN LISTS arrows)
      set(target "")
      if(arrow MATCHES "'(\\.[^']*)'")
        set(target ${CMAKE_MATCH_1})
        cmake_path(GET file PARENT_PATH folder)
        cmake_path(ABSOLUTE_PATH target BASE_DIRECTORY /${folder} NORMALIZE)
        string(SUBSTRING ${target} 1 -1 target)
      elseif(arrow MATCHES "\"${top}/([^\"]*)\"")
        set(target ${CMAKE_MATCH_1})
      endif()
      if(NOT target STREQUAL "")
        room_of(${target} "${names}" reached)
        list(APPEND ${top}_reached_${room} "${reached}")
        if(NOT reached STREQUAL room AND NOT reached IN_LIST ${top}_uses_${room} AND NOT room STREQUAL "")
          fault("${top}/${file} reaches ${target}: ${room} may use ${${top}_uses_${room}}")
        endif()
      endif()
    endforeach()
  endforeach()
  foreach(name IN LISTS names)
    foreach(use IN LISTS ${top}_uses_${name})
      if(NOT use IN_LIST ${top}_reached_${name})
        fault("${top}/${name} may use ${use}, but no file of it does")
      endif()
    endforeach()
  endforeach()
endforeach()

if(faults)
  message(FATAL_ERROR "walls between rooms:${faults}")
endif()
