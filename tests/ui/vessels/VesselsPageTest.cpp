// The admin's page driven as a person would.
#include "ui/vessels/VesselsPage.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "FakeLibrary.h"
#include "core/base/Units.h"
#include "ui/theme/Theme.h"
#include "ui/vessels/DocumentTree.h"
#include "ui/vessels/ModelDialog.h"
#include "ui/vessels/NewVesselDialog.h"
#include "ui/vessels/SectionsView.h"
#include "ui/vessels/TrialsPanel.h"
#include "ui/vessels/VesselEditor.h"

namespace sagara::ui {
namespace {

class Vessels : public ::testing::Test {
protected:
    test::FakeLibrary library;
    std::unique_ptr<render::Stage> stage;
    std::unique_ptr<VesselsPage> page;

    void SetUp() override { open(); }
    void open() {
        page = std::make_unique<VesselsPage>(
            library, [this](const std::shared_ptr<const core::World>& world) { return stageFor(world); },
            [] { return std::string("2027-01-15"); });
        page->setColours(PaletteName::Day);
        page->resize(1280, 720);
        page->show();
        QApplication::processEvents();
    }
    void TearDown() override {
        page.reset();
        stage.reset();
    }
    /// The scene only where pictures are kept: it takes seconds.
    render::Stage* stageFor(const std::shared_ptr<const core::World>& world) {
        if (std::getenv("SAGARA_UI_PICTURES") == nullptr) return nullptr;
        if (!stage) {
            render::StageOptions options;
            options.assets = SAGARA_ASSETS;
            options.preset = render::Preset::Low;
            options.headless = true;
            options.ownModels = library.ownModels();
            auto opened = render::Stage::open(options);
            if (!opened) return nullptr;
            stage = std::move(opened).value();
        }
        return stage->show(world) ? nullptr : stage.get();
    }
    template <typename Widget>
    Widget* find(const char* name, QWidget* in = nullptr) {
        auto* const widget = (in ? in : page.get())->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    QString message() { return find<QLabel>("message")->text(); }
    void keep(QWidget* widget, const QString& name) {
        const char* folder = std::getenv("SAGARA_UI_PICTURES");
        if (folder == nullptr) return;
        for (const auto& [palette, word] :
             {std::pair{PaletteName::Day, "day"}, {PaletteName::Night, "night"}}) {
            applyTheme(*qobject_cast<QApplication*>(QApplication::instance()), palette);
            page->setColours(palette);
            for (int i = 0; i < 8; ++i) QTest::qWait(120);
            widget->grab().save(
                QStringLiteral("%1/%2-%3.png").arg(QString::fromUtf8(folder), name, QLatin1String(word)));
        }
        applyTheme(*qobject_cast<QApplication*>(QApplication::instance()), PaletteName::Day);
        page->setColours(PaletteName::Day);
    }
};

TEST_F(Vessels, AreListedSearchedAndShownWithTheirSources) {
    auto* const list = find<QListWidget>("vessels");
    ASSERT_EQ(list->count(), 2);
    ASSERT_TRUE(page->choose("esso-osaka"));
    EXPECT_EQ(find<QLabel>("title")->text(), QStringLiteral("Esso Osaka, 278 000 dwt tanker"));
    auto* const tree = page->findChild<DocumentTree*>();
    QTreeWidgetItem* const steering = tree->itemAt("steering");
    ASSERT_NE(steering, nullptr);
    EXPECT_EQ(steering->text(DocumentTree::Value), QStringLiteral("estimated"));
    EXPECT_TRUE(steering->text(DocumentTree::About).contains(QStringLiteral("Crane 1979")));
    ASSERT_NE(tree->itemAt("hull.lengthBp_m"), nullptr);
    EXPECT_EQ(tree->itemAt("hull.lengthBp_m")->text(DocumentTree::Unit), QStringLiteral("m"));
    keep(page.get(), QStringLiteral("vessels-ship"));
    find<QTabWidget>("tabs")->setCurrentIndex(1);
    keep(page.get(), QStringLiteral("vessels-data"));
    find<QLineEdit>("search")->setText(QStringLiteral("patrol"));
    EXPECT_EQ(list->count(), 1);
    EXPECT_EQ(page->chosen(), "patrol51");
    find<QLineEdit>("search")->setText(QStringLiteral("no such ship"));
    EXPECT_EQ(list->count(), 0);
    EXPECT_FALSE(find<QPushButton>("edit")->isEnabled());
}

TEST_F(Vessels, ANewOneFromParticularsIsMadeAndTested) {
    page->openNew();
    auto* const dialog = page->findChild<NewVesselDialog*>();
    ASSERT_NE(dialog, nullptr);
    auto* const create = find<QPushButton>("create", dialog);
    EXPECT_FALSE(create->isEnabled());  // no name yet
    EXPECT_TRUE(find<QLabel>("note-name", dialog)->isVisible());
    find<QLineEdit>("name", dialog)->setText(QStringLiteral("MV Ruhuna"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return create->isEnabled(); }, 3000));
    EXPECT_EQ(find<QLineEdit>("id", dialog)->text(), QStringLiteral("mv-ruhuna"));
    find<QDoubleSpinBox>("power_W", dialog)->setValue(100.0);  // 12.5 kn on 100 kW
    ASSERT_TRUE(QTest::qWaitFor([&] { return !create->isEnabled(); }, 3000));
    EXPECT_TRUE(find<QLabel>("note-power_W", dialog)->text().contains(QStringLiteral("at least")));
    keep(dialog, QStringLiteral("vessels-new-refused"));
    find<QDoubleSpinBox>("power_W", dialog)->setValue(0.0);  // not known
    ASSERT_TRUE(QTest::qWaitFor([&] { return create->isEnabled(); }, 3000));
    EXPECT_TRUE(find<QLabel>("summary", dialog)->text().contains(QStringLiteral("kW, by resistance")));
    keep(dialog, QStringLiteral("vessels-new-without-power"));
    find<QDoubleSpinBox>("power_W", dialog)->setValue(2200.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return create->isEnabled(); }, 3000));
    keep(dialog, QStringLiteral("vessels-new"));
    QTest::mouseClick(create, Qt::LeftButton);
    ASSERT_EQ(library.vessels.count("mv-ruhuna"), 1u);
    EXPECT_EQ(page->chosen(), "mv-ruhuna");
    keep(page.get(), QStringLiteral("vessels-estimated"));

