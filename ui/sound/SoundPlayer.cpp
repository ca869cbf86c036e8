#include "ui/sound/SoundPlayer.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace sagara::ui {
namespace {

/// OpenAL: x to the right, y up, z backwards.
std::array<float, 3> axes(const SoundPlace& p) {
    return {static_cast<float>(p.starboard_m), static_cast<float>(p.up_m), static_cast<float>(-p.forward_m)};
}

/// Whether there is anything that could make a sound. Asked first, because ALSA's library writes its
/// complaints to the terminal where there is nothing.
bool anySoundSystem() {
    namespace fs = std::filesystem;
    if (std::getenv("ALSOFT_DRIVERS") != nullptr || std::getenv("PULSE_SERVER") != nullptr) return true;
    std::error_code ignored;
    fs::path runtime = "/run/user/" + std::to_string(::getuid());
    if (const char* const given = std::getenv("XDG_RUNTIME_DIR")) runtime = given;
    for (const fs::path& door :
         {runtime / "pulse/native", fs::path("/run/pulse/native"), fs::path("/dev/dsp")})
        if (fs::exists(door, ignored)) return true;
    for (const auto& entry : fs::directory_iterator("/dev/snd", ignored)) {
        const std::string name = entry.path().filename().string();
        if (name.rfind("pcm", 0) == 0 && name.back() == 'p') return true;  // plays
    }
    return false;
}

}  // namespace

SoundPlayer::~SoundPlayer() {
    if (m_context != nullptr) {
        for (Stream& stream : m_streams) {
            alSourceStop(stream.source);
            alDeleteSources(1, &stream.source);
            alDeleteBuffers(static_cast<ALsizei>(kBlocks), stream.buffers.data());
        }
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(m_context);
    }
    if (m_device != nullptr) alcCloseDevice(m_device);
}

bool SoundPlayer::open() {
    if (!anySoundSystem()) return false;
    m_device = alcOpenDevice(nullptr);
    if (m_device == nullptr) return false;
    m_context = alcCreateContext(m_device, nullptr);
    if (m_context == nullptr || alcMakeContextCurrent(m_context) == ALC_FALSE) {
        if (m_context != nullptr) alcDestroyContext(m_context);
        m_context = nullptr;
        return false;
    }
    alDistanceModel(AL_INVERSE_DISTANCE_CLAMPED);
    for (Stream& stream : m_streams) {
        alGenSources(1, &stream.source);
        alGenBuffers(static_cast<ALsizei>(kBlocks), stream.buffers.data());
        stream.free.assign(stream.buffers.begin(), stream.buffers.end());
    }
    return alGetError() == AL_NO_ERROR;
}

std::string SoundPlayer::deviceName() const {
    if (m_device == nullptr) return {};
    const bool all = alcIsExtensionPresent(m_device, "ALC_ENUMERATE_ALL_EXT") == ALC_TRUE;
    const ALCchar* const name =
        alcGetString(m_device, all ? ALC_ALL_DEVICES_SPECIFIER : ALC_DEVICE_SPECIFIER);
    return name == nullptr ? std::string() : std::string(name);
}

bool SoundPlayer::connected() const {
    if (alcIsExtensionPresent(m_device, "ALC_EXT_disconnect") == ALC_FALSE) return true;
    ALCint connected = 1;
    alcGetIntegerv(m_device, ALC_CONNECTED, 1, &connected);
    return connected != 0;
}

void SoundPlayer::play(const SoundScene& scene, double volume) {
    m_mixer.show(scene);
    const SoundScene::Listener& ear = scene.listener;
    alListenerf(AL_GAIN, static_cast<float>(volume));
    alListenerfv(AL_POSITION, axes(ear.at).data());
    const std::array<float, 6> facing{static_cast<float>(std::sin(ear.look_rad)),
                                      0.0F,
                                      static_cast<float>(-std::cos(ear.look_rad)),
                                      0.0F,
                                      1.0F,
                                      0.0F};
    alListenerfv(AL_ORIENTATION, facing.data());
    for (std::size_t i = 0; i < m_streams.size(); ++i) {
        place(i);
        feed(i);
    }
}

void SoundPlayer::place(std::size_t index) const {
    const ALuint source = m_streams[index].source;
    const SoundMixer::Placing placing = m_mixer.placing(index);
    alSourcei(source, AL_SOURCE_RELATIVE, placing.everywhere ? AL_TRUE : AL_FALSE);
    alSourcefv(source, AL_POSITION, axes(placing.everywhere ? SoundPlace{} : placing.at).data());
    alSourcef(source, AL_REFERENCE_DISTANCE, static_cast<float>(placing.fullWithin_m));
    alSourcef(source, AL_GAIN, static_cast<float>(placing.gain));
}

void SoundPlayer::feed(std::size_t index) {
    Stream& stream = m_streams[index];
    ALint played = 0;
    alGetSourcei(stream.source, AL_BUFFERS_PROCESSED, &played);
    for (; played > 0; --played) {
        ALuint buffer = 0;
        alSourceUnqueueBuffers(stream.source, 1, &buffer);
        stream.free.push_back(buffer);
    }
    while (!stream.free.empty() && m_mixer.fill(index, m_samples)) {
        toInt16(m_samples, m_words);
        const ALuint buffer = stream.free.back();
        stream.free.pop_back();
        alBufferData(buffer, AL_FORMAT_MONO16, m_words.data(),
                     static_cast<ALsizei>(m_words.size() * sizeof(std::int16_t)), kSampleRate_Hz);
        alSourceQueueBuffers(stream.source, 1, &buffer);
    }
    ALint state = AL_STOPPED;
    alGetSourcei(stream.source, AL_SOURCE_STATE, &state);
    // Starved or new: on again as soon as there is something.
    if (state != AL_PLAYING && stream.free.size() < kBlocks) alSourcePlay(stream.source);
}

}  // namespace sagara::ui
