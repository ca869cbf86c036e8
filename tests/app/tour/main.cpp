// sagara-tour: walks through the station as its users do and keeps pictures of what they see. A test (without
// pictures) and what packaging/run does where nobody is at a display.
#include <QApplication>
#include <QCommandLineParser>
#include <QTemporaryDir>
#include <cstdio>

#include "app/files/AssetSource.h"
#include "render/headless/HeadlessGl.h"
#include "tests/app/tour/Tour.h"

namespace {

using namespace sagara;

std::vector<QSize> sizesOf(const QString& list, const std::vector<QSize>& otherwise) {
    std::vector<QSize> sizes;
    for (const QString& item : list.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const QStringList sides = item.split(QLatin1Char('x'));
        sizes.push_back({sides.value(0).toInt(), sides.value(1).toInt()});
    }
    return sizes.empty() ? otherwise : sizes;
}

std::vector<ui::PaletteName> palettesOf(const QString& list, const std::vector<ui::PaletteName>& otherwise) {
    std::vector<ui::PaletteName> palettes;
    for (const QString& name : list.split(QLatin1Char(','), Qt::SkipEmptyParts))
        palettes.push_back(name == QStringLiteral("night")  ? ui::PaletteName::Night
                           : name == QStringLiteral("dusk") ? ui::PaletteName::Dusk
                                                            : ui::PaletteName::Day);
    return palettes.empty() ? otherwise : palettes;
}

}  // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QCommandLineParser options;
    options.addHelpOption();
    options.addOptions(
        {{QStringLiteral("pictures"), QStringLiteral("folder for the pictures"), QStringLiteral("folder")},
         {QStringLiteral("data"), QStringLiteral("data folder"), QStringLiteral("folder")},
         {QStringLiteral("only"), QStringLiteral("one part of the walk"), QStringLiteral("part")},
         {QStringLiteral("all"), QStringLiteral("day and night, 1280x720 and 1920x1080")},
         {QStringLiteral("sizes"), QStringLiteral("of the window: 1280x720,3840x2160"),
          QStringLiteral("list")},
         {QStringLiteral("palettes"), QStringLiteral("day,dusk,night"), QStringLiteral("list")}});
    options.process(application);
    const QTemporaryDir scratch;
    const QString data =
        options.isSet(QStringLiteral("data")) ? options.value(QStringLiteral("data")) : scratch.path();
    auto store = run::Store::open(std::filesystem::path(data.toStdString()));
    if (!store) return std::fprintf(stderr, "sagara-tour: %s\n", store.error().c_str()), 2;
    tour::Screens::Look look;
    if (options.isSet(QStringLiteral("pictures"))) {
        look.folder = options.value(QStringLiteral("pictures")).toStdString();
        std::filesystem::create_directories(look.folder);
    }
    if (options.isSet(QStringLiteral("all"))) {
        look.sizes = {{1280, 720}, {1920, 1080}};
        look.palettes = {ui::PaletteName::Day, ui::PaletteName::Night};
    }
    look.sizes = sizesOf(options.value(QStringLiteral("sizes")), look.sizes);
    look.palettes = palettesOf(options.value(QStringLiteral("palettes")), look.palettes);
    render::StageOptions stage;
    stage.assets = files::assetFolder();
    stage.preset = station::presetOfThisMachine();
    stage.ownModels = (*store)->ownModels();
    stage.headless = !render::displayIsSet();
    station::Station station(**store, stage);
    station.resize(1280, 720);
    station.show();
    tour::Screens screens(station, look);
    tour::walk(screens, options.value(QStringLiteral("only")).toStdString());
    std::printf("%d pictures, %d things amiss\n", screens.pictures(),
                static_cast<int>(screens.failures().size()));
    return screens.failures().isEmpty() ? 0 : 1;
}
