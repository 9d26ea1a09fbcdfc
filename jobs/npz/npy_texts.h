// Texts as an array of NumPy: characters of four bytes, each text as long as the longest one.
#pragma once

#include <string>
#include <vector>

#include "jobs/npz/npz_file.h"

namespace stanok::jobs {

struct NpyTexts {
  NpyArray array;
  std::string bytes;
};

// The texts are UTF-8; what is no character of it becomes U+FFFD.
[[nodiscard]] NpyTexts npy_texts(std::string name, const std::vector<std::string>& texts);

}  // namespace stanok::jobs
