#include "ui/sound/Synthesis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sagara::ui {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kStep_s = 1.0 / kSampleRate_Hz;

/// One turn of a sine, to be read between its points: error below 1e-6, a tenth of the time.
constexpr std::size_t kTable = 2048;
const std::array<float, kTable + 1>& sineTable() {
    static const std::array<float, kTable + 1> table = [] {
        std::array<float, kTable + 1> made{};
        for (std::size_t i = 0; i <= kTable; ++i)
            made[i] = static_cast<float>(std::sin(kTwoPi * static_cast<double>(i) / kTable));
        return made;
    }();
    return table;
}
/// Of turns, 0 or more.
float sine(double turns) {
    const std::array<float, kTable + 1>& table = sineTable();
    const double at = (turns - static_cast<double>(static_cast<long>(turns))) * kTable;
    const auto index = static_cast<std::size_t>(at);
    const auto part = static_cast<float>(at - static_cast<double>(index));
    return table[index] + part * (table[index + 1] - table[index]);
}
/// How often slow things are worked out, in samples: every half millisecond.
constexpr int kControl = 16;
double advanced(double phase, double frequency_Hz) {
    const double next = phase + frequency_Hz * kStep_s;
    return next - std::floor(next);
}
/// Soft limit: straight for what is quiet, never beyond 1.
float clipped(float x) { return std::clamp(x / (1.0F + 0.3F * std::abs(x)), -1.0F, 1.0F); }

}  // namespace

float Noise::next() {
    m_state ^= m_state << 13U;  // xorshift, Marsaglia 2003
    m_state ^= m_state >> 17U;
    m_state ^= m_state << 5U;
    return static_cast<float>(m_state) * (2.0F / 4294967296.0F) - 1.0F;
}

void Filter::set(double cutoff_Hz, double damping) {
    const double held_Hz = std::clamp(cutoff_Hz, 5.0, kSampleRate_Hz / 6.5);
    m_f = static_cast<float>(2.0 * std::sin(std::numbers::pi * held_Hz * kStep_s));
    m_q = static_cast<float>(std::clamp(damping, 0.02, 2.0));
    m_q = std::min(m_q, 2.0F / m_f - 0.5F * m_f);  // beyond this it is not stable
}

void Filter::run(float in) {
    m_low += m_f * m_band;
    m_high = in - m_low - m_q * m_band;
    m_band += m_f * m_high;
}

Glide::Glide(double time_s) : m_share(static_cast<float>(1.0 - std::exp(-kStep_s / time_s))) {}

float Glide::next(double target) {
    m_value += m_share * (static_cast<float>(target) - m_value);
    if (std::abs(m_value) < 1e-7F) m_value = 0.0F;  // or it would sink through the denormals for ever
    return m_value;
}

EngineVoice::EngineVoice(std::uint32_t seed) : m_noise(seed) { m_body.set(220.0, 0.9); }

void EngineVoice::fill(Samples out, double firing_Hz, double load) {
    constexpr int kCylinders = 6;
    // How much louder or softer each fires: gives the half orders that make a diesel sound like one.
    constexpr std::array<float, kCylinders> kUneven{1.0F, 0.78F, 1.16F, 0.88F, 1.1F, 0.8F};
    const bool runs = firing_Hz > 0.5;
    if (!runs && m_level.value() == 0.0F) return std::fill(out.begin(), out.end(), 0.0F);
    for (float& sample : out) {
        const double frequency_Hz =
            m_frequency.next(runs ? firing_Hz : static_cast<double>(m_frequency.value()));
        const float drive = m_load.next(std::clamp(load, 0.0, 1.0));
        const float level = m_level.next(runs ? 0.35 + 0.65 * load : 0.0);
        m_phase = advanced(m_phase, frequency_Hz / kCylinders);
        const double fired = m_phase * kCylinders;
        const auto cylinder = static_cast<std::size_t>(fired) % kCylinders;
        const double t = fired - std::floor(fired);
        // One stroke of pressure: rises at once, dies away; harder with load.
        const auto sharp = static_cast<float>(4.0 + 6.0 * static_cast<double>(drive));
        const auto after = static_cast<float>(t);
        const float stroke =
            kUneven[cylinder] * 4.0F * after * sharp * std::exp(-sharp * after) * (1.0F - after);
        if (m_untilControl-- <= 0) {
            m_body.set(140.0 + 2.2 * frequency_Hz + 160.0 * static_cast<double>(drive), 0.8);
            m_untilControl = kControl - 1;
        }
        m_body.run(stroke - 1.0F / sharp + 0.25F * m_noise.next() * (0.3F + stroke));
        sample = clipped(0.9F * level * m_body.band());
    }
}

