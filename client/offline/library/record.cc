#include "client/offline/library/record.h"

#include <cstddef>

namespace stanok::client {
namespace {

using nlohmann::json;

constexpr int nesting_max = 16;

// Goes through a record without keeping anything, and ends where it is nested too deep.
class NestingMeasure final : public nlohmann::json_sax<json> {
 public:
  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(number_integer_t /*value*/) override { return true; }
  bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
  bool string(string_t& /*value*/) override { return true; }
  bool binary(binary_t& /*value*/) override { return true; }
  bool key(string_t& /*value*/) override { return true; }
  bool start_object(std::size_t /*count*/) override { return ++nesting_ <= nesting_max; }
  bool start_array(std::size_t /*count*/) override { return ++nesting_ <= nesting_max; }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t /*place*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*fault*/) override {
    return false;
  }

 private:
  bool leave() {
    --nesting_;
    return true;
  }

  int nesting_ = 0;
};

}  // namespace

std::string bytes_of(const json& record) {
  std::string bytes;
  json::to_cbor(record, bytes);
  return bytes;
}

std::optional<json> record_in(std::string_view bytes) {
  NestingMeasure measure;
  if (!json::sax_parse(bytes, &measure, json::input_format_t::cbor)) return std::nullopt;
  json record = json::from_cbor(bytes, true, false);
  if (record.is_discarded()) return std::nullopt;
  return record;
}

}  // namespace stanok::client
