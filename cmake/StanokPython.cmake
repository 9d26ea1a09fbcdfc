# The Python package: the module stanok._native from python/native, beside copies of the sources of
# python/stanok, so that PYTHONPATH=build/PRESET/python runs it as it is built.
#
# It is made for Debian's own Python: another one in the PATH has other modules. Where pybind11 or NumPy
# are missing (tools/install-packages.sh python) it is left out; with sanitizers too, whose run-time parts
# would have to be in the interpreter.
set(STANOK_PYTHON /usr/bin/python3 CACHE FILEPATH "Interpreter for which the Python module is built")
set(python_layers runtime jobs)
string(JOIN " " python_line python/native ${python_layers})
set_property(GLOBAL APPEND PROPERTY STANOK_LAYERS "${python_line}")
set_property(GLOBAL APPEND PROPERTY STANOK_LAYERS "python python/native")

if(STANOK_SANITIZE OR STANOK_COVERAGE OR NOT EXISTS ${STANOK_PYTHON})
  return()
endif()
set(Python3_EXECUTABLE ${STANOK_PYTHON})
find_package(Python3 COMPONENTS Interpreter Development.Module NumPy QUIET)
find_package(pybind11 2.10 CONFIG QUIET)
if(NOT Python3_FOUND OR NOT pybind11_FOUND)
  message(STATUS "python3-stanok is left out: tools/install-packages.sh python installs what it needs")
  return()
endif()

set(python_package ${CMAKE_BINARY_DIR}/python/stanok)
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/python/native/*.cc)
stanok_units(units stanok_python_native ${stanok_unit_most} ${sources})
pybind11_add_module(stanok_python_native MODULE NO_EXTRAS ${units})
target_include_directories(stanok_python_native PRIVATE ${CMAKE_SOURCE_DIR})
target_link_libraries(stanok_python_native PRIVATE stanok_warnings)
foreach(layer IN LISTS python_layers)
  string(REPLACE "/" "_" layer ${layer})
  target_link_libraries(stanok_python_native PRIVATE stanok_${layer})
endforeach()
# Nothing of the libraries is seen by other modules of the interpreter.
set_target_properties(stanok_python_native PROPERTIES
  OUTPUT_NAME _native LIBRARY_OUTPUT_DIRECTORY ${python_package}
  CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
target_link_options(stanok_python_native PRIVATE LINKER:--exclude-libs,ALL)

file(GLOB python_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/python/stanok/*.py
     ${CMAKE_SOURCE_DIR}/python/stanok/*.pyi ${CMAKE_SOURCE_DIR}/python/stanok/py.typed)
set(python_copies)
foreach(source IN LISTS python_sources)
  get_filename_component(name ${source} NAME)
  add_custom_command(OUTPUT ${python_package}/${name} DEPENDS ${source}
    COMMAND ${CMAKE_COMMAND} -E copy ${source} ${python_package}/${name} VERBATIM)
  list(APPEND python_copies ${python_package}/${name})
endforeach()
add_custom_target(stanok_python ALL DEPENDS ${python_copies} stanok_python_native)
