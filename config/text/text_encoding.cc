#include "config/text/text_encoding.h"

#include <iconv.h>

#include <array>
#include <cerrno>

#include "base/utf8.h"

namespace stanok::config {
namespace {

// One conversion of iconv to UTF-8.
class Converter {
 public:
  explicit Converter(const std::string& from) : descriptor_(::iconv_open("UTF-8", from.c_str())) {}
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;
  ~Converter() {
    if (exists()) ::iconv_close(descriptor_);
  }

  [[nodiscard]] bool exists() const { return descriptor_ != no_descriptor(); }

  [[nodiscard]] std::string utf8_of(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() * 2);
    while (!bytes.empty()) {
      if (!convert_some(bytes, text)) {
        text += replacement_character;
        bytes.remove_prefix(1);
      }
    }
    return text;
  }

 private:
  static ::iconv_t no_descriptor() {
    return reinterpret_cast<::iconv_t>(-1);  // NOLINT(performance-no-int-to-ptr): of POSIX
  }

  // As much of `bytes` as goes into the room for one turn; false: they begin with what is no
  // character.
  bool convert_some(std::string_view& bytes, std::string& text) {
    std::array<char, 4096> room{};
    char* in = const_cast<char*>(bytes.data());  // NOLINT: iconv does not write there
    std::size_t in_left = bytes.size();
    char* out = room.data();
    std::size_t out_left = room.size();
    const std::size_t result = ::iconv(descriptor_, &in, &in_left, &out, &out_left);
    const bool is_stuck = result == static_cast<std::size_t>(-1) && errno != E2BIG;
    text.append(room.data(), room.size() - out_left);
    bytes.remove_prefix(bytes.size() - in_left);
    return !is_stuck;
  }

  ::iconv_t descriptor_;
};

std::string_view marked_encoding(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return "UTF-16LE";
  if (bytes.starts_with("\xFE\xFF")) return "UTF-16BE";
  return {};
}

}  // namespace

bool is_encoding_of_programs(const std::string& name) {
  constexpr std::string_view written =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789 "
      "\t\r\n%()[]{}#=+-*/.,;:<>_\"'!&|$";
  if (name.empty()) return false;  // to iconv the one of the environment
  Converter converter(name);
  return converter.exists() && converter.utf8_of(written) == written;
}

std::string text_from(std::string bytes, const std::string& encoding) {
  if (const std::string_view marked = marked_encoding(bytes); !marked.empty()) {
    constexpr std::size_t mark_bytes = 2;
    return Converter(std::string(marked)).utf8_of(std::string_view(bytes).substr(mark_bytes));
  }
  if (encoding.empty() || is_utf8(bytes)) return bytes;
  Converter converter(encoding);
  return converter.exists() ? converter.utf8_of(bytes) : bytes;
}

}  // namespace stanok::config
