# Third-party libraries, all Debian packages (tools/packages.txt). Each becomes one target stanok_dep_<name>
# whose headers are SYSTEM, so that only our own code is held to our warnings.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

function(stanok_dependency name)
  cmake_parse_arguments(ARG "" "PKGCONFIG" "TARGETS;DEFINITIONS" ${ARGN})
  add_library(stanok_dep_${name} INTERFACE)
  if(ARG_PKGCONFIG)
    pkg_check_modules(${name} REQUIRED IMPORTED_TARGET ${ARG_PKGCONFIG})
    target_link_libraries(stanok_dep_${name} INTERFACE PkgConfig::${name})
  endif()
  target_link_libraries(stanok_dep_${name} INTERFACE ${ARG_TARGETS})
  target_compile_definitions(stanok_dep_${name} INTERFACE ${ARG_DEFINITIONS})
endfunction()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.81 REQUIRED)
find_package(OpenSSL 3 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(spdlog 1.10 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)

# Vectors without values are zero, as all our types are; no part of Eigen that we use allocates (ADR 0020).
stanok_dependency(eigen        TARGETS Eigen3::Eigen DEFINITIONS EIGEN_INITIALIZE_MATRICES_BY_ZERO EIGEN_NO_MALLOC)
stanok_dependency(asio         TARGETS Boost::headers Threads::Threads)
# The sources of Beast are compiled once, by web/server/beast_source.cc.
stanok_dependency(beast        TARGETS stanok_dep_asio DEFINITIONS BOOST_BEAST_SEPARATE_COMPILATION)
stanok_dependency(openssl      TARGETS OpenSSL::SSL)
stanok_dependency(sodium       PKGCONFIG libsodium)
stanok_dependency(json         TARGETS nlohmann_json::nlohmann_json)
stanok_dependency(cli11        TARGETS CLI11::CLI11)
stanok_dependency(spdlog       TARGETS spdlog::spdlog)
stanok_dependency(fmt          TARGETS fmt::fmt)
stanok_dependency(cairo        PKGCONFIG cairo)
stanok_dependency(lcm          PKGCONFIG lcm)
stanok_dependency(zlib         PKGCONFIG zlib)
stanok_dependency(modbus       PKGCONFIG libmodbus)
stanok_dependency(tomlplusplus PKGCONFIG tomlplusplus)
stanok_dependency(fast_float)
stanok_dependency(kissfft)  # one header
