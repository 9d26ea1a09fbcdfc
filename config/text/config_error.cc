// Text of ConfigError.
#include "config/text/config_error.h"

namespace stanok::config {
namespace {

std::string all_lines(const std::vector<ConfigFault>& faults) {
  std::string text;
  for (const ConfigFault& fault : faults) {
    if (!text.empty()) text += '\n';
    text += to_string(fault);
  }
  return text;
}

}  // namespace

std::string to_string(const ConfigFault& fault) {
  if (fault.line == 0) return fault.file + ": " + fault.text;
  return fault.file + ':' + std::to_string(fault.line) + ':' + std::to_string(fault.column) + ": " +
         fault.text;
}

ConfigError::ConfigError(std::vector<ConfigFault> faults)
    : std::runtime_error(all_lines(faults)), faults_(std::move(faults)) {}

}  // namespace stanok::config