NoiseVoice::NoiseVoice(std::uint32_t seed, const Colour& colour)
    : m_colour(colour), m_noise(seed), m_slow(seed * 2654435761U + 1U), m_drift(0.4 * colour.wander_s) {}

void NoiseVoice::fill(Samples out, double level, double beat_Hz) {
    const double wanted = std::clamp(level, 0.0, 1.0);
    if (wanted == 0.0 && m_level.value() == 0.0F) return std::fill(out.begin(), out.end(), 0.0F);
    for (float& sample : out) {
        if (m_hold-- <= 0) {
            m_target = m_slow.next();
            m_hold = static_cast<int>(m_colour.wander_s * kSampleRate_Hz);
        }
        const double drift =
            static_cast<double>(m_drift.next(static_cast<double>(m_target))) * m_colour.wander;
        const auto now = static_cast<double>(m_level.next(wanted));
        m_phase = advanced(m_phase, beat_Hz);
        const double beat =
            1.0 - m_colour.beat * (beat_Hz > 0.0 ? 0.5 + 0.5 * std::cos(kTwoPi * m_phase) : 0.0);
        if (m_untilControl-- <= 0) {
            m_untilControl = kControl - 1;
            m_filter.set((m_colour.from_Hz + now * (m_colour.to_Hz - m_colour.from_Hz)) * (1.0 + 0.5 * drift),
                         m_colour.damping);
        }
        m_filter.run(m_noise.next());
        const auto gain = static_cast<float>(now * beat * (1.0 + 0.6 * drift));
        sample = clipped(1.2F * gain * m_filter.band());
    }
}

void HornVoice::fill(Samples out, double pitch_Hz, bool on) {
    if (!on && m_level.value() == 0.0F) return std::fill(out.begin(), out.end(), 0.0F);
    m_throat.set(4.0 * pitch_Hz, 1.2);
    for (float& sample : out) {
        const float level = m_level.next(on ? 1.0 : 0.0);
        m_phase = advanced(m_phase, pitch_Hz);
        // A reed: rich in harmonics that fall off, and breath.
        float tone = 0.0F;
        for (int k = 1; k <= 7; ++k) tone += sine(k * m_phase) / static_cast<float>(k);
        m_throat.run(tone + 0.12F * m_noise.next());
        sample = clipped(0.55F * level * m_throat.low());
    }
}

void BellVoice::strike() {
    constexpr std::array<float, kPartials> kBell{0.5F, 0.9F, 0.7F, 0.5F, 0.35F, 0.2F};
    constexpr std::array<float, kPartials> kGong{1.0F, 0.8F, 0.6F, 0.35F, 0.2F, 0.1F};
    for (std::size_t i = 0; i < kPartials; ++i) m_rising[i] += m_kind == Kind::Bell ? kBell[i] : kGong[i];
}

