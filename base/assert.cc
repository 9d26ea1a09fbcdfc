#include "base/assert.h"

#include <string>
#include <string_view>

namespace stanok {
namespace {

// Names of sources begin where the build was made, as that of this one does; what counts is from
// the root of the repository.
std::string_view from_root(std::string_view file) {
  std::string_view root = __FILE__;
  root.remove_suffix(std::string_view("base/assert.cc").size());
  if (file.starts_with(root)) file.remove_prefix(root.size());
  return file;
}

}  // namespace

void assertion_failed(const char* claim, const char* file, int line) {
  throw BrokenClaim(std::string(from_root(file)) + ":" + std::to_string(line) +
                    ": broken claim: " + claim);
}

}  // namespace stanok
