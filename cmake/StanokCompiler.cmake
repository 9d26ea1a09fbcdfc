# Language level, warnings, floating-point contract and sanitizers for every target.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

option(STANOK_WERROR "Warnings are errors" ON)
set(STANOK_SANITIZE "" CACHE STRING "Value for -fsanitize= (address,undefined | thread | realtime)")
# Sources of a folder are compiled several at a time: headers and their templates are most of what a compiler
# reads. Presets `tidy` and `fuzz` take them one by one, which proves that each source includes what it uses.
option(STANOK_UNITY "Compile several sources of a folder at a time" ON)
option(STANOK_COVERAGE "Instrument for gcov" OFF)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# The sanitized test programs are large; mold links each in a tenth of the time of ld.
find_program(MOLD mold)
if(MOLD)
  add_link_options(-fuse-ld=mold)
endif()

# Bit identity between runs and builds: no contraction into fused multiply-add, no fast-math.
add_compile_options(-ffp-contract=off)

# No library is replaced at load time: functions of a unit may be inlined in each other although they are
# compiled as position independent code. (clang takes it for granted.)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-fno-semantic-interposition)
endif()

add_library(stanok_warnings INTERFACE)
target_compile_options(stanok_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow $<$<BOOL:${STANOK_WERROR}>:-Werror>)
if(STANOK_UNITY)
  # A source that is included by another looks like a header, and its names like global ones; both warnings are
  # armed where sources are compiled one by one.
  target_compile_options(stanok_warnings INTERFACE
    -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 20)
  # libstdc++ 12 deprecates what its own std::stable_sort uses; clang reports that at the caller.
  target_compile_options(stanok_warnings INTERFACE -Wfunction-effects -Wno-deprecated-declarations)
endif()

if(STANOK_SANITIZE)
  add_compile_options(-fsanitize=${STANOK_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${STANOK_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Instrumented code of the standard library (std::regex) warns falsely; the release build still warns.
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
  if(STANOK_SANITIZE MATCHES "undefined")
    # g++ 12 miscompiles the member-pointer calls of LCM's subscribe under -fsanitize=vptr.
    add_compile_options(-fno-sanitize=vptr -fno-sanitize-recover=all)
  endif()
  if(STANOK_SANITIZE STREQUAL "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # Tests have operators new and delete of their own, which the static library of ThreadSanitizer does not allow.
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libclang_rt.tsan-${CMAKE_HOST_SYSTEM_PROCESSOR}.so
      OUTPUT_VARIABLE shared_sanitizer OUTPUT_STRIP_TRAILING_WHITESPACE)
    get_filename_component(shared_sanitizer ${shared_sanitizer} DIRECTORY)
    add_link_options(-shared-libsan LINKER:-rpath,${shared_sanitizer})
  elseif(STANOK_SANITIZE STREQUAL "thread")
    # Asio's fences are not modelled by ThreadSanitizer; its queues synchronise by mutexes besides.
    add_compile_options(-Wno-tsan)
  endif()
endif()
if(STANOK_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()
