#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/sea/SeaState.h"

namespace sagara::render {

/// A square picture with its mipmaps, each half the one before, down to `kSmallestMip` points a side.
template <typename T>
struct MipChain {
    std::vector<int> sizes;
    std::vector<std::vector<T>> levels;  ///< row by row, south to north, west to east
};
inline constexpr int kSmallestMip = 4;

/// The surface of one band over its tile, which repeats. A value belongs to the lattice point (row, column),
/// at row * step north and column * step east of a tile's corner; one corner is the origin of N.
struct SeaTile {
    double tile_m = 0.0;
    MipChain<float> height_m;  ///< above still water, shelter not applied
    /// Red, green: slope to the north and to the east; blue: upward acceleration; alpha: slope squared, whose
    /// mean over a mipmap tells how rough the sea is that it hides. Each byte b stands for (b / 127.5 - 1)
    /// times its scale, in alpha b / 255 times slopeScale squared.
    MipChain<std::uint32_t> surface;
    double slopeScale = 1.0;
    double accelerationScale_mps2 = 1.0;
};

/// The sea as it is drawn: every wave of core's table, laid on the three lattices by inverse FFT. Owns no GL;
/// the same table, sea and time give the same bytes in every process.
class SeaTiles {
public:
    explicit SeaTiles(const core::WaveTable& table);
    ~SeaTiles();
    SeaTiles(const SeaTiles&) = delete;
    SeaTiles& operator=(const SeaTiles&) = delete;

    /// The sea of this moment. Amplitudes are worked out anew only when the systems have changed.
    void advance(const core::SeaState& sea, core::SimTime time);

    const std::array<SeaTile, core::kWaveBands.size()>& tiles() const { return m_tiles; }
    /// Standard deviation of the upward acceleration of the two long bands.
    double accelerationRms_mps2() const { return m_accelerationRms_mps2; }

    /// Height as the graphics card samples the finest mipmaps: bilinear.
    double elevation_m(core::NorthEast p) const;

private:
    struct Band;
    void raise(const core::SeaState& sea);

    const core::WaveTable& m_table;
    std::vector<core::SeaSystem> m_systems;
    std::size_t m_activeCount = 0;
    double m_accelerationRms_mps2 = 0.0;
    std::array<SeaTile, core::kWaveBands.size()> m_tiles;
    std::array<std::unique_ptr<Band>, core::kWaveBands.size()> m_bands;
};

}  // namespace sagara::render
