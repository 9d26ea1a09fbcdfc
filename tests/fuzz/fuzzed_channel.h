// What the fuzz targets give the interpreter: a text as the only file, tables, a five-axis mill or
// a lathe, of any dialect.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "lang/run/interpreter.h"

namespace stanok::lang::fuzz {

class OneFile final : public Files {
 public:
  explicit OneFile(std::string text)
      : text_(
            std::make_shared<const SourceText>(SourceText{"fuzz.nc", "fuzz.nc", std::move(text)})) {
  }

  [[nodiscard]] Expected<std::shared_ptr<const SourceText>, Diagnostic> read(
      std::string_view name, std::string_view) const override {
    if (name == text_->name) return text_;
    Diagnostic missing;
    missing.code = "E7001";
    missing.message = "the file was not found: " + std::string(name);
    return tl::unexpected(missing);
  }

 private:
  std::shared_ptr<const SourceText> text_;
};

class SomeTables final : public Tables {
 public:
  [[nodiscard]] std::optional<AxisValues> work_offset(int number) const override {
    if (number < 1 || number > 309) return std::nullopt;
    return AxisValues{0.5 * number, 1.0, -2.0};
  }
  [[nodiscard]] std::optional<Tool> tool(int number) const override {
    if (number < 1 || number > 9) return std::nullopt;
    Tool tool;
    tool.number = number;
    tool.length_mm = {0.0, 0.0, 10.0 * number};
    tool.radius_mm = 0.5 * number;
    return tool;
  }
  [[nodiscard]] MachineReading machine_reading() const override { return {}; }
  [[nodiscard]] AxisValues reference_point(int which) const override {
    return reference_.at(static_cast<std::size_t>(which - 1));
  }
  [[nodiscard]] double common_variable(int) const override { return 0.0; }
  void set_common_variable(int, double) override {}
  void store_reference_point(int which, const AxisValues& point_M) override {
    reference_.at(static_cast<std::size_t>(which - 1)) = point_M;
  }

 private:
  std::array<AxisValues, reference_point_count> reference_{};
};

// By two bits of the byte the dialect, by two the code system.
inline TextRules rules_of(std::uint8_t byte) {
  constexpr std::array dialects{Dialect::stanok, Dialect::linuxcnc, Dialect::fanuc, Dialect::haas};
  constexpr std::array systems{CodeSystem::b, CodeSystem::a, CodeSystem::c, CodeSystem::a};
  return {dialects[byte & 3U], systems[(byte >> 2U) & 3U]};
}

inline ChannelDescription mill() {
  ChannelDescription channel;
  channel.axes = {{"X", false, 0.0, 0},
                  {"Y", false, 0.0, 1},
                  {"Z", false, 0.0, 2},
                  {"B", true, 0.0, -1},
                  {"C", true, 360.0, -1}};
  channel.spindles = {1, 2};
  channel.channels = {1, 2};
  channel.schemes = {{1, 1}, {1, 2}};
  return channel;
}

inline ChannelDescription lathe() {
  ChannelDescription channel = mill();
  channel.kind = ChannelKind::lathe;
  channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}, {"C", true, 0.0, -1}};
  return channel;
}

}  // namespace stanok::lang::fuzz
