#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Problems.h"
#include "core/base/Result.h"

/// What was measured of a real ship (or model) in a trial: plain data, SI, signs as everywhere.
namespace sagara::core {

enum class TrialKind { Turning, Zigzag, Spiral, Stopping, Speed, Decay, MotionLog };
inline constexpr std::size_t kTrialKinds = 7;
/// "turning", "zigzag", "spiral", "stopping", "speed", "decay", "motion-log".
const char* trialKindName(TrialKind kind);

/// What a column of a trial holds.
enum class Channel {
    Time,
    North,  ///< x along the heading from which headings are counted, of midship
    East,   ///< y to its right
    Heading,
    Surge,
    Sway,
    YawRate,
    Roll,
    Rudder,
    Shaft,
    Speed,  ///< through the water
    Pitch,
    Heave,  ///< downward
    Wave    ///< of the surface at midship, upward
};
inline constexpr std::size_t kChannels = 14;

struct SeaTrial {
    std::string name;  ///< of its file
    TrialKind kind = TrialKind::Turning;
    std::optional<double> approach_mps;
    std::optional<double> shaft_rps;
    std::optional<double> rudder_rad;       ///< ordered; of the first execute
    std::optional<double> switch_rad;       ///< heading at which a zigzag is reversed
    std::optional<double> waveHeading_rad;  ///< heading less direction of travel: 180 deg head sea
    double depth_m = std::numeric_limits<double>::infinity();
    /// Columns of equal length, empty where there is none; a cell left empty is NaN. Time rises, headings are
    /// not wrapped.
    std::array<std::vector<double>, kChannels> columns;

    const std::vector<double>& operator[](Channel c) const { return columns[static_cast<std::size_t>(c)]; }
    std::vector<double>& operator[](Channel c) { return columns[static_cast<std::size_t>(c)]; }
    bool has(Channel c) const { return !(*this)[c].empty(); }
    std::size_t rows() const;
    double duration_s() const { return (*this)[Channel::Time].back() - (*this)[Channel::Time].front(); }
    /// Straight between rows, the first and last held; NaN where the column has no number.
    double at(Channel c, double time_s) const;
};

/// Reads a trial's CSV: lines `# name: value` that say what it is, then names of columns, then rows. All
/// problems at once. What is accepted: see app/tools/README.md.
Result<SeaTrial, config::Problems> readSeaTrial(const std::string& name, std::string_view text);

}  // namespace sagara::core
