#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ui/sound/SoundMixer.h"

struct ALCdevice_struct;  // as alc.h names them
struct ALCcontext_struct;

namespace sagara::ui {

/// The thin part that talks to OpenAL: keeps a few blocks of every source that is heard queued. All calls
/// from one thread.
class SoundPlayer final {
public:
    SoundPlayer() = default;
    ~SoundPlayer();
    SoundPlayer(const SoundPlayer&) = delete;
    SoundPlayer& operator=(const SoundPlayer&) = delete;

    /// False where there is no sound device.
    bool open();
    std::string deviceName() const;
    bool connected() const;
    /// Queues what is missing. To be called again within 60 ms.
    void play(const SoundScene& scene, double volume);

private:
    static constexpr std::size_t kBlocks = 4;
    static constexpr std::size_t kBlock = 1024;  ///< samples: 32 ms
    struct Stream {
        unsigned source = 0;
        std::array<unsigned, kBlocks> buffers{};
        std::vector<unsigned> free;
    };
    void feed(std::size_t index);
    void place(std::size_t index) const;

    ALCdevice_struct* m_device = nullptr;
    ALCcontext_struct* m_context = nullptr;
    SoundMixer m_mixer;
    std::array<Stream, SoundMixer::kSources> m_streams;
    std::vector<float> m_samples = std::vector<float>(kBlock);
    std::vector<std::int16_t> m_words = std::vector<std::int16_t>(kBlock);
};

}  // namespace sagara::ui
