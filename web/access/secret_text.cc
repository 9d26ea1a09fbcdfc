#include "web/access/secret_text.h"

#include <sodium.h>

#include <stdexcept>

namespace stanok::web {
namespace {

constexpr std::size_t secret_bytes = 32;

void require_sodium() {
  static const bool is_ready = sodium_init() >= 0;
  if (!is_ready) throw std::runtime_error("libsodium finds no source of random numbers");
}

}  // namespace

std::string new_secret() {
  require_sodium();
  std::array<unsigned char, secret_bytes> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  constexpr int variant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;
  std::string text(sodium_base64_ENCODED_LEN(secret_bytes, variant), '\0');
  sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(), variant);
  text.pop_back();  // the zero that ends it
  return text;
}

SecretHash hash_of(std::string_view secret) {
  require_sodium();
  SecretHash hash{};
  crypto_generichash(hash.data(), hash.size(),
                     reinterpret_cast<const unsigned char*>(secret.data()), secret.size(), nullptr,
                     0);
  return hash;
}

}  // namespace stanok::web
