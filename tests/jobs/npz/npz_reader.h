// A reader of stored ZIP files and of the .npy files in them, written from their descriptions and
// not from the writer: PKWARE APPNOTE, numpy.lib.format.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace stanok::jobs {

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Bit by bit, polynomial 0xEDB88320.
inline std::uint32_t plain_crc32(std::string_view bytes) {
  std::uint32_t sum = 0xFFFFFFFF;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int k = 0; k < 8; ++k) sum = (sum & 1U) != 0 ? sum >> 1U ^ 0xEDB88320U : sum >> 1U;
  }
  return ~sum;
}

struct ReadArray {
  std::string header;  // the dictionary, without padding
  std::string bytes;

  template <class Number>
  [[nodiscard]] std::vector<Number> numbers() const {
    std::vector<Number> list(bytes.size() / sizeof(Number));
    if (!list.empty()) std::memcpy(list.data(), bytes.data(), list.size() * sizeof(Number));
    return list;
  }
};

class NpzReader {
 public:
  explicit NpzReader(std::string content) : content_(std::move(content)) { read_directory(); }

  [[nodiscard]] const std::map<std::string, ReadArray>& arrays() const { return arrays_; }
  [[nodiscard]] bool has_zip64() const { return has_zip64_; }

 private:
  static constexpr std::uint64_t in_extra = 0xFFFFFFFF;

  [[nodiscard]] std::uint64_t number(std::uint64_t at, unsigned bytes) const {
    std::uint64_t value = 0;
    for (unsigned k = 0; k < bytes; ++k)
      value |= std::uint64_t{static_cast<unsigned char>(content_.at(at + k))} << 8 * k;
    return value;
  }

  // The next number of the ZIP64 field at `extra`, where the plain one says so.
  std::uint64_t size(std::uint64_t plain, std::uint64_t extra, unsigned& place) {
    if (plain != in_extra) return plain;
    has_zip64_ = true;
    EXPECT_EQ(number(extra, 2), 1U);
    EXPECT_LE(8 * (place + 1), number(extra + 2, 2));
    return number(extra + 4 + std::uint64_t{8} * place++, 8);
  }

  void read_directory() {
    constexpr std::uint64_t end_bytes = 22;
    ASSERT_GE(content_.size(), end_bytes);
    const std::uint64_t end = content_.size() - end_bytes;
    ASSERT_EQ(number(end, 4), 0x06054B50U);
    std::uint64_t at = number(end + 16, 4);
    std::uint64_t bytes = number(end + 12, 4);
    if (at == in_extra || bytes == in_extra) {
      ASSERT_EQ(number(end - 20, 4), 0x07064B50U);
      const std::uint64_t end64 = number(end - 12, 8);
      ASSERT_EQ(number(end64, 4), 0x06064B50U);
      EXPECT_EQ(number(end64 + 32, 8), number(end + 10, 2));
      bytes = number(end64 + 40, 8);
      at = number(end64 + 48, 8);
      EXPECT_EQ(end64, at + bytes);
    } else {
      EXPECT_EQ(end, at + bytes);
    }
    for (std::uint64_t k = 0; k < number(end + 10, 2); ++k) at = read_entry(at);
  }

  std::uint64_t read_entry(std::uint64_t at) {
    EXPECT_EQ(number(at, 4), 0x02014B50U);
    EXPECT_EQ(number(at + 10, 2), 0U) << "stored";
    const std::uint64_t name_bytes = number(at + 28, 2);
    const std::uint64_t extra = at + 46 + name_bytes;
    unsigned place = 0;
    const std::uint64_t whole = size(number(at + 24, 4), extra, place);
    EXPECT_EQ(size(number(at + 20, 4), extra, place), whole);
    const std::uint64_t local = size(number(at + 42, 4), extra, place);
    const std::string name = content_.substr(at + 46, name_bytes);
    read_member(local, name, whole, number(at + 16, 4));
    return extra + number(at + 30, 2) + number(at + 32, 2);
  }

  void read_member(std::uint64_t at, const std::string& name, std::uint64_t bytes,
                   std::uint64_t sum) {
    ASSERT_EQ(number(at, 4), 0x04034B50U);
    ASSERT_EQ(content_.substr(at + 30, number(at + 26, 2)), name);
    EXPECT_EQ(number(at + 14, 4), sum);
    const std::uint64_t extra = at + 30 + number(at + 26, 2);
    unsigned place = 0;
    EXPECT_EQ(size(number(at + 22, 4), extra, place), bytes);
    EXPECT_EQ(size(number(at + 18, 4), extra, place), bytes);
    const std::string member = content_.substr(extra + number(at + 28, 2), bytes);
    ASSERT_EQ(member.size(), bytes);
    EXPECT_EQ(plain_crc32(member), sum) << name;
    ASSERT_TRUE(name.ends_with(".npy"));
    arrays_[name.substr(0, name.size() - 4)] = array_of(member);
  }

  static ReadArray array_of(const std::string& member) {
    EXPECT_EQ(member.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t header = static_cast<unsigned char>(member[8]) +
                               std::size_t{256} * static_cast<unsigned char>(member[9]);
    EXPECT_EQ((10 + header) % 64, 0U);
    EXPECT_EQ(member[9 + header], '\n');
    const std::string text = member.substr(10, header);
    return {text.substr(0, text.find('}') + 1), member.substr(10 + header)};
  }

  std::string content_;
  std::map<std::string, ReadArray> arrays_;
  bool has_zip64_ = false;
};

}  // namespace stanok::jobs
