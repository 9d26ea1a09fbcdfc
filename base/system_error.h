// The words of the system for an error number.
#pragma once

#include <string>
#include <system_error>

namespace stanok {

[[nodiscard]] inline std::string system_error_text(int error) {
  return std::generic_category().message(error);
}

}  // namespace stanok
