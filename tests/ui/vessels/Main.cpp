#include <gtest/gtest.h>

#include <QApplication>

#include "ui/theme/Theme.h"

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    QApplication application(argc, argv);
    sagara::ui::applyTheme(application, sagara::ui::PaletteName::Day);
    return RUN_ALL_TESTS();
}
