# Read by cpack before it makes packages: python3-stanok is left out where its module was not built,
# since without it the package would be installed and could not be used.
file(GLOB stanok_python_module "${CPACK_STANOK_PYTHON_FOLDER}/_native*.so")
if(NOT stanok_python_module)
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL python)
  message(WARNING "python3-stanok is left out: its module is not built "
                  "(cmake --build ${CPACK_STANOK_BUILD} --target stanok_python)")
endif()
