# Dependencies go one way: shell, web, examples -> core -> Eigen, web -> shell/body and shell/export, which need no window,
# and examples -> shell/export. Fails
# on any other include, and on words in core that would bring in threads, clocks, files, printing, exceptions or the
# platform's own mathematics.
#   cmake -DROOT=<repository> -P layering_test.cmake
cmake_policy(VERSION 3.25)
set(faults "")

# Headers of the standard library that core may include. All others fail.
set(standard algorithm array bit charconv cmath concepts cstddef cstdint cstdlib expected functional initializer_list limits memory numeric optional
    span string string_view utility vector variant tuple type_traits map)

function(check_includes room allowed_rooms)
  file(GLOB_RECURSE files ${ROOT}/${room}/*.h ${ROOT}/${room}/*.cpp)
  foreach(file IN LISTS files)
    file(STRINGS ${file} includes REGEX "^[ \t]*#[ \t]*include")
    file(RELATIVE_PATH name ${ROOT} ${file})
    foreach(line IN LISTS includes)
      if(line MATCHES "\"(shell/body|shell/export|[a-z_]+)[/.]")
        if(NOT CMAKE_MATCH_1 IN_LIST allowed_rooms)
          set(faults "${faults}\n${name}: ${line}" PARENT_SCOPE)
          set(faults "${faults}\n${name}: ${line}")
        endif()
      endif()
      if(name STREQUAL "core/runtime/gaitsmith.h" AND line STREQUAL "#include <stddef.h>")
        continue() # C, and nothing but sizes
      endif()
      if(room STREQUAL "core" AND line MATCHES "<([^>]+)>")
        if(NOT CMAKE_MATCH_1 IN_LIST standard AND NOT CMAKE_MATCH_1 MATCHES "^Eigen/")
          set(faults "${faults}\n${name}: ${line}" PARENT_SCOPE)
          set(faults "${faults}\n${name}: ${line}")
        endif()
      endif()
    endforeach()
  endforeach()
endfunction()

check_includes(core "core")
check_includes(shell "core;shell;shell/body;shell/export")
check_includes(shell/body "core;shell/body")
check_includes(shell/export "core;shell/body;shell/export")
check_includes(web "core;shell/body;shell/export;web")
check_includes(examples "core;shell/export")

# std::sin and similar functions round differently in different libraries. The other words do not belong in core at all.
set(forbidden
    "std::(sin|cos|tan|asin|acos|atan|atan2|exp|exp2|log|log2|log10|pow|hypot|cbrt|fma|sinh|cosh|tanh|erf)[^a-z_0-9]"
    "[^a-z_0-9:.](sinf?|cosf?|expf?|powf?|logf?|atan2f?)\\("
    "std::(thread|jthread|mutex|async|atomic|chrono|cout|cerr|printf|ofstream|ifstream|random_device)"
    "std::[a-z_]*_distribution" "std::hash" "unordered_" "[^a-z_]throw[^a-z_]" "[^a-z_]printf\\(" "__EMSCRIPTEN__"
    "stable_sort")
file(GLOB_RECURSE files ${ROOT}/core/*.h ${ROOT}/core/*.cpp)
foreach(file IN LISTS files)
  file(READ ${file} text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}") # comments may name what code must not use
  file(RELATIVE_PATH name ${ROOT} ${file})
  foreach(pattern IN LISTS forbidden)
    if(text MATCHES "${pattern}")
      string(APPEND faults "\n${name}: ${CMAKE_MATCH_0}")
    endif()
  endforeach()
endforeach()

if(faults)
  message(FATAL_ERROR "what core must not use, or rooms that must not be reached:${faults}")
endif()
