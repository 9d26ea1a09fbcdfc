// ErrandState: how far an errand is.
//
// Each kind of request is a small machine of states; a state carries what only it needs. All begin
// with `Asked`; one that is done has no state, its errand ends.
#pragma once

#include <cstdint>
#include <variant>

namespace stanok::channels::errand_states {

// Nothing of it has been done.
struct Asked {};

// ProgramLoad, Search, ProgramRun, LineRun: the target reads the text.
struct Loading {};
// ProgramRun, LineRun: the text is read and is to be started.
struct Loaded {};
// ProgramStop: the target comes to rest. ProgramReset: its run ends.
struct Ending {};
// Home: the axes search; then those that the scheme parks go back.
struct Homing {};
struct Parking {};
// ProgramReturn: what may stop it has been counted so far.
struct GoingBack {
  std::uint32_t hand_stops = 0;
};
// KinematicsSelect.
struct ChangingScheme {};

// M902: the spindle stops, the drive takes its position over, the axis turns to its index pulse.
struct SpindleStopping {};
struct LoopClosing {};
struct IndexSearching {};

// TapOut: the tap comes back to where it began.
struct TapComingOut {};

// EndWait: for the end of this run of the target.
struct AwaitingEnd {
  std::uint32_t run = 0;
};
// MarkWait: the asker has arrived.
struct AtMark {};
// InputWait.
struct WatchingInput {
  bool was_on = false;  // in the cycle before
};

}  // namespace stanok::channels::errand_states

namespace stanok::channels {

using ErrandState =
    std::variant<errand_states::Asked, errand_states::Loading, errand_states::Loaded,
                 errand_states::Ending, errand_states::Homing, errand_states::Parking,
                 errand_states::GoingBack, errand_states::ChangingScheme,
                 errand_states::SpindleStopping, errand_states::LoopClosing,
                 errand_states::IndexSearching, errand_states::TapComingOut,
                 errand_states::AwaitingEnd, errand_states::AtMark, errand_states::WatchingInput>;

}  // namespace stanok::channels
