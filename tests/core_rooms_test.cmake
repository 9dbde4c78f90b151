# The rooms of core, and the other rooms that each may include. A room may only name rooms before it in the list, so
# there are no cycles. Fails on any other include between rooms, and on a folder of core that is not in the list.
#   cmake -DROOT=<repository> -P core_rooms_test.cmake
cmake_policy(VERSION 3.25)
set(rooms
  "runtime  ->"
  "numeric  ->"
  "world    -> numeric"
  "signal   -> numeric world"
  "control  -> numeric world signal"
  "physics  -> numeric signal world"
  "springs  -> numeric signal world physics"
  "spacetime -> numeric signal world physics"
  "rollout  -> numeric signal control world physics springs"
  "kinematics -> numeric control world physics springs rollout"
  "search   -> numeric signal control rollout"
  "evolution -> numeric signal control search"
  "document -> numeric signal control world physics spacetime rollout search"
  "planning -> numeric signal control world physics spacetime rollout kinematics document"
  "gait     -> numeric world kinematics document"
  "breeding -> numeric signal control rollout document search")

set(faults "")
set(known "")
foreach(line IN LISTS rooms)
  string(REGEX MATCHALL "[a-z]+" names "${line}")
  list(POP_FRONT names room)
  foreach(name IN LISTS names)
    if(NOT name IN_LIST known)
      string(APPEND faults "\n${room} may not name ${name}, which does not stand above it in the list")
    endif()
  endforeach()
  list(APPEND known ${room})
  set(allowed_${room} ${room} ${names})
endforeach()

file(GLOB_RECURSE files RELATIVE ${ROOT}/core ${ROOT}/core/*.h ${ROOT}/core/*.cpp)
set(includes_seen 0)
foreach(file IN LISTS files)
  string(REGEX MATCH "^[^/]+" room "${file}")
  if(NOT room IN_LIST known)
    string(APPEND faults "\ncore/${file} is in no room of the list")
    continue()
  endif()
  file(STRINGS ${ROOT}/core/${file} includes REGEX "^[ \t]*#[ \t]*include[ \t]+\"")
  foreach(include IN LISTS includes)
    math(EXPR includes_seen "${includes_seen} + 1")
    if(NOT include MATCHES "\"core/([a-z_]+)/" OR NOT CMAKE_MATCH_1 IN_LIST allowed_${room})
      string(APPEND faults "\ncore/${file}: ${include}")
    endif()
  endforeach()
endforeach()

if(includes_seen LESS 100)
  message(FATAL_ERROR "only ${includes_seen} includes found: the pattern no longer fits")
endif()
if(faults)
  message(FATAL_ERROR "includes between rooms of core that are not allowed:${faults}")
endif()
