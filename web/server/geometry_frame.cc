#include "web/server/geometry_frame.h"

#include <sodium.h>

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "protocol/contract/json_rpc.h"
#include "protocol/contract/json_text.h"

namespace stanok::web {
namespace {

using nlohmann::json;

// Requests for next pages; those of browsers have numbers of their own.
constexpr auto id_of_more = "stanok-web: more";
constexpr std::size_t point_bytes = 16;  // three Float32 and a Uint32
constexpr std::uint32_t count_max = 1U << 20;

void append_word(std::string& bytes, std::uint32_t word) {
  for (unsigned shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<char>(word >> shift & 0xFFU));
}

std::optional<std::string> decoded(const std::string& text) {
  std::string bytes(text.size(), '\0');
  std::size_t count = 0;
  const int outcome =
      sodium_base642bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.data(),
                        text.size(), nullptr, &count, nullptr, sodium_base64_VARIANT_ORIGINAL);
  if (outcome != 0) return std::nullopt;
  bytes.resize(count);
  return bytes;
}

// 0 where there is none.
std::uint32_t word_of(const json& object, const char* name) {
  const auto member = object.find(name);
  return member != object.end() && member->is_number_unsigned() ? member->get<std::uint32_t>() : 0;
}

std::optional<std::string> frame_of(const json& geometry) {
  const auto text = geometry.find("base64");
  if (text == geometry.end() || !text->is_string()) return std::nullopt;
  const auto points = decoded(text->get_ref<const std::string&>());
  const std::uint32_t count = word_of(geometry, "count");
  if (!points || count > count_max || points->size() != count * point_bytes) return std::nullopt;
  std::string frame;
  for (const char* name : {"kind", "id", "page"}) append_word(frame, word_of(geometry, name));
  append_word(frame, count);
  return frame + *points;
}

std::string request_for_more(const json& geometry) {
  const auto more = geometry.find("more");
  if (more == geometry.end() || !more->is_object()) return {};
  return protocol::json_text(json{{"jsonrpc", "2.0"},
                                  {"id", id_of_more},
                                  {"method", more->value("method", "")},
                                  {"params", more->value("params", json::object())}});
}

}  // namespace

std::optional<GeometryMessage> geometry_of(const std::string& line) {
  if (line.find("\"geometry\":{") == std::string::npos) return std::nullopt;
  json message = protocol::json_from_text(line);
  if (!message.is_object() || !message.contains("result")) return std::nullopt;
  json& result = message["result"];
  if (!result.is_object() || !result.contains("geometry")) return std::nullopt;
  json& geometry = result["geometry"];
  if (!geometry.is_object()) return std::nullopt;
  auto frame = frame_of(geometry);
  if (!frame) return std::nullopt;
  GeometryMessage taken{
      .frame = std::move(*frame), .message = {}, .more = request_for_more(geometry)};
  geometry.erase("base64");
  geometry.erase("more");
  taken.is_own = message.value("id", json()) == id_of_more;
  if (taken.is_own) {
    message = {{"jsonrpc", "2.0"}, {"method", "geometry"}, {"params", geometry}};
  }
  taken.message = protocol::json_text(message);
  return taken;
}

}  // namespace stanok::web
