// ConfigError: what is wrong in the files an installer writes, all of it, with its place.
//
// Thrown by the readers of config before any axis has power, caught once in each main. what() shows
// one fault per line: "file:line:column: what is wrong; how to correct it".
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace stanok::config {

// One wrong place of one file. Line and column count from 1; 0 when the file itself is at fault.
struct ConfigFault {
  std::string file;
  unsigned line = 0;
  unsigned column = 0;
  std::string text;
};

// "file:line:column: text", or "file: text".
[[nodiscard]] std::string to_string(const ConfigFault& fault);

class ConfigError : public std::runtime_error {
 public:
  // At least one fault; shown in the order of the files' lines.
  explicit ConfigError(std::vector<ConfigFault> faults);

  [[nodiscard]] const std::vector<ConfigFault>& faults() const { return faults_; }

 private:
  std::vector<ConfigFault> faults_;
};

}  // namespace stanok::config
