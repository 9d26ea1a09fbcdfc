// A file of a machine as it was read: its name, and its text as recorded in a log.
#pragma once

#include <filesystem>
#include <string>

namespace stanok::config {

struct SourceFile {
  std::filesystem::path path;
  std::string text;
};

}  // namespace stanok::config
