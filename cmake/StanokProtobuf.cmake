# stanok_protobuf(<folder> <name>): the messages of <folder>/<name>.proto in C++, as <stanok_protobuf/<name>.pb.h>
# and the dependency stanok_dep_<name>. Only the lite runtime is used; its code is not held to our warnings.
find_program(PROTOC protoc REQUIRED)
pkg_check_modules(protobuf REQUIRED IMPORTED_TARGET protobuf-lite)

function(stanok_protobuf folder name)
  set(output ${CMAKE_BINARY_DIR}/protobuf_generated)
  file(MAKE_DIRECTORY ${output}/stanok_protobuf)
  set(generated ${output}/stanok_protobuf/${name}.pb.cc ${output}/stanok_protobuf/${name}.pb.h)
  add_custom_command(OUTPUT ${generated}
    COMMAND ${PROTOC} --cpp_out=${output}/stanok_protobuf -I ${CMAKE_SOURCE_DIR}/${folder} ${name}.proto
    DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/${name}.proto COMMENT "protoc ${name}" VERBATIM)
  add_library(stanok_protobuf_${name} STATIC ${generated})
  target_include_directories(stanok_protobuf_${name} SYSTEM PUBLIC ${output})
  target_link_libraries(stanok_protobuf_${name} PUBLIC PkgConfig::protobuf)
  add_library(stanok_dep_${name} INTERFACE)
  target_link_libraries(stanok_dep_${name} INTERFACE stanok_protobuf_${name})
endfunction()
