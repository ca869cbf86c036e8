#include "ui/sound/SoundMixer.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sagara::ui {
namespace {

/// Below this a block is silence (-80 dB).
constexpr float kSilence = 1e-4F;

constexpr NoiseVoice::Colour kWash{60.0, 420.0, 0.9, 0.25, 0.5, 0.5};
constexpr NoiseVoice::Colour kBow{350.0, 1100.0, 1.1, 0.5, 0.7, 0.0};
constexpr NoiseVoice::Colour kWind{160.0, 520.0, 0.8, 0.7, 1.6, 0.0};
constexpr NoiseVoice::Colour kHowl{300.0, 900.0, 0.06, 0.5, 2.2, 0.0};  // rigging
constexpr NoiseVoice::Colour kRain{2600.0, 3800.0, 1.4, 0.15, 0.2, 0.0};

}  // namespace

SoundMixer::SoundMixer()
    : m_engines{EngineVoice(3), EngineVoice(5), EngineVoice(7), EngineVoice(11)},
      m_wash(29, kWash),
      m_bow(31, kBow),
      m_wind(37, kWind),
      m_howl(41, kHowl),
      m_rain(43, kRain) {}

void SoundMixer::show(const SoundScene& scene) {
    m_scene = scene;
    for (OtherVoice& voice : m_others) {
        const auto found =
            std::find_if(m_scene.others.begin(), m_scene.others.end(),
                         [&voice](const SoundScene::Other& other) { return voice.id == other.id; });
        if (found == m_scene.others.end()) {
            voice.id.reset();
            voice.heard.horn = voice.heard.bell = voice.heard.gong = false;  // it dies away where it was
        } else {
            voice.heard = *found;
        }
    }
    for (const SoundScene::Other& other : m_scene.others) {
        const auto known = [&other](const OtherVoice& voice) { return voice.id == other.id; };
        if (std::any_of(m_others.begin(), m_others.end(), known)) continue;
        const auto free = std::find_if(m_others.begin(), m_others.end(),
                                       [](const OtherVoice& voice) { return !voice.id.has_value(); });
        if (free == m_others.end()) break;
        free->id = other.id;
        free->heard = other;
    }
}

SoundMixer::Placing SoundMixer::placing(std::size_t source) const {
    const SoundPlace& ear = m_scene.listener.at;
    switch (source) {
        case Engines:
            return {m_scene.enginesAt, false, 25.0, 0.55};
        case Wash:
            return {m_scene.washAt, false, 20.0, 0.8};
        case BowWave:
            return {m_scene.bowAt, false, 20.0, 0.5};
        case Wind:
            return {{ear.forward_m + 10.0 * std::cos(m_scene.windFrom_rad),
                     ear.starboard_m + 10.0 * std::sin(m_scene.windFrom_rad), ear.up_m},
                    false,
                    20.0,
                    0.7};
        case Rain:
            return {{}, true, 1.0, 0.9};
        case Horn:
            return {m_scene.hornAt, false, 20.0, 1.0};
        case Bell:
            return {m_scene.forecastle, false, 25.0, 0.9};
        case Cable:
            return {m_scene.forecastle, false, 30.0, 0.9};
        case Alarm:
            return {{ear.forward_m + 1.5, ear.starboard_m, ear.up_m}, false, 5.0, 0.7};
        default:
            return {m_others[source - FirstOther].heard.at, false, 90.0, 1.0};
    }
}

bool SoundMixer::wanted(std::size_t source) const {
    switch (source) {
        case Engines:
            return std::any_of(m_scene.engines.begin(), m_scene.engines.end(),
                               [](const SoundScene::Engine& e) { return e.firing_Hz > 0.0; });
        case Wash:
            return m_scene.wash > 0.0;
        case BowWave:
            return m_scene.bowWave > 0.0;
        case Wind:
            return m_scene.wind > 0.0;
        case Rain:
            return m_scene.rain > 0.0;
        case Horn:
            return m_scene.horn;
        case Bell:
            return m_scene.bell;
        case Cable:
            return m_scene.cableLinks_Hz > 0.0;
        case Alarm:
            return m_scene.alarm;
        default: {
            const SoundScene::Other& other = m_others[source - FirstOther].heard;
            return other.horn || other.bell || other.gong;
        }
    }
}

