// Version of the programs, as `--version`, the daemon's hello and LOG_META tell it.
#pragma once

#include <string_view>

namespace stanok::protocol {

inline constexpr std::string_view version = "0.2.0";

}  // namespace stanok::protocol
