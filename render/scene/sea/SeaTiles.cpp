#include "render/scene/sea/SeaTiles.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <thread>

#include "core/base/Trig.h"
#include "render/scene/sea/MipChain.h"

namespace sagara::render {
namespace {

using Complex = std::complex<float>;
constexpr int kLattice = static_cast<int>(core::kLatticeSize);
/// Points a side of the heights. The long band has waves of only four lattice points; twice as many keep what
/// is lost between them by bilinear sampling under 2 cm at Beaufort 5.
constexpr std::array<int, 3> kHeightSizes{2 * kLattice, kLattice, kLattice};
/// Below this a wave is not seen, and thousands of them together have less than 2 mm.
constexpr double kLeastAmplitude_m = 2e-5;

/// A square inverse transform with its own memory.
class Transform {
public:
    explicit Transform(int size)
        : m_size(size),
          m_data(fftwf_alloc_complex(static_cast<std::size_t>(size) * static_cast<std::size_t>(size))),
          // Not FFTW_MEASURE: it may choose differently from run to run, and with it the last bits.
          m_plan(fftwf_plan_dft_2d(size, size, m_data, m_data, FFTW_BACKWARD, FFTW_ESTIMATE)) {}
    ~Transform() {
        fftwf_destroy_plan(m_plan);
        fftwf_free(m_data);
    }
    Transform(const Transform&) = delete;
    Transform& operator=(const Transform&) = delete;

    Complex* data() { return reinterpret_cast<Complex*>(m_data); }
    void clear() { std::fill_n(data(), m_size * m_size, Complex{}); }
    void run() { fftwf_execute(m_plan); }
    /// Index of wave number (i, j), which may be negative.
    std::size_t index(int i, int j) const {
        const int row = i < 0 ? i + m_size : i, column = j < 0 ? j + m_size : j;
        return static_cast<std::size_t>(row * m_size + column);
    }

private:
    int m_size;
    fftwf_complex* m_data;
    fftwf_plan m_plan;
};

float scaled(double value, double scale) { return static_cast<float>(127.5 * value / scale); }
std::uint32_t byteOf(float value) {
    return static_cast<std::uint32_t>(std::clamp(static_cast<int>(value + 127.5f + 0.5f), 0, 255));
}

}  // namespace

/// Waves of one band and the transforms that lay them out.
struct SeaTiles::Band {
    struct Wave {
        int i, j;  ///< wave number in steps of the lattice, north and east
        double kNorth_radpm, kEast_radpm, omega_radps, phase_rad, amplitude_m;
    };
    explicit Band(int size) : heightSize(size), heights(size), slopes(kLattice) {}

    int heightSize;
    std::vector<Wave> waves;
    Transform heights;  ///< real part height, imaginary part acceleration
    Transform slopes;   ///< real part to the north, imaginary part to the east

