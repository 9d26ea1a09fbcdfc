#include "motion/path/path_history.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace stanok::motion {
namespace {

// What every segment has; behind it stand the numbers that its kind has, those of axes for as many
// axes as the channel has.
struct Head {
  std::uint64_t block = 0;
  BlockTag tag;
  SegmentKind kind = SegmentKind::line;
  ChainPlace place = ChainPlace::within;
  bool begins_chain = false;
  bool rapid = false;
  PathMetric metric;
  SegmentBounds bounds;
  double length = 0.0;
  double feed_per_s = 0.0;
  const kinematics::Transform* transform = nullptr;
};
static_assert(std::is_trivially_copyable_v<Head>);

constexpr std::size_t record_max = sizeof(Head) + sizeof(Geometry);

// Numbers into a buffer, or out of it.
class Packer {
 public:
  explicit Packer(std::byte* to) : to_(to) {}
  void operator()(const void* from, std::size_t size) RT_SAFE {
    std::memcpy(to_ + size_, from, size);
    size_ += size;
  }
  [[nodiscard]] std::size_t size() const RT_SAFE { return size_; }

 private:
  std::byte* to_;
  std::size_t size_ = 0;
};

class Unpacker {
 public:
  explicit Unpacker(const std::byte* from) : from_(from) {}
  void operator()(void* to, std::size_t size) RT_SAFE {
    std::memcpy(to, from_, size);
    from_ += size;
  }

 private:
  const std::byte* from_;
};

// The numbers of a geometry, of which kind and metric are known, in the order in which they stand.
template <class Each, class Shape>
void visit_numbers(Shape& geometry, Each& each) RT_SAFE {
  const auto axes = static_cast<std::size_t>(geometry.metric.axis_count);
  each(geometry.start.data(), axes * sizeof(double));
  each(geometry.end.data(), axes * sizeof(double));
  if (geometry.kind == SegmentKind::line) return;
  if (geometry.kind == SegmentKind::arc) {
    each(geometry.plane.data(), sizeof geometry.plane);
    each(geometry.centre.data(), sizeof geometry.centre);
    each(&geometry.radius, sizeof geometry.radius);
    each(&geometry.radius_change, sizeof geometry.radius_change);
    each(&geometry.start_angle, sizeof geometry.start_angle);
    each(&geometry.sweep, sizeof geometry.sweep);
    return;
  }
  for (std::size_t axis = 0; axis < axes; ++axis) {
    auto& row = geometry.coefficients[static_cast<int>(axis)];
    each(row.data(), sizeof row);
  }
  if (geometry.kind == SegmentKind::quintic) each(geometry.knots.data(), sizeof geometry.knots);
}

}  // namespace

PathHistory::PathHistory(std::size_t bytes)
    : capacity_(bytes), bytes_(bytes > 0 ? new std::byte[bytes] : nullptr) {}

void PathHistory::note(const Segment& segment, ChainPlace place) RT_SAFE {
  if (is_empty() || !is_of_newest_block(segment.tag)) ++blocks_;
  last_ = segment.tag;
  std::array<std::byte, record_max> packed;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  Packer pack(packed.data());
  const Head head{.block = blocks_,
                  .tag = segment.tag,
                  .kind = segment.geometry.kind,
                  .place = place,
                  .begins_chain = rests(),
                  .rapid = segment.rapid,
                  .metric = segment.geometry.metric,
                  .bounds = segment.bounds,
                  .length = segment.length,
                  .feed_per_s = segment.feed_per_s,
                  .transform = segment.transform};
  pack(&head, sizeof head);
  visit_numbers(segment.geometry, pack);
  const auto size = static_cast<Size>(pack.size() + 2 * sizeof(Size));
  if (size > capacity_) return cut();
  while (newest_ + size - oldest_ > capacity_) oldest_ = behind(oldest_);
  write(newest_, &size, sizeof size);
  write(newest_ + sizeof size, packed.data(), pack.size());
  newest_ += size;
  last_place_ = place;
  write(newest_ - sizeof size, &size, sizeof size);
}

PathHistory::Place PathHistory::before(Place place) const RT_SAFE {
  Size size = 0;
  copy(place - sizeof size, &size, sizeof size);
  return place - size;
}

PathHistory::Place PathHistory::behind(Place place) const RT_SAFE {
  Size size = 0;
  copy(place, &size, sizeof size);
  return place + size;
}

void PathHistory::read(Place place, PassedSegment& record) const RT_SAFE {
  Size size = 0;
  copy(place, &size, sizeof size);
  std::array<std::byte, record_max> packed;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  copy(place + sizeof size, packed.data(), size - 2 * sizeof size);
  Unpacker unpack(packed.data());
  Head head;
  unpack(&head, sizeof head);
  record = {.segment = {}, .place = head.place, .begins_chain = head.begins_chain};
  Segment& segment = record.segment;
  segment.tag = head.tag;
  segment.geometry.kind = head.kind;
  segment.geometry.metric = head.metric;
  segment.bounds = head.bounds;
  segment.length = head.length;
  segment.feed_per_s = head.feed_per_s;
  segment.rapid = head.rapid;
  segment.transform = head.transform;
  visit_numbers(segment.geometry, unpack);
}

std::uint64_t PathHistory::blocks_between(Place first, Place last) const RT_SAFE {
  return first < last ? block_at(before(last)) - block_at(first) + 1 : 0;
}

std::uint32_t PathHistory::line_at(Place place) const RT_SAFE {
  BlockTag tag;
  copy(place + sizeof(Size) + offsetof(Head, tag), &tag, sizeof tag);
  return tag.line;
}

std::uint64_t PathHistory::block_at(Place place) const RT_SAFE {
  static_assert(offsetof(Head, block) == 0);
  std::uint64_t block = 0;
  copy(place + sizeof(Size), &block, sizeof block);
  return block;
}

void PathHistory::write(Place place, const void* from, std::size_t size) RT_SAFE {
  const std::size_t begin = place % capacity_;
  const std::size_t until_end = std::min(size, capacity_ - begin);
  std::memcpy(bytes_.get() + begin, from, until_end);
  std::memcpy(bytes_.get(), static_cast<const std::byte*>(from) + until_end, size - until_end);
}

void PathHistory::copy(Place place, void* to, std::size_t size) const RT_SAFE {
  const std::size_t begin = place % capacity_;
  const std::size_t until_end = std::min(size, capacity_ - begin);
  std::memcpy(to, bytes_.get() + begin, until_end);
  std::memcpy(static_cast<std::byte*>(to) + until_end, bytes_.get(), size - until_end);
}

}  // namespace stanok::motion
