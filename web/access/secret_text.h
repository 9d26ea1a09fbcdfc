// Secrets that the server gives out: random texts, of which it keeps hashes only.
//
// What is stolen from its memory or a core file opens nothing. Source: libsodium, randombytes_buf
// and crypto_generichash (BLAKE2b).
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace stanok::web {

// 256 random bits as text that may stand in an address (base64url, 43 characters).
[[nodiscard]] std::string new_secret();

using SecretHash = std::array<unsigned char, 32>;

[[nodiscard]] SecretHash hash_of(std::string_view secret);

}  // namespace stanok::web