void BellVoice::fill(Samples out, bool ringing) {
    // Partials of a bell (hum, prime, tierce, quint, nominal, upper) over its nominal; a gong is lower and
    // not harmonic either.
    constexpr std::array<double, kPartials> kBell_Hz{260.0, 520.0, 624.0, 780.0, 1040.0, 1560.0};
    constexpr std::array<double, kPartials> kGong_Hz{110.0, 167.0, 243.0, 331.0, 457.0, 611.0};
    const bool bell = m_kind == Kind::Bell;
    const double between_s = bell ? 0.25 : 0.45;
    const auto still = [](float strength) { return strength == 0.0F; };
    if (!ringing && std::all_of(m_strength.begin(), m_strength.end(), still))
        return std::fill(out.begin(), out.end(), 0.0F);
    for (float& sample : out) {
        if (ringing && m_untilStrike <= 0) {
            strike();
            m_untilStrike = static_cast<int>(between_s * kSampleRate_Hz);
        }
        if (m_untilStrike > 0) --m_untilStrike;
        float sum = 0.0F;
        for (std::size_t i = 0; i < kPartials; ++i) {
            // The clapper takes 2 ms; higher partials die sooner.
            const float rise = m_rising[i] * 0.015F;
            m_rising[i] -= rise;
            m_strength[i] += rise;
            const double life_s = (bell ? 1.4 : 2.6) / (1.0 + 0.5 * static_cast<double>(i));
            m_strength[i] *= static_cast<float>(1.0 - kStep_s / life_s);
            if (m_strength[i] < 1e-6F) m_strength[i] = 0.0F;
            m_phase[i] = advanced(m_phase[i], bell ? kBell_Hz[i] : kGong_Hz[i]);
            sum += m_strength[i] * sine(m_phase[i]);
        }
        sample = clipped(0.16F * sum);
    }
}

CableVoice::CableVoice(std::uint32_t seed) : m_noise(seed) {
    m_ring.set(1450.0, 0.25);
    m_rumble.set(160.0, 1.0);
}

void CableVoice::fill(Samples out, double links_Hz) {
    const bool runs = links_Hz > 0.1;
    if (!runs && m_level.value() == 0.0F) return std::fill(out.begin(), out.end(), 0.0F);
    for (float& sample : out) {
        const float level = m_level.next(runs ? std::min(1.0, 0.35 + links_Hz / 40.0) : 0.0);
        if (runs && --m_untilKnock <= 0) {
            const auto spread = static_cast<double>(1.0F + 0.35F * m_noise.next());
            m_untilKnock = static_cast<int>(spread * kSampleRate_Hz / links_Hz);
            m_edge += 0.7F + 0.3F * m_noise.next();
        }
        const float rise = 0.05F * m_edge;  // iron on iron, but not a step
        m_edge -= rise;
        m_knock = m_knock * 0.9975F + rise;
        m_ring.run(m_noise.next() * m_knock);
        m_rumble.run(m_noise.next() * (0.3F + m_knock));
        sample = clipped(level * (0.6F * m_ring.band() + 0.9F * m_rumble.band()));
    }
}

void AlarmVoice::fill(Samples out, bool on) {
    constexpr int kBeep = kSampleRate_Hz / 6;   // tone, and pause after it
    constexpr int kCycle = kSampleRate_Hz * 2;  // three of them in two seconds
    if (!on && m_level.value() == 0.0F) {
        m_at = 0;
        return std::fill(out.begin(), out.end(), 0.0F);
    }
    for (float& sample : out) {
        const bool sounding = on && m_at < 6 * kBeep && (m_at / kBeep) % 2 == 0;
        m_at = on ? (m_at + 1) % kCycle : 0;
        const float level = m_level.next(sounding ? 1.0 : 0.0);
        m_phase = advanced(m_phase, 1000.0);
        sample = clipped(0.35F * level * (sine(m_phase) + 0.25F * sine(3.0 * m_phase)));
    }
}

double whistlePitch_Hz(double length_m) {
    if (length_m >= 200.0) return 120.0;  // 70 to 200 Hz
    if (length_m >= 75.0) return 220.0;   // 130 to 350 Hz
    return 400.0;                         // 250 to 700 Hz
}

}  // namespace sagara::ui
