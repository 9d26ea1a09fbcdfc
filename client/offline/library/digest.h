// A digest of bytes: BLAKE2b of 256 bits (RFC 7693, by libsodium), as 64 hexadecimal digits.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace stanok::client {

// Of several texts. Where one ends and the next begins makes a difference.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;

  Digest& add(std::string_view text);
  // Nothing is added behind it.
  [[nodiscard]] std::string text();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

[[nodiscard]] std::string digest_of(std::string_view text);

}  // namespace stanok::client
