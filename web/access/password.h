// Passwords, kept as argon2id hashes.
//
// A hash takes 64 MiB and a tenth of a second, which is what makes guessing dear; whoever computes
// them does so one at a time and in no thread that others wait for. Source: libsodium,
// crypto_pwhash_str with its limits for interactive use (RFC 9106).
#pragma once

#include <string>
#include <string_view>

namespace stanok::web {

inline constexpr std::size_t password_bytes_min = 10;
inline constexpr std::size_t password_bytes_max = 256;

// Throws std::runtime_error without memory.
[[nodiscard]] std::string hash_of_password(std::string_view password);
[[nodiscard]] bool is_password_of(const std::string& hash, std::string_view password);
// Takes as long as a right one, for users that there are not.
[[nodiscard]] std::string hash_of_nobody();

}  // namespace stanok::web
