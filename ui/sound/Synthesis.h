#pragma once

#include <array>
#include <cstdint>
#include <span>

/// Every sound is made by arithmetic, sample by sample; there are no sound files. A voice keeps its phase
/// from block to block and glides from what was wanted to what is wanted, so that blocks join without a
/// click. Samples are -1 to 1 and never beyond.
namespace sagara::ui {

inline constexpr int kSampleRate_Hz = 32'000;
using Samples = std::span<float>;

/// White noise, the same for the same seed.
class Noise final {
public:
    explicit Noise(std::uint32_t seed) : m_state(seed == 0 ? 1 : seed) {}
    float next();  ///< -1 to 1

private:
    std::uint32_t m_state;
};

/// Two-pole filter, state variable form (Chamberlin 1985): stable for cut-offs up to a sixth of the rate.
class Filter final {
public:
    void set(double cutoff_Hz, double damping);  ///< damping 2: none of a peak; 0.1: rings
    void run(float in);
    float low() const { return m_low; }
    float band() const { return m_band; }
    float high() const { return m_high; }

private:
    float m_f = 0.1F, m_q = 1.0F, m_low = 0.0F, m_band = 0.0F, m_high = 0.0F;
};

/// A value that glides to its target: 63 % of the way in `time_s`.
class Glide final {
public:
    explicit Glide(double time_s);
    float next(double target);
    float value() const { return m_value; }

private:
    float m_share;
    float m_value = 0.0F;
};

/// A diesel: harmonics of its firing frequency, each cylinder a little different, and mechanical noise.
class EngineVoice final {
public:
    explicit EngineVoice(std::uint32_t seed);
    /// 0 Hz: stopped. Load 0 to 1.
    void fill(Samples out, double firing_Hz, double load);

private:
    Noise m_noise;
    Filter m_body;
    Glide m_frequency{0.4}, m_load{0.4}, m_level{0.3};
    int m_untilControl = 0;
    double m_phase = 0.0;  ///< of the slow beat of all cylinders, 0 to 1
};

/// Water: bow wave, propeller wash, rain and wind are noise with a colour and a level that wander.
class NoiseVoice final {
public:
    struct Colour {
        double from_Hz = 100.0;  ///< at level 0
        double to_Hz = 100.0;    ///< at level 1
        double damping = 1.0;
        double wander = 0.0;    ///< of level and colour, 0 to 1
        double wander_s = 1.0;  ///< how slowly
        double beat = 0.0;      ///< depth of a beat (blades), 0 to 1
    };
    NoiseVoice(std::uint32_t seed, const Colour& colour);
    /// Level 0 to 1. `beat_Hz`: of propeller blades.
    void fill(Samples out, double level, double beat_Hz = 0.0);

private:
    Colour m_colour;
    Noise m_noise, m_slow;
    Filter m_filter;
    Glide m_level{0.3}, m_drift;
    float m_target = 0.0F;
    int m_untilControl = 0;
    int m_hold = 0;
    double m_phase = 0.0;
};

/// Whistle of a ship; COLREG annex III gives the pitch by length.
class HornVoice final {
public:
    explicit HornVoice(std::uint32_t seed) : m_noise(seed) {}
    void fill(Samples out, double pitch_Hz, bool on);

private:
    Noise m_noise;
    Filter m_throat;
    Glide m_level{0.06};
    double m_phase = 0.0;
};

/// Bell or gong: partials struck again and again while it rings, dying away when it no longer does.
class BellVoice final {
public:
    enum class Kind { Bell, Gong };
    explicit BellVoice(Kind kind) : m_kind(kind) {}
    void fill(Samples out, bool ringing);

private:
    static constexpr std::size_t kPartials = 6;
    void strike();
    Kind m_kind;
    std::array<double, kPartials> m_phase{};
    std::array<float, kPartials> m_strength{};
    std::array<float, kPartials> m_rising{};
    int m_untilStrike = 0;
};

/// Chain over the gipsy: knocks of links, many when it runs, few when the windlass works.
class CableVoice final {
public:
    explicit CableVoice(std::uint32_t seed);
    /// Links a second; 0: still.
    void fill(Samples out, double links_Hz);

private:
    Noise m_noise;
    Filter m_ring, m_rumble;
    float m_knock = 0.0F, m_edge = 0.0F;
    Glide m_level{0.1};
    int m_untilKnock = 0;
};

/// The bridge's alarm: three short tones, a pause.
class AlarmVoice final {
public:
    void fill(Samples out, bool on);

private:
    Glide m_level{0.006};
    double m_phase = 0.0;
    int m_at = 0;
};

/// Frequency of the whistle for a ship of this length: the middle of what COLREG annex III 1(b) allows.
double whistlePitch_Hz(double length_m);

}  // namespace sagara::ui
