# How every target of Sagara is made. Three functions, one place for compiler settings.
#
#   sagara_room(core/base SOURCES a.cpp USES core/sea LINKS Eigen3::Eigen PRIVATE_LINKS foo)
#   sagara_program(sagara-sim SOURCES main.cpp USES core/exercise db)
#   sagara_tests(core/base SOURCES x_test.cpp USES core/base)
#
# A room is one folder and one static library. Includes are written from the root of the tree
# ("core/base/Angle.h"), yet a room sees only the rooms it USES (and what those use): each room has an
# include root of its own in the build folder, which holds one link, to that room. So the folder table of
# README.md is kept by the compiler.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
# Asserts stay on in Release: they cost nothing that can be measured and a broken precondition must show.
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -g1")
if(SAGARA_SANITIZE)
  set(CMAKE_CXX_FLAGS_RELEASE "-O1 -g1")  # half the time to build, with the same findings
endif()

function(sagara_room_target room out)
  string(REGEX REPLACE "[/-]" "_" name "sagara_${room}")
  set(${out} ${name} PARENT_SCOPE)
endfunction()

# The one function that configures every target: language, warnings, determinism, sanitizers, Qt strictness.
function(sagara_configure target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align -Woverloaded-virtual
    -Wconversion -Wdouble-promotion -Wformat=2 -Werror
    # Determinism: the same bytes wherever this build runs, as far as the mathematics library lets it (core/README.md).
    -ffp-contract=off -fno-fast-math -march=x86-64 -mtune=generic
    # These two change no value; they let loops with a choice in them be vectorised.
    -fno-trapping-math -fno-math-errno)
  target_compile_definitions(${target} PRIVATE
    QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_URL_CAST_FROM_STRING QT_NO_CAST_FROM_BYTEARRAY
    QT_NO_CONTEXTLESS_CONNECT QT_NO_NARROWING_CONVERSIONS_IN_CONNECT QT_NO_FOREACH QT_NO_KEYWORDS
    QT_STRICT_ITERATORS QT_DISABLE_DEPRECATED_BEFORE=0x060400)
  if(SAGARA_FUZZ)
    # clang 14 warns of other things than GCC 12, which is the compiler of record.
    target_compile_options(${target} PRIVATE -Wno-error)
  endif()
  if(SAGARA_SANITIZE)
    # GCC 12 with instrumentation warns of overlaps in std::string and blanks in std::regex that are not there.
    target_compile_options(${target} PRIVATE -fsanitize=${SAGARA_SANITIZE} -fno-omit-frame-pointer
      $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    # PUBLIC: whoever links an instrumented library needs the runtime.
    target_link_options(${target} PUBLIC -fsanitize=${SAGARA_SANITIZE})
    if(SAGARA_SANITIZE MATCHES undefined)
      target_compile_options(${target} PRIVATE -fno-sanitize-recover=undefined)
    endif()
  endif()
endfunction()

function(sagara_link_rooms target)
  foreach(room IN LISTS ARGN)
    sagara_room_target(${room} name)
    target_link_libraries(${target} PUBLIC ${name})
  endforeach()
endfunction()

function(sagara_room room)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;LINKS;PRIVATE_LINKS" ${ARGN})
  sagara_room_target(${room} name)
  set(include_root ${CMAKE_BINARY_DIR}/rooms/${name})
  get_filename_component(parent ${include_root}/${room} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_root}/${room} SYMBOLIC)

  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${include_root})
  sagara_link_rooms(${name} ${ARG_USES})
  target_link_libraries(${name} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  sagara_configure(${name})
endfunction()

function(sagara_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  sagara_link_rooms(${name} ${ARG_USES})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS})
  sagara_configure(${name})
endfunction()

# Tests of one room, or of several together. SAGARA_TEST_DATA is tests/reference, SAGARA_ASSETS is assets/.
function(sagara_tests name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;USES;LINKS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  string(REGEX REPLACE "[/-]" "_" target "test_${name}")
  add_executable(${target} ${ARG_SOURCES})
  sagara_link_rooms(${target} ${ARG_USES})
  target_link_libraries(${target} PRIVATE ${ARG_LINKS} GTest::gtest GTest::gtest_main)
  target_compile_definitions(${target} PRIVATE
    SAGARA_TEST_DATA="${CMAKE_SOURCE_DIR}/tests/reference" SAGARA_ASSETS="${CMAKE_SOURCE_DIR}/assets")
  sagara_configure(${target})
  # "tests_core" builds the tests of core/ and so on.
  string(REGEX REPLACE "[/-].*" "" house ${name})
  if(NOT TARGET tests_${house})
    add_custom_target(tests_${house})
  endif()
  add_dependencies(tests_${house} ${target})
  gtest_discover_tests(${target} TEST_PREFIX "${name}: " DISCOVERY_MODE PRE_TEST
    PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS ${name})
endfunction()