    auto* const trials = page->findChild<TrialsPanel*>();
    find<QTabWidget>("tabs")->setCurrentWidget(trials);
    QSignalSpy done(trials, &TrialsPanel::finished);
    QTest::mouseClick(find<QPushButton>("runTrials"), Qt::LeftButton);
    EXPECT_TRUE(trials->running());
    ASSERT_TRUE(QTest::qWaitFor([&] { return done.count() == 1; }, 120000));
    auto* const checks = find<QTableWidget>("imoChecks");
    ASSERT_EQ(checks->rowCount(), 9);
    for (int row = 0; row < checks->rowCount(); ++row) EXPECT_FALSE(checks->item(row, 1)->text().isEmpty());
    keep(page.get(), QStringLiteral("vessels-test"));
    page->resize(1920, 1080);
    keep(page.get(), QStringLiteral("vessels-test-1080"));
    find<QTabWidget>("tabs")->setCurrentIndex(0);
    keep(page.get(), QStringLiteral("vessels-estimated-1080"));
}

TEST_F(Vessels, TrialsAreCancelled) {
    ASSERT_TRUE(page->choose("esso-osaka"));
    auto* const trials = page->findChild<TrialsPanel*>();
    trials->start();
    trials->cancel();
    EXPECT_FALSE(trials->running());
    ASSERT_TRUE(QTest::qWaitFor([&] { return find<QPushButton>("runTrials")->isEnabled(); }, 20000));
    EXPECT_FALSE(trials->trials());
}

