# The rule of the rooms, checked: `cmake -P tests/rooms.cmake` reads every #include of dem/, fem/,
# coupling/ and apps/ and lists each forbidden one as file:line. -DHOUSE=DIR reads another checkout.
cmake_minimum_required(VERSION 3.25)

if(NOT HOUSE)
  cmake_path(SET HOUSE NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/..")
endif()

# What a room may include; std headers have neither folder nor extension.
set(common "<[a-z_0-9]+>|<experimental/simd>|<(unsupported/)?Eigen/[^>]+>")
set(deal_ii "<deal\\.II/[^>]+>")
set(dem_may "${common}|<omp\\.h>|<immintrin\\.h>|<Random123/[^>]+>|\"dem/[^\"]+\"")
set(fem_may "${common}|${deal_ii}|<cholmod\\.h>|\"fem/[^\"]+\"")
set(coupling_may "${common}|\"coupling/[^\"]+\"|\"dem/simulation\\.h\"|\"fem/elastic_body\\.h\"")
set(apps_may "<[^>]+>|\"(dem|fem|coupling|apps)/[^\"]+\"")

# Headers of fem that others see: neither they nor what they include may hold deal.II.
set(shown fem/body.h fem/elastic_body.h fem/reduced_body.h fem/stress_recovery.h)

# Files and printing live in apps only.
set(edges "fstream|iostream|stdio|printf|fopen|std::(cout|cerr|clog)")

# The lines of a file as a list; characters with a meaning in lists say nothing about includes.
function(read_lines file lines)
  file(READ "${HOUSE}/${file}" text)
  string(REGEX REPLACE "[][;\\\\]" " " text "${text}")
  string(REPLACE "\n" ";" text "${text}")
  set(${lines} "${text}" PARENT_SCOPE)
endfunction()

# What a line includes, with its brackets or quotes; empty if it includes nothing.
function(included line header)
  set(${header} "" PARENT_SCOPE)
  if(line MATCHES "^[ \t]*#[ \t]*include[ \t]*([<\"][^>\"]*[>\"]|[^ \t]+)")
    set(${header} "${CMAKE_MATCH_1}" PARENT_SCOPE)
  endif()
endfunction()

set(seen "")
while(shown)
  list(POP_FRONT shown file)
  if(file IN_LIST seen OR NOT EXISTS "${HOUSE}/${file}")
    continue()
  endif()
  list(APPEND seen ${file})
  read_lines(${file} lines)
  foreach(line IN LISTS lines)
    included("${line}" header)
    if(header MATCHES "^\"(fem/[^\"]+)\"$")
      list(APPEND shown ${CMAKE_MATCH_1})
    endif()
  endforeach()
endwhile()

set(offences "")
foreach(room dem fem coupling apps)
  file(GLOB_RECURSE files RELATIVE "${HOUSE}" "${HOUSE}/${room}/*.h" "${HOUSE}/${room}/*.cc")
  list(SORT files)
  foreach(file ${files})
    read_lines(${file} lines)
    set(number 0)
    foreach(line IN LISTS lines)
      math(EXPR number "${number} + 1")
      included("${line}" header)
      if(header AND NOT header MATCHES "^(${${room}_may})$")
        string(APPEND offences "${file}:${number}: ${room} may not include ${header}\n")
      elseif(header MATCHES "^${deal_ii}$" AND (NOT room STREQUAL "fem" OR file IN_LIST seen))
        string(APPEND offences "${file}:${number}: seen outside fem, may not include ${header}\n")
      endif()
      if(NOT room STREQUAL "apps" AND line MATCHES "${edges}")
        string(APPEND offences "${file}:${number}: ${room} neither opens files nor prints, "
               "found ${CMAKE_MATCH_0}\n")
      endif()
    endforeach()
  endforeach()
endforeach()

if(offences)
  string(REPLACE "\n" "\n  " offences "\n${offences}")
  message(FATAL_ERROR "The rule of the rooms is broken:${offences}")
endif()
