#include "gateway/database/postgres.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

namespace stanok::gateway {
namespace {

// Beside the programs, in the tree of a build as where it is installed.
std::filesystem::path module_file() {
  std::error_code ignored;
  const auto programs = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  return (programs / "../lib/stanok/stanok-postgres.so").lexically_normal();
}

const PostgresFunctions& load() {
  void* const module = dlopen(module_file().c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const functions = module == nullptr ? nullptr : dlsym(module, "stanok_postgres");
  if (functions == nullptr)
    throw DatabaseError("PostgreSQL is not available here (" +
                        std::string(dlerror()) +  // NOLINT(concurrency-mt-unsafe): of this thread
                        "); install all of stanok and libpq5, or use an SQLite file");
  return *static_cast<const PostgresFunctions*>(functions);
}

}  // namespace

const PostgresFunctions& postgres() {
  static const PostgresFunctions& functions = load();
  return functions;
}

}  // namespace stanok::gateway