TEST_F(Vessels, EveryFieldIsCheckedAndSaysWhatIsAccepted) {
    VesselEditor editor(library.text("patrol51"), PaletteName::Day,
                        [this](const std::string& id, const std::string& name, const std::string& text) {
                            return library.save(id, name, text);
                        });
    editor.show();
    auto* const tree = editor.findChild<DocumentTree*>();
    auto* const save = editor.findChild<QPushButton*>(QStringLiteral("save"));
    EXPECT_FALSE(save->isEnabled());
    QTreeWidgetItem* const diameter = tree->itemAt("propulsion.units[0].diameter_m");
    ASSERT_NE(diameter, nullptr);
    tree->setCurrentItem(diameter);
    EXPECT_TRUE(
        editor.findChild<QLabel*>(QStringLiteral("hint"))->text().contains(QStringLiteral("0.1 to 15 m")));
    diameter->setText(DocumentTree::Value, QStringLiteral("99"));
    EXPECT_EQ(editor.problemCount(), 1u);
    EXPECT_TRUE(diameter->text(DocumentTree::About).contains(QStringLiteral("0.1 to 15 m")));
    EXPECT_FALSE(save->isEnabled());
    tree->setFilter(QString());
    if (std::getenv("SAGARA_UI_PICTURES")) {
        editor.setParent(page.get(), Qt::Dialog);
        editor.show();
        keep(&editor, QStringLiteral("vessels-edit"));
    }
    diameter->setText(DocumentTree::Value, QStringLiteral("1,7"));
    EXPECT_EQ(editor.problemCount(), 0u);
    EXPECT_TRUE(save->isEnabled());
    diameter->setText(DocumentTree::Value, QStringLiteral("wide"));
    EXPECT_EQ(editor.problemCount(), 1u);
    diameter->setText(DocumentTree::Value, QStringLiteral("1.7"));

    // Lists grow and shrink, and what was done is taken back.
    ASSERT_TRUE(tree->choose("mooring.fairleads[0].id"));
    ASSERT_TRUE(tree->addLikeCurrent());
    EXPECT_NE(tree->itemAt("mooring.fairleads[8]"), nullptr);
    QTest::mouseClick(editor.findChildren<QPushButton*>().at(2), Qt::LeftButton);  // undo
    EXPECT_EQ(tree->itemAt("mooring.fairleads[8]"), nullptr);
    ASSERT_TRUE(save->isEnabled());
    QTest::mouseClick(save, Qt::LeftButton);
    EXPECT_FALSE(library.vessels["patrol51"].shipped);
    const core::Vessel saved = core::loadVessel("x", library.text("patrol51")).value();
    EXPECT_EQ(saved.propulsion.units[0].diameter_m, 1.7);
}

TEST_F(Vessels, EveryNumberOfADocumentHasAField) {
    DocumentTree tree(DocumentTree::Use::Edit);
    tree.setDocument(library.text("esso-osaka"));
    EXPECT_TRUE(core::loadVessel("round trip", tree.text()));
    int numbers = 0;
    for (QTreeWidgetItemIterator it(&tree); *it; ++it) numbers += (*it)->flags().testFlag(Qt::ItemIsEditable);
    EXPECT_GT(numbers, 150);
    EXPECT_EQ(acceptedAt(library.text("esso-osaka"), "steering.limit_deg"), "10 to 70 deg");
}

TEST_F(Vessels, DeletingIsRefusedWhileAScenarioUsesHer) {
    ASSERT_TRUE(page->choose("patrol51"));
    page->retireOrRestore();
    EXPECT_FALSE(library.vessels["patrol51"].retired);
    EXPECT_TRUE(message().contains(QStringLiteral("Basic Navigation"))) << message().toStdString();
    ASSERT_TRUE(page->choose("esso-osaka"));
    page->retireOrRestore();
    EXPECT_TRUE(library.vessels["esso-osaka"].retired);
    EXPECT_FALSE(page->choose("esso-osaka"));
    QTest::mouseClick(find<QAbstractButton>("showRetired"), Qt::LeftButton);
    ASSERT_TRUE(page->choose("esso-osaka"));
    EXPECT_EQ(find<QPushButton>("retire")->text(), QStringLiteral("Restore"));
    page->retireOrRestore();
    EXPECT_FALSE(library.vessels["esso-osaka"].retired);
}

TEST_F(Vessels, AreExportedAndImportedAsOneFileWithTheirModel) {
    // A model with its material and texture, attached to the patrol vessel.
    const auto source = library.folder / "source";
    std::filesystem::create_directories(source);
    const auto put = [&](const char* name, const std::string& bytes) {
        FILE* const f = std::fopen((source / name).c_str(), "wb");
        std::fwrite(bytes.data(), 1, bytes.size(), f);
        std::fclose(f);
    };
    put("boat.obj",
        "mtllib boat.mtl\nv -1 0 0\nv 1 0 0\nv 0 0.3 0\nv 0 0 0.4\nusemtl m\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 "
        "3 4\n");
    put("boat.mtl", "newmtl m\nKd 0.8 0.2 0.2\n");
    put("other.png", "not named");
    auto dialog = std::make_unique<ModelDialog>(
        library.text("patrol51"), library.ownModels(), PaletteName::Day,
        [this](const std::shared_ptr<const core::World>& world) { return stageFor(world); },
        [this](const std::string& text) { return library.save("patrol51", "51.5 m patrol vessel", text); },
        page.get());
    ASSERT_FALSE(dialog->takeFile(source / "boat.obj"));
    find<QComboBox>("up", dialog.get())->setCurrentText(QStringLiteral("+z"));
    auto* const save = find<QPushButton>("save", dialog.get());
    QTest::qWait(500);
    EXPECT_FALSE(save->isEnabled());  // licence and source are missing
    find<QLineEdit>("licence", dialog.get())->setText(QStringLiteral("our own"));
    find<QLineEdit>("source", dialog.get())->setText(QStringLiteral("a test"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return save->isEnabled(); }, 3000));
    if (std::getenv("SAGARA_UI_PICTURES")) {
        dialog->show();
        keep(dialog.get(), QStringLiteral("vessels-model"));
    }
    dialog->accept();
    EXPECT_TRUE(std::filesystem::exists(library.ownModels() / "attached/patrol51/boat.mtl"));
    EXPECT_FALSE(std::filesystem::exists(library.ownModels() / "attached/patrol51/other.png"));

    dialog.reset();
    open();
    ASSERT_TRUE(page->choose("patrol51"));
    const auto file = library.folder / "patrol.json";
    ASSERT_FALSE(page->exportTo(file));
    std::filesystem::remove_all(library.ownModels());
    const auto trouble = page->importFrom(file);
    ASSERT_FALSE(trouble) << *trouble;
    EXPECT_EQ(page->chosen(), "patrol51-2");  // the one that was there stays
    EXPECT_TRUE(std::filesystem::exists(library.ownModels() / "attached/patrol51/boat.obj"));
    EXPECT_TRUE(std::filesystem::exists(library.ownModels() / "attached/patrol51/boat.mtl"));
}

