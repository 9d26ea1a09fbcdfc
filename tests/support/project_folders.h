// Where the repository and the build lie, for tests that read or run what is in them.
//
// Functions and one source of their own: the other tests are compiled to the same objects wherever
// the repository lies, so that checkouts share a compiler cache.
#pragma once

#include <string>

namespace stanok::testing {

[[nodiscard]] std::string source_folder();
[[nodiscard]] std::string build_folder();

}  // namespace stanok::testing
