#include "core/base/Archive.h"

#include <gtest/gtest.h>

#include "core/base/Random.h"

namespace sagara::core {
namespace {

enum class Colour : std::uint8_t { Red, Green };

struct Inner {
    double x = 0.0;
    std::optional<int> y;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.x, self.y);
    }
    friend bool operator==(const Inner&, const Inner&) = default;
};

struct Outer {
    std::string name;
    std::vector<Inner> list;
    std::array<float, 3> triple{};
    std::variant<int, std::string, Inner> any;
    Colour colour = Colour::Red;
    bool flag = false;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.name, self.list, self.triple, self.any, self.colour, self.flag);
    }
    friend bool operator==(const Outer&, const Outer&) = default;
};

const Outer kSample{"harbour", {{1.5, 7}, {-2.25, std::nullopt}}, {1, 2, 3}, Inner{9.0, 4}, Colour::Green,
                    true};

TEST(Archive, WhatIsWrittenIsReadBack) { EXPECT_EQ(fromBytes<Outer>(toBytes(kSample)), kSample); }

TEST(Archive, EveryTruncationIsRefused) {
    const Bytes whole = toBytes(kSample);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_FALSE(fromBytes<Outer>(std::span(whole).first(size))) << size;
    }
}

TEST(Archive, LeftOverBytesAreRefused) {
    Bytes bytes = toBytes(kSample);
    bytes.push_back(std::byte{0});
    EXPECT_FALSE(fromBytes<Outer>(bytes));
}

TEST(Archive, RandomBuffersNeverCrash) {
    Random random(1);
    for (int i = 0; i < 10'000; ++i) {
        Bytes bytes(random.next() % 200);
        for (std::byte& b : bytes) b = static_cast<std::byte>(random.next());
        (void)fromBytes<Outer>(bytes);
    }
}

TEST(Archive, HashIsThatOfTheBytesAndChangesWithAnyBit) {
    Bytes bytes = toBytes(kSample);
    const std::uint64_t whole = archiveHash(kSample);
    EXPECT_EQ(whole, hashOf(bytes));
    for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        bytes[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
        EXPECT_NE(hashOf(bytes), whole);
        bytes[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    }
}

TEST(Hash, MatchesThePublishedFnv1aVectors) {
    EXPECT_EQ(toHex(hashOf(std::string_view(""))), "cbf29ce484222325");
    EXPECT_EQ(toHex(hashOf(std::string_view("a"))), "af63dc4c8601ec8c");
    EXPECT_EQ(toHex(hashOf(std::string_view("foobar"))), "85944171f73967e8");
}

}  // namespace
}  // namespace sagara::core