TEST_F(Vessels, ADocumentOfParticularsAloneIsImportedWhole) {
    const auto file = library.folder / "ruhuna.json";
    std::ofstream(file) << R"({"document": "vessel", "version": 1, "id": "ruhuna", "name": "MV Ruhuna",
        "type": "general cargo", "particulars": {"lengthOverall_m": 88, "lengthBp_m": 84, "beam_m": 14,
        "draught_m": 5.4, "blockCoefficient": 0.76, "speed_kn": 12.5, "power_kW": 2200}})";
    const auto trouble = page->importFrom(file);
    ASSERT_FALSE(trouble) << *trouble;
    EXPECT_EQ(page->chosen(), "ruhuna");
    const std::string text = library.text("ruhuna");
    EXPECT_EQ(text.find("particulars\":"), std::string::npos);
    EXPECT_NE(text.find("\"telegraph_rpm\""), std::string::npos);  // to be seen and changed
}

TEST_F(Vessels, APilotCardRunsTheTrialsFirst) {
    ASSERT_TRUE(page->choose("patrol51"));
    const char* folder = std::getenv("SAGARA_UI_PICTURES");
    const QString file = folder ? QStringLiteral("%1/pilot-card.pdf").arg(QString::fromUtf8(folder))
                                : QString::fromStdString((library.folder / "card.pdf").string());
    QSignalSpy written(page.get(), &VesselsPage::pilotCardWritten);
    page->writePilotCard(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 1; }, 120000)) << message().toStdString();
    EXPECT_GT(std::filesystem::file_size(file.toStdString()), 8000u);
}

TEST_F(Vessels, WithoutADatabaseNothingCanBeChangedAndThePageSaysWhy) {
    library.noDatabase = "the database is locked";
    open();
    EXPECT_EQ(message(), QStringLiteral("the database is locked"));
    EXPECT_FALSE(find<QPushButton>("new")->isEnabled());
    EXPECT_FALSE(find<QPushButton>("retire")->isEnabled());
    EXPECT_TRUE(find<QPushButton>("export")->isEnabled());
}

TEST(Sections, KeepWaterplaneAreaAndVolume) {
    const core::Vessel v = core::loadVessel("esso", test::readAsset("vessels/esso-osaka.json")).value();
    const std::vector<core::HullStation> sections = sectionsOf(v.hull);
    double water_m2 = 0.0, volume_m3 = 0.0;
    for (std::size_t i = 1; i < sections.size(); ++i) {
        const double step_m = sections[i].x_m - sections[i - 1].x_m;
        water_m2 += 0.5 * step_m * (sections[i].breadth_m + sections[i - 1].breadth_m);
        volume_m3 += 0.5 * step_m * (sections[i].area_m2 + sections[i - 1].area_m2);
    }
    // 5 %: 20 straight pieces, ends cut to what fits into the waterline
    EXPECT_NEAR(water_m2 / v.hull.waterplaneArea_m2(), 1.0, 0.05);
    EXPECT_NEAR(volume_m3 / v.hull.displacement_m3, 1.0, 0.05);
    // A section's own area comes back from its half breadths.
    const core::HullStation& s = sections[10];
    double area_m2 = 0.0;
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i)
        area_m2 += 2.0 * halfBreadth_m(s, (i + 0.5) * s.draught_m / kSteps) * s.draught_m / kSteps;
    EXPECT_NEAR(area_m2 / s.area_m2, 1.0, 0.01);
}

}  // namespace
}  // namespace sagara::ui
