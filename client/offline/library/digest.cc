#include "client/offline/library/digest.h"

#include <sodium.h>

#include <array>
#include <cstdint>

#include "base/assert.h"

namespace stanok::client {
namespace {

constexpr std::size_t digest_bytes = 32;

const unsigned char* bytes_at(const void* place) {
  return static_cast<const unsigned char*>(place);
}

}  // namespace

struct Digest::State {
  crypto_generichash_state state{};
};

Digest::Digest() : state_(std::make_unique<State>()) {
  STANOK_ASSERT(sodium_init() >= 0);
  crypto_generichash_init(&state_->state, nullptr, 0, digest_bytes);
}

Digest::~Digest() = default;

Digest& Digest::add(std::string_view text) {
  const std::uint64_t size = text.size();
  crypto_generichash_update(&state_->state, bytes_at(&size), sizeof(size));
  crypto_generichash_update(&state_->state, bytes_at(text.data()), text.size());
  return *this;
}

std::string Digest::text() {
  std::array<unsigned char, digest_bytes> bytes{};
  crypto_generichash_final(&state_->state, bytes.data(), bytes.size());
  std::array<char, 2 * digest_bytes + 1> digits{};
  sodium_bin2hex(digits.data(), digits.size(), bytes.data(), bytes.size());
  return digits.data();
}

std::string digest_of(std::string_view text) {
  return Digest().add(text).text();
}

}  // namespace stanok::client
