#include "ui/sound/SoundBoard.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace sagara::ui {
namespace {

using namespace std::chrono_literals;

/// Which of the devices this process was started with; see CMakeLists.txt.
std::string device() {
    const char* const name = std::getenv("SAGARA_SOUND_DEVICE");
    return name == nullptr ? "" : name;
}

SoundBoard::Status settled(const SoundBoard& board) {
    for (int i = 0; i < 500 && board.status().device == SoundBoard::Device::Looking; ++i)
        std::this_thread::sleep_for(10ms);
    return board.status();
}

TEST(SoundBoard, WithoutADeviceItIsSilentAndSaysSo) {
    if (device() != "none") GTEST_SKIP() << "another device";
    SoundBoard board;
    EXPECT_EQ(settled(board).device, SoundBoard::Device::None);
    EXPECT_TRUE(board.status().name.empty());
    board.play({});
    board.soundTest();
    board.setMuted(true);
    board.lookAgain();
    EXPECT_EQ(settled(board).device, SoundBoard::Device::None);
}

TEST(SoundBoard, PlaysWhateverSceneForAWhileAndEnds) {
    if (device() != "null") GTEST_SKIP() << "another device";
    SoundBoard board;
    ASSERT_EQ(settled(board).device, SoundBoard::Device::Found);
    EXPECT_FALSE(board.status().name.empty());
    board.setVolume(3.0);
    EXPECT_EQ(board.volume(), 1.0);
    SoundScene scene;
    scene.engines = {{100.0, 70.0, 0.5, true}};
    scene.wind = scene.rain = 0.5;
    for (int i = 0; i < 60; ++i) {
        scene.horn = i % 20 < 10;
        scene.others.clear();
        if (i % 2 == 0) scene.others.push_back({3, {300.0, 100.0, 5.0}, 200.0, true, false, false});
        board.play(scene);
        board.setMuted(i > 30);
        std::this_thread::sleep_for(10ms);
    }
    EXPECT_EQ(board.status().device, SoundBoard::Device::Found);
}

TEST(SoundBoard, WhatIsPlayedComesOutAndFadesWhenNothingIsPlayedAnyMore) {
    if (device() != "wave") GTEST_SKIP() << "another device";
    const std::filesystem::path file = std::getenv("SAGARA_HEARD");
    std::filesystem::remove(file);
    {
        SoundBoard board;
        ASSERT_EQ(settled(board).device, SoundBoard::Device::Found);
        SoundScene scene;
        scene.horn = true;
        for (int i = 0; i < 20; ++i) {
            board.play(scene);
            std::this_thread::sleep_for(50ms);
        }
        std::this_thread::sleep_for(1500ms);
    }
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    ASSERT_GT(bytes.size(), 100'000U);
    // 16 bit or float as the driver likes: what is not nought is sound.
    const auto loudBytes = [&](std::size_t from, std::size_t to) {
        return std::count_if(bytes.begin() + static_cast<std::ptrdiff_t>(from),
                             bytes.begin() + static_cast<std::ptrdiff_t>(to), [](char c) { return c != 0; });
    };
    const std::size_t n = bytes.size();
    EXPECT_GT(loudBytes(n / 8, n / 4), static_cast<std::ptrdiff_t>(n / 16));
    EXPECT_LT(loudBytes(n - n / 10, n), static_cast<std::ptrdiff_t>(n / 100));
}

}  // namespace
}  // namespace sagara::ui