void SoundMixer::fillEngines(Samples out) {
    std::vector<float> one(out.size());
    std::fill(out.begin(), out.end(), 0.0F);
    for (std::size_t i = 0; i < m_engines.size(); ++i) {
        const SoundScene::Engine engine =
            i < m_scene.engines.size() ? m_scene.engines[i] : SoundScene::Engine{};
        // No two engines are governed quite alike: they beat against one another.
        m_engines[i].fill(one, engine.firing_Hz * (1.0 + 0.004 * static_cast<double>(i)), engine.load);
        for (std::size_t k = 0; k < out.size(); ++k) out[k] = std::clamp(out[k] + 0.6F * one[k], -1.0F, 1.0F);
    }
}

void SoundMixer::fillOther(OtherVoice& voice, Samples out) {
    std::vector<float> one(out.size());
    voice.horn.fill(out, voice.heard.pitch_Hz, voice.heard.horn);
    voice.bell.fill(one, voice.heard.bell);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += one[k];
    voice.gong.fill(one, voice.heard.gong);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = std::clamp(out[k] + one[k], -1.0F, 1.0F);
}

void SoundMixer::synthesise(std::size_t source, Samples out) {
    switch (source) {
        case Engines:
            return fillEngines(out);
        case Wash:
            return m_wash.fill(out, m_scene.wash, m_scene.blades_Hz);
        case BowWave:
            return m_bow.fill(out, m_scene.bowWave);
        case Wind: {
            m_wind.fill(out, m_scene.wind);
            std::vector<float> howl(out.size());
            m_howl.fill(howl, std::max(0.0, m_scene.wind - 0.25));
            for (std::size_t k = 0; k < out.size(); ++k)
                out[k] = std::clamp(out[k] + 0.12F * howl[k], -1.0F, 1.0F);
            return;
        }
        case Rain:
            return m_rain.fill(out, m_scene.rain);
        case Horn:
            return m_horn.fill(out, m_scene.hornPitch_Hz, m_scene.horn);
        case Bell:
            return m_bell.fill(out, m_scene.bell);
        case Cable:
            return m_cable.fill(out, m_scene.cableLinks_Hz);
        case Alarm:
            return m_alarm.fill(out, m_scene.alarm);
        default:
            return fillOther(m_others[source - FirstOther], out);
    }
}

void SoundMixer::muffle(std::size_t source, Samples out) {
    // Engines come through the hull and the alarm is in the room.
    if (source == Engines || source == Alarm) return;
    const float open = m_doors.value();
    m_walls[source].set(1100.0 + 3600.0 * static_cast<double>(open), 1.3);
    const float gain = 0.5F + 0.5F * open;
    for (float& sample : out) {
        m_walls[source].run(sample);
        sample = std::clamp(gain * m_walls[source].low(), -1.0F, 1.0F);
    }
}

bool SoundMixer::fill(std::size_t source, Samples out) {
    if (source == Engines)  // once a block
        for (std::size_t k = 0; k < out.size(); ++k) m_doors.next(m_scene.listener.outside ? 1.0 : 0.0);
    synthesise(source, out);
    muffle(source, out);
    const bool silent = std::all_of(out.begin(), out.end(), [](float x) { return std::abs(x) < kSilence; });
    return !silent || wanted(source);
}

void toInt16(std::span<const float> samples, std::span<std::int16_t> out) {
    for (std::size_t i = 0; i < std::min(samples.size(), out.size()); ++i)
        out[i] = static_cast<std::int16_t>(std::lrint(32767.0F * std::clamp(samples[i], -1.0F, 1.0F)));
}

}  // namespace sagara::ui
