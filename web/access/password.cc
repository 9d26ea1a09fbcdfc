#include "web/access/password.h"

#include <sodium.h>

#include <array>
#include <stdexcept>

#include "web/access/secret_text.h"

namespace stanok::web {

std::string hash_of_password(std::string_view password) {
  std::array<char, crypto_pwhash_STRBYTES> hash{};
  if (crypto_pwhash_str(hash.data(), password.data(), password.size(),
                        crypto_pwhash_OPSLIMIT_INTERACTIVE,
                        crypto_pwhash_MEMLIMIT_INTERACTIVE) != 0)
    throw std::runtime_error("there is not enough memory for the hash of a password (64 MiB)");
  return hash.data();
}

bool is_password_of(const std::string& hash, std::string_view password) {
  return crypto_pwhash_str_verify(hash.c_str(), password.data(), password.size()) == 0;
}

std::string hash_of_nobody() {
  static const std::string hash = hash_of_password(new_secret());
  return hash;
}

}  // namespace stanok::web