    void layOut(core::SimTime time);
    void fill(SeaTile& tile);
};

/// Two real fields in one complex transform: F + i G, each with its own half of a wave at +k and the other
/// half, its conjugate, at -k.
void SeaTiles::Band::layOut(core::SimTime time) {
    heights.clear();
    slopes.clear();
    for (const Wave& w : waves) {
        const core::SinCos turn = core::sinCos(w.phase_rad - w.omega_radps * time.seconds());
        const auto re = static_cast<float>(0.5 * w.amplitude_m * turn.cos);
        const auto im = static_cast<float>(0.5 * w.amplitude_m * turn.sin);
        const auto acceleration = static_cast<float>(-w.omega_radps * w.omega_radps);
        const auto kN = static_cast<float>(w.kNorth_radpm), kE = static_cast<float>(w.kEast_radpm);
        const Complex h(re, im), conjugate(re, -im);
        const Complex i1(0.0f, 1.0f);
        heights.data()[heights.index(w.i, w.j)] += h * Complex(1.0f, acceleration);
        heights.data()[heights.index(-w.i, -w.j)] += conjugate * Complex(1.0f, acceleration);
        slopes.data()[slopes.index(w.i, w.j)] += h * (i1 * kN - kE);
        slopes.data()[slopes.index(-w.i, -w.j)] += conjugate * (kE - i1 * kN);
    }
    heights.run();
    slopes.run();
}

void SeaTiles::Band::fill(SeaTile& tile) {
    const Complex* height = heights.data();
    auto& level = tile.height_m.levels[0];
    for (std::size_t n = 0; n < level.size(); ++n) level[n] = height[n].real();

    const auto toByte = scaled(1.0, tile.slopeScale);
    const auto accelerationToByte = scaled(1.0, tile.accelerationScale_mps2);
    const int every = heightSize / kLattice;
    auto& surface = tile.surface.levels[0];
    for (int row = 0; row < kLattice; ++row) {
        for (int column = 0; column < kLattice; ++column) {
            const auto n = static_cast<std::size_t>(row * kLattice + column);
            const Complex s = slopes.data()[n] * toByte;
            const float a = height[every * (row * heightSize + column)].imag() * accelerationToByte;
            const float square = std::norm(s) * (2.0f / 127.5f) - 127.5f;
            surface[n] = byteOf(s.real()) | byteOf(s.imag()) << 8 | byteOf(a) << 16 | byteOf(square) << 24;
        }
    }
    halveAll(tile.height_m);
    halveAll(tile.surface);
}

SeaTiles::SeaTiles(const core::WaveTable& table) : m_table(table) {
    for (std::size_t b = 0; b < m_bands.size(); ++b) {
        m_bands[b] = std::make_unique<Band>(kHeightSizes[b]);
        m_tiles[b].tile_m = core::kWaveBands[b].tile_m;
        m_tiles[b].height_m = emptyChain<float>(kHeightSizes[b]);
        m_tiles[b].surface = emptyChain<std::uint32_t>(kLattice);
    }
}

SeaTiles::~SeaTiles() = default;

void SeaTiles::raise(const core::SeaState& sea) {
    for (auto& band : m_bands) band->waves.clear();
    std::array<double, 3> slope2{}, acceleration2{};
    const core::SeaSurface surface(m_table, sea);
    for (const auto& [c, amplitude_m] : surface.waves()) {
        if (amplitude_m < kLeastAmplitude_m) continue;
        const double step = core::kWaveBands[c.band].step_radpm();
        m_bands[c.band]->waves.push_back({static_cast<int>(std::lround(c.kNorth_radpm / step)),
                                          static_cast<int>(std::lround(c.kEast_radpm / step)), c.kNorth_radpm,
                                          c.kEast_radpm, c.omega_radps, c.phase_rad, amplitude_m});
        const double k2 = c.kNorth_radpm * c.kNorth_radpm + c.kEast_radpm * c.kEast_radpm;
        slope2[c.band] += 0.5 * amplitude_m * amplitude_m * k2;
        acceleration2[c.band] += 0.5 * amplitude_m * amplitude_m * std::pow(c.omega_radps, 4);
    }
    for (std::size_t b = 0; b < m_tiles.size(); ++b) {
        m_tiles[b].slopeScale = std::max(1e-3, 3.5 * std::sqrt(slope2[b]));
        m_tiles[b].accelerationScale_mps2 = std::max(1e-3, 4.0 * std::sqrt(acceleration2[b]));
    }
    m_accelerationRms_mps2 = std::sqrt(acceleration2[0] + acceleration2[1]);
}

void SeaTiles::advance(const core::SeaState& sea, core::SimTime time) {
    if (sea.systems != m_systems || sea.active.size() != m_activeCount) {
        raise(sea);
        m_systems = sea.systems;
        m_activeCount = sea.active.size();
    }
    const auto layOut = [&](std::size_t b) {
        m_bands[b]->layOut(time);
        m_bands[b]->fill(m_tiles[b]);
    };
    // The long band is as much work as the others together, and nothing can be drawn before all are there.
    std::thread others([&] {
        for (std::size_t b = 1; b < m_bands.size(); ++b) layOut(b);
    });
    layOut(0);
    others.join();
}

double SeaTiles::elevation_m(core::NorthEast p) const {
    double sum_m = 0.0;
    for (const SeaTile& tile : m_tiles) {
        const int size = tile.height_m.sizes[0];
        const auto& values = tile.height_m.levels[0];
        const double row = p.north_m / tile.tile_m * size, column = p.east_m / tile.tile_m * size;
        const double south = std::floor(row), west = std::floor(column);
        const auto at = [&](double r, double c) {
            const int i = static_cast<int>(r) & (size - 1), j = static_cast<int>(c) & (size - 1);
            return static_cast<double>(values[static_cast<std::size_t>(i * size + j)]);
        };
        const double fr = row - south, fc = column - west;
        sum_m += (1 - fr) * ((1 - fc) * at(south, west) + fc * at(south, west + 1)) +
                 fr * ((1 - fc) * at(south + 1, west) + fc * at(south + 1, west + 1));
    }
    return sum_m;
}

}  // namespace sagara::render
