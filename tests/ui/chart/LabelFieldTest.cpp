#include "ui/chart/LabelField.h"

#include <gtest/gtest.h>

namespace sagara::chart {
namespace {

TEST(LabelField, LabelsNeverOverlapAndStayInside) {
    const QRectF frame(0, 0, 60, 60);
    LabelField field(frame);
    std::vector<QRectF> placed;
    for (int i = 0; i < 60; ++i) {
        const auto box = field.place({30, 30}, {8, 3}, 1.0, 40.0);
        if (!box) continue;
        EXPECT_TRUE(frame.contains(*box));
        for (const QRectF& other : placed) EXPECT_FALSE(other.intersects(*box));
        placed.push_back(*box);
    }
    EXPECT_GT(placed.size(), 20u);
}

}  // namespace
}  // namespace sagara::chart
