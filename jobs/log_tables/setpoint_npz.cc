#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/place.h"
#include "jobs/log_tables/log_tables.h"
#include "jobs/log_tables/table_faults.h"
#include "jobs/npz/npy_texts.h"
#include "jobs/npz/npz_file.h"
#include "recording/read/setpoint_fields.h"
#include "recording/read/setpoint_walk.h"

namespace stanok::jobs {
namespace {

using recording::SetpointField;

NpyArray array_of_field(const SetpointField& field, std::int64_t rows, std::int64_t axis_count) {
  std::vector<std::int64_t> shape{rows};
  if (field.is_of_axes()) shape.push_back(axis_count);
  return std::visit(
      [&]<class Kind>(const Kind&) {
        using Number = typename recording::NumberOfSource<Kind>::Type;
        return npy_array<Number>(std::string(field.name), shape);
      },
      field.source);
}

std::vector<NpyTexts> texts_of_axes(const std::vector<recording::AxisDescription>& axes) {
  std::vector<std::string> names;
  std::vector<std::string> words;
  std::vector<std::string> units;
  for (const recording::AxisDescription& axis : axes) {
    names.push_back(axis.name);
    words.push_back(axis.word);
    units.emplace_back(axis.rotary ? "deg" : "mm");
  }
  return {npy_texts("axes", names), npy_texts("words", words), npy_texts("units", units)};
}

// The file is made with the first setpoint, which says how many axes there are.
class SetpointNpz {
 public:
  SetpointNpz(const recording::LogContents& contents, int channel, std::filesystem::path npz)
      : contents_(contents), channel_(channel), npz_(std::move(npz)) {
    const auto& told = contents.channels.at(contents.setpoint_channels.at(channel));
    rows_ = told.messages - told.undecodable;
  }

  void take(const setpoint_t& setpoint) {
    if (written_ == rows_ || error_) return;
    if (file_ == nullptr) create(recording::axis_count_of(setpoint));
    if (error_) return;
    const double time_s = static_cast<double>(setpoint.utime - contents_.utime_first) * 1e-6;
    std::size_t place = 0;
    for (const SetpointField& field : recording::setpoint_fields())
      add(place++, field, setpoint, time_s);
    ++written_;
  }

  [[nodiscard]] RowsOrError finish(const std::filesystem::path& log) {
    if (!error_ && (file_ == nullptr || written_ < rows_)) return has_changed(log);
    if (!error_) error_ = file_->finish();
    if (error_) return not_written(*error_);
    return written_;
  }

 private:
  void create(int axis_count) {
    axis_count_ = axis_count;
    std::vector<NpyArray> arrays;
    for (const SetpointField& field : recording::setpoint_fields())
      arrays.push_back(array_of_field(field, rows_, axis_count));
    const std::size_t first_text = arrays.size();
    const auto texts = texts_of_axes(recording::axes_of(contents_, channel_, axis_count));
    for (const NpyTexts& text : texts) arrays.push_back(text.array);
    auto made = NpzFile::create(npz_, arrays);
    if (!made) {
      error_ = made.error();
      return;
    }
    file_ = std::move(*made);
    for (std::size_t k = 0; k < texts.size(); ++k) file_->add_bytes(first_text + k, texts[k].bytes);
  }

  void add(std::size_t place, const SetpointField& field, const setpoint_t& setpoint,
           double time_s) {
    std::visit(
        [&]<class Kind>(const Kind& source) {
          if constexpr (std::is_same_v<Kind, SetpointField::Time>) {
            file_->add(place, time_s);
          } else {
            const auto& member = setpoint.*source;
            if constexpr (std::is_array_v<std::remove_cvref_t<decltype(member)>>) {
              for (const auto number : std::span(member).first(checked_size(axis_count_)))
                file_->add(place, number);
            } else {
              file_->add(place, member);
            }
          }
        },
        field.source);
  }

  const recording::LogContents& contents_;
  int channel_;
  std::filesystem::path npz_;
  std::int64_t rows_ = 0;
  std::int64_t written_ = 0;
  int axis_count_ = 0;
  std::unique_ptr<NpzFile> file_;
  std::optional<NpzError> error_;
};

}  // namespace

RowsOrError write_setpoints_npz(const std::filesystem::path& log,
                                const recording::LogContents& contents, int channel,
                                const std::filesystem::path& npz) {
  SetpointNpz file(contents, channel, npz);
  const auto error = recording::for_each_setpoint(
      log, contents, channel, [&](const setpoint_t& setpoint) { file.take(setpoint); });
  if (error) return Unexpected<recording::LogError>(*error);
  return file.finish(log);
}

}  // namespace stanok::jobs
